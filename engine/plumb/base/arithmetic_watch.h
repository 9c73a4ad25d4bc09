// ArithmeticWatch: stops exact arithmetic on very long numbers within the limits of a Context.
//
// Operations call Context::checkpoint() between their steps. If a file has coordinates of thousands
// of digits, a single step may take seconds. While an ArithmeticWatch exists, each operation on
// such long numbers checks the Context, too.
//
// Main flow:
//   Context context(Limits{.max_seconds = 5});
//   const ArithmeticWatch watch(context);
//   Nef3 result = boolean_op(a, b, BooleanOp::Union, context);
//
// Cost: a few nanoseconds for each operation on fractions. Errors: while a watch exists, every
// function that computes with numbers can throw the errors of Context::checkpoint().
#pragma once

#include "plumb/base/context.h"

#pragma GCC visibility push(default)
namespace plumb {

/// While the object exists, arithmetic of the calling thread on long fractions can throw errors. It
/// throws Error{Cancelled} if a stop of `context` was requested. It throws Error{ResourceLimit} if
/// the time limit of `context` is exceeded. Such errors can come from the operations of plumb, from
/// the threads that these operations start, and from fractions that the caller adds, multiplies or
/// compares. Watches of one thread must be destroyed in the reverse order of their construction.
class ArithmeticWatch {
 public:
  /// Requires that the context outlives the watch.
  explicit ArithmeticWatch(const Context& context);
  /// Restores the watch that was active before this watch was constructed.
  ~ArithmeticWatch();
  ArithmeticWatch(const ArithmeticWatch&) = delete;
  ArithmeticWatch& operator=(const ArithmeticWatch&) = delete;

  /// Whether a watch of the calling thread exists.
  static bool is_active();

 private:
  // The check that was active before this watch was constructed, and the argument of this check.
  void (*check_before_)(const void*);
  const void* context_before_;
};

}  // namespace plumb
#pragma GCC visibility pop
