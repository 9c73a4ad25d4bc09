#include "plumb/surface/surface_path.h"

#include <string>

#include "plumb/base/error.h"

namespace plumb {

void SurfacePolygons::add_segment(SurfacePointId from, FaceId in, bool from_is_control) {
  point.push_back(from);
  face.push_back(in);
  is_control.push_back(from_is_control ? 1 : 0);
}

void SurfacePolygons::add_leg(const SurfacePath& leg) {
  for (std::size_t i = 0; i < leg.faces.size(); ++i) {
    add_segment(leg.points[i], leg.faces[i], i == 0);
  }
}

void SurfacePolygons::close() { begin.push_back(static_cast<std::uint32_t>(point.size())); }

void require_valid(const SurfacePolygons& polygons) {
  const SurfacePointTable& points = polygons.points;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    for (std::uint32_t i = polygons.begin[p]; i < polygons.begin[p + 1]; ++i) {
      const FaceId f = polygons.face[i];
      const auto is_good = [&](SurfacePointId q) {
        return q.value() < points.size() && points.is_in(q, f);
      };
      if (f.value() < points.mesh().face_count() && is_good(polygons.point[i]) &&
          is_good(polygons.point[polygons.next(p, i)])) {
        continue;
      }
      throw Error(ErrorCode::BadArgument, "polygon " + std::to_string(p) + ", segment " +
                                              std::to_string(i - polygons.begin[p]) +
                                              ": an end is not in its face");
    }
  }
}

}  // namespace plumb
