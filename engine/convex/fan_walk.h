// The directions of the facets of a Minkowski sum, by walks in one operand's normal fan (internal to convex_sum).
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "plumb/base/context.h"
#include "plumb/convex/convex_body.h"

namespace plumb {

/// A facet of a + b: its outer normal and the faces of the operands there, by their vertices: one, the two of an edge,
/// or the corners of a facet, counter-clockwise seen from outside.
struct FacetDirection {
  const RationalPoint3& normal;
  const BallVector& rough_normal;
  std::span<const std::uint32_t> face_a;
  std::span<const std::uint32_t> face_b;
};

/// Calls visit for every facet of the sum, once. Requires a sum of dimension 3 (so one operand has facets).
void for_each_direction(const ConvexBody& a, const ConvexBody& b,
                        const std::function<void(const FacetDirection&)>& visit, Context& context);

}  // namespace plumb
