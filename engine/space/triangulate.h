// Regions of a plane cut into triangles between their own points.
//
// Main flow of triangulate(): a sweep in lexicographic order that triangulates what it leaves behind
// (Hertel and Mehlhorn, "Fast triangulation of simple polygons", FCT 1983, extended to regions whose
// boundaries touch in points). The part of the region between two edges met by the sweep line keeps a
// chain: the points behind it that no triangle has closed off, each corner of it reflex or flat.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/planar_points.h"

namespace plumb {

using IndexEdge = std::array<std::uint32_t, 2>;
using IndexTriangle = std::array<std::uint32_t, 3>;

/// Appends triangles, counter-clockwise, whose corners are given points and whose union is the region to
/// the left of the edges. Points inside the region are corners too. Requires all points to be
/// different and edges that meet each other and points in their ends only; one that runs both ways is a slit.
/// False, and nothing appended: the edges have no region to their left (somewhere it would be covered
/// twice, or less than once).
/// O(n log n).
bool triangulate(const PlanarPoints& points, std::span<const IndexEdge> edges,
                 std::vector<IndexTriangle>& triangles);

/// Flips edges that are not among `edges` until every one is locally Delaunay; of four points on a
/// circle the one with the lowest index is joined. Hence the result is unique. O(n^2) flips at
/// worst, O(n) as a rule.
void make_delaunay(const PlanarPoints& points, std::span<const IndexEdge> edges,
                   std::span<IndexTriangle> triangles);

}  // namespace plumb
