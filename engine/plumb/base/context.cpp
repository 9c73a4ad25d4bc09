#include "plumb/base/context.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "plumb/predicates/error.h"

namespace plumb {

Context::Context(Limits limits, std::stop_token stop, ProgressCallback progress, unsigned threads)
    : limits_(limits),
      stops_{std::move(stop)},
      progress_(std::move(progress)),
      threads_(std::max(1U, threads)),
      charged_bytes_(std::make_shared<std::atomic<std::uint64_t>>(0)),
      start_(Clock::now()),
      last_report_(start_) {}

Context::Context(Job, const Context& of, std::stop_token stop, unsigned threads,
                 JobProgress progress)
    : limits_(of.limits_),
      stops_(of.stops_),
      progress_(progress == JobProgress::Reported ? of.progress_ : ProgressCallback()),
      threads_(std::max(1U, threads)),
      charged_bytes_(of.charged_bytes_),
      start_(of.start_),
      last_report_(of.last_report_) {
  stops_.push_back(std::move(stop));
}

Context Context::of_job(const Context& of, std::stop_token stop, unsigned threads,
                        JobProgress progress) {
  return Context(Job(), of, std::move(stop), threads, progress);
}

Context& unlimited_context() {
  thread_local Context context{
      Limits{.max_memory_bytes = std::numeric_limits<std::uint64_t>::max()}};
  return context;
}

void Context::check_limits(std::string_view phase, Clock::time_point now) const {
  for (const std::stop_token& stop : stops_) {
    if (stop.stop_requested()) throw Error(ErrorCode::Cancelled, "cancelled");
  }
  if (limits_.max_seconds > 0 &&
      std::chrono::duration<double>(now - start_).count() > limits_.max_seconds) {
    throw Error(ErrorCode::ResourceLimit,
                "the time limit was reached during " + std::string(phase));
  }
}

void Context::check_limits(std::string_view phase) const { check_limits(phase, Clock::now()); }

void Context::checkpoint(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  const auto now = Clock::now();
  check_limits(phase, now);
  const bool is_done = total != 0 && done == total;  // A total of 0 means that it is not known.
  if (progress_ && (now - last_report_ >= std::chrono::milliseconds(50) || is_done)) {
    last_report_ = now;
    progress_(phase, done, total);
  }
}

void Context::charge_memory(std::uint64_t bytes, std::string_view what) {
  std::uint64_t charged = *charged_bytes_;
  do {
    const std::uint64_t left = limits_.max_memory_bytes - charged;
    if (bytes > left) {
      throw Error(ErrorCode::ResourceLimit, std::string(what) + " needs " + std::to_string(bytes) +
                                                " bytes, but only " + std::to_string(left) +
                                                " of " + std::to_string(limits_.max_memory_bytes) +
                                                " bytes are left under the memory limit");
    }
  } while (!charged_bytes_->compare_exchange_weak(charged, charged + bytes));
}

void Context::release_memory(std::uint64_t bytes) {
  std::uint64_t charged = *charged_bytes_;
  while (!charged_bytes_->compare_exchange_weak(charged, charged - std::min(bytes, charged))) {
  }
}

}  // namespace plumb
