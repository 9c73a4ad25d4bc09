// Counts the work of exact arithmetic, so that a caller can stop between two operations on numbers.
//
// Predicates and classes of numbers have no limits of their own. A thread that must stop at a limit
// installs a function, called a hook. Each long operation on numbers adds its estimated work to a
// counter before it begins. Whenever the counter reaches a bound, the operation calls the hook. The
// hook may throw. Then the operation has not changed anything yet.
#pragma once

#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb::detail {

/// A function that is called between operations of arithmetic. It may throw.
struct WorkHook {
  /// The function to call. If it is null, no function is called.
  void (*call)(const void* state) = nullptr;
  const void* state = nullptr;  ///< The argument of `call`.
};

/// Installs the hook of the calling thread, and returns the previous one.
WorkHook exchange_work_hook(WorkHook hook) noexcept;

/// Counts the work of one operation. `limbs` is the total number of limbs (machine words) of its
/// operands. If the work counted since the last call of the hook corresponds to about 2
/// milliseconds, the function calls the hook of the calling thread.
void count_work(std::uint64_t limbs);

}  // namespace plumb::detail
#pragma GCC visibility pop
