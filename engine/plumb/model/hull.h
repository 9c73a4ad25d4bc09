// Computes exact convex hulls of points and of sets, in space and in the plane. Points may have any
// position. For example, the hull of points in a common plane is a polygon, and the hull of points
// on a line is a segment.
//
// Main flow of convex_hull() in space:
//  1. a tetrahedron   finds four points that do not lie in a common plane. If there are no such
//                     points, the hull is flat, and it is computed as a hull in the plane
//  2. insert          chooses a face with points in front of it, and inserts one of these points.
//                     It chooses the point that is farthest from the face, up to rounding. A face
//                     is visible from a point if the point lies strictly in front of the face. All
//                     faces visible from the inserted point are replaced by triangles that have
//                     this point as a corner. Each point in front of a removed face is assigned to
//                     a new triangle, or dropped if it is not in front of any new triangle
//  3. from_mesh       joins coplanar triangles
// Only faces that are visible from the inserted point are removed. Therefore every new triangle has
// a positive area. All decisions depend on exact signs of determinants (input_predicates.h).
//
// Cost for n points: in space, O(n log n) for usual input and O(n^2) in the worst case. In the
// plane, O(n log n). Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for
// convex hulls, ACM Transactions on Mathematical Software 22 (1996) 469-483.
#pragma once

#include <span>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the convex hull of points as a closed set. The hull of no points is empty. Throws
/// Error{NotFinite} if a coordinate is not finite.
[[nodiscard]] Nef3 convex_hull(std::span<const Point3> points,
                               Context& context = unlimited_context());
[[nodiscard]] Nef3 convex_hull(std::span<const RationalPoint3> points,
                               Context& context = unlimited_context());
/// Returns the convex hull of the closures of all sets together. Throws Error{BadArgument} if a set
/// is unbounded.
[[nodiscard]] Nef3 convex_hull(std::span<const Nef3> sets, Context& context = unlimited_context());

/// Returns the boundary of the convex hull as a mesh of triangles that are oriented outwards.
/// Coplanar triangles are not joined. The mesh contains only the points that are corners of
/// triangles. The mesh has no faces if all points lie in a common plane. Throws Error{NotFinite} if
/// a coordinate is not finite.
[[nodiscard]] PolygonMesh hull_mesh(std::span<const Point3> points,
                                    Context& context = unlimited_context());

/// Returns the convex hull of points of the plane as a closed set. The hull of no points is empty.
/// Throws Error{NotFinite} if a coordinate is not finite.
[[nodiscard]] Nef2 convex_hull(std::span<const Point2> points,
                               Context& context = unlimited_context());
[[nodiscard]] Nef2 convex_hull(std::span<const RationalPoint2> points,
                               Context& context = unlimited_context());
/// Returns the convex hull of the closures of all sets together. Throws Error{BadArgument} if a set
/// is unbounded.
[[nodiscard]] Nef2 convex_hull(std::span<const Nef2> sets, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
