#include "plumb/testing/map_oracle.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "oracle/segments.h"

namespace plumb::testing {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge reversed(Edge e) { return {e.second, e.first}; }
Edge undirected(Edge e) { return e.first < e.second ? e : reversed(e); }

// One boundary cycle of the induced planar graph.
struct Orbit {
  std::vector<Edge> halfedges;
  std::set<std::uint32_t> cycles;  // listed cycles that use them
  bool all_listed = true;
  BigInt doubled_area = 0;
  std::size_t component = 0;
  std::size_t face = 0;  // Of the plane, by the orbit around it; one more is the unbounded one.
  bool is_bounded() const { return doubled_area > 0; }
};

// Listed cycles that bound common faces, directly or by way of others.
struct RegionClass {
  std::set<std::size_t> faces;
  std::set<std::uint32_t> cycles;
  bool is_region = false;
};

std::vector<std::uint32_t> ascending(const std::set<std::uint32_t>& set) {
  return {set.begin(), set.end()};
}

class Judge {
 public:
  Judge(const TestMap& map, const OracleOptions& options);
  OracleReport run();

 private:
  void list_uses();
  void add_use(std::uint32_t cycle);
  void infer_outer();
  bool has_contacts() const;
  bool is_inside_of_regions(const Cycle& chain) const;
  Cycle close_chain(Edge start, std::set<Edge>& missing) const;
  Edge before_in_cycle(Edge h) const;
  void count_duplicates();
  void count_open();
  void count_twins();
  void count_crossings();
  std::vector<std::uint32_t> users(const std::vector<Edge>& edges) const;
  void label_components();
  std::vector<Edge> directed() const;
  void sort_around_vertices();
  Edge next(Edge h) const;
  Orbit trace(Edge start) const;
  void trace_orbits();
  void name_faces();
  void find_classes();
  void judge_class(RegionClass& regions) const;
  std::vector<int> windings(const RegionClass& regions) const;
  std::size_t face_of(Edge h) const { return orbits_[orbit_of_.at(h)].face; }
  std::size_t class_of(std::uint32_t cycle) const;
  void count_mixed();
  bool is_mixed(const Orbit& orbit) const;
  bool is_no_cycle(const Orbit& orbit) const;
  void count_nested();
  bool surrounds(const Orbit& orbit, std::uint32_t vertex) const;
  const Orbit* innermost_around(std::size_t component, std::uint32_t vertex) const;
  MapVerdict verdict() const;
  void list_regions();
  BigInt doubled_area(const std::vector<std::uint32_t>& cycle) const;
  const IntegerPoint& at(std::uint32_t v) const { return integers_.points[v]; }
  ExactPoint unscaled(const ExactPoint& p) const;

  TestMap map_;
  OracleOptions options_;
  IntegerPoints integers_;
  std::map<Edge, std::vector<std::uint32_t>> uses_;  // directed edge -> cycle of every use
  std::set<Edge> edges_;                             // undirected
  std::map<std::uint32_t, std::size_t> component_;   // used vertex -> component
  std::map<std::uint32_t, std::vector<Edge>> around_;
  std::vector<Orbit> orbits_;
  std::map<Edge, std::size_t> orbit_of_;
  std::vector<RegionClass> classes_;
  OracleReport report_;
};

TestMap merged(const TestMap& map) {
  TestMap result = map;
  std::map<ExactPoint, std::uint32_t> first;
  for (std::uint32_t v = 0; v < map.points.size(); ++v) first.emplace(map.points[v], v);
  for (Cycle& cycle : result.cycles) {
    for (std::uint32_t& v : cycle) v = first.at(map.points[v]);
    cycle.erase(std::unique(cycle.begin(), cycle.end()), cycle.end());
    while (cycle.size() > 1 && cycle.back() == cycle.front()) cycle.pop_back();
  }
  return result;
}

Judge::Judge(const TestMap& map, const OracleOptions& options)
    : map_(options.merge_vertices ? merged(map) : map),
      options_(options),
      integers_(over_common_denominator(map.points)) {
  list_uses();
  label_components();
  if (options_.outer == OuterRule::Infer) infer_outer();
}

void Judge::list_uses() {
  for (std::uint32_t c = 0; c < map_.cycles.size(); ++c) add_use(c);
}

void Judge::add_use(std::uint32_t c) {
  const Cycle& cycle = map_.cycles[c];
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Edge h{cycle[i], cycle[(i + 1) % cycle.size()]};
    uses_[h].push_back(c);
    edges_.insert(undirected(h));
  }
}

bool is_common_vertex(const TestMap& map, Edge e, Edge f, const ExactPoint& p) {
  for (const std::uint32_t v : {e.first, e.second}) {
    if ((v == f.first || v == f.second) && map.points[v] == p) return true;
  }
  return false;
}

// Chains of unlisted half-edges are walked so that they stay with the same faces: around a vertex,
// through listed faces, to the next border. Those that run clockwise become cycles. With duplicate
// uses "the face at that side" has no meaning, and nothing is inferred.
void Judge::infer_outer() {
  std::set<Edge> missing;
  for (const auto& [h, cycles] : uses_) {
    if (cycles.size() > 1) return;
    if (!uses_.contains(reversed(h))) missing.insert(reversed(h));
  }
  const std::set<Edge> starts(edges_);
  for (const Edge& e : starts) {
    for (const Edge& start : {e, reversed(e)}) {
      if (!missing.contains(start)) continue;
      const Cycle chain = close_chain(start, missing);
      if (doubled_area(chain) < 0) report_.inferred.push_back(chain);
    }
  }
  if (!has_contacts()) {
    sort_around_vertices();
    trace_orbits();
    std::erase_if(report_.inferred, [&](const Cycle& c) { return is_inside_of_regions(c); });
    around_.clear();
    orbits_.clear();
    orbit_of_.clear();
  }
  for (const Cycle& cycle : report_.inferred) {
    map_.cycles.push_back(cycle);
    add_use(static_cast<std::uint32_t>(map_.cycles.size() - 1));
  }
}

bool Judge::has_contacts() const {
  for (auto e = edges_.begin(); e != edges_.end(); ++e) {
    if (at(e->first) == at(e->second)) return true;
    for (auto f = std::next(e); f != edges_.end(); ++f) {
      const auto meeting = meet(at(e->first), at(e->second), at(f->first), at(f->second));
      const bool is_legal = !meeting || (meeting->first == meeting->last &&
                                         is_common_vertex(map_, *e, *f, unscaled(meeting->first)));
      if (!is_legal) return true;
    }
  }
  return false;
}

// Whether the left side of every half-edge of a chain lies inside of a counter-clockwise cycle that
// bounds the same face from outside, and these are not all one cycle. Then the chain goes round an
// overlap.
bool Judge::is_inside_of_regions(const Cycle& chain) const {
  std::set<std::uint32_t> around;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Orbit* orbit = &orbits_[orbit_of_.at({chain[i], chain[(i + 1) % chain.size()]})];
    if (!orbit->is_bounded()) orbit = innermost_around(orbit->component, chain[i]);
    if (orbit == nullptr) return false;
    const auto region = std::find_if(orbit->cycles.begin(), orbit->cycles.end(),
                                     [&](auto c) { return doubled_area(map_.cycles[c]) > 0; });
    if (region == orbit->cycles.end()) return false;
    around.insert(*region);
  }
  return around.size() > 1;
}

Cycle Judge::close_chain(Edge start, std::set<Edge>& missing) const {
  Cycle chain;
  Edge h = start;
  while (missing.erase(h) > 0) {
    chain.push_back(h.first);
    h = reversed(h);
    while (uses_.contains(h)) h = reversed(before_in_cycle(h));
  }
  return chain;
}

// The half-edge before a half-edge that is listed once.
Edge Judge::before_in_cycle(Edge h) const {
  const Cycle& cycle = map_.cycles[uses_.at(h).front()];
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const std::size_t next = (i + 1) % cycle.size();
    const std::size_t second = (i + 2) % cycle.size();
    if (Edge{cycle[next], cycle[second]} == h) return {cycle[i], cycle[next]};
  }
  return h;
}

ExactPoint Judge::unscaled(const ExactPoint& p) const {
  return {p.x / integers_.denominator, p.y / integers_.denominator};
}

// One defect per use beyond the first; it names the first user and this one.
void Judge::count_duplicates() {
  for (const auto& [h, cycles] : uses_) {
    for (std::size_t i = 1; i < cycles.size(); ++i) {
      ++report_.counts.duplicate;
      report_.defects.push_back(
          {DefectKind::Duplicate, {h}, ascending({cycles.front(), cycles[i]}), std::nullopt});
    }
  }
}

void Judge::count_open() {
  if (options_.outer == OuterRule::Ignore) return;
  for (const auto& [h, cycles] : uses_) {
    if (uses_.contains(reversed(h))) continue;
    ++report_.counts.open;
    report_.defects.push_back({DefectKind::Open, {h}, {cycles.front()}, std::nullopt});
  }
}

void Judge::count_twins() {
  for (const Edge& e : edges_) {
    const auto there = uses_.find(e);
    const auto back = uses_.find(reversed(e));
    if (there == uses_.end() || back == uses_.end()) continue;
    const std::set<std::uint32_t> forward(there->second.begin(), there->second.end());
    std::set<std::uint32_t> both;
    for (const std::uint32_t c : back->second) {
      if (forward.contains(c)) both.insert(c);
    }
    if (both.empty()) continue;
    ++report_.counts.twin;
    report_.defects.push_back({DefectKind::Twin, {e}, {*both.begin()}, std::nullopt});
  }
}

std::vector<std::uint32_t> Judge::users(const std::vector<Edge>& edges) const {
  std::set<std::uint32_t> cycles;
  for (const Edge& e : edges) {
    for (const Edge& h : {e, reversed(e)}) {
      const auto found = uses_.find(h);
      if (found != uses_.end()) cycles.insert(found->second.begin(), found->second.end());
    }
  }
  return ascending(cycles);
}

void Judge::count_crossings() {
  for (auto e = edges_.begin(); e != edges_.end(); ++e) {
    for (auto f = std::next(e); f != edges_.end(); ++f) {
      const auto meeting = meet(at(e->first), at(e->second), at(f->first), at(f->second));
      if (!meeting) continue;
      const ExactPoint first = unscaled(meeting->first);
      if (meeting->first == meeting->last && is_common_vertex(map_, *e, *f, first)) continue;
      ++report_.counts.crossing;
      report_.defects.push_back({DefectKind::Crossing, {*e, *f}, users({*e, *f}), first});
    }
  }
}

void Judge::label_components() {
  std::map<std::uint32_t, std::vector<std::uint32_t>> neighbours;
  for (const Edge& e : edges_) {
    neighbours[e.first].push_back(e.second);
    neighbours[e.second].push_back(e.first);
  }
  for (const auto& [seed, unused] : neighbours) {
    if (component_.contains(seed)) continue;
    const std::size_t label = report_.components++;
    std::vector<std::uint32_t> stack{seed};
    component_[seed] = label;
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      for (const std::uint32_t w : neighbours[v]) {
        if (component_.emplace(w, label).second) stack.push_back(w);
      }
    }
  }
}

std::vector<Edge> Judge::directed() const {
  std::vector<Edge> both;
  for (const Edge& e : edges_) {
    both.push_back(e);
    both.push_back(reversed(e));
  }
  return both;
}

// Half-edges leaving each vertex, counter-clockwise.
void Judge::sort_around_vertices() {
  for (const Edge& h : directed()) around_[h.first].push_back(h);
  for (auto& [vertex, leaving] : around_) {
    const IntegerPoint& v = at(vertex);
    std::sort(leaving.begin(), leaving.end(),
              [&](Edge a, Edge b) { return angle_less(v, at(a.second), v, at(b.second)); });
  }
}

// The face to the left of h goes on with the edge just clockwise of h's twin.
Edge Judge::next(Edge h) const {
  const std::vector<Edge>& leaving = around_.at(h.second);
  const auto twin = std::find(leaving.begin(), leaving.end(), reversed(h));
  return twin == leaving.begin() ? leaving.back() : *std::prev(twin);
}

Orbit Judge::trace(Edge start) const {
  Orbit orbit;
  orbit.component = component_.at(start.first);
  std::vector<std::uint32_t> corners;
  Edge h = start;
  do {
    orbit.halfedges.push_back(h);
    corners.push_back(h.first);
    const auto users = uses_.find(h);
    if (users == uses_.end()) {
      orbit.all_listed = false;
    } else {
      orbit.cycles.insert(users->second.begin(), users->second.end());
    }
    h = next(h);
  } while (h != start);
  orbit.doubled_area = doubled_area(corners);
  return orbit;
}

void Judge::trace_orbits() {
  std::set<Edge> seen;
  for (const Edge& h : directed()) {
    if (seen.contains(h)) continue;
    for (const Edge& own : trace(h).halfedges) orbit_of_[own] = orbits_.size();
    orbits_.push_back(trace(h));
    seen.insert(orbits_.back().halfedges.begin(), orbits_.back().halfedges.end());
  }
}

// A bounded face is called by the orbit around it. The outside of a component belongs to the face
// that the component lies in.
void Judge::name_faces() {
  for (std::size_t i = 0; i < orbits_.size(); ++i) {
    orbits_[i].face = i;
    if (orbits_[i].is_bounded()) continue;
    const Orbit* around =
        innermost_around(orbits_[i].component, orbits_[i].halfedges.front().first);
    orbits_[i].face = around ? static_cast<std::size_t>(around - orbits_.data()) : orbits_.size();
  }
}

// Cycles with half-edges at one face are in one class, and so are the cycles of classes with a
// common cycle. What bounds the unbounded face is in one class, too.
void Judge::find_classes() {
  std::map<std::size_t, RegionClass> at_face;
  for (const Orbit& orbit : orbits_) {
    at_face[orbit.face].faces.insert(orbit.face);
    at_face[orbit.face].cycles.insert(orbit.cycles.begin(), orbit.cycles.end());
  }
  for (const auto& [face, here] : at_face) {
    RegionClass merged = here;
    std::erase_if(classes_, [&](const RegionClass& other) {
      const bool is_linked = std::any_of(other.cycles.begin(), other.cycles.end(),
                                         [&](auto c) { return merged.cycles.contains(c); });
      if (!is_linked) return false;
      merged.faces.insert(other.faces.begin(), other.faces.end());
      merged.cycles.insert(other.cycles.begin(), other.cycles.end());
      return true;
    });
    classes_.push_back(std::move(merged));
  }
  for (RegionClass& regions : classes_) judge_class(regions);
}

// A class is one region if its cycles together run once around its faces, and around nothing else:
// the left sides of its half-edges have winding number 1, the right sides 0 (0 and -1 if the region
// is unbounded).
void Judge::judge_class(RegionClass& regions) const {
  const bool is_unbounded = regions.faces.contains(orbits_.size());
  const int inside = is_unbounded ? 0 : 1;
  std::size_t shells = 0;
  for (const std::uint32_t c : regions.cycles) {
    const BigInt area = doubled_area(map_.cycles[c]);
    if (area == 0) return;
    if (area > 0) ++shells;
  }
  if (shells != (is_unbounded ? 0U : 1U)) return;
  for (const Orbit& orbit : orbits_) {
    if (!regions.faces.contains(orbit.face)) continue;
    if (!orbit.all_listed || (!orbit.is_bounded() && is_no_cycle(orbit))) return;
  }
  const std::vector<int> winding = windings(regions);
  for (const auto& [h, users] : uses_) {
    if (!regions.cycles.contains(users.front())) continue;
    if (winding[face_of(h)] != inside || winding[face_of(reversed(h))] != inside - 1) return;
  }
  regions.is_region = true;
}

// The winding number of the cycles of a class in each face, from the unbounded one inwards.
std::vector<int> Judge::windings(const RegionClass& regions) const {
  const auto uses = [&](Edge h) {
    const auto found = uses_.find(h);
    return found != uses_.end() && regions.cycles.contains(found->second.front()) ? 1 : 0;
  };
  std::vector<int> winding(orbits_.size() + 1, 0);
  std::set<std::size_t> known{orbits_.size()};
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const Edge& h : directed()) {
      const std::size_t left = face_of(h), right = face_of(reversed(h));
      if (!known.contains(right) || !known.insert(left).second) continue;
      winding[left] = winding[right] + uses(h) - uses(reversed(h));
      is_new = true;
    }
  }
  return winding;
}

std::size_t Judge::class_of(std::uint32_t cycle) const {
  std::size_t i = 0;
  while (!classes_[i].cycles.contains(cycle)) ++i;
  return i;
}

// A bounded face of which the boundary is not one cycle may be a part of a region of rings.
bool Judge::is_mixed(const Orbit& orbit) const {
  if (!is_no_cycle(orbit)) return false;
  return !orbit.is_bounded() || !classes_[class_of(*orbit.cycles.begin())].is_region;
}

bool Judge::is_no_cycle(const Orbit& orbit) const {
  const auto area = [&](std::uint32_t c) { return doubled_area(map_.cycles[c]); };
  if (orbit.cycles.empty()) return false;
  const std::uint32_t only = *orbit.cycles.begin();
  const bool single = orbit.cycles.size() == 1;
  if (orbit.is_bounded()) return !single || area(only) <= 0;
  if (single) return area(only) > 0;
  return !std::all_of(orbit.cycles.begin(), orbit.cycles.end(),
                      [&](std::uint32_t c) { return area(c) < 0; });
}

void Judge::count_mixed() {
  report_.counts.mixed = 0;
  for (const Orbit& orbit : orbits_) {
    if (!is_mixed(orbit)) continue;
    ++*report_.counts.mixed;
    report_.defects.push_back({DefectKind::Mixed, {}, ascending(orbit.cycles), std::nullopt});
  }
}

// Even-odd along the ray to the right; half-open in y, so a vertex on the ray counts once.
// Edges the orbit walks twice cancel. Requires the vertex not to lie on the orbit.
bool Judge::surrounds(const Orbit& orbit, std::uint32_t vertex) const {
  const IntegerPoint& p = at(vertex);
  bool inside = false;
  for (const auto& [from, to] : orbit.halfedges) {
    const IntegerPoint& low = at(from).y < at(to).y ? at(from) : at(to);
    const IntegerPoint& high = at(from).y < at(to).y ? at(to) : at(from);
    if (low.y <= p.y && p.y < high.y && cross(low, high, low, p) > 0) inside = !inside;
  }
  return inside;
}

const Orbit* Judge::innermost_around(std::size_t component, std::uint32_t vertex) const {
  const Orbit* innermost = nullptr;
  for (const Orbit& orbit : orbits_) {
    if (!orbit.is_bounded() || orbit.component == component || !surrounds(orbit, vertex)) continue;
    if (!innermost || orbit.doubled_area < innermost->doubled_area) innermost = &orbit;
  }
  return innermost;
}

void Judge::count_nested() {
  for (const Orbit& orbit : orbits_) {
    if (orbit.is_bounded() || orbit.all_listed) continue;
    const Orbit* around = innermost_around(orbit.component, orbit.halfedges.front().first);
    if (!around || around->cycles.empty()) continue;
    ++report_.counts.nested;
    report_.defects.push_back({DefectKind::Nested, {}, {}, std::nullopt});
  }
}

MapVerdict Judge::verdict() const {
  const MapDefectCounts& n = report_.counts;
  if (n.duplicate > 0) return MapVerdict::NotAPlanarSubdivision;
  if (n.open > 0) return MapVerdict::Open;
  const bool superposed = n.crossing > 0 || n.twin > 0 || n.mixed.value_or(0) > 0 || n.nested > 0;
  return superposed ? MapVerdict::Superposed : MapVerdict::Valid;
}

// A counter-clockwise cycle bounds its own region, any other one that of its class. What lies in a
// gap (only under Ignore) goes with the unbounded region.
void Judge::list_regions() {
  std::map<std::uint32_t, std::vector<std::uint32_t>> holes;
  std::vector<std::uint32_t> unbounded;
  for (std::uint32_t c = 0; c < map_.cycles.size(); ++c) {
    const Cycle& cycle = map_.cycles[c];
    if (doubled_area(cycle) > 0) {
      holes[c];
      continue;
    }
    const std::set<std::uint32_t>& here = classes_[class_of(c)].cycles;
    const auto shell = std::find_if(
        here.begin(), here.end(), [&](auto other) { return doubled_area(map_.cycles[other]) > 0; });
    (shell == here.end() ? unbounded : holes[*shell]).push_back(c);
  }
  report_.regions.push_back({std::nullopt, unbounded});
  for (const auto& [outer, inner] : holes) report_.regions.push_back({outer, inner});
}

BigInt Judge::doubled_area(const std::vector<std::uint32_t>& cycle) const {
  BigInt sum = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const IntegerPoint& p = at(cycle[i]);
    const IntegerPoint& q = at(cycle[(i + 1) % cycle.size()]);
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

OracleReport Judge::run() {
  report_.edges = edges_.size();
  report_.cycles = map_.cycles.size();
  count_duplicates();
  count_open();
  count_twins();
  count_crossings();
  const MapDefectCounts& n = report_.counts;
  if (n.duplicate == 0 && n.open == 0 && n.crossing == 0) {
    sort_around_vertices();
    trace_orbits();
    name_faces();
    find_classes();
    count_mixed();
    if (options_.outer == OuterRule::Ignore) count_nested();
  }
  for (const Edge& e : edges_) {
    if (at(e.first) == at(e.second)) report_.has_zero_length_edge = true;
  }
  report_.verdict = verdict();
  if (report_.verdict == MapVerdict::Valid) list_regions();
  std::sort(report_.defects.begin(), report_.defects.end());
  return std::move(report_);
}

std::string refusal_of(const TestMap& map, const Cycle& cycle) {
  if (cycle.size() < 3) return "fewer than 3 corners";
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    if (cycle[i] >= map.points.size()) return "vertex out of range";
    if (cycle[i] == cycle[(i + 1) % cycle.size()]) return "repeated consecutive vertex";
  }
  return "";
}

}  // namespace

bool operator<(const OracleDefect& a, const OracleDefect& b) {
  return std::tie(a.kind, a.edges, a.cycles, a.point) <
         std::tie(b.kind, b.edges, b.cycles, b.point);
}

std::string refusal(const TestMap& map, const OracleOptions& options) {
  for (const Cycle& cycle : map.cycles) {
    const std::string reason = refusal_of(map, cycle);
    if (!reason.empty()) return reason;
  }
  return options.merge_vertices ? refusal(merged(map), {options.outer, false}) : "";
}

OracleReport judge(const TestMap& map, const OracleOptions& options) {
  return Judge(map, options).run();
}

}  // namespace plumb::testing
