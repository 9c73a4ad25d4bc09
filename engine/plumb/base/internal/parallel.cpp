#include "plumb/base/internal/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <vector>

#include "plumb/base/arithmetic_watch.h"

namespace plumb {
namespace {

class Jobs {
 public:
  Jobs(Context& context, std::size_t count, const std::function<void(std::size_t, Context&)>& job)
      : context_(context), job_(job), stop_(count), error_(count) {}

  void run() {
    const std::size_t workers = std::min<std::size_t>(context_.threads(), stop_.size());
    share_ = static_cast<unsigned>(context_.threads() / workers);
    {
      std::vector<std::jthread> others;
      others.reserve(workers);
      try {
        for (std::size_t i = 1; i < workers; ++i) others.emplace_back([this] { work(false); });
      } catch (const std::system_error&) {  // There are no more threads: fewer do the work.
      } catch (const std::bad_alloc&) {     // There is no memory for one more: likewise.
      }
      work(true);
    }
    for (const std::exception_ptr& error : error_) {
      if (error) std::rethrow_exception(error);
    }
  }

 private:
  void work(bool is_caller) {
    for (std::size_t i = next_++; i < stop_.size(); i = next_++) {
      if (stop_[i].stop_requested()) continue;
      try {
        Context own = Context::of_job(context_, stop_[i].get_token(), share_,
                                      is_caller ? JobProgress::Reported : JobProgress::Silent);
        std::optional<ArithmeticWatch> watch;
        if (is_watched_) watch.emplace(own);
        job_(i, own);
      } catch (...) {
        error_[i] = std::current_exception();
        for (std::size_t j = i + 1; j < stop_.size(); ++j) stop_[j].request_stop();
      }
    }
  }

  Context& context_;
  const std::function<void(std::size_t, Context&)>& job_;
  std::vector<std::stop_source> stop_;     // Stops each job.
  std::vector<std::exception_ptr> error_;  // The error of each job, if it failed.
  std::atomic<std::size_t> next_ = 0;
  unsigned share_ = 1;
  const bool is_watched_ = ArithmeticWatch::is_active();
};

}  // namespace

void run_jobs(Context& context, std::size_t jobs,
              const std::function<void(std::size_t, Context&)>& job) {
  if (context.threads() > 1 && jobs > 1) return Jobs(context, jobs, job).run();
  for (std::size_t i = 0; i < jobs; ++i) job(i, context);
}

}  // namespace plumb
