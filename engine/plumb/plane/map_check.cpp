// The check of a map: whether a list of cycles is a planar subdivision.
//
// Main flow of MapChecker::run(): edges are paired (map_edges.h); one sweep finds contacts and the
// rotation system (map_contacts.h); borders that no cycle lists are traced, and outer boundaries
// are inferred if the options ask for it; orbits of the rotation system are the faces that the
// edges really induce, components are nested in them, and rings that touch make regions
// (map_orbits.h). Combinatorial and geometric defects are independent, so all are counted in one
// run; faces are traced only if there is no duplicate, open edge or contact, because only then does
// the rotation system belong to a plane graph. For a defective map, map_claims.h finds which
// regions overlap, because hints must say so. docs/maps.md describes the check.
//
// Tested by tests/plane/map_check_test.cpp, tests/plane/map_check_property_test.cpp and
// tests/plane/map_check_scale_test.cpp.

#include "plumb/plane/map_check.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plumb/plane/check/map_claims.h"
#include "plumb/plane/check/map_contacts.h"
#include "plumb/plane/check/map_describe.h"
#include "plumb/plane/check/map_edges.h"
#include "plumb/plane/check/map_orbits.h"
#include "plumb/plane/map.h"
#include "plumb/plane/sweep/sweep_curves.h"
#include "plumb/predicates/error.h"

namespace plumb {

/// Replaces in every cycle each vertex by the least-numbered one with the same coordinates, and
/// removes repetitions that arise. Vertices keep their numbers. Returns the replaced ones,
/// ascending. Throws Error{DegenerateFace} if a cycle keeps fewer than three corners.
std::vector<std::uint32_t> merge_equal_vertices(Map& map);

namespace {

std::vector<std::uint32_t> representatives(const Map& map) {
  const PointRanks ranks = rank_points(map.points, std::vector<char>(map.vertex_count(), 1));
  std::vector<std::uint32_t> representative(map.vertex_count());
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    representative[v] = ranks.order[ranks.rank[v]];
  }
  return representative;
}

}  // namespace

std::vector<std::uint32_t> merge_equal_vertices(Map& map) {
  const std::vector<std::uint32_t> representative = representatives(map);
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> begin = {0};
  corners.reserve(map.corners.size());
  for (std::size_t c = 0; c < map.cycle_count(); ++c) {
    for (const std::uint32_t v : map.cycle(c)) {
      const std::uint32_t r = representative[v];
      if (corners.size() == begin.back() || corners.back() != r) corners.push_back(r);
    }
    while (corners.size() > begin.back() + 1 && corners.back() == corners[begin.back()]) {
      corners.pop_back();
    }
    if (corners.size() - begin.back() < 3) {
      throw Error(ErrorCode::DegenerateFace,
                  "face " + std::to_string(c + 1) +
                      " collapses when vertices with equal coordinates are merged");
    }
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  map.corners = std::move(corners);
  map.cycle_begin = std::move(begin);
  std::vector<std::uint32_t> merged;
  for (std::uint32_t v = 0; v < representative.size(); ++v) {
    if (representative[v] != v) merged.push_back(v);
  }
  return merged;
}

namespace {

// Measurements show that edges, the sweep over them and orbits take at most 68 bytes for each
// corner, including the map.
constexpr std::uint64_t kBytesPerCorner = 64;
constexpr std::uint64_t kBytesPerVertex = 40;

/// Throws Error{DegenerateFace} or Error{BadIndex} unless every cycle has at least three corners,
/// refers to existing vertices, and has no vertex twice in a row.
void require_well_formed(const Map& map) {
  for (std::size_t c = 0; c < map.cycle_count(); ++c) {
    const auto cycle = map.cycle(c);
    const std::string face = "face " + std::to_string(c + 1);
    if (cycle.size() < 3) {
      throw Error(ErrorCode::DegenerateFace, face + " has fewer than three vertices");
    }
    std::uint32_t previous = cycle.back();
    for (const std::uint32_t v : cycle) {
      if (v >= map.vertex_count()) {
        throw Error(ErrorCode::BadIndex, face + " uses vertex " + std::to_string(v + 1) + " of " +
                                             std::to_string(map.vertex_count()));
      }
      if (v == previous) {
        throw Error(ErrorCode::DegenerateFace,
                    face + " repeats vertex " + std::to_string(v + 1) + " in a row");
      }
      previous = v;
    }
  }
}

/// One check.
class MapChecker {
 public:
  MapChecker(Map map, const MapCheckOptions& options, Context& context)
      : options_(options), context_(context), memory_(context) {
    report_.map = std::move(map);
    findings_.names_places = options.name_places;
  }

  MapReport run();

 private:
  Map& map() { return report_.map; }
  MapDefectCounts& counts() { return report_.counts; }

  void match();
  void classify_open();
  void infer_outer_cycles();
  bool knows_faces() const;
  std::vector<std::uint32_t> claims();
  void count_matching_defects();
  void sweep_contacts();
  void find_claims();
  void trace_faces();
  void settle_mixed(const std::vector<std::uint32_t>& parent);
  std::vector<std::uint32_t> shells_of_cycles(const std::vector<std::uint32_t>& parent) const;
  void find_nested(const std::vector<std::uint32_t>& parent);
  void collect_regions(const std::vector<std::uint32_t>& parent);
  MapVerdict verdict();
  bool ignores_borders() const { return options_.outer == OuterRule::Ignore; }

  MapCheckOptions options_;
  Context& context_;
  MemoryCharge memory_;
  MapReport report_;
  MapFindings findings_;
  // Set by settle_touching_rings(); empty if it was not needed.
  std::vector<std::uint32_t> shells_;
};

MapReport MapChecker::run() {
  memory_.add(kBytesPerCorner * map().corners.size() + kBytesPerVertex * map().vertex_count(),
              "a check of a map");
  require_well_formed(map());
  if (options_.merge_vertices) findings_.merged = merge_equal_vertices(map());
  match();
  sweep_contacts();
  classify_open();
  count_matching_defects();
  trace_faces();
  report_.verdict = verdict();
  if (report_.verdict != MapVerdict::Valid) {
    report_.regions.clear();
    find_claims();
    describe_defects(findings_, options_.max_defects, report_);
  }
  describe_warnings(findings_, options_.max_defects, report_);
  return std::move(report_);
}

void MapChecker::match() {
  context_.checkpoint("match edges", 0, 1);
  findings_.edges = match_twins(map());
  context_.checkpoint("match edges", 1, 1);
}

// ---------------------------------------------------------------- open edges

void MapChecker::classify_open() {
  findings_.open_is_defect = !ignores_borders();
  // If there are duplicate uses, borders have no unique continuation, and the hints remain general.
  if (!findings_.edges.extra_uses.empty() || ignores_borders()) return;
  findings_.chains = trace_open_chains(map(), findings_.edges);
  if (options_.outer == OuterRule::Infer) infer_outer_cycles();
}

// Whether the orbits of the rotation system are the faces of a plane graph. An edge between equal
// points has no direction, so the order around its ends has no meaning.
bool MapChecker::knows_faces() const {
  const std::vector<std::uint32_t>& order = findings_.contacts.rotation.order;
  return findings_.contacts.count == 0 &&
         std::ranges::none_of(findings_.edges.ends,
                              [&](const SweepSegment& e) { return order[e.from] == order[e.to]; });
}

// Returns, for each half-edge, the listed cycle that claims the face on its left, or kNone. Returns
// nothing if faces are not known. The outside of a component is claimed by the region around it.
std::vector<std::uint32_t> MapChecker::claims() {
  if (!knows_faces()) return {};
  const MapEdges& edges = findings_.edges;
  const MapComponents& components = findings_.components;
  const MapRotation& rotation = findings_.contacts.rotation;
  const MapOrbits orbits = trace_orbits(map(), edges, components, rotation);
  const std::vector<std::uint32_t> parent = nest_components(edges, components, rotation, orbits);
  std::vector<std::uint32_t> of_orbit = claims_of_orbits(map(), edges, orbits);
  for (std::uint32_t c = 0; c < components.count; ++c) {
    of_orbit[orbits.outside[c]] = parent[c] == kNone ? kNone : of_orbit[parent[c]];
  }
  std::vector<std::uint32_t> claims;
  claims.reserve(orbits.of_halfedge.size());
  for (const std::uint32_t orbit : orbits.of_halfedge) claims.push_back(of_orbit[orbit]);
  return claims;
}

// Whether a chain lies inside of listed regions, and of more than one. In this case, it is the
// border of an overlap, not of a component.
bool is_inside_of_regions(const OpenChain& chain, const std::vector<std::uint32_t>& claims) {
  if (claims.empty()) return false;
  const std::uint32_t first = claims[chain.halfedges.front()];
  const auto is = [&](std::uint32_t claim) {
    return [&claims, claim](std::uint32_t h) { return claims[h] == claim; };
  };
  return std::ranges::none_of(chain.halfedges, is(kNone)) &&
         !std::ranges::all_of(chain.halfedges, is(first));
}

// Adds a cycle for each chain that is a missing outer boundary, and pairs the edges again. The
// undirected edges do not change, so the results of the sweep remain valid.
void MapChecker::infer_outer_cycles() {
  const auto is_clockwise = [](const OpenChain& c) { return c.area == Sign::Negative; };
  if (std::ranges::none_of(findings_.chains, is_clockwise)) return;
  const std::vector<std::uint32_t> claims = this->claims();
  for (const OpenChain& chain : findings_.chains) {
    if (!is_clockwise(chain) || is_inside_of_regions(chain, claims)) continue;
    findings_.inferred.push_back(static_cast<std::uint32_t>(map().cycle_count()));
    map().add_cycle(cycle_of_chain(findings_.edges, chain));
  }
  if (findings_.inferred.empty()) return;
  findings_.edges = match_twins(map());
  findings_.chains = trace_open_chains(map(), findings_.edges);
}

void MapChecker::count_matching_defects() {
  const MapEdges& edges = findings_.edges;
  report_.cycles = map().cycle_count();
  counts().duplicate = edges.extra_uses.size();
  for (std::uint32_t e = 0; e < edges.edge_count(); ++e) {
    if (edges.cycle_on_both_sides(e) != MapEdges::kNoCycle) ++counts().twin;
    if (ignores_borders()) continue;
    counts().open += static_cast<std::uint64_t>(edges.is_open(2 * e)) +
                     static_cast<std::uint64_t>(edges.is_open(2 * e + 1));
  }
}

// ---------------------------------------------------------------- geometry

void MapChecker::sweep_contacts() {
  findings_.components = connect(map(), findings_.edges);
  findings_.contacts =
      find_contacts(map(), findings_.edges, findings_.components, options_.max_defects, context_);
  counts().crossing = findings_.contacts.count;
  report_.vertices = map().vertex_count();
  report_.edges = findings_.edges.edge_count();
  report_.components = findings_.components.count;
}

// Finds the claims of regions for the hints. If the crossings are far more than the edges, the
// pieces of all edges would need too much memory, and the hints remain general.
void MapChecker::find_claims() {
  constexpr std::uint64_t kMostContacts = 1024;
  if (options_.max_defects == 0) return;
  if (counts().crossing > kMostContacts + findings_.edges.edge_count()) return;
  findings_.claims = MapClaims(map(), findings_.edges, context_);
}

// Finds the faces that the edges induce, and the regions if the map is valid.
void MapChecker::trace_faces() {
  if (counts().duplicate + counts().open + counts().crossing > 0) return;
  context_.checkpoint("faces", 0, 1);
  const MapRotation& rotation = findings_.contacts.rotation;
  findings_.orbits = trace_orbits(map(), findings_.edges, findings_.components, rotation);
  const std::vector<std::uint32_t> parent =
      nest_components(findings_.edges, findings_.components, rotation, findings_.orbits);
  settle_mixed(parent);
  if (ignores_borders()) find_nested(parent);
  if (verdict() == MapVerdict::Valid) collect_regions(parent);
  context_.checkpoint("faces", 1, 1);
}

// Counts mixed orbits. In most maps, the first test finds none, so no further test is needed.
void MapChecker::settle_mixed(const std::vector<std::uint32_t>& parent) {
  const auto is_mixed = [](const MapOrbits::Orbit& o) { return o.mixed; };
  const auto& orbits = findings_.orbits.orbits;
  if (std::ranges::any_of(orbits, is_mixed)) {
    shells_ = settle_touching_rings(map(), findings_.edges, findings_.components, parent,
                                    findings_.orbits);
  }
  counts().mixed = static_cast<std::uint64_t>(std::ranges::count_if(orbits, is_mixed));
}

// Finds components that lie in a listed face, and whose outside is not completely listed.
void MapChecker::find_nested(const std::vector<std::uint32_t>& parent) {
  const MapOrbits& orbits = findings_.orbits;
  for (std::uint32_t c = 0; c < parent.size(); ++c) {
    if (parent[c] == kNone) continue;
    std::uint32_t container = orbits.orbits[parent[c]].cycle;
    if (container != kNone && !shells_.empty() && shells_[container] != kNone) {
      container = shells_[container];
    }
    const bool is_listed = orbits.orbits[orbits.outside[c]].complete;
    if (container != kNone && !is_listed) findings_.nested.push_back({c, container});
  }
  counts().nested = findings_.nested.size();
}

// Returns for each cycle the counter-clockwise cycle around its region, or kNone. If no orbit was
// mixed, the clockwise cycles of a component are holes of the region of its parent orbit.
std::vector<std::uint32_t> MapChecker::shells_of_cycles(
    const std::vector<std::uint32_t>& parent) const {
  if (!shells_.empty()) return shells_;
  const MapOrbits& orbits = findings_.orbits;
  const MapEdges& edges = findings_.edges;
  std::vector<std::uint32_t> shells(report_.map.cycle_count(), kNone);
  for (const std::uint32_t h : edges.at_corner) {
    const std::uint32_t cycle = edges.cycle_of[h];
    const std::uint32_t around = parent[findings_.components.of_vertex[edges.origin(h)]];
    if (orbits.orbits[orbits.of_halfedge[h]].counterclockwise) {
      shells[cycle] = cycle;
    } else if (around != kNone) {
      shells[cycle] = orbits.orbits[around].cycle;
    }
  }
  return shells;
}

// Collects the regions. Region 0 is the unbounded region. It is followed by a region for each
// counter-clockwise cycle, in the order of the input.
void MapChecker::collect_regions(const std::vector<std::uint32_t>& parent) {
  const std::vector<std::uint32_t> shells = shells_of_cycles(parent);
  std::vector<std::uint32_t> region_of(shells.size(), 0);
  report_.regions.resize(1);
  for (std::uint32_t c = 0; c < shells.size(); ++c) {
    if (shells[c] != c) continue;
    region_of[c] = static_cast<std::uint32_t>(report_.regions.size());
    report_.regions.push_back({c, {}});
  }
  for (std::uint32_t c = 0; c < shells.size(); ++c) {
    if (shells[c] == c) continue;
    report_.regions[shells[c] == kNone ? 0 : region_of[shells[c]]].holes.push_back(c);
  }
}

// Returns the first verdict that applies.
MapVerdict MapChecker::verdict() {
  if (counts().duplicate > 0) return MapVerdict::NotAPlanarSubdivision;
  if (counts().open > 0) return MapVerdict::Open;
  const std::uint64_t superposed =
      counts().crossing + counts().twin + counts().mixed.value_or(0) + counts().nested;
  return superposed > 0 ? MapVerdict::Superposed : MapVerdict::Valid;
}

// Returns for each corner position the position of the opposite directed edge.
std::vector<std::uint32_t> twin_positions(const MapEdges& edges) {
  std::vector<std::uint32_t> corner_of(edges.halfedge_count());
  for (std::uint32_t i = 0; i < edges.at_corner.size(); ++i) corner_of[edges.at_corner[i]] = i;
  std::vector<std::uint32_t> twin(edges.at_corner.size());
  for (std::uint32_t i = 0; i < twin.size(); ++i) twin[i] = corner_of[edges.at_corner[i] ^ 1U];
  return twin;
}

}  // namespace

MapReport check_map(Map map, const MapCheckOptions& options, Context& context) {
  return MapChecker(std::move(map), options, context).run();
}

DcelFromCycles to_dcel(const MapReport& report) {
  const Map& map = report.map;
  const MapEdges edges = match_twins(map);
  const bool complete = edges.extra_uses.empty() && 2 * edges.edge_count() == map.corners.size();
  if (report.verdict != MapVerdict::Valid || !complete) {
    throw Error(ErrorCode::BadArgument,
                "a half-edge structure needs a valid map without open borders");
  }
  std::vector<std::uint32_t> face_of_cycle(map.cycle_count(), 0);
  for (std::uint32_t r = 0; r < report.regions.size(); ++r) {
    if (report.regions[r].outer) face_of_cycle[*report.regions[r].outer] = r;
    for (const std::uint32_t hole : report.regions[r].holes) face_of_cycle[hole] = r;
  }
  return Dcel::from_cycles(map.vertex_count(), map.corners, map.cycle_begin, twin_positions(edges),
                           face_of_cycle);
}

}  // namespace plumb
