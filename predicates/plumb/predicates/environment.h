// Checks the floating-point environment. The error bounds of the filters depend on assumptions
// about this environment. input_filters.h checks these assumptions at compile time, and self_test()
// checks them at run time.
#pragma once

#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// The result of self_test(). `ok` is false if and only if `failures` is not empty.
struct SelfTestReport {
  bool ok = true;                     ///< Whether the predicates can be relied on.
  std::vector<std::string> failures;  ///< Reasons why the predicates cannot be relied on.
  std::vector<std::string> notes;     ///< Unusual settings that do not affect the predicates.
};

/// Tests the arithmetic of this build with the current settings of the calling thread, and runs
/// predicates on difficult inputs with known signs. The function does not change the environment.
///
/// The possible failures are: the compiler reassociates arithmetic; arithmetic has extended
/// precision; a predicate returns a wrong sign. Notes report the following settings: flush-to-zero,
/// denormals-are-zero, the contraction of a*b+c to a fused multiply-add, and a rounding mode other
/// than to nearest. The bounds of the filters hold under all these settings. Other code of the
/// caller may depend on such a setting.
SelfTestReport self_test();

}  // namespace plumb
#pragma GCC visibility pop
