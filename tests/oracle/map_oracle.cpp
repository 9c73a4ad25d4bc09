#include "oracle/map_oracle.h"

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
  bool is_bounded() const { return doubled_area > 0; }
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
  std::optional<Cycle> close_chain(Edge start, std::set<Edge>& missing) const;
  void count_duplicates();
  void count_open();
  void count_twins();
  void count_crossings();
  void label_components();
  std::vector<Edge> directed() const;
  std::vector<Edge> around(std::uint32_t vertex) const;
  Edge next(Edge h) const;
  Orbit trace(Edge start) const;
  void trace_orbits();
  void count_mixed();
  bool is_mixed(const Orbit& orbit) const;
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
  std::vector<Orbit> orbits_;
  OracleReport report_;
};

TestMap merged(const TestMap& map) {
  TestMap result = map;
  std::map<ExactPoint, std::uint32_t> first;
  for (std::uint32_t v = 0; v < map.points.size(); ++v) first.emplace(map.points[v], v);
  for (Cycle& cycle : result.cycles) {
    for (std::uint32_t& v : cycle) v = first.at(map.points[v]);
  }
  return result;
}

Judge::Judge(const TestMap& map, const OracleOptions& options)
    : map_(options.merge_vertices ? merged(map) : map),
      options_(options),
      integers_(over_common_denominator(map.points)) {
  list_uses();
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

// Missing half-edges are walked as faces of the missing ones alone: at each vertex the first one
// clockwise from where we came. Chains that close clockwise become cycles.
void Judge::infer_outer() {
  std::set<Edge> missing;
  for (const auto& [h, cycles] : uses_) {
    if (!uses_.contains(reversed(h))) missing.insert(reversed(h));
  }
  const std::set<Edge> all = missing;
  for (const Edge& start : all) {
    if (!missing.contains(start)) continue;
    const std::optional<Cycle> chain = close_chain(start, missing);
    if (chain && doubled_area(*chain) < 0) report_.inferred.push_back(*chain);
  }
  for (const Cycle& cycle : report_.inferred) {
    map_.cycles.push_back(cycle);
    add_use(static_cast<std::uint32_t>(map_.cycles.size() - 1));
  }
}

std::optional<Cycle> Judge::close_chain(Edge start, std::set<Edge>& missing) const {
  Cycle chain;
  Edge h = start;
  do {
    missing.erase(h);
    chain.push_back(h.first);
    std::vector<Edge> candidates;
    for (const Edge& e : missing) {
      if (e.first == h.second) candidates.push_back(e);
    }
    if (h.second == start.first) candidates.push_back(start);
    if (candidates.empty()) return std::nullopt;
    const IntegerPoint& v = at(h.second);
    const auto before = [&](Edge a, Edge b) {  // a is met before b when turning clockwise
      const bool a_wraps = !angle_less(v, at(a.second), v, at(h.first));
      const bool b_wraps = !angle_less(v, at(b.second), v, at(h.first));
      if (a_wraps != b_wraps) return b_wraps;
      return angle_less(v, at(b.second), v, at(a.second));
    };
    h = *std::min_element(candidates.begin(), candidates.end(), before);
  } while (h != start);
  return chain;
}

ExactPoint Judge::unscaled(const ExactPoint& p) const {
  return {p.x / integers_.denominator, p.y / integers_.denominator};
}

void Judge::count_duplicates() {
  for (const auto& [h, cycles] : uses_) {
    if (cycles.size() < 2) continue;
    report_.counts.duplicate += cycles.size() - 1;
    const std::set<std::uint32_t> users(cycles.begin(), cycles.end());
    report_.defects.push_back({DefectKind::Duplicate, {h}, ascending(users), std::nullopt});
  }
}

void Judge::count_open() {
  if (options_.outer == OuterRule::Ignore) return;
  for (const auto& [h, cycles] : uses_) {
    if (uses_.contains(reversed(h))) continue;
    ++report_.counts.open;
    const std::set<std::uint32_t> users(cycles.begin(), cycles.end());
    report_.defects.push_back({DefectKind::Open, {h}, ascending(users), std::nullopt});
  }
}

void Judge::count_twins() {
  for (const Edge& e : edges_) {
    const auto there = uses_.find(e);
    const auto back = uses_.find(reversed(e));
    if (there == uses_.end() || back == uses_.end()) continue;
    const std::set<std::uint32_t> users(there->second.begin(), there->second.end());
    std::set<std::uint32_t> both;
    for (const std::uint32_t c : back->second) {
      if (users.contains(c)) both.insert(c);
    }
    if (both.empty()) continue;
    ++report_.counts.twin;
    report_.defects.push_back({DefectKind::Twin, {e}, ascending(both), std::nullopt});
  }
}

bool is_common_vertex(const TestMap& map, Edge e, Edge f, const ExactPoint& p) {
  for (const std::uint32_t v : {e.first, e.second}) {
    if ((v == f.first || v == f.second) && map.points[v] == p) return true;
  }
  return false;
}

void Judge::count_crossings() {
  for (auto e = edges_.begin(); e != edges_.end(); ++e) {
    for (auto f = std::next(e); f != edges_.end(); ++f) {
      const auto meeting = meet(at(e->first), at(e->second), at(f->first), at(f->second));
      if (!meeting) continue;
      const ExactPoint first = unscaled(meeting->first);
      if (meeting->first == meeting->last && is_common_vertex(map_, *e, *f, first)) continue;
      ++report_.counts.crossing;
      report_.defects.push_back({DefectKind::Crossing, {*e, *f}, {}, first});
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

std::vector<Edge> Judge::around(std::uint32_t vertex) const {
  std::vector<Edge> leaving;
  for (const Edge& h : directed()) {
    if (h.first == vertex) leaving.push_back(h);
  }
  std::sort(leaving.begin(), leaving.end(), [&](Edge a, Edge b) {
    return angle_less(at(vertex), at(a.second), at(vertex), at(b.second));
  });
  return leaving;
}

// The face to the left of h goes on with the edge just clockwise of h's twin.
Edge Judge::next(Edge h) const {
  const std::vector<Edge> leaving = around(h.second);
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
    orbits_.push_back(trace(h));
    seen.insert(orbits_.back().halfedges.begin(), orbits_.back().halfedges.end());
  }
}

bool Judge::is_mixed(const Orbit& orbit) const {
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

// A clockwise cycle bounds the face that its component lies in; all others bound their own.
void Judge::list_regions() {
  std::map<std::uint32_t, std::vector<std::uint32_t>> holes;
  std::vector<std::uint32_t> unbounded;
  for (std::uint32_t c = 0; c < map_.cycles.size(); ++c) {
    const Cycle& cycle = map_.cycles[c];
    if (doubled_area(cycle) > 0) {
      holes[c];
      continue;
    }
    const Orbit* around = innermost_around(component_.at(cycle[0]), cycle[0]);
    if (!around) unbounded.push_back(c);
    if (around && !around->cycles.empty()) holes[*around->cycles.begin()].push_back(c);
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
  label_components();
  count_duplicates();
  count_open();
  count_twins();
  count_crossings();
  const MapDefectCounts& n = report_.counts;
  if (n.duplicate == 0 && n.open == 0 && n.crossing == 0) {
    trace_orbits();
    count_mixed();
    if (options_.outer == OuterRule::Ignore) count_nested();
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

bool has_zero_length_edge(const TestMap& map) {
  for (const Cycle& cycle : map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      if (map.points[cycle[i]] == map.points[cycle[(i + 1) % cycle.size()]]) return true;
    }
  }
  return false;
}

OracleReport judge(const TestMap& map, const OracleOptions& options) {
  return Judge(map, options).run();
}

}  // namespace plumb::testing
