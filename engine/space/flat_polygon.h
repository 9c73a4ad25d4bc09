// Polygons in a view: are they simple, and if not, what do they cover?
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/sign.h"
#include "plumb/space/flat_points.h"
#include "plumb/space/triangulate.h"

namespace plumb {

enum class PolygonShape : std::uint8_t {
  Simple,
  Touching,  ///< meets itself in common corners only, or runs an edge there and back
  Crossing,
};

/// `polygon`: indices of points, all points different, no corner follows itself. O(n) when convex,
/// else O(n log n).
PolygonShape shape_of(const FlatPoints& points, std::span<const std::uint32_t> polygon,
                      Context& context);

/// Requires a Simple polygon that is not all on a line. Positive: counter-clockwise.
Sign orientation_of(const FlatPoints& points, std::span<const std::uint32_t> polygon);

/// Without those there whose reverse is there too: neither stays. Sorts the others.
void cancel_reverses(std::vector<IndexEdge>& edges);

/// The directed edges of a polygon without those that it runs there and back.
std::vector<IndexEdge> boundary_of(std::span<const std::uint32_t> polygon);

}  // namespace plumb
