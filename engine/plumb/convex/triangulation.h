// Delaunay triangulations in the plane: of points, and of sets whose edges are kept (constrained
// Delaunay triangulations). No points are added, and all decisions are exact.
//
// A side of a triangle is locally Delaunay if the circle through the corners of the triangle does
// not contain the opposite corner of the triangle beyond the side. Every side is locally Delaunay,
// except sides that are edges of the set. So among all triangulations with these corners and edges
// the least angle is as large as possible. If four or more points lie on a circle, the diagonals
// that end at the point of lowest index are used, so the result is unique.
//
// Main flow of delaunay():
//  1. edges          lists the edges with the set to their left; for points, the edges of their
//                    convex hull
//  2. triangulate    sweeps over the points, and triangulates the region (space/planar)
//  3. make_delaunay  flips sides until all are locally Delaunay
//
// Cost: O(n log n) for the sweep; O(n^2) flips at worst, and usually O(n).
// Sources: B. Delaunay, Sur la sphere vide, 1934; C. L. Lawson, Software for C1 surface
// interpolation, 1977; L. P. Chew, Constrained Delaunay triangulations, Algorithmica 4 (1989).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Triangles whose corners are given points of the plane.
struct PlaneTriangulation {
  PointTable2 points;  ///< The points, exactly.
  /// The corners of each triangle, counter-clockwise, as indices of points.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Returns the Delaunay triangulation of the convex hull of points. Every point is a corner of a
/// triangle, except points that equal an earlier one. The indices are those of `points`. There are
/// no triangles if all points lie on a line. Throws what the context throws.
[[nodiscard]] PlaneTriangulation delaunay(const PointTable2& points,
                                          Context& context = unlimited_context());

/// Returns the constrained Delaunay triangulation of the closures of the marked faces of a set. The
/// points are the vertices of these faces, also those of slits and of missing points inside. All
/// edges of these faces are sides of triangles. There are no triangles if no face is marked. Throws
/// Error{BadArgument} if a marked face is unbounded, and what the context throws.
[[nodiscard]] PlaneTriangulation delaunay(const Nef2& set, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
