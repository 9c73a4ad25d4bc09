#include "generate/surface_program.h"

#include <array>
#include <vector>

#include "oracle/surface_oracle.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/surface_audit.h"
#include "plumb/surface/triangulation.h"

namespace plumb::testing {
namespace {

using Record = std::array<std::uint8_t, kSurfaceRecord>;

std::vector<Record> records_of(std::span<const std::uint8_t> program) {
  std::vector<Record> records;
  for (std::size_t i = 0; i + kSurfaceRecord <= program.size(); i += kSurfaceRecord) {
    records.push_back({program[i], program[i + 1], program[i + 2]});
  }
  if (records.size() > kMostSurfaceRecords) records.resize(kMostSurfaceRecords);
  return records;
}

std::string flat_difference(std::span<const Record> records) {
  constexpr std::int64_t kUnits[] = {1, 2, 3, 4, 10, 64, 1000};
  const Record& head = records.front();
  const std::int64_t unit = kUnits[head[0] % 8];
  FlatScene scene;
  scene.columns = 1 + head[1] % 4U;
  scene.rows = 1 + head[1] / 4 % 4U;
  scene.polygons.emplace_back();
  for (const Record& r : records.subspan(1)) {
    auto& last = scene.polygons.back();
    if (r[0] % 8 == 0) {
      scene.polygons.emplace_back();
    } else if (r[0] % 8 == 1 && !last.empty()) {
      last.push_back(last[r[1] % last.size()]);
    } else if (r[0] % 8 == 2) {
      const auto copy = scene.polygons[r[1] % scene.polygons.size()];
      scene.polygons.push_back(copy);
    } else {
      // Large units reach everywhere with few bytes.
      const std::int64_t step = unit > 64 ? 37 : 1;
      const Rational x = Rational(step * r[1] % (scene.columns * unit + 1)) / unit;
      const Rational y = Rational(step * r[2] % (scene.rows * unit + 1)) / unit;
      last.push_back({x, y});
    }
    std::size_t corners = 0;
    for (const auto& polygon : scene.polygons) corners += polygon.size();
    if (corners > kMostSurfaceRecords) break;  // copies of copies
  }
  return disagreement_on_plane(scene, head[2]);
}

/// Even the vertices of triangles may not be there.
std::string raw_difference(std::span<const Record> records) {
  const std::size_t vertices = 4 + records.front()[1] % 5U;
  std::vector<Point3> points;
  for (std::size_t v = 0; v < vertices; ++v) {
    points.push_back({static_cast<double>(v), static_cast<double>(v * v % 5), 0});
  }
  std::vector<SurfaceTriangle> triangles;
  std::size_t at = 1;
  for (; at < records.size() && records[at][0] % 16 < 12; ++at) {
    const auto corner = [&](std::size_t i) {
      return static_cast<std::uint32_t>(records[at][i] % 16 % (vertices + 1));
    };
    triangles.push_back({corner(0), corner(1), corner(2)});
  }
  const auto mesh = std::make_shared<const SurfaceMesh>(points, triangles);
  SurfaceScene scene{mesh, SurfacePolygons(*mesh), {}, FaceId{}};
  for (; at < records.size(); ++at) {
    const Record& r = records[at];
    if (r[0] % 8 == 7) {
      scene.polygons.close();
      continue;
    }
    SurfacePointTable& table = scene.polygons.points;
    const SurfacePointId p =
        r[0] % 3 == 0   ? table.add_vertex(VertexId(r[1] % (vertices + 1)))
        : r[0] % 3 == 1 ? table.add_on_edge(EdgeId(r[1] % 16U), r[2] / 16 / 8.0)
                        : table.add_in_face(FaceId(r[1] % 8U), r[1] / 32 / 7.0, r[2] / 32 / 7.0);
    scene.polygons.add_segment(
        p, FaceId(r[2] % 16U),
        r[0] % 2 == 0 ? SegmentStart::ControlPoint : SegmentStart::PathPoint);
  }
  scene.polygons.close();
  Context context;
  const SurfaceDivision division(scene, context);
  triangulate_surface(division, context);
  return audit(division).value_or("");
}

}  // namespace

std::string disagreement_on_surface(std::span<const std::uint8_t> program) {
  const std::vector<Record> records = records_of(program);
  if (records.empty()) return "";
  if (records.front()[0] % 8 < 7) return flat_difference(records);
  try {
    return raw_difference(records);
  } catch (const Error&) {
    return "";  // refused
  }
}

}  // namespace plumb::testing
