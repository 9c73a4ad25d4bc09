#include "plumb/base/internal/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <vector>

#include "plumb/base/arithmetic_watch.h"
#include "plumb/base/internal/restarted_jobs.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

enum class OnLimit : std::uint8_t { Fail, RunAgain };

/// Whether the exception that is being handled reports an exceeded limit, or a lack of memory.
bool is_limit() {
  try {
    throw;
  } catch (const Error& error) {
    return error.code() == ErrorCode::ResourceLimit;
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

class Jobs {
 public:
  Jobs(Context& context, std::size_t count, const std::function<void(std::size_t, Context&)>& job,
       OnLimit on_limit)
      : context_(context),
        job_(job),
        on_limit_(on_limit),
        stop_(count),
        error_(count),
        is_postponed_(count),
        work_(count) {}

  void run() {
    const std::size_t workers = std::min<std::size_t>(context_.threads(), stop_.size());
    share_ = static_cast<unsigned>(context_.threads() / workers);
    {
      std::vector<std::jthread> others;
      others.reserve(workers);
      try {
        for (std::size_t i = 1; i < workers; ++i) others.emplace_back([this] { work(false); });
      } catch (const std::system_error&) {  // The system has no more threads. Fewer do the work.
      } catch (const std::bad_alloc&) {     // There is no memory for one more. Fewer do the work.
      }
      work(true);
    }
    for (std::size_t i = 0; i < error_.size(); ++i) {
      if (error_[i]) std::rethrow_exception(error_[i]);
      if (is_postponed_[i] != 0) job_(i, context_);
    }
  }

 private:
  void work(bool is_caller) {
    for (std::size_t i = next_++; i < stop_.size(); i = next_++) {
      if (stop_[i].stop_requested()) continue;
      const WorkSection::Job work(work_, i);
      try {
        Context own = Context::of_job(context_, stop_[i].get_token(), share_,
                                      is_caller ? JobProgress::Reported : JobProgress::Silent);
        std::optional<ArithmeticWatch> watch;
        if (is_watched_) watch.emplace(own);
        job_(i, own);
      } catch (...) {
        is_postponed_[i] = on_limit_ == OnLimit::RunAgain && is_limit() ? 1 : 0;
        if (is_postponed_[i] != 0) continue;
        error_[i] = std::current_exception();
        for (std::size_t j = i + 1; j < stop_.size(); ++j) stop_[j].request_stop();
      }
    }
  }

  Context& context_;
  const std::function<void(std::size_t, Context&)>& job_;
  const OnLimit on_limit_;
  std::vector<std::stop_source> stop_;     // The stop sources of the jobs.
  std::vector<std::exception_ptr> error_;  // The error of each job, if it failed.
  // The jobs that exceeded a limit. They are run again when no other job runs.
  std::vector<std::uint8_t> is_postponed_;
  std::atomic<std::size_t> next_ = 0;
  unsigned share_ = 1;
  const bool is_watched_ = ArithmeticWatch::is_active();
  WorkSection work_;
};

void run(Context& context, std::size_t jobs, const std::function<void(std::size_t, Context&)>& job,
         OnLimit on_limit) {
  if (context.threads() > 1 && jobs > 1) return Jobs(context, jobs, job, on_limit).run();
  for (std::size_t i = 0; i < jobs; ++i) job(i, context);
}

}  // namespace

void run_jobs(Context& context, std::size_t jobs,
              const std::function<void(std::size_t, Context&)>& job) {
  run(context, jobs, job, OnLimit::Fail);
}

void run_restarted_jobs(Context& context, std::size_t jobs,
                        const std::function<void(std::size_t, Context&)>& job) {
  run(context, jobs, job, OnLimit::RunAgain);
}

}  // namespace plumb
