// Polylines on a surface: what a tracer makes, what is cut, and what borders are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/surface/surface_point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A traced polyline. Segment i runs straight from points[i] to points[i + 1] in faces[i], which both lie
/// in. (Along an edge either face will do.) One point and no face: a path of length zero.
struct SurfacePath {
  std::vector<SurfacePointId> points;  ///< one after another
  std::vector<FaceId> faces;  ///< the face that the segment from points[i] to points[i + 1] runs in
};

/// Closed polygons over one table of points, in flat arrays. Polygon p has the entries from begin[p] on;
/// segment i of it runs in face[i] from point[i] to the next, the last one back to the first. Points may follow
/// themselves. Left of a polygon is where it winds around counter-clockwise.
struct SurfacePolygons {
  explicit SurfacePolygons(const SurfaceMesh& mesh)
      : points(mesh) {}  ///< None yet, over that mesh.

  SurfacePointTable points;                ///< shared by all polygons
  std::vector<std::uint32_t> begin = {0};  ///< size() + 1 entries
  std::vector<SurfacePointId> point;       ///< per entry
  std::vector<FaceId> face;                ///< per entry: where the segment to the next one runs
  std::vector<std::uint8_t> is_control;    ///< given by whoever drew it, not by crossing an edge

  std::size_t size() const { return begin.size() - 1; }  ///< How many polygons there are.
  /// The entry after i in polygon p.
  std::uint32_t next(std::size_t p, std::uint32_t i) const {
    return i + 1 == begin[p + 1] ? begin[p] : i + 1;
  }
  /// The points of a polygon, in order.
  std::span<const SurfacePointId> points_of(std::size_t p) const {
    return std::span(point).subspan(begin[p], begin[p + 1] - begin[p]);
  }

  /// Appends a segment to the polygon being made.
  void add_segment(SurfacePointId from, FaceId in, bool from_is_control);
  /// Appends all segments of a path between two control points.
  void add_leg(const SurfacePath& leg);
  /// Ends the polygon being made; the last segment leads back to its first point. A polygon with no
  /// segments is allowed.
  void close();
};

/// Throws Error{BadArgument} with polygon and segment unless every segment's ends lie in its face. O(n).
void require_valid(const SurfacePolygons& polygons);

}  // namespace plumb
#pragma GCC visibility pop
