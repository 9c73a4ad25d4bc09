// Computes sets of the plane from sets of space. A slice is the intersection of a set with the
// plane at a given height. The shadow of a set is its projection along the z-axis. Slices and
// shadows are exact.
//
// Main flow of slice(): a Boolean intersects the set with the plane at the given height. The result
// is a flat set of space. Its cells become the cells of a subdivision of the plane and keep their
// marks.
// Main flow of shadow(): the border of each facet is projected, and directed so that the projection
// of the facet lies to its left. So the winding number of these borders at a point is the number of
// facets whose projections contain the point. The shadow consists of the points with a positive
// winding number.
//
// Cost: slice() takes the time of the Boolean. shadow() takes O((n + k) log n) for n edges whose
// projections have k crossings.
#pragma once

#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the points (x, y) for which (x, y, height) belongs to the set. The set may be unbounded,
/// and so may its slice.
[[nodiscard]] Nef2 slice(const Nef3& set, const Rational& height,
                         Context& context = unlimited_context());
/// Returns one slice for each of the given heights, in the same order. Heights may be equal. Cost:
/// one slice() for each height.
[[nodiscard]] std::vector<Nef2> slices(const Nef3& set, std::span<const Rational> heights,
                                       Context& context = unlimited_context());
/// Returns the closure of the set of points (x, y) for which some point (x, y, z) belongs to the
/// set. Throws Error{BadArgument} if the set is unbounded.
[[nodiscard]] Nef2 shadow(const Nef3& set, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
