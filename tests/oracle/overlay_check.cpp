#include "oracle/overlay_check.h"

#include <optional>

#include "oracle/nef2_check.h"
#include "plane/checked.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb::testing {
namespace {

Rational area_of(const MapReport& report, const MapRegion& region) {
  Rational doubled = twice_polygon_area(report.map.points, report.map.cycle(*region.outer));
  for (const std::uint32_t hole : region.holes) {
    doubled += twice_polygon_area(report.map.points, report.map.cycle(hole));
  }
  return doubled / 2;
}

/// The first region whose cells do not have its area.
std::string wrong_region(const MapReport& report, const std::vector<Rational>& areas,
                         const char* map) {
  for (std::size_t r = 1; r < report.regions.size(); ++r) {
    if (areas[r] == area_of(report, report.regions[r])) continue;
    return "the area of region " + std::to_string(r) + " of the " + map + " map";
  }
  return {};
}

// The cycles of a region as chains.
std::vector<Chain> rings_of(const TestMap& map, const MapRegion& region) {
  std::vector<std::uint32_t> cycles = region.holes;
  if (region.outer) cycles.push_back(*region.outer);
  std::vector<Chain> rings;
  for (const std::uint32_t c : cycles) {
    Chain& ring = rings.emplace_back();
    for (const std::uint32_t v : map.cycles[c]) ring.push_back(map.points[v]);
  }
  return rings;
}

}  // namespace

std::vector<std::uint32_t> regions_of(const MapReport& report, const LineCells& cells) {
  const TestMap map = from_map(report.map);
  std::vector<std::uint32_t> region(cells.size(), 0);
  for (std::uint32_t r = 1; r < report.regions.size(); ++r) {
    const SetPolygons set{rings_of(map, report.regions[r]), WindingRule::NonZero, Boundary::Open};
    const CellMarks inside = marks_of(PlaneSet{set}, cells);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (inside[c]) region[c] = r;
    }
  }
  return region;
}

void add_edges(const TestMap& map, CurveScene& scene) {
  for (const Cycle& cycle : map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const ExactPoint& p = map.points[cycle[i]];
      const ExactPoint& q = map.points[cycle[(i + 1) % cycle.size()]];
      scene.curves.push_back({p, q, p, q});
    }
  }
}

std::string areas_that_differ(const MapReport& first, const MapReport& second,
                              const MapOverlay& overlay) {
  std::vector<Rational> in_first(first.regions.size());
  std::vector<Rational> in_second(second.regions.size());
  for (std::size_t i = 0; i < overlay.origin.size(); ++i) {
    const std::optional<Rational> area = face_area(overlay.complex, FaceId(i));
    const MapOverlay::Origin origin = overlay.origin[i];
    if (!area) {
      if (origin != MapOverlay::Origin{0, 0}) return "an unbounded cell in a bounded region";
      continue;
    }
    if (*area <= 0) return "a cell without area";
    in_first[origin.first] += *area;
    in_second[origin.second] += *area;
  }
  const std::string wrong = wrong_region(first, in_first, "first");
  return wrong.empty() ? wrong_region(second, in_second, "second") : wrong;
}

std::string overlay_disagreement(const TestMap& one, const TestMap& two) {
  const MapReport first = checked(one), second = checked(two);
  if (first.verdict != MapVerdict::Valid || second.verdict != MapVerdict::Valid) {
    return "a subdivision is no valid map";
  }
  Context context;
  const MapOverlay overlay = overlay_maps(first, second, context);
  if (const auto flaw = audit(overlay.complex, AuditForm::Any))
    return flaw->invariant + " at " + flaw->place;
  if (overlay.origin.size() != overlay.complex.face_count()) return "not one origin for each face";
  CurveScene scene;
  add_edges(one, scene);
  add_edges(two, scene);
  const LineCells cells(lines_of(scene));
  const PlaneGraph graph = arrangement_graph(cells, scene);
  const GraphMatch found = match(overlay.complex, graph, cells);
  if (!found.difference.empty()) return found.difference;
  const std::vector<std::uint32_t> in_first = regions_of(first, cells);
  const std::vector<std::uint32_t> in_second = regions_of(second, cells);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].dimension != 2) continue;
    const FaceId f = found.face[graph.element_of[c].index];
    if (overlay.origin[f.value()] != MapOverlay::Origin{in_first[c], in_second[c]}) {
      return "the regions at " + to_text(cells[c].point);
    }
  }
  return areas_that_differ(first, second, overlay);
}

}  // namespace plumb::testing
