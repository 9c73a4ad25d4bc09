// The faces that the edges of a map induce, and the nesting of components.
//
// Following the rotation system gives orbits, one boundary cycle each. The lexicographically first
// vertex of an orbit shows whether the orbit is the outside of its component. All edges lead to the
// right there, and the orbit is the outside if and only if one of its corners there contains the
// direction to the left. A component lies in the face above the edge that is next below its first
// vertex; components are settled in the order of these vertices, so the component with this edge
// has been settled before.
//
// Rings that touch: two cycles that list half-edges of one face are boundaries of one region. So
// the classes of cycles that this relation generates are the regions, if the listing describes
// regions at all. A class is a region if its faces are bounded by nothing unlisted, no edge has the
// class at both sides, and exactly one cycle is counter-clockwise (none if a face of the class is
// unbounded). Proof that the winding number w of the cycles of such a class is 1 in its faces and 0
// elsewhere: let u be 1 in the faces of the class and 0 elsewhere. Across an edge with the class on
// one side only, the half-edge on that side is listed by the class, so w and u jump alike. Across
// any other edge neither jumps. So w - u is constant, and it is 0 in the unbounded face (1 is to be
// added to w if that is a face of the class). So each face is in exactly one region.
//
// Tested by tests/plane/map_check_test.cpp and tests/plane/map_check_property_test.cpp.

#include "plumb/plane/check/map_orbits.h"

#include <algorithm>
#include <iterator>

#include "plumb/base/internal/union_find.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {
namespace {

static_assert(MapEdges::kNoCycle == kNone);

class OrbitTracer {
 public:
  OrbitTracer(const Map& map, const MapEdges& edges, const MapComponents& components,
              const MapRotation& rotation)
      : map_(map), edges_(edges), components_(components), rotation_(rotation) {
    result_.of_halfedge.assign(edges.halfedge_count(), kNone);
    result_.outside.assign(components.count, kNone);
    area_sign_.assign(map.cycle_count(), FilteredSign::Unsure);
  }

  MapOrbits run() {
    for (std::uint32_t h = 0; h < edges_.halfedge_count(); ++h) {
      if (result_.of_halfedge[h] == kNone) trace(h);
    }
    return std::move(result_);
  }

 private:
  // The result of one walk around an orbit.
  struct Walk {
    std::uint32_t first;  // A half-edge that leaves the lexicographically first vertex.
    // Whether a corner at this vertex contains the direction to the left, so that the orbit is an
    // outside.
    bool has_outer_corner;
    bool single_cycle;     // Whether at most one listed cycle has half-edges in the orbit.
    std::uint32_t cycle;   // The least such cycle, or kNone.
    std::uint32_t length;  // The number of half-edges.
    bool complete;         // Whether all half-edges are listed.
  };

  void trace(std::uint32_t start);
  Walk walk(std::uint32_t start, std::uint32_t id);
  void visit_corner(std::uint32_t arriving, std::uint32_t leaving, Walk& walk) const;
  bool is_mixed(const Walk& walk);
  bool all_clockwise(std::uint32_t start);
  Sign cycle_sign(std::uint32_t cycle);

  const Map& map_;
  const MapEdges& edges_;
  const MapComponents& components_;
  const MapRotation& rotation_;
  MapOrbits result_;
  std::vector<FilteredSign>
      area_sign_;  // The sign of the area of each listed cycle; Unsure if it is not known.
};

void OrbitTracer::trace(std::uint32_t start) {
  const auto id = static_cast<std::uint32_t>(result_.orbits.size());
  const Walk w = walk(start, id);
  result_.orbits.push_back({w.first, w.cycle, !w.has_outer_corner, is_mixed(w), w.complete});
  if (w.has_outer_corner) {
    result_.outside[components_.of_vertex[edges_.origin(w.first)]] = id;
  }
}

OrbitTracer::Walk OrbitTracer::walk(std::uint32_t start, std::uint32_t id) {
  Walk w{start, false, true, kNone, 0, true};
  bool is_first = true;
  for (std::uint32_t h = start; is_first || h != start; is_first = false) {
    result_.of_halfedge[h] = id;
    ++w.length;
    const std::uint32_t cycle = edges_.cycle_of[h];
    if (cycle == kNone) {
      w.complete = false;
    } else {
      if (w.cycle != kNone && w.cycle != cycle) w.single_cycle = false;
      w.cycle = std::min(w.cycle, cycle);
    }
    const std::uint32_t next = rotation_.orbit_next[h];
    visit_corner(h, next, w);
    h = next;
  }
  return w;
}

// At the first vertex of an orbit, all edges lead to the right. The corner from `arriving` to
// `leaving` contains the direction to the left unless it is a proper left turn.
void OrbitTracer::visit_corner(std::uint32_t arriving, std::uint32_t leaving, Walk& w) const {
  const std::uint32_t corner = edges_.origin(leaving);
  const std::uint32_t least = edges_.origin(w.first);
  const std::uint32_t order = rotation_.order[corner];
  if (order > rotation_.order[least]) return;
  if (order < rotation_.order[least]) {
    w.first = leaving;
    w.has_outer_corner = false;
  }
  const Sign turn = orient2d(map_.points, edges_.origin(arriving), corner, edges_.target(leaving));
  if (turn != Sign::Positive) w.has_outer_corner = true;
}

// Whether an orbit differs from the boundary that its listed cycles claim. The orbit of a bounded
// face must be one counter-clockwise cycle, and an outside may only have clockwise cycles. If no
// half-edge of an orbit is listed, the orbit is a gap, which open edges report.
bool OrbitTracer::is_mixed(const Walk& w) {
  if (w.cycle == kNone) return false;
  const bool is_the_cycle = w.complete && w.single_cycle && w.length == map_.cycle(w.cycle).size();
  if (is_the_cycle) return false;
  const bool is_bounded = !w.has_outer_corner;
  if (is_bounded) return !w.single_cycle || cycle_sign(w.cycle) != Sign::Positive;
  if (w.single_cycle) return cycle_sign(w.cycle) == Sign::Positive;
  return !all_clockwise(w.first);
}

bool OrbitTracer::all_clockwise(std::uint32_t start) {
  const std::vector<std::uint32_t> cycles = cycles_of_orbit(edges_, rotation_, start);
  return std::all_of(cycles.begin(), cycles.end(),
                     [&](std::uint32_t c) { return cycle_sign(c) == Sign::Negative; });
}

Sign OrbitTracer::cycle_sign(std::uint32_t cycle) {
  if (area_sign_[cycle] == FilteredSign::Unsure) {
    area_sign_[cycle] = filtered(polygon_area_sign(map_.points, map_.cycle(cycle)));
  }
  return decided(area_sign_[cycle]);
}

}  // namespace

MapOrbits trace_orbits(const Map& map, const MapEdges& edges, const MapComponents& components,
                       const MapRotation& rotation) {
  return OrbitTracer(map, edges, components, rotation).run();
}

std::vector<std::uint32_t> cycles_of_orbit(const MapEdges& edges, const MapRotation& rotation,
                                           std::uint32_t halfedge) {
  std::vector<std::uint32_t> cycles;
  bool is_first = true;
  for (std::uint32_t h = halfedge; is_first || h != halfedge; is_first = false) {
    const std::uint32_t cycle = edges.cycle_of[h];
    if (cycle != kNone && (cycles.empty() || cycles.back() != cycle)) cycles.push_back(cycle);
    h = rotation.orbit_next[h];
  }
  std::sort(cycles.begin(), cycles.end());
  cycles.erase(std::unique(cycles.begin(), cycles.end()), cycles.end());
  return cycles;
}

// Components are processed in the order of their first vertices, so the component below has been
// processed before.
std::vector<std::uint32_t> nest_components(const MapEdges& edges, const MapComponents& components,
                                           const MapRotation& rotation, const MapOrbits& orbits) {
  std::vector<std::uint32_t> by_order(components.count);
  for (std::uint32_t c = 0; c < components.count; ++c) by_order[c] = c;
  const auto first_order = [&](std::uint32_t c) {
    const std::uint32_t h = orbits.orbits[orbits.outside[c]].halfedge;
    return rotation.order[edges.origin(h)];
  };
  std::sort(by_order.begin(), by_order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return first_order(a) < first_order(b); });
  std::vector<std::uint32_t> parent(components.count, kNone);
  for (const std::uint32_t c : by_order) {
    const std::uint32_t edge = rotation.edge_below[c];
    if (edge == kNone) continue;
    // The half-edge that leads from left to right has the face above the edge on its left.
    const bool forward =
        rotation.order[edges.ends[edge].from] < rotation.order[edges.ends[edge].to];
    const std::uint32_t above = orbits.of_halfedge[2 * edge + (forward ? 0 : 1)];
    const std::uint32_t other = components.of_vertex[edges.ends[edge].from];
    parent[c] = orbits.orbits[above].counterclockwise ? above : parent[other];
  }
  return parent;
}

namespace {

std::vector<Sign> cycle_signs(const Map& map) {
  std::vector<Sign> signs;
  signs.reserve(map.cycle_count());
  for (std::size_t c = 0; c < map.cycle_count(); ++c) {
    signs.push_back(polygon_area_sign(map.points, map.cycle(c)));
  }
  return signs;
}

// The classes of cycles that bound common faces. The unbounded region is an additional member.
class TouchingRings {
 public:
  TouchingRings(const Map& map, const MapEdges& edges, const MapComponents& components,
                const std::vector<std::uint32_t>& parent, MapOrbits& orbits)
      : edges_(edges),
        components_(components),
        parent_(parent),
        orbits_(orbits),
        signs_(cycle_signs(map)),
        unbounded_(static_cast<std::uint32_t>(map.cycle_count())),
        classes_(map.cycle_count() + 1),
        shell_(map.cycle_count() + 1, kNone),
        is_region_(map.cycle_count() + 1, 1) {}

  std::vector<std::uint32_t> settle() {
    unite_around_faces();
    find_shells();
    reject_open_faces();
    reject_inner_edges();
    for (MapOrbits::Orbit& orbit : orbits_.orbits) {
      if (orbit.mixed && orbit.counterclockwise) orbit.mixed = !is_region(orbit.cycle);
    }
    return shells();
  }

 private:
  void unite_around_faces();
  void find_shells();
  void reject_open_faces();
  void reject_inner_edges();
  std::vector<std::uint32_t> shells();

  bool is_region(std::uint32_t cycle) { return is_region_[classes_.root(cycle)] != 0; }
  void reject(std::uint32_t cycle) { is_region_[classes_.root(cycle)] = 0; }
  // A cycle on the outer boundary of the face around a component, or the unbounded region.
  std::uint32_t around(std::uint32_t component) const {
    const std::uint32_t orbit = parent_[component];
    return orbit == kNone ? unbounded_ : orbits_.orbits[orbit].cycle;
  }

  const MapEdges& edges_;
  const MapComponents& components_;
  const std::vector<std::uint32_t>& parent_;
  MapOrbits& orbits_;
  std::vector<Sign> signs_;
  std::uint32_t unbounded_;
  UnionFind classes_;
  std::vector<std::uint32_t> shell_;  // For each root, the counter-clockwise cycle.
  std::vector<char> is_region_;       // For each root.
};

void TouchingRings::unite_around_faces() {
  for (std::uint32_t h = 0; h < edges_.halfedge_count(); ++h) {
    if (edges_.cycle_of[h] == kNone) continue;
    classes_.unite(edges_.cycle_of[h], orbits_.orbits[orbits_.of_halfedge[h]].cycle);
  }
  for (std::uint32_t c = 0; c < components_.count; ++c) {
    const std::uint32_t outside = orbits_.orbits[orbits_.outside[c]].cycle;
    if (outside != kNone && around(c) != kNone) classes_.unite(outside, around(c));
  }
}

void TouchingRings::find_shells() {
  for (std::uint32_t c = 0; c < signs_.size(); ++c) {
    const std::uint32_t root = classes_.root(c);
    if (signs_[c] == Sign::Negative) continue;
    const bool is_shell =
        signs_[c] == Sign::Positive && shell_[root] == kNone && root != classes_.root(unbounded_);
    if (is_shell) {
      shell_[root] = c;
    } else {
      is_region_[root] = 0;
    }
  }
}

void TouchingRings::reject_open_faces() {
  for (const MapOrbits::Orbit& orbit : orbits_.orbits) {
    if (orbit.cycle == kNone) continue;
    const bool is_mixed_outside = orbit.mixed && !orbit.counterclockwise;
    if (!orbit.complete || is_mixed_outside) reject(orbit.cycle);
  }
  for (std::uint32_t c = 0; c < components_.count; ++c) {
    const std::uint32_t outside = orbits_.orbits[orbits_.outside[c]].cycle;
    if (outside == kNone && around(c) != kNone) reject(around(c));
    if (outside != kNone && around(c) == kNone) reject(outside);
  }
}

void TouchingRings::reject_inner_edges() {
  for (std::uint32_t e = 0; e < edges_.edge_count(); ++e) {
    const std::uint32_t left = edges_.cycle_of[2 * e];
    const std::uint32_t right = edges_.cycle_of[2 * e + 1];
    if (left == kNone || right == kNone) continue;
    if (classes_.root(left) == classes_.root(right)) reject(left);
  }
}

std::vector<std::uint32_t> TouchingRings::shells() {
  std::vector<std::uint32_t> shells(signs_.size());
  for (std::uint32_t c = 0; c < shells.size(); ++c) shells[c] = shell_[classes_.root(c)];
  return shells;
}

}  // namespace

std::vector<std::uint32_t> settle_touching_rings(const Map& map, const MapEdges& edges,
                                                 const MapComponents& components,
                                                 const std::vector<std::uint32_t>& parent,
                                                 MapOrbits& orbits) {
  return TouchingRings(map, edges, components, parent, orbits).settle();
}

std::vector<std::uint32_t> claims_of_orbits(const Map& map, const MapEdges& edges,
                                            const MapOrbits& orbits) {
  const std::vector<Sign> signs = cycle_signs(map);
  std::vector<std::uint32_t> claims(orbits.orbits.size(), kNone);
  for (std::uint32_t h = 0; h < edges.halfedge_count(); ++h) {
    const std::uint32_t cycle = edges.cycle_of[h];
    if (cycle == kNone || signs[cycle] != Sign::Positive) continue;
    std::uint32_t& claim = claims[orbits.of_halfedge[h]];
    claim = std::min(claim, cycle);
  }
  return claims;
}

std::vector<std::uint32_t> find_pinches(const Map& map, const MapEdges& edges,
                                        const MapOrbits& orbits) {
  // Sorts half-edges by origin, and then such that equal orbits are consecutive.
  std::vector<std::uint32_t> begin(map.vertex_count() + 1, 0);
  for (const SweepSegment& e : edges.ends) {
    ++begin[e.from + 1];
    ++begin[e.to + 1];
  }
  for (std::size_t v = 0; v < map.vertex_count(); ++v) begin[v + 1] += begin[v];
  std::vector<std::uint32_t> around(edges.halfedge_count());
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  for (std::uint32_t h = 0; h < edges.halfedge_count(); ++h) {
    around[fill[edges.origin(h)]++] = orbits.of_halfedge[h];
  }
  std::vector<std::uint32_t> pinches;
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    const auto first = around.begin() + begin[v];
    const auto last = around.begin() + begin[v + 1];
    std::sort(first, last);
    if (std::adjacent_find(first, last) != last) pinches.push_back(v);
  }
  return pinches;
}

}  // namespace plumb
