// Traces geodesics between points of a mesh. A geodesic is a locally shortest path. On request, the
// tracer finds a globally shortest path.
//
// Notation: a strip is a sequence of faces in which each face shares a side with the next one. The
// shared sides are the doors of the strip (face_strip.h). A bend is a vertex at which the shortest
// path in a strip turns.
//
// Main flow of Tracer::trace:
//  1. order      puts the two end points in a fixed order, so that trace(a, b) and trace(b, a) find
//                the same path. If this exchanges the two end points, the last step reverses the
//                path
//  2. find       finds a short strip by a search in the dual graph of the mesh (face_strip.h). The
//                search measures the length of a strip along the centroids of its faces
//  3. tighten    lays the strip out in the plane, and finds the shortest path in the strip by the
//                funnel algorithm (unfolded_strip.h)
//  4. flip       examines each bend. The path passes the vertex of the bend on one side. If the
//                angle on the other side of the vertex is less than half a turn, the strip is
//                changed. The new strip passes the vertex on this other side. Steps 3 and 4 are
//                repeated until there are no such bends, or the path does not become shorter. If a
//                shortest path is asked for, a second search looks for a strip with a shorter path
//                (shortest_strip.h)
//  5. read off   appends the points of the path. First, these are the vertices where the path
//                bends. Second, if the path crosses a side closer to one of its ends than 2^-40
//                times the length of the side, this end is appended. Where the path crosses a side
//                away from these vertices, the crossing point is appended. It is stored by its
//                parameter t on the side. If the faces between two such vertices are coplanar, t is
//                exact; otherwise t is a double (unfolded_strip.h)
//
// Steps 1 to 4 are computed in doubles. Rounding can only affect the choice of the path. From step
// 5 on, the chosen path is represented exactly, and is never traced again. If several paths are
// locally shortest (or shortest), any of them may be chosen. The same input always gives the same
// path. Design: docs/design/surface.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/strip/face_strip.h"
#include "plumb/surface/strip/shortest_strip.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Selects the kind of path that a tracer finds.
enum class PathChoice : std::uint8_t {
  Local,    ///< A locally shortest path near the strip that a quick search finds.
  Shortest  ///< A shortest path: no other path is shorter by more than 2^-40 of its length.
};

/// Traces paths between points of a mesh.
class Tracer {
 public:
  /// Makes a tracer for the mesh. The mesh must outlive the tracer. Cost: O(n) for n vertices.
  explicit Tracer(const SurfaceMesh& mesh, PathChoice choice = PathChoice::Local);
  /// A moved-from tracer may only be destroyed. There is no copy constructor, because finder_
  /// refers to positions_.
  Tracer(Tracer&&) = default;

  /// Returns a path from a to b, and appends the inner points of the path to `points`. Both a and b
  /// are rows of `points`. Returns no value if a and b lie on different components. Requires that
  /// `points` is a table over the same mesh. trace(b, a) returns the same path in reverse. Two
  /// points in the same face are joined by a segment. The cost is the cost of finding the strip
  /// (StripFinder), plus the length of the strip for each repetition of steps 3 and 4. If the path
  /// choice is Shortest, the cost of ShortestStripFinder::find() is added. Throws the errors of the
  /// Context.
  std::optional<SurfacePath> trace(SurfacePointTable& points, SurfacePointId a, SurfacePointId b,
                                   Context& context = unlimited_context());

  /// Returns the positions of the vertices, scaled by a power of two so that no product overflows.
  const std::vector<Point3>& positions() const { return positions_; }

 private:
  std::optional<SurfacePath> trace_upward(SurfacePointTable& points, SurfacePointId a,
                                          SurfacePointId b, Context& context);
  FaceStrip chosen_strip(const StripEnd& from, const StripEnd& to, Context& context);
  FaceStrip tightened(FaceStrip strip, const StripEnd& from, const StripEnd& to, Context& context);

  const SurfaceMesh& mesh_;
  std::vector<Point3> positions_;
  StripFinder finder_;
  std::optional<ShortestStripFinder> shortest_finder_;  // If shortest paths are asked for.
};

/// Returns the length of a path whose points are rows of `points`, in the units of the mesh. The
/// segments are measured in doubles. A path of one point has length 0.
double path_length(const SurfacePointTable& points, const SurfacePath& path);
/// Returns the length of polygon p, in the units of the mesh.
double polygon_length(const SurfacePolygons& polygons, std::size_t p);

/// Appends the closed polygon through the control points in `control`, which are rows of
/// `polygons.points`. Consecutive control points are joined by traced paths. Returns no value on
/// success. On failure, appends no polygon, and returns the index of the first control point from
/// which no path leads to the next control point. For each control point, `named` contains a face
/// in which the control point lies. If the next control point lies in this face, too, the two
/// points are joined by a segment in this face. Two consecutive control points can lie in several
/// common faces. It makes no difference which of these faces is named, except in a component of two
/// triangles that share all their edges. Throws the errors of the Context.
std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              std::span<const FaceId> named,
                                              SurfacePolygons& polygons,
                                              Context& context = unlimited_context());
/// Appends a closed polygon through control points, like the function above, but without named
/// faces.
std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              SurfacePolygons& polygons,
                                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
