// Counts the work of exact arithmetic, so that a caller can stop between two operations on numbers.
//
// Predicates and numbers know no limits. A thread that wants to keep limits installs a hook.
// Operations on numbers count their work before they begin, and call the hook each time the counted
// work reaches a bound. The hook may throw. The operation that counts has then changed nothing.
#pragma once

#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb::detail {

/// A function that is called between operations of arithmetic. It may throw.
struct WorkHook {
  void (*call)(const void* state) = nullptr;  ///< A null pointer: nothing is called.
  const void* state = nullptr;                ///< The argument of `call`.
};

/// Installs the hook of the calling thread, and returns the previous one.
WorkHook exchange_work_hook(WorkHook hook) noexcept;

/// Counts an operation whose operands have this number of limbs together. Calls the hook of the
/// calling thread if operations that take about 2 milliseconds were counted since the last call.
void count_work(std::uint64_t limbs);

}  // namespace plumb::detail
#pragma GCC visibility pop
