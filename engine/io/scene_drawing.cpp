#include "plumb/io/scene_drawing.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/io/text_cursor.h"
#include "plumb/io/with_place.h"
#include "plumb/surface/exponential_map.h"

namespace plumb {
namespace {

constexpr std::uint64_t kPointBytes = 96;  // of a control point, in tables and lists
constexpr std::size_t kPointsPerCheckpoint = 256;

/// Points of the surface for all points of the drawing.
std::vector<SurfacePointId> placed_points(const DrawingFile& file, const ExponentialMap& map,
                                          double scale, SurfacePointTable& points,
                                          Context& context) {
  const SvgDrawing& drawing = file.drawing;
  TextCursor cursor(file.text, file.name);
  std::vector<SurfacePointId> placed;
  for (std::size_t i = 0; i < drawing.points.size(); ++i) {
    if (i % kPointsPerCheckpoint == 0) context.checkpoint("draw", i, drawing.points.size());
    cursor.move_to(file.text.data() + drawing.places[i]);
    const Point2 p = drawing.points[i];
    const auto at = with_place(cursor, [&] {
      context.charge_memory(kPointBytes, "drawings on the surface");
      return map.add({scale * p.x, scale * p.y}, points, context);
    });
    if (!at) cursor.fail(ErrorCode::BadShape, "what is drawn here lies beyond the border");
    placed.push_back(*at);
  }
  return placed;
}

}  // namespace

void add_drawing(const DrawingFile& file, const ParsedScene::Drawing& how, SurfacePointId centre,
                 FaceId face, Tracer& tracer, SurfaceScene& scene, Context& context) {
  const SvgDrawing& drawing = file.drawing;
  SurfacePolygons& polygons = scene.polygons;
  const ExponentialMap map(polygons.points, centre, face, how.angle);
  const std::vector<SurfacePointId> placed =
      placed_points(file, map, how.scale, polygons.points, context);
  for (std::size_t s = 0; s < drawing.shape_count(); ++s) {
    std::vector<std::uint32_t>& shape = scene.shapes->emplace_back();
    for (std::uint32_t r = drawing.shape_begin[s]; r < drawing.shape_begin[s + 1]; ++r) {
      context.checkpoint("trace", r, drawing.ring_count());
      const auto ring = std::span(placed).subspan(
          drawing.ring_begin[r], drawing.ring_begin[r + 1] - drawing.ring_begin[r]);
      shape.push_back(static_cast<std::uint32_t>(polygons.size()));
      const auto torn = add_traced_polygon(tracer, ring, polygons, context);
      PLUMB_CHECK(!torn);  // lines do not leave their component
    }
  }
}

FaceId farthest_face(const SurfaceMesh& mesh, const Point3& from, FaceId face) {
  FaceId farthest = face;
  double most = -1;
  for (std::uint32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    if (mesh.component(f) != mesh.component(face)) continue;
    const Point3& p = mesh.point(mesh.corner(f, 0));
    const double distance = std::hypot(p.x - from.x, p.y - from.y, p.z - from.z);
    if (distance <= most) continue;
    most = distance;
    farthest = f;
  }
  return farthest;
}

}  // namespace plumb
