// The floating-point environment the filters are derived for, checked at compile time and on call.
#pragma once

#include <string>

namespace plumb {

/// Checks contraction, reassociation, rounding mode and flush-to-zero as they are *now*, in this
/// build. Returns an empty string when the predicates' derivations hold, else what is wrong.
/// (Predicates stay right under any rounding mode and FTZ/DAZ; contraction and reassociation are
/// what a build must not do.)
std::string self_test();

}  // namespace plumb
