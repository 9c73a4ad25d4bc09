#include "plumb/base/context.h"

#include <algorithm>
#include <string>
#include <utility>

#include "plumb/base/error.h"

namespace plumb {

Context::Context(Limits limits, std::stop_token stop, ProgressCallback progress, unsigned threads)
    : limits_(limits),
      stop_(std::move(stop)),
      progress_(std::move(progress)),
      threads_(std::max(1U, threads)),
      start_(Clock::now()),
      last_report_(start_) {}

void Context::checkpoint(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  if (stop_.stop_requested()) throw Error(ErrorCode::Cancelled, "cancelled");
  const auto now = Clock::now();
  if (limits_.max_seconds > 0 &&
      std::chrono::duration<double>(now - start_).count() > limits_.max_seconds) {
    throw Error(ErrorCode::ResourceLimit, "the time limit was reached during " +
                                              std::string(phase) + " (raise --limit-seconds)");
  }
  if (progress_ && (now - last_report_ >= std::chrono::milliseconds(50) || done == total)) {
    last_report_ = now;
    progress_(phase, done, total);
  }
}

void Context::charge_memory(std::uint64_t bytes, std::string_view what) {
  if (bytes > limits_.max_memory_bytes - charged_bytes_) {
    throw Error(ErrorCode::ResourceLimit, std::string(what) + " needs " + std::to_string(bytes) +
                                              " more bytes than the memory limit leaves (raise "
                                              "--limit-memory)");
  }
  charged_bytes_ += bytes;
}

void Context::release_memory(std::uint64_t bytes) {
  charged_bytes_ -= std::min(bytes, charged_bytes_);
}

}  // namespace plumb
