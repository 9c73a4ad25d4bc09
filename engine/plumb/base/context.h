// Context: the limits, the stop request and the progress callback of a long operation.
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

/// Bounds on the resources of an operation. If a file states a size, the reader of the file
/// compares this size with the limits and with the number of bytes left in the file. This
/// comparison comes *before* the reader allocates memory or builds a number.
struct Limits {
  /// The largest working memory of an operation in bytes. Operations estimate this memory.
  std::uint64_t max_memory_bytes = std::uint64_t{16} << 30;
  double max_seconds = 0;  ///< The largest wall time of an operation; 0 means no limit.
  /// Largest number of digits of one number that is read. In a fraction p/q, the digits of p and of
  /// q are counted together. The default is enough for the exact decimal expansion of every double.
  /// Numbers of `.nef` and `.nef2` files, and fractions of map and OFF files, may have up to
  /// 16,384 digits, even if this limit is smaller.
  std::uint32_t max_number_digits = 1100;
  /// The largest absolute value of the decimal exponent of a number that is read exactly. For
  /// example, 1e-300 has the exponent -300.
  std::uint32_t max_decimal_exponent = 1100;
};

/// Callback that receives the name of a phase, the number of steps done, and the total number of
/// steps of the phase. A total of 0 means that the number of steps is unknown.
using ProgressCallback =
    std::function<void(std::string_view phase, std::uint64_t done, std::uint64_t total)>;

/// Whether a job within an operation reports the progress of the operation.
enum class JobProgress : std::uint8_t { Silent, Reported };

/// The state that a long operation shares with its caller. The caller passes it by reference. The
/// errors of a Context are Error{Cancelled} if a stop was requested, and Error{ResourceLimit} if a
/// limit is exceeded. A Context is not thread-safe. Each operation needs a Context of its own. Each
/// parallel job within an operation (parallel.h) also needs a Context of its own.
class Context {
 public:
  /// Constructs a context. The time limit counts from the construction of the context. `progress`
  /// is called on the thread that runs the operation. `threads` is the number of threads that an
  /// operation may use; 0 means 1.
  explicit Context(Limits limits = {}, std::stop_token stop = {}, ProgressCallback progress = {},
                   unsigned threads = 1);
  /// Returns the context of a job within an operation. `of` is the context of the operation. The
  /// job shares the limits, the start time and the charged memory of `of`. The job stops if a stop
  /// is requested through `of` or through `stop`.
  static Context of_job(const Context& of, std::stop_token stop, unsigned threads,
                        JobProgress progress);

  const Limits& limits() const { return limits_; }  ///< Returns the limits.
  unsigned threads() const { return threads_; }     ///< Returns the number of threads (>= 1).

  /// Reports progress and checks for a stop request. An operation calls this function every few
  /// thousand steps. Throws Error{Cancelled} if a stop was requested, and Error{ResourceLimit} if
  /// the time limit is exceeded. The callback is called at most 20 times a second. The callback is
  /// also called at the end of a phase, that is, if total > 0 and done == total.
  void checkpoint(std::string_view phase, std::uint64_t done, std::uint64_t total);
  /// Checks for a stop request and for the time limit, and reports no progress. Throws as
  /// checkpoint() does.
  void check_limits(std::string_view phase) const;

  /// Charges memory that the operation is about to allocate: its size is added to the memory that
  /// counts against the limit. If `bytes` more bytes would exceed the memory limit, the function
  /// charges nothing. In this case it throws Error{ResourceLimit} with a message that names `what`.
  void charge_memory(std::uint64_t bytes, std::string_view what);
  /// Subtracts `bytes` from the charged memory, which never falls below 0.
  void release_memory(std::uint64_t bytes);

 private:
  using Clock = std::chrono::steady_clock;

  struct Job {};
  Context(Job, const Context& of, std::stop_token stop, unsigned threads, JobProgress progress);
  void check_limits(std::string_view phase, Clock::time_point now) const;

  Limits limits_;
  // The stop tokens of this job, of all jobs that contain it, and of the operation.
  std::vector<std::stop_token> stops_;
  ProgressCallback progress_;
  unsigned threads_;
  std::shared_ptr<std::atomic<std::uint64_t>> charged_bytes_;
  Clock::time_point start_;
  Clock::time_point last_report_;
};

/// Returns a context of the calling thread that has no limits, no stop request and no progress
/// callback. Functions use this context if their caller passes no context. The context is valid
/// until the thread ends.
Context& unlimited_context();

/// Charges growing amounts of memory to a context, and releases the whole charge on destruction.
class MemoryCharge {
 public:
  /// Constructs an object that has charged 0 bytes so far. Requires that the context outlives the
  /// charge.
  explicit MemoryCharge(Context& context) : context_(context) {}
  ~MemoryCharge() { context_.release_memory(bytes_); }
  MemoryCharge(const MemoryCharge&) = delete;
  MemoryCharge& operator=(const MemoryCharge&) = delete;

  /// Charges `bytes` more bytes. Throws as Context::charge_memory does.
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
