// The texts of defects and warnings, with exact places.
//
// Each defect names its faces and edges, the exact point with the nearest doubles, and a hint how
// to mend it. Hints follow from the other findings: an open edge may be a T-junction, if the
// vertices on it are joined by listed edges; a part of a border chain, which is a gap or a missing
// outer boundary by the sign of its area; or a face that is listed the wrong way round. Faces and
// vertices are counted from 1 in texts. docs/maps.md describes the kinds.
//
// Tested by tests/plane/map_check_test.cpp.

#include "plumb/plane/check/map_describe.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kMaxListedCycles = 16;     // The most cycles in one mixed defect.
constexpr std::size_t kMaxSpelledVertices = 12;  // The most vertices in one hint.

std::string number(std::size_t index) { return std::to_string(index + 1); }

std::string edge_name(std::uint32_t from, std::uint32_t to) {
  return number(from) + "-" + number(to);
}

std::string spelled(const std::vector<std::uint32_t>& vertices) {
  std::string text;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i == kMaxSpelledVertices) return text + " ...";
    text += (i == 0 ? "" : " ") + number(vertices[i]);
  }
  return text;
}

// Writes all defects, kind by kind, until there are as many as the report may have.
class DefectWriter {
 public:
  DefectWriter(const MapFindings& findings, std::uint64_t max_defects, MapReport& report)
      : findings_(findings), max_(max_defects), report_(report), points_(report.map.points) {}

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

  std::vector<std::uint32_t> cycles_at(std::uint32_t edge) const;
  std::string open_hint(std::uint32_t h) const;
  std::string covered_by(std::uint32_t h) const;
  std::string chain_hint(std::uint32_t missing) const;
  std::string crossing_hint(const EdgeContact& contact) const;
  RationalPoint2 place_of(const EdgeContact& contact) const;

  const MapFindings& findings_;
  std::uint64_t max_;
  MapReport& report_;
  const PointTable2& points_;
  std::unordered_map<std::uint32_t, std::uint32_t> chain_of_;  // The chain of unlisted half-edges.
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

// Returns all cycles that list an edge, in either direction.
std::vector<std::uint32_t> DefectWriter::cycles_at(std::uint32_t edge) const {
  std::vector<std::uint32_t> cycles = edges().uses(2 * edge);
  const std::vector<std::uint32_t> backward = edges().uses(2 * edge + 1);
  cycles.insert(cycles.end(), backward.begin(), backward.end());
  return cycles;
}

// ---------------------------------------------------------------- duplicate, open

void DefectWriter::add_duplicates() {
  for (const MapEdges::ExtraUse& use : edges().extra_uses) {
    if (is_full()) return;
    const std::uint32_t first = edges().cycle_of[use.halfedge];
    const MapEdge e = directed(use.halfedge);
    MapDefect defect{DefectKind::Duplicate, {first, use.cycle}, {e}, {}, {}, {}};
    defect.hint = first == use.cycle
                      ? "face " + number(first) + " uses the directed edge " +
                            edge_name(e.from, e.to) + " more than once"
                      : "faces " + number(first) + " and " + number(use.cycle) +
                            " both use the directed edge " + edge_name(e.from, e.to) +
                            ": they overlap, or one of them runs the wrong way; remove or reverse "
                            "one";
    push(std::move(defect), midpoint(e.from, e.to));
  }
}

void DefectWriter::add_open() {
  for (std::uint32_t c = 0; c < findings_.chains.size(); ++c) {
    for (const std::uint32_t h : findings_.chains[c].halfedges) chain_of_.emplace(h, c);
  }
  for (std::uint32_t h = 0; h < edges().halfedge_count() && !is_full(); ++h) {
    if (!edges().is_open(h)) continue;
    const MapEdge e = directed(h);
    MapDefect defect{DefectKind::Open, {edges().cycle_of[h]}, {e}, {}, {}, open_hint(h)};
    push(std::move(defect), midpoint(e.from, e.to));
  }
}

std::string DefectWriter::open_hint(std::uint32_t h) const {
  const MapEdge e = directed(h);
  const std::string lead =
      "no face lists " + edge_name(e.to, e.from) + ", the other side of " + edge_name(e.from, e.to);
  const std::string covered = covered_by(h);
  return lead + (covered.empty() ? chain_hint(h ^ 1U) : covered);
}

// Returns the hint for a T-junction, where the other side of an edge is listed in pieces, by way of
// vertices on the edge; empty if it is none.
std::string DefectWriter::covered_by(std::uint32_t h) const {
  const std::uint32_t edge = h / 2;
  const auto& on_edge = findings_.contacts.on_edge;
  const auto less = [](const VertexOnEdge& p, std::uint32_t e) { return p.edge < e; };
  auto it = std::lower_bound(on_edge.begin(), on_edge.end(), edge, less);
  std::vector<std::uint32_t> path = {edges().ends[edge].from};
  for (; it != on_edge.end() && it->edge == edge; ++it) path.push_back(it->vertex);
  if (path.size() == 1) return {};
  if (compare_xy(points_, path[0], edges().ends[edge].to) == Sign::Positive) {
    std::reverse(path.begin() + 1, path.end());
  }
  path.push_back(edges().ends[edge].to);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (edges().find(path[i], path[i + 1]) == edges().edge_count()) return {};
  }
  std::string text;
  for (const std::uint32_t v : path) text += (text.empty() ? "" : "-") + number(v);
  return ": T-junction, edge " + edge_name(path.front(), path.back()) + " is covered by " + text +
         "; insert the vertices between into face " + number(edges().cycle_of[h]);
}

std::string DefectWriter::chain_hint(std::uint32_t missing) const {
  const auto found = chain_of_.find(missing);
  if (found == chain_of_.end()) return ": list the face on that side, or reverse a face";
  const OpenChain& chain = findings_.chains[found->second];
  const std::string cycle = spelled(cycle_of_chain(edges(), chain));
  const std::string size = std::to_string(chain.halfedges.size());
  if (chain.area == Sign::Negative) {
    return ": missing outer boundary of " + size + " edges; list the clockwise cycle " + cycle;
  }
  return ": gap of " + size + " edges in the coverage; list the missing face " + cycle;
}

// ---------------------------------------------------------------- crossing

RationalPoint2 DefectWriter::place_of(const EdgeContact& contact) const {
  return contact.crossing ? exact(points_, *contact.crossing) : points_.exact(contact.vertex);
}

std::string DefectWriter::crossing_hint(const EdgeContact& contact) const {
  const MapEdge a = undirected(contact.edge_a);
  const MapEdge b = undirected(contact.edge_b);
  std::string names = "edges " + edge_name(a.from, a.to) + " and " + edge_name(b.from, b.to);
  switch (contact.kind) {
    case EdgeContact::Kind::Cross:
      return names + " cross: move a vertex, or split both edges at the crossing";
    case EdgeContact::Kind::Touch:
      return names + " touch: vertex " + number(contact.vertex) +
             " lies inside one of them; insert it into the faces there";
    case EdgeContact::Kind::Alias:
      return names +
             " meet at two vertices with equal coordinates: use one vertex, or "
             "--merge-vertices";
    case EdgeContact::Kind::Overlap:
      return names + " overlap from vertex " + number(contact.vertex) +
             " on: insert the vertices of each into the other";
  }
  return names;
}

void DefectWriter::add_crossings() {
  for (const EdgeContact& contact : findings_.contacts.described) {
    if (is_full()) return;
    MapDefect defect{DefectKind::Crossing, cycles_at(contact.edge_a), {}, {}, {}, {}};
    const std::vector<std::uint32_t> more = cycles_at(contact.edge_b);
    defect.cycles.insert(defect.cycles.end(), more.begin(), more.end());
    defect.edges = {undirected(contact.edge_a), undirected(contact.edge_b)};
    defect.hint = crossing_hint(contact);
    push(std::move(defect), place_of(contact));
  }
}

// ---------------------------------------------------------------- twin, mixed, nested

void DefectWriter::add_twins() {
  for (std::uint32_t e = 0; e < edges().edge_count() && !is_full(); ++e) {
    const std::uint32_t cycle = edges().cycle_on_both_sides(e);
    if (cycle == MapEdges::kNoCycle) continue;
    const MapEdge edge = undirected(e);
    MapDefect defect{DefectKind::Twin, {cycle}, {edge}, {}, {}, {}};
    defect.hint = "face " + number(cycle) + " runs along edge " + edge_name(edge.from, edge.to) +
                  " in both directions: remove the spike, or split the face";
    push(std::move(defect), midpoint(edge.from, edge.to));
  }
}

void DefectWriter::add_mixed() {
  for (const MapOrbits::Orbit& orbit : findings_.orbits.orbits) {
    if (is_full()) return;
    if (!orbit.mixed) continue;
    std::vector<std::uint32_t> cycles =
        cycles_of_orbit(edges(), findings_.contacts.rotation, orbit.halfedge);
    MapDefect defect{DefectKind::Mixed, {}, {directed(orbit.halfedge)}, {}, {}, {}};
    const bool several = cycles.size() > 1;
    defect.hint = several ? "one region is bounded by edges of " + std::to_string(cycles.size()) +
                                " listed faces: they overlap, or are listed the wrong way round"
                          : "face " + number(cycles.front()) +
                                " is listed the wrong way round for the region it bounds";
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
    defect.hint = "face " + number(inner) + " lies inside face " + number(nested.container) +
                  ", whose hole is not listed: list the clockwise boundary of the island";
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
