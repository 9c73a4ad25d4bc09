// Traces geodesics between points of a mesh: locally shortest paths.
//
// Notation: the doors of a strip of faces are the sides that it leads through (face_strip.h); a
// bend is a vertex at which the shortest path in a strip turns.
//
// Main flow of Tracer::trace:
//  1. order      starts at the lower point, and reverses the path at the end if necessary
//  2. find       finds a strip of faces over the dual graph that is short by the faces' centroids
//                (face_strip.h)
//  3. tighten    lays the strip out in the plane, and finds the shortest path in it by a funnel
//                (unfolded_strip.h)
//  4. flip       leads the strip around the other side of each bend that has less than half a turn
//                there; repeats 3 and 4 until there are no such bends or the path does not become
//                shorter
//  5. read off   appends the vertices where the path bends or would pass within 2^-40 of a side's
//                length, and a parameter t for each other side that is crossed: a double, or exact
//                where the faces between two such vertices are coplanar (unfolded_strip.h)
//
// Steps 1 to 4 are computed in doubles, which only chooses a path. From step 5 on the chosen path
// is exact, and it is never traced again. If several paths are locally shortest, any of them may be
// chosen, but always the same one. Design: docs/design/surface.md.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/strip/face_strip.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Traces paths between points of a mesh.
class Tracer {
 public:
  /// Makes a tracer for the mesh, which must outlive it. O(n).
  explicit Tracer(const SurfaceMesh& mesh);
  /// A moved-from tracer may only be destroyed. Tracers are not copied, because finder_ refers to
  /// positions_.
  Tracer(Tracer&&) = default;

  /// Returns a path from a to b, rows of `points`, and appends the points between to `points`.
  /// Returns no value if a and b lie on different components. Requires a table over the same mesh.
  /// trace(b, a) is the same path reversed. Two points in one face are joined by a segment. Costs
  /// as much as finding the strip (StripFinder), plus the length of the strip for each round of
  /// flips. Throws what the context throws.
  std::optional<SurfacePath> trace(SurfacePointTable& points, SurfacePointId a, SurfacePointId b,
                                   Context& context = unlimited_context());

  /// Returns the positions of the vertices, scaled by a power of two so that no product overflows.
  const std::vector<Point3>& positions() const { return positions_; }

 private:
  std::optional<SurfacePath> trace_upward(SurfacePointTable& points, SurfacePointId a,
                                          SurfacePointId b, Context& context);
  FaceStrip tightened(const StripEnd& from, const StripEnd& to, Context& context);

  const SurfaceMesh& mesh_;
  std::vector<Point3> positions_;
  StripFinder finder_;
};

/// Appends the closed polygon through control points, rows of `polygons.points`, joined by traced
/// paths. Returns no value on success; otherwise appends no polygon, and returns the index of the
/// first control point from which no path leads to the next. `named` holds a face for each control
/// point that contains it; if that face contains the next control point, too, the two are joined by
/// a segment there. (Any common face would do, except where two triangles make up a component and
/// share every edge.) Throws what the context throws.
std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              std::span<const FaceId> named,
                                              SurfacePolygons& polygons,
                                              Context& context = unlimited_context());
/// Does the same without named faces.
std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              SurfacePolygons& polygons,
                                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
