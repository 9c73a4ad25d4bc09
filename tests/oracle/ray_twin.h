// Ray shooting that is slow and plainly right: every edge is asked where the ray meets it, in
// rationals.
#pragma once

#include <optional>

#include "plumb/plane/nef2.h"

namespace plumb::testing {

/// What Nef2::shoot and Nef2::shoot_to_boundary are to answer. O(n) rationals.
std::optional<PlaneHit> shoot_slowly(const Nef2& set, const RationalPoint2& origin,
                                     const RationalPoint2& direction);
std::optional<PlaneHit> shoot_to_boundary_slowly(const Nef2& set, const RationalPoint2& origin,
                                                 const RationalPoint2& direction);

}  // namespace plumb::testing
