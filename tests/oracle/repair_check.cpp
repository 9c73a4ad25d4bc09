#include "oracle/repair_check.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/space/repair_mesh.h"

namespace plumb::testing {
namespace {

using Spot = std::array<double, 3>;

Spot spot_of(const PolygonMesh& mesh, std::uint32_t v) {
  return {mesh.points[v].x, mesh.points[v].y, mesh.points[v].z};
}
Spot spot_difference(const Spot& a, const Spot& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// A mesh of the faces of a program. All points of the grid are there.
PolygonMesh mesh_of_records(std::span<const std::uint8_t> program) {
  PolygonMesh mesh;
  for (int i = 0; i < 54; ++i) {
    const double off = i < 27 ? 0 : 0.25;
    mesh.points.push_back({i % 3 + off, i / 3 % 3 + 0.0, i / 9 % 3 + 0.0});
  }
  std::vector<std::uint32_t> face;
  for (std::size_t i = kRepairRecord; i + kRepairRecord <= program.size(); i += kRepairRecord) {
    face.clear();
    const std::size_t corners = program[i] % 8;
    for (std::size_t k = 1; k <= corners && k < kRepairRecord; ++k) {
      face.push_back(program[i + k] % 54);
    }
    mesh.add_face(face);
    std::ranges::reverse(face);
    if (program[i] >= 200) mesh.add_face(face);
  }
  return mesh;
}

RepairOptions options_of_record(std::span<const std::uint8_t> record) {
  RepairOptions options;
  options.weld = record[0] % 3 == 0 ? 0.25 * (record[1] % 3) : 0;
  options.doubled = static_cast<DoubledFaces>(record[2] % 3);
  options.reorient = record[3] % 2 == 0;
  options.fill_holes = record[4] % 2 == 0 ? 0 : record[4] / 2;
  return options;
}

std::string report_flaw(const PolygonMesh& before, const PolygonMesh& after,
                        const RepairOptions& options, const RepairReport& report) {
  if (report.is_closed() != is_balanced_by_places(after)) return "the holes are not those of edges";
  if (report.farthest > options.weld) return "a point moved farther than the tolerance";
  for (const Point3& p : after.points) {
    if (std::ranges::find(before.points, p) == before.points.end()) return "a point is new";
  }
  for (std::uint32_t v = 0; v < after.points.size(); ++v) {
    if (std::ranges::find(after.corners, v) == after.corners.end()) return "a point is not used";
  }
  if (!options.reorient && options.fill_holes == 0 && !report.flipped.empty()) {
    return "faces were turned, which was not asked for";
  }
  const std::size_t dropped = report.degenerate.size() + report.doubled.size();
  if (after.face_count() != before.face_count() - dropped + report.added) {
    return "the number of faces is not that of the report";
  }
  for (const std::uint32_t edges : report.filled) {
    if (edges > options.fill_holes) return "a hole was filled that is too large";
  }
  return "";
}

}  // namespace

bool is_balanced_by_places(const PolygonMesh& mesh) {
  std::vector<Spot> spots;
  for (const std::uint32_t v : mesh.corners) spots.push_back(spot_of(mesh, v));
  std::ranges::sort(spots);
  spots.erase(std::unique(spots.begin(), spots.end()), spots.end());
  std::map<std::pair<Spot, Spot>, int> balance;
  const auto run = [&](const Spot& a, const Spot& b) {
    const Spot along = spot_difference(b, a);
    std::vector<std::pair<double, Spot>> stops;  // With their places along the edge.
    for (const Spot& p : spots) {
      const Spot to = spot_difference(p, a);
      const double at = plumb::dot(along, to);
      if (plumb::cross(along, to) == Spot{} && at >= 0 && at <= plumb::dot(along, along)) {
        stops.emplace_back(at, p);
      }
    }
    std::ranges::sort(stops);
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const Spot &p = stops[i - 1].second, &q = stops[i].second;
      balance[std::minmax(p, q)] += p < q ? 1 : -1;
    }
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Spot a = spot_of(mesh, face[i]), b = spot_of(mesh, face[(i + 1) % face.size()]);
      if (a != b) run(a, b);
    }
  }
  return std::ranges::all_of(balance, [](const auto& edge) { return edge.second == 0; });
}

std::string repair_of_program_disagreement(std::span<const std::uint8_t> program) {
  if (program.size() < kRepairRecord) return "";
  const PolygonMesh before = mesh_of_records(program);
  const RepairOptions options = options_of_record(program);
  PolygonMesh after = before;
  const RepairReport report = repair_mesh(after, options);
  if (std::string flaw = report_flaw(before, after, options, report); !flaw.empty()) return flaw;
  const PolygonMesh once = after;
  const RepairReport again = repair_mesh(after, options);
  if (report.is_closed() && !again.is_closed()) return "mending again opens the mesh";
  if (again.welded > 0 || !again.degenerate.empty() || again.trimmed > 0) {
    return "mending again welds or drops something";
  }
  return once.points == after.points ? "" : "mending again changes points";
}

}  // namespace plumb::testing
