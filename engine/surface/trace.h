// Traces geodesics between points of a mesh: locally shortest paths.
//
// Notation: doors are the sides of faces that a strip of faces leads through (face_strip.h); a bend is a vertex at
// which the shortest path in a strip turns.
//
// Main flow of Tracer::trace:
//  1. order      the lower point first; turned around at the end, if need be
//  2. find       a strip of faces over the dual graph: short by its centroids (face_strip.h)
//  3. tighten    the strip laid out in the plane; the shortest path in it by a funnel (unfolded_strip.h)
//  4. flip       around bends with less than half a turn on their other side the strip is led that other way;
//                3 and 4 until there are none, or the path does not become shorter
//  5. read off   vertices where it bends or would pass within 2^-40 of a side's length, else a t for each side:
//                a double, or exact where the faces between two such vertices lie in one plane (flat_run.h)
//
// 1 to 4 are done in doubles: that chooses a path. What was chosen is exact from 5 on and is never traced
// again. On a mesh where several paths are locally shortest, any of them may be chosen; always the same one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/face_strip.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Paths between points of a mesh.
class Tracer {
 public:
  /// The mesh has to outlive the tracer. O(n).
  explicit Tracer(const SurfaceMesh& mesh);
  Tracer(Tracer&&) = default;  // and no copies: the finder looks at these positions

  /// From a to b, points of `points`, which is over the same mesh; the points between are appended to it. None
  /// when no path leads there: they lie on different components. trace(b, a) is the same path the other way. Two
  /// points in one face are joined straight. Cost: that of find() plus, for each round of flips, the length of the
  /// strip. Errors: Cancelled, ResourceLimit.
  std::optional<SurfacePath> trace(SurfacePointTable& points, SurfacePointId a, SurfacePointId b,
                                   Context& context);

  /// The vertices as the tracer sees them: scaled by a power of two so that no product overflows.
  const std::vector<Point3>& positions() const { return positions_; }

 private:
  std::optional<SurfacePath> trace_upward(SurfacePointTable& points, SurfacePointId a,
                                          SurfacePointId b, Context& context);
  FaceStrip tightened(const StripEnd& from, const StripEnd& to, Context& context);

  const SurfaceMesh& mesh_;
  std::vector<Point3> positions_;
  StripFinder finder_;
};

/// Appends the closed polygon through control points of `polygons.points`, joined by traced paths. Returns the
/// first of them from which no path leads to the next; then the polygon has not been appended. `named`: a face that
/// each control point lies in; if the next lies in it, too, they are joined straight there. (Any common face would
/// do but where two triangles are all of a component: they share every edge.)
std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              std::span<const FaceId> named,
                                              SurfacePolygons& polygons, Context& context);
/// The same, without.
std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              SurfacePolygons& polygons, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
