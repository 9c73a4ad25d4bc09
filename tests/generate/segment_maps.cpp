// With |coordinate| <= 2^13: cross products < 2^29, x = numerator / denominator has a numerator
// < 2^14 * 2^29 + ... < 2^44, and comparing two parameters multiplies two cross products: < 2^58.
#include "plumb/testing/segment_maps.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace plumb::testing {
namespace {

using Int = std::int64_t;

// A parameter along a segment, denominator > 0.
struct Parameter {
  Int num;
  Int den;
};

struct Stop {
  Parameter at;
  std::uint32_t vertex;
};

// x and y in lowest terms with positive denominators: a key.
using PointKey = std::array<Int, 4>;

struct PlaneEdge {
  std::uint32_t from, to;
  Int dx, dy;  // direction from -> to
};

Int dx(const IntegerSegment& s) { return s.x2 - s.x1; }
Int dy(const IntegerSegment& s) { return s.y2 - s.y1; }

PointKey point_at(const IntegerSegment& s, Parameter t) {
  const auto coordinate = [&](Int start, Int delta) {
    const Int num = start * t.den + t.num * delta;
    const Int divisor = std::gcd(num, t.den);
    return std::pair{num / divisor, t.den / divisor};
  };
  const auto [xn, xd] = coordinate(s.x1, dx(s));
  const auto [yn, yd] = coordinate(s.y1, dy(s));
  return {xn, xd, yn, yd};
}

// Adds the parameters on `s` of its common points with `t`: the crossing, or ends of `t` on it.
void add_stops(const IntegerSegment& s, const IntegerSegment& t, std::vector<Parameter>& stops) {
  const Int px = t.x1 - s.x1;
  const Int py = t.y1 - s.y1;
  Int den = dx(s) * dy(t) - dy(s) * dx(t);
  if (den == 0) {
    if (px * dy(s) - py * dx(s) != 0) return;
    const Int length = dx(s) * dx(s) + dy(s) * dy(s);
    for (const Int along :
         {px * dx(s) + py * dy(s), (t.x2 - s.x1) * dx(s) + (t.y2 - s.y1) * dy(s)}) {
      if (along >= 0 && along <= length) stops.push_back({along, length});
    }
    return;
  }
  Int on_s = px * dy(t) - py * dx(t);
  Int on_t = px * dy(s) - py * dx(s);
  if (den < 0) {
    den = -den;
    on_s = -on_s;
    on_t = -on_t;
  }
  if (on_s >= 0 && on_s <= den && on_t >= 0 && on_t <= den) stops.push_back({on_s, den});
}

bool before(Parameter a, Parameter b) { return a.num * b.den < b.num * a.den; }

class Planariser {
 public:
  explicit Planariser(const std::vector<IntegerSegment>& segments);
  TestMap listed();

 private:
  void split_all();
  void collect_edges();
  void sort_around_vertices();
  void trace();
  bool remove_bridges();
  std::vector<std::uint32_t> left_to_right() const;

  std::vector<IntegerSegment> segments_;
  std::vector<std::vector<PointKey>> points_on_;  // per segment, in order along it
  std::vector<PointKey> points_;                  // sorted: the vertices
  std::vector<PlaneEdge> edges_;                  // both directions, twins adjacent (xor 1)
  std::vector<std::uint32_t> next_;
  std::vector<std::uint32_t> orbit_;
  std::vector<Cycle> cycles_;
};

Planariser::Planariser(const std::vector<IntegerSegment>& segments) {
  for (const IntegerSegment& s : segments) {
    if (dx(s) != 0 || dy(s) != 0) segments_.push_back(s);
  }
  split_all();
  collect_edges();
  do {
    sort_around_vertices();
    trace();
  } while (remove_bridges());
}

void Planariser::split_all() {
  for (const IntegerSegment& s : segments_) {
    std::vector<Parameter> stops{{0, 1}, {1, 1}};
    for (const IntegerSegment& t : segments_) {
      if (&s != &t) add_stops(s, t, stops);
    }
    std::sort(stops.begin(), stops.end(), before);
    std::vector<PointKey>& points = points_on_.emplace_back();
    for (const Parameter t : stops) points.push_back(point_at(s, t));
    points.erase(std::unique(points.begin(), points.end()), points.end());
    points_.insert(points_.end(), points.begin(), points.end());
  }
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
}

void Planariser::collect_edges() {
  const auto vertex = [&](const PointKey& key) {
    const auto place = std::lower_bound(points_.begin(), points_.end(), key);
    return static_cast<std::uint32_t>(place - points_.begin());
  };
  std::vector<PlaneEdge> found;
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    for (std::size_t i = 0; i + 1 < points_on_[s].size(); ++i) {
      PlaneEdge e{vertex(points_on_[s][i]), vertex(points_on_[s][i + 1]), dx(segments_[s]),
                  dy(segments_[s])};
      if (e.from > e.to) e = {e.to, e.from, -e.dx, -e.dy};
      found.push_back(e);
    }
  }
  const auto ends = [](const PlaneEdge& e) { return std::pair{e.from, e.to}; };
  std::sort(found.begin(), found.end(),
            [&](const PlaneEdge& a, const PlaneEdge& b) { return ends(a) < ends(b); });
  for (const PlaneEdge& e : found) {
    if (!edges_.empty() && ends(edges_[edges_.size() - 2]) == ends(e)) continue;
    edges_.push_back(e);
    edges_.push_back({e.to, e.from, -e.dx, -e.dy});
  }
}

bool is_lower(const PlaneEdge& e) { return e.dy < 0 || (e.dy == 0 && e.dx < 0); }

bool counter_clockwise_before(const PlaneEdge& a, const PlaneEdge& b) {
  if (is_lower(a) != is_lower(b)) return is_lower(b);
  return a.dx * b.dy - a.dy * b.dx > 0;
}

// next_[h]: the half-edge just clockwise of h's twin around h's end.
void Planariser::sort_around_vertices() {
  std::vector<std::uint32_t> order(edges_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (edges_[a].from != edges_[b].from) return edges_[a].from < edges_[b].from;
    return counter_clockwise_before(edges_[a], edges_[b]);
  });
  next_.assign(edges_.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && edges_[order[end]].from == edges_[order[begin]].from) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      next_[order[i] ^ 1U] = order[i == begin ? end - 1 : i - 1];
    }
  }
}

void Planariser::trace() {
  cycles_.clear();
  const auto untraced = static_cast<std::uint32_t>(edges_.size());
  orbit_.assign(edges_.size(), untraced);
  for (std::uint32_t start = 0; start < edges_.size(); ++start) {
    if (orbit_[start] != untraced) continue;
    Cycle cycle;
    for (std::uint32_t h = start; orbit_[h] == untraced; h = next_[h]) {
      orbit_[h] = static_cast<std::uint32_t>(cycles_.size());
      cycle.push_back(edges_[h].from);
    }
    cycles_.push_back(std::move(cycle));
  }
}

// A bridge has the same orbit on both sides.
bool Planariser::remove_bridges() {
  std::vector<PlaneEdge> kept;
  for (std::size_t h = 0; h < edges_.size(); h += 2) {
    if (orbit_[h] == orbit_[h + 1]) continue;
    kept.push_back(edges_[h]);
    kept.push_back(edges_[h + 1]);
  }
  const bool removed = kept.size() < edges_.size();
  edges_ = std::move(kept);
  return removed;
}

double approximate(Int num, Int den) { return static_cast<double>(num) / static_cast<double>(den); }

// The used vertices from left to right, as a map that was digitised strip by strip would list them.
std::vector<std::uint32_t> Planariser::left_to_right() const {
  std::vector<bool> used(points_.size(), false);
  for (const PlaneEdge& e : edges_) used[e.from] = true;
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (used[v]) order.emplace_back(approximate(points_[v][0], points_[v][1]), v);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> vertices;
  for (const auto& [x, v] : order) vertices.push_back(v);
  return vertices;
}

TestMap Planariser::listed() {
  TestMap map;
  std::vector<std::uint32_t> name(points_.size(), 0);
  for (const std::uint32_t v : left_to_right()) {
    const auto& [xn, xd, yn, yd] = points_[v];
    name[v] = map.add_point(BigRational(xn, xd), BigRational(yn, yd));
  }
  for (Cycle& cycle : cycles_) {
    for (std::uint32_t& v : cycle) v = name[v];
  }
  const auto least = [](const Cycle& cycle) {
    return *std::min_element(cycle.begin(), cycle.end());
  };
  std::stable_sort(cycles_.begin(), cycles_.end(),
                   [&](const Cycle& a, const Cycle& b) { return least(a) < least(b); });
  map.cycles = std::move(cycles_);
  return map;
}

}  // namespace

TestMap subdivision_of(const std::vector<IntegerSegment>& segments) {
  return Planariser(segments).listed();
}

}  // namespace plumb::testing
