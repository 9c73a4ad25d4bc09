// The texts of defects and warnings, with exact places.
//
// Each defect names its faces and edges, the exact point with the nearest doubles, and a hint about
// its repair (map_hints.h). Faces and vertices are counted from 1 in texts. docs/maps.md describes
// the kinds.
//
// Tested by tests/plane/map_describe_test.cpp and tests/plane/map_check_test.cpp.

#include "plumb/plane/check/map_describe.h"

#include <algorithm>
#include <string>
#include <utility>

#include "plumb/plane/check/map_hints.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kMaxListedCycles = 16;  // The greatest number of cycles in one mixed defect.

// Writes all defects, kind by kind, until the report is full.
class DefectWriter {
 public:
  DefectWriter(const MapFindings& findings, std::uint64_t max_defects, MapReport& report)
      : findings_(findings),
        max_(max_defects),
        report_(report),
        points_(report.map.points),
        hints_(findings, report.map) {}

  void run() {
    add_duplicates();
    if (findings_.open_is_defect) add_open();
    add_crossings();
    add_twins();
    add_mixed();
    add_nested();
  }

 private:
  void add_duplicates();
  void add_open();
  void add_crossings();
  void add_twins();
  void add_mixed();
  void add_nested();

  bool is_full() const { return report_.defects.size() >= max_; }
  void push(MapDefect defect, RationalPoint2 place);
  RationalPoint2 midpoint(std::uint32_t u, std::uint32_t v) const;
  MapEdge directed(std::uint32_t h) const { return {edges().origin(h), edges().target(h)}; }
  MapEdge undirected(std::uint32_t e) const { return {edges().ends[e].from, edges().ends[e].to}; }
  const MapEdges& edges() const { return findings_.edges; }

  RationalPoint2 place_of(const EdgeContact& contact) const;

  const MapFindings& findings_;
  std::uint64_t max_;
  MapReport& report_;
  const PointTable2& points_;
  MapHints hints_;
};

void DefectWriter::push(MapDefect defect, RationalPoint2 place) {
  std::sort(defect.cycles.begin(), defect.cycles.end());
  defect.cycles.erase(std::unique(defect.cycles.begin(), defect.cycles.end()), defect.cycles.end());
  defect.near = {nearest_double(place.x), nearest_double(place.y)};
  defect.point = std::move(place);
  report_.defects.push_back(std::move(defect));
}

RationalPoint2 DefectWriter::midpoint(std::uint32_t u, std::uint32_t v) const {
  const RationalPoint2 p = points_.exact(u);
  const RationalPoint2 q = points_.exact(v);
  return {(p.x + q.x) / 2, (p.y + q.y) / 2};
}

// ---------------------------------------------------------------- duplicate, open

void DefectWriter::add_duplicates() {
  for (const MapEdges::ExtraUse& use : edges().extra_uses) {
    if (is_full()) return;
    const std::uint32_t first = edges().cycle_of[use.halfedge];
    const MapEdge e = directed(use.halfedge);
    push({DefectKind::Duplicate, {first, use.cycle}, {e}, {}, {}, hints_.duplicate(use)},
         midpoint(e.from, e.to));
  }
}

void DefectWriter::add_open() {
  for (std::uint32_t h = 0; h < edges().halfedge_count() && !is_full(); ++h) {
    if (!edges().is_open(h)) continue;
    const MapEdge e = directed(h);
    push({DefectKind::Open, {edges().cycle_of[h]}, {e}, {}, {}, hints_.open(h)},
         midpoint(e.from, e.to));
  }
}

// ---------------------------------------------------------------- crossing

RationalPoint2 DefectWriter::place_of(const EdgeContact& contact) const {
  return contact.crossing ? exact(points_, *contact.crossing) : points_.exact(contact.vertex);
}

void DefectWriter::add_crossings() {
  for (const EdgeContact& contact : findings_.contacts.described) {
    if (is_full()) return;
    MapDefect defect{DefectKind::Crossing, cycles_at(edges(), contact.edge_a), {}, {}, {}, {}};
    const std::vector<std::uint32_t> more = cycles_at(edges(), contact.edge_b);
    defect.cycles.insert(defect.cycles.end(), more.begin(), more.end());
    defect.edges = {undirected(contact.edge_a), undirected(contact.edge_b)};
    defect.hint = hints_.crossing(contact);
    push(std::move(defect), place_of(contact));
  }
}

// ---------------------------------------------------------------- twin, mixed, nested

void DefectWriter::add_twins() {
  for (std::uint32_t e = 0; e < edges().edge_count() && !is_full(); ++e) {
    const std::uint32_t cycle = edges().cycle_on_both_sides(e);
    if (cycle == MapEdges::kNoCycle) continue;
    const MapEdge edge = undirected(e);
    push({DefectKind::Twin, {cycle}, {edge}, {}, {}, hints_.twin(e, cycle)},
         midpoint(edge.from, edge.to));
  }
}

void DefectWriter::add_mixed() {
  for (const MapOrbits::Orbit& orbit : findings_.orbits.orbits) {
    if (is_full()) return;
    if (!orbit.mixed) continue;
    std::vector<std::uint32_t> cycles =
        cycles_of_orbit(edges(), findings_.contacts.rotation, orbit.halfedge);
    MapDefect defect{DefectKind::Mixed, {}, {directed(orbit.halfedge)}, {}, {}, {}};
    defect.hint = hints_.mixed(orbit, cycles);
    if (cycles.size() > kMaxListedCycles) cycles.resize(kMaxListedCycles);
    defect.cycles = std::move(cycles);
    push(std::move(defect), points_.exact(edges().origin(orbit.halfedge)));
  }
}

void DefectWriter::add_nested() {
  for (const NestedComponent& nested : findings_.nested) {
    if (is_full()) return;
    const std::uint32_t outside = findings_.orbits.outside[nested.component];
    const std::uint32_t h = findings_.orbits.orbits[outside].halfedge;
    const bool inside_is_listed = edges().cycle_of[h ^ 1U] != MapEdges::kNoCycle;
    const std::uint32_t inner = edges().cycle_of[inside_is_listed ? h ^ 1U : h];
    MapDefect defect{DefectKind::Nested, {nested.container, inner}, {directed(h)}, {}, {}, {}};
    defect.hint = hints_.nested(nested, inner);
    push(std::move(defect), points_.exact(edges().origin(h)));
  }
}

void spell_out(const std::vector<std::uint32_t>& vertices, WarningKind kind, const char* text,
               std::uint64_t max_warnings, MapReport& report) {
  for (std::size_t i = 0; i < vertices.size() && i < max_warnings; ++i) {
    report.warnings.push_back({kind, vertices[i], "vertex " + number(vertices[i]) + text});
  }
  if (vertices.size() > max_warnings) {
    const std::uint64_t more = vertices.size() - max_warnings;
    report.warnings.push_back(
        {kind, vertices.back(), "and " + std::to_string(more) + " more such vertices"});
  }
}

std::vector<std::uint32_t> isolated_vertices(const MapFindings& findings) {
  std::vector<std::uint32_t> isolated;
  for (std::uint32_t v = 0; v < findings.components.of_vertex.size(); ++v) {
    const bool has_edges = findings.components.of_vertex[v] != MapComponents::kNoComponent;
    const bool was_merged = std::binary_search(findings.merged.begin(), findings.merged.end(), v);
    if (!has_edges && !was_merged) isolated.push_back(v);
  }
  return isolated;
}

}  // namespace

std::vector<std::uint32_t> cycles_at(const MapEdges& edges, std::uint32_t edge) {
  std::vector<std::uint32_t> cycles = edges.uses(2 * edge);
  const std::vector<std::uint32_t> backward = edges.uses(2 * edge + 1);
  cycles.insert(cycles.end(), backward.begin(), backward.end());
  return cycles;
}

void describe_defects(const MapFindings& findings, std::uint64_t max_defects, MapReport& report) {
  DefectWriter(findings, max_defects, report).run();
}

void describe_warnings(const MapFindings& findings, std::uint64_t max_warnings, MapReport& report) {
  spell_out(findings.merged, WarningKind::MergedVertex,
            " was merged into a lower-numbered vertex with equal coordinates", max_warnings,
            report);
  for (const std::uint32_t cycle : findings.inferred) {
    report.warnings.push_back({WarningKind::InferredOuter, cycle,
                               "outer boundary of " +
                                   std::to_string(report.map.cycle(cycle).size()) +
                                   " edges was inferred as face " + number(cycle)});
  }
  if (!findings.orbits.orbits.empty()) {
    spell_out(find_pinches(report.map, findings.edges, findings.orbits), WarningKind::Pinch,
              " is a pinch: a face touches itself there", max_warnings, report);
  }
  spell_out(isolated_vertices(findings), WarningKind::IsolatedVertex, " is used by no face",
            max_warnings, report);
}

}  // namespace plumb
