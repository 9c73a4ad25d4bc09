// Delaunay triangulations of points of the plane, and constrained Delaunay triangulations of sets
// of the plane. In a constrained triangulation, every edge of the set is a side of triangles. No
// points are added, and all decisions are exact.
//
// Let s be the common side of two triangles. The side s is locally Delaunay if the following
// condition holds: the circle through the corners of one triangle does not contain the third corner
// of the other triangle. Every common side is locally Delaunay, except sides that are edges of the
// set. Therefore the smallest angle of all triangles is at least as large as in any other
// triangulation with the same corners and edges. If four or more points lie on a circle with no
// point inside, several triangulations have these properties. The function then chooses the
// diagonals that end at the point with the lowest index, so the result is unique.
//
// Main flow of delaunay():
//  1. edges          lists the edges of the set, directed so that the set lies to their left. For
//                    points, the step lists the edges of their convex hull
//  2. triangulate    sweeps over the points, and triangulates the region (space/planar)
//  3. make_delaunay  flips sides until every side that is not an edge of the set is locally
//                    Delaunay
//
// Cost: the sweep over n points takes O(n log n). The number of flips is O(n^2) in the worst case,
// and usually O(n). Sources: B. Delaunay, Sur la sphere vide, 1934; C. L. Lawson, Software for C1
// surface interpolation, 1977; L. P. Chew, Constrained Delaunay triangulations, Algorithmica 4
// (1989).
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
  PointTable2 points;  ///< The points, with exact coordinates.
  /// The corners of each triangle, counter-clockwise, as indices of points.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Returns the Delaunay triangulation of `points`, which covers their convex hull. Every point is a
/// corner of a triangle, unless it equals a point with a lower index. The indices of corners are
/// indices of `points`. There are no triangles if all points lie on a line. Throws the errors of
/// the Context.
[[nodiscard]] PlaneTriangulation delaunay(const PointTable2& points,
                                          Context& context = unlimited_context());

/// Returns the constrained Delaunay triangulation of the closures of the marked faces of a set. The
/// points of the triangulation are the vertices of these faces, including the ends of slits and
/// points that are missing inside a face. All edges of these faces are sides of triangles. There
/// are no triangles if no face is marked. Throws Error{BadArgument} if a marked face is unbounded,
/// and the errors of the Context.
[[nodiscard]] PlaneTriangulation delaunay(const Nef2& set, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
