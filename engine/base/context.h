// What a long operation is given besides its input: limits, a way to stop it, a way to watch it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// Bounds on what an operation may use. Readers check a claim against the limits and against the
/// bytes that are really left *before* they allocate or build a number.
struct Limits {
  std::uint64_t max_memory_bytes = std::uint64_t{16} << 30;  ///< working memory, estimated
  double max_seconds = 0;                                    ///< wall time; 0 = no limit
  std::uint32_t max_number_digits = 4096;                    ///< digits of one number in a file
  std::uint32_t max_decimal_exponent = 4096;                 ///< |exponent| with exact decimals
};

/// Called with a phase name and how much of it is done.
using ProgressCallback =
    std::function<void(std::string_view phase, std::uint64_t done, std::uint64_t total)>;

/// Passed by reference down a long operation. Not thread-safe: one Context for one operation, and one for each job
/// of it (parallel.h).
class Context {
 public:
  /// The clock of max_seconds starts here. `progress` is called from the thread that runs the
  /// operation.
  explicit Context(Limits limits = {}, std::stop_token stop = {}, ProgressCallback progress = {},
                   unsigned threads = 1);
  /// Of a job within an operation: it also stops with `stop`, shares limits, time and charged memory with
  /// `of`, and reports progress if `reports`.
  Context(const Context& of, std::stop_token stop, unsigned threads, bool reports);

  const Limits& limits() const { return limits_; }  ///< As given.
  unsigned threads() const { return threads_; }     ///< How many threads an operation may use.

  /// Call often (every few thousand steps): reports progress at most 20 times a second; throws
  /// Error{Cancelled} once a stop was requested, Error{ResourceLimit} once the time is used up.
  void checkpoint(std::string_view phase, std::uint64_t done, std::uint64_t total);

  /// Throws Error{ResourceLimit} when `bytes` more would pass the memory limit. `what` is named
  /// in the message. Memory is charged before it is allocated and given back by release().
  void charge_memory(std::uint64_t bytes, std::string_view what);
  void release_memory(std::uint64_t bytes);  ///< Gives back what was charged.

 private:
  using Clock = std::chrono::steady_clock;

  Limits limits_;
  std::vector<std::stop_token>
      stops_;  // of the operation and of the jobs within it that this is one of
  ProgressCallback progress_;
  unsigned threads_;
  std::shared_ptr<std::atomic<std::uint64_t>> charged_bytes_;
  Clock::time_point start_;
  Clock::time_point last_report_;
};

/// Memory of one piece of work, charged as it grows and released at its end.
class MemoryCharge {
 public:
  /// Nothing is charged yet. The context must outlive it.
  explicit MemoryCharge(Context& context) : context_(context) {}
  ~MemoryCharge() { context_.release_memory(bytes_); }
  MemoryCharge(const MemoryCharge&) = delete;
  MemoryCharge& operator=(const MemoryCharge&) = delete;

  /// Throws as Context::charge_memory does.
  void add(std::uint64_t bytes, std::string_view what) {
    context_.charge_memory(bytes, what);
    bytes_ += bytes;
  }

 private:
  Context& context_;
  std::uint64_t bytes_ = 0;
};

}  // namespace plumb
#pragma GCC visibility pop
