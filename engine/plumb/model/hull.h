// Convex hulls of points and of sets, in space and in the plane, exactly. Input in any position is
// handled: the hull of points in a plane is a polygon, that of points on a line a segment.
//
// Main flow of convex_hull() in space:
//  1. a tetrahedron   finds four points that do not lie in a plane; if there are none, the hull is
//                     flat, and is computed in a view of the plane
//  2. insert          takes a face with points in front of it, and inserts the point that seems
//                     farthest: the faces that the point sees are replaced by triangles to it, and
//                     the points in front of them are distributed over the new triangles
//  3. from_mesh       joins coplanar triangles
// A face is removed only if the point lies strictly in front of it. So every new triangle has a
// positive area, and all decisions are signs of determinants (input_predicates.h).
//
// Cost: O(n log n) for usual input; O(n^2) at worst. In the plane O(n log n).
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for convex hulls, ACM
// Transactions on Mathematical Software 22 (1996) 469-483.
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

/// Returns the boundary of the convex hull as triangles that look outward; coplanar triangles are
/// not joined. Only points that are corners of the mesh are kept. The mesh has no faces if all
/// points lie in a plane. Throws Error{NotFinite} if a coordinate is not finite.
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
