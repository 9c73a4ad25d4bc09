// Sets of the plane from sets of space: slices at a height, and shadows along the z-axis. Both are
// exact.
//
// Main flow of slice(): the Boolean intersects the set with the plane; the cells of the flat result
// become the cells of a subdivision of the plane, with their marks.
// Main flow of shadow(): the borders of all facets are projected, each with its facet on the left;
// the shadow consists of the points with a positive winding number, which is the number of facets
// above the point.
//
// Cost: slice() costs as much as the Boolean; shadow() takes O((n + k) log n) for n edges and k
// crossings of their projections.
#pragma once

#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the points (x, y) for which (x, y, height) belongs to the set. The set and the slice may
/// be unbounded.
[[nodiscard]] Nef2 slice(const Nef3& set, const Rational& height,
                         Context& context = unlimited_context());
/// Returns the slices at several heights.
[[nodiscard]] std::vector<Nef2> slices(const Nef3& set, std::span<const Rational> heights,
                                       Context& context = unlimited_context());
/// Returns the closure of the set of points (x, y) for which some point (x, y, z) belongs to the
/// set. Throws Error{BadArgument} if the set is unbounded.
[[nodiscard]] Nef2 shadow(const Nef3& set, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
