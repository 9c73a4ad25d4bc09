// Traces geodesics between points of a mesh: locally shortest paths.
//
// Notation: a strip is a sequence of faces in which each face shares a side with the next one.
// These sides are the doors of the strip (face_strip.h). A bend is a vertex at which the shortest
// path in a strip turns.
//
// Main flow of Tracer::trace:
//  1. order      starts at the lower point, and reverses the path at the end if necessary
//  2. find       finds a strip over the dual graph whose length, measured by the centroids of its
//                faces, is short (face_strip.h)
//  3. tighten    lays the strip out in the plane, and finds the shortest path in it by a funnel
//                (unfolded_strip.h)
//  4. flip       leads the strip around the other side of each bend, if the angle on that side is
//                less than half a turn; repeats steps 3 and 4 until there are no such bends or the
//                path does not become shorter
//  5. read off   appends the points of the path. These are the vertices where the path bends, the
//                vertices that it would pass within 2^-40 of a side's length, and a parameter t for
//                each other side that is crossed. The parameter is exact where the faces between
//                two such vertices are coplanar; otherwise it is a double (unfolded_strip.h)
//
// Steps 1 to 4 are computed in doubles, which only choose a path. From step 5 on the chosen path is
// exact, and it is never traced again. If several paths are locally shortest, any of them may be
// chosen, but always the same path. Design: docs/design/surface.md.
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
  /// Makes a tracer for the mesh. The mesh must outlive the tracer. O(n).
  explicit Tracer(const SurfaceMesh& mesh);
  /// A moved-from tracer may only be destroyed. Tracers are not copied, because finder_ refers to
  /// positions_.
  Tracer(Tracer&&) = default;

  /// Returns a path from a to b, which are rows of `points`, and appends the points between them to
  /// `points`. Returns no value if a and b lie on different components. Requires that `points` is a
  /// table over the same mesh. trace(b, a) is the same path reversed. Two points in one face are
  /// joined by a segment. Costs as much as finding the strip (StripFinder), plus the length of the
  /// strip for each round of flips. Throws what the context throws.
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

/// Appends the closed polygon through control points, which are rows of `polygons.points`, joined
/// by traced paths. Returns no value on success. On failure, appends no polygon and returns the
/// index of the first control point from which no path leads to the next one. For each control
/// point, `named` has a face that contains it. If this face contains the next control point, too,
/// the two points are joined by a segment in this face. (The choice among common faces matters only
/// in a component of two triangles that share all edges.) Throws what the context throws.
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
