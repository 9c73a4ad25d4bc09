// The reader of drawings on arbitrary bytes, and where drawings lie on a surface.
//
// The first byte chooses the tolerance, the place and the mesh; the rest is the file. Either the
// reader throws an Error that names the file, a line and a column inside it, or rings of two points
// or more, finite ones; what it takes is in proportion to the file. On a flat mesh their points lie
// where a similarity puts them, or beyond the border and are refused; elsewhere lines to them end
// in the mesh, and the rings are polygons.

#include "plumb/io/svg_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "generate/surface_meshes.h"
#include "plumb/base/internal/degrees.h"
#include "plumb/surface/exponential_map.h"
#include "plumb/surface/surface_path.h"
#include "plumb/surface/trace.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace {

using namespace plumb;
using namespace plumb::fuzz;

constexpr std::size_t kMostText = 1U << 14U;
constexpr std::size_t kMostRings = 20;
constexpr std::size_t kMostPoints = 200;
constexpr double kClose = 1e-9;
// What a drawing may be charged at most: a chord of a curve takes 48 bytes; there may be 2^20 of
// them, and one more for every 8 bytes. An attribute takes 64 bytes from 5, a point 48 from 2.
constexpr std::size_t kBytesOfChords = std::size_t{48} << 20U;
constexpr std::size_t kBytesPerByte = 48 / 8 + 48;

void require_rings(const SvgDrawing& drawing, std::string_view text) {
  require(drawing.places.size() == drawing.points.size(), "every point has a place");
  require(drawing.ring_begin.back() == drawing.points.size(), "rings have all points");
  require(drawing.shape_begin.back() == drawing.ring_count(), "shapes have all rings");
  for (std::size_t r = 0; r < drawing.ring_count(); ++r) {
    require(drawing.ring(r).size() >= 2, "a ring has two points");
  }
  for (const Point2& p : drawing.points) {
    require(std::isfinite(p.x) && std::isfinite(p.y), "points are finite");
  }
  for (const std::size_t place : drawing.places) {
    require(place < text.size(), "places lie in the text");
  }
}

/// A square of 4 x 4, turned by some degrees, and a centre in the lower face right of its middle or
/// on the side of that.
struct FlatPlace {
  FlatPlace(double degrees, double u, double v)
      : turn(unit_vector(degrees)), mesh(turned(turn)), u(u), v(v) {}
  static SurfaceMesh turned(const Point2& turn) {
    const SurfaceMesh grid = plumb::testing::grid_surface(4);
    std::vector<Point3> points;
    std::vector<SurfaceTriangle> triangles;
    for (std::uint32_t i = 0; i < grid.vertex_count(); ++i) {
      const Point3& p = grid.point(VertexId(i));
      points.push_back({turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y, 0});
    }
    for (std::uint32_t f = 0; f < grid.face_count(); ++f)
      triangles.push_back(grid.corners(FaceId(f)));
    return {std::move(points), std::move(triangles)};
  }
  Point2 turned_back(const Point3& p) const {
    return {turn.x * p.x + turn.y * p.y, turn.x * p.y - turn.y * p.x};
  }

  Point2 turn;
  SurfaceMesh mesh;
  double u, v;
};

void judge_flat(const FlatPlace& place, const SvgDrawing& drawing) {
  SurfacePointTable points(place.mesh);
  const FaceId face(2 * (4 * 2 + 2));
  const ExponentialMap map(points, points.add_in_face(face, place.u, place.v), face, 0);
  Context context;
  for (std::size_t i = 0; i < std::min(drawing.points.size(), kMostPoints); ++i) {
    const Point2 p = drawing.points[i];
    const Point2 to{2 + place.u + place.v + p.x, 2 + place.v + p.y};
    const double reach = std::max(std::fabs(to.x - 2), std::fabs(to.y - 2));
    if (reach > 1e3) continue;
    const auto at = map.add(p, points, context);
    if (std::fabs(reach - 2) > kClose)
      require(at.has_value() == (reach < 2), "what is on the mesh");
    if (!at) continue;
    const Point2 there = place.turned_back(points.position(*at));
    require(std::hypot(there.x - to.x, there.y - to.y) < kClose, "a similarity");
  }
}

void judge_on(const SurfaceMesh& mesh, const SvgDrawing& drawing) {
  SurfacePolygons polygons(mesh);
  const FaceId face(3);
  const ExponentialMap map(polygons.points, polygons.points.add_in_face(face, .25, .25), face, 10);
  Tracer tracer(mesh);
  Context context;
  for (std::size_t r = 0; r < std::min(drawing.ring_count(), kMostRings); ++r) {
    std::vector<SurfacePointId> ring;
    for (const Point2& p : drawing.ring(r)) {
      if (ring.size() == kMostPoints || std::hypot(p.x, p.y) > 100) break;
      const auto at = map.add(p, polygons.points, context);
      require(at.has_value(), "closed meshes have no border");
      ring.push_back(*at);
    }
    require(!add_traced_polygon(tracer, ring, polygons, context), "rings are polygons");
  }
  require_valid(polygons);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  begin_input();
  static const std::array<SurfaceMesh, 2> kMeshes{plumb::testing::torus_surface(6, 5, .4),
                                                  plumb::testing::sphere_surface(0)};
  static const std::array<FlatPlace, 4> kPlaces{
      {{0, 0, 0}, {20, .5, 0}, {50, 0, 1. / 3}, {77, .25, .75}}};
  if (size == 0 || size > kMostText) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::optional<double> tolerance =
      (data[0] & 1U) != 0 ? std::optional(0.01 * (1 + data[0] / 16)) : std::nullopt;
  Limits limits;
  limits.max_memory_bytes = kBytesOfChords + kBytesPerByte * text.size();
  Context context(limits);
  try {
    const SvgDrawing drawing = read_svg(text, {kFileName, false}, tolerance, context);
    if (drawing.ring_count() > 0) oracle_reached();
    require_rings(drawing, text);
    for (const FlatPlace& place : kPlaces) judge_flat(place, drawing);
    if ((data[0] & 2U) != 0) judge_on(kMeshes[data[0] / 4 % 2], drawing);
  } catch (const Error& error) {
    require(error.message().find("memory limit") == std::string::npos,
            "memory charged is in proportion to the input");
    require_place(error, text);
  }
  return 0;
}
