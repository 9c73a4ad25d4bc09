// The floating-point environment the filters are derived for, checked at compile time
// (input_filters.h) and on call.
#pragma once

#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// What self_test() found. `ok` is false exactly when `failures` is not empty.
struct SelfTestReport {
  bool ok = true;                     ///< do the predicates keep their promises here?
  std::vector<std::string> failures;  ///< the predicates cannot be relied on
  std::vector<std::string> notes;     ///< unusual, but the predicates stay right
};

/// Probes arithmetic as it is *now*, in this build and on the calling thread, and runs predicates on
/// inputs whose signs are known and hard.
///
/// Failures: reassociated or extended-precision arithmetic, a predicate with a wrong sign.
/// Notes: a rounding mode other than to nearest, flush-to-zero, denormals-are-zero, contraction of
/// a*b+c to a fused multiply-add. The filters' bounds are derived for all of these; other code of the
/// caller may mind. Leaves the environment as it was.
SelfTestReport self_test();

}  // namespace plumb
#pragma GCC visibility pop
