// audit() of complexes in the plane (plane_complex.h) within limits.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// audit(complex, minimal). Throws Error{ResourceLimit}, Error{Cancelled}.
std::optional<DcelFlaw> audit(const PlaneComplex& complex, bool minimal, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
