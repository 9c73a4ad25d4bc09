// Exact predicates of points in a view, the sweep over a region, its triangulation, and Delaunay
// flips.
//
// Triangulation: the sweep keeps, for the part of the region above each lower edge on the sweep
// line, the chain of points behind it that no triangle has closed off. Invariant: between the two
// edges of the part the chain is a path from bottom to top whose inner corners are reflex or flat
// as seen from the right. A new point closes off triangles with neighbours of the chain as long as
// it sees them; where no edge ends it divides the chain at its rightmost point, which it surely
// sees. Every point enters chains a constant number of times and every triangle removes one, so all
// walks together are O(n) besides the O(n log n) of the status.
//
// The edges at a point must alternate between lower and upper, starting by whether the region is
// below; otherwise some place would be covered twice or less than once, and there is no region.
//
// Delaunay: flips of sides that are no given edges, until every side is locally Delaunay; ties go
// to the lowest index, so the result does not depend on the order of flips.
//
// Tested by tests/space/triangulate_test.cpp.

#include "plumb/space/planar/triangulate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rational_predicates.h"

namespace plumb {

FlatView FlatView::of_plane(const PlaneTable& planes, PlaneId plane) {
  const PlaneRow& row = planes.row(plane);
  FlatView view;
  view.axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(row.n[i]) > std::fabs(row.n[view.axis])) view.axis = i;
  }
  view.is_mirrored = row.n[view.axis] < 0;  // Here |n| >= 1/2, so this is the exact sign.
  return view;
}

void FlatPoints::reset(FlatView view) {
  view_ = view;
  at_.clear();
  homogeneous_.clear();
  exact_.clear();
}

void FlatPoints::push_back(SpacePoint p) {
  const PointBox box = points_.box(p);
  at_.push_back(
      {{box.mid[view_.coordinate(0)], box.mid[view_.coordinate(1)]}, box.radius, p, p.is_input()});
}

// The nearest double is off by half a unit in the last place, at most 2^-53 of its magnitude.
void FlatPoints::push_back(SpacePoint p, const RoundedPoint3& nearest) {
  const std::array c{nearest.at.x, nearest.at.y, nearest.at.z};
  const Point2 mid{c[view_.coordinate(0)], c[view_.coordinate(1)]};
  const double half_ulp = 0x1p-53 * std::max(std::fabs(mid.x), std::fabs(mid.y));
  at_.push_back({mid, nearest.is_exact ? 0 : half_ulp, p, true});
}

const RationalPoint2& FlatPoints::exact_point(std::uint32_t i) const {
  if (exact_.size() < at_.size()) exact_.resize(at_.size());
  if (!exact_[i]) {
    const RationalPoint3 p = exact(points_, at_[i].point);
    const std::array<const Rational*, 3> c{&p.x, &p.y, &p.z};
    exact_[i] = RationalPoint2{*c[view_.coordinate(0)], *c[view_.coordinate(1)]};
  }
  return *exact_[i];
}

const FlatPoints::HomogeneousPoint& FlatPoints::homogeneous_point(std::uint32_t i) const {
  if (homogeneous_.size() < at_.size()) homogeneous_.resize(at_.size());
  if (!homogeneous_[i]) {
    IntegerRow row = homogeneous(points_, at_[i].point);
    homogeneous_[i] = HomogeneousPoint{std::move(row[view_.coordinate(0)]),
                                       std::move(row[view_.coordinate(1)]), std::move(row[3])};
  }
  return *homogeneous_[i];
}

// With E = error, the determinant is off by E times the four differences, by 2 E^2, and by 2^-50 of
// its products; the factor 2 covers the roundings of the bound.
FilteredSign turn_of_nearby(const Point2& a, const Point2& b, const Point2& c, double error) {
  const double ax = a.x - c.x, ay = a.y - c.y, bx = b.x - c.x, by = b.y - c.y;
  const double left = ax * by, right = ay * bx;
  const double sum = std::fabs(ax) + std::fabs(ay) + std::fabs(bx) + std::fabs(by);
  const double bound =
      2 * (error * sum + 2 * error * error + 0x1p-50 * (std::fabs(left) + std::fabs(right)));
  const double value = left - right;
  if (value > bound) return FilteredSign::Positive;
  return value < -bound ? FilteredSign::Negative : FilteredSign::Unsure;
}

// A difference of two coordinates is off by the sum of two radii, and by what subnormals lose,
// flushed or rounded: 2^-1000 covers it.
FilteredSign FlatPoints::nearby_orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k];
  const double radii = 2 * std::max({a.radius, b.radius, c.radius});
  return turn_of_nearby(a.mid, b.mid, c.mid, radii + 0x1p-1000);
}

Sign FlatPoints::orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k];
  if (a.point.is_input() && b.point.is_input() && c.point.is_input()) {
    return orient2d(a.mid, b.mid, c.mid);
  }
  const FilteredSign s = nearby_orient(i, j, k);
  if (is_decided(s)) return decide(Predicate::Orient2d, Rung::Filter, s);
  const auto& [ax, ay, aw] = homogeneous_point(i);
  const auto& [bx, by, bw] = homogeneous_point(j);
  const auto& [cx, cy, cw] = homogeneous_point(k);
  // The determinant of the homogeneous rows has the sign of the turn, as all weights are positive.
  const Integer det =
      ax * (by * cw - bw * cy) - ay * (bx * cw - bw * cx) + aw * (bx * cy - by * cx);
  count_rung(Predicate::Orient2d, Rung::Big);
  return sign_of(det);
}

// Rounding to nearest is monotone, so two different nearest doubles are in the order of the points.
Sign FlatPoints::compare_along(std::size_t i, std::size_t j, std::size_t side) const {
  const Entry &a = at_[i], &b = at_[j];
  const double x = side == 0 ? a.mid.x : a.mid.y, y = side == 0 ? b.mid.x : b.mid.y;
  const bool are_inputs = a.point.is_input() && b.point.is_input();
  if (are_inputs && std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y)) {
    return Sign::Zero;
  }
  if (a.is_nearest && b.is_nearest && (x < y || x > y)) {
    const FilteredSign s = x < y ? FilteredSign::Negative : FilteredSign::Positive;
    return decide(Predicate::CompareAxis, Rung::Filter, s);
  }
  return compare_axis(points_, a.point, b.point, view_.coordinate(side));
}

Sign FlatPoints::compare(std::uint32_t i, std::uint32_t j) const {
  const Sign x = compare_along(i, j, 0);
  return x != Sign::Zero ? x : compare_along(i, j, 1);
}

// Unless all four are input points, the sign is computed with rationals immediately.
Sign FlatPoints::incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                          std::uint32_t l) const {
  const Entry &a = at_[i], &b = at_[j], &c = at_[k], &d = at_[l];
  if (a.point.is_input() && b.point.is_input() && c.point.is_input() && d.point.is_input()) {
    return plumb::incircle(a.mid, b.mid, c.mid, d.mid);
  }
  return plumb::incircle(exact_point(i), exact_point(j), exact_point(k), exact_point(l));
}

PointTable2 FlatPoints::table() const {
  PointTable2 table;
  table.reserve(at_.size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (at_[i].point.is_input()) {
      table.push_back(at_[i].mid);
    } else {
      table.push_back(exact_point(i).x, exact_point(i).y);
    }
  }
  return table;
}

RegionSweep::RegionSweep(const PlanarPoints& points, std::span<const IndexEdge> edges,
                         Context* context)
    : points_(points), status_(Below{this}), context_(context) {
  rank_points();
  edges_.reserve(edges.size());
  for (const IndexEdge& e : edges) {
    const std::uint32_t from = rank_[e[0]], to = rank_[e[1]];
    // The region lies to the left of an edge: above an edge that leads to the right, and below an
    // edge that leads back.
    edges_.push_back({std::min(from, to), std::max(from, to), from < to});
  }
}

void RegionSweep::rank_points() {
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
    count_step();
    return points_.compare(i, j) == Sign::Negative;
  });
  rank_.resize(order_.size());
  for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
}

// Edges that leave the same point enter the status together, so they are sorted in advance.
void RegionSweep::start() {
  starts_.resize(edges_.size());
  std::iota(starts_.begin(), starts_.end(), 0U);
  std::sort(starts_.begin(), starts_.end(), [&](std::uint32_t a, std::uint32_t b) {
    count_step();
    if (edges_[a].left != edges_[b].left) return edges_[a].left < edges_[b].left;
    return a != b && is_below(a, b);
  });
  place_.resize(edges_.size());
  incoming_.assign(order_.size(), kNone);
}

/// Returns the order of two edges that some vertical line meets, or that start together.
bool RegionSweep::is_below(std::uint32_t a, std::uint32_t b) const {
  const SweepEdge &p = edges_[a], &q = edges_[b];
  if (p.left == q.left) {
    const Sign side = turn(a, q.right);
    // These edges are the two halves of a slit. The region below it ends before the region above
    // begins.
    return side == Sign::Zero ? !p.is_lower && q.is_lower : side == Sign::Positive;
  }
  if (p.left < q.left) return turn(a, q.left) == Sign::Positive;
  return turn(b, p.left) == Sign::Negative;
}

// Edges that end in the same point are neighbours in the status, so one of them leads to all of
// them.
std::pair<RegionSweep::Place, RegionSweep::Place> RegionSweep::edges_ending(std::uint32_t v) {
  if (incoming_[v] == kNone) {
    const Place at = status_.lower_bound(Probe{v});
    return {at, at};
  }
  Place begin = place_[incoming_[v]], end = std::next(begin);
  while (begin != status_.begin() && edges_[*std::prev(begin)].right == v) --begin;
  while (end != status_.end() && edges_[*end].right == v) ++end;
  return {begin, end};
}

namespace {

/// The points that no triangle has closed off, of the part of the region above a lower edge: bottom
/// to top, as indices of nodes.
struct Chain {
  std::uint32_t first = kNone;
  std::uint32_t last = kNone;
  std::uint32_t rightmost = kNone;
};

/// A point of a chain, with its neighbours.
struct ChainNode {
  std::uint32_t rank;
  std::uint32_t below = kNone;
  std::uint32_t above = kNone;
};

/// A part of a chain on one side of the point being swept.
struct ChainPart {
  std::uint32_t outer = kNone;  ///< The node at the edge that bounds the part.
  std::uint32_t inner = kNone;  ///< The node that the new point sees last.
  bool is_there() const { return outer != kNone; }
};

/// The triangulation of one region.
class RegionCut final : RegionSweep {
 public:
  RegionCut(const PlanarPoints& points, std::span<const IndexEdge> edges)
      : RegionSweep(points, edges), chain_(edges.size()) {}

  /// Appends the triangles, or returns false.
  bool run(std::vector<IndexTriangle>& triangles) {
    const std::size_t before = triangles.size();
    triangles_ = &triangles;
    start();
    for (std::uint32_t v = 0; v < order_.size(); ++v) {
      if (visit(v)) continue;
      triangles.resize(before);
      return false;
    }
    return true;
  }

 private:
  // ---------------------------------------------------------------- chains

  std::uint32_t add_node(std::uint32_t rank) {
    nodes_.push_back({rank});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  void link(std::uint32_t below, std::uint32_t above) {
    nodes_[below].above = above;
    nodes_[above].below = below;
  }

  /// Adds the triangle of the new point v and two neighbours of a chain, if both are visible from
  /// v.
  bool close_off(std::uint32_t v, std::uint32_t upper, std::uint32_t lower) {
    const std::uint32_t u = nodes_[upper].rank, l = nodes_[lower].rank;
    if (orient(v, u, l) != Sign::Positive) return false;
    triangles_->push_back({order_[v], order_[u], order_[l]});
    return true;
  }
  /// Closes off triangles downward from a node, and returns the last node that is visible from v.
  std::uint32_t walk_down(std::uint32_t v, std::uint32_t node) {
    while (nodes_[node].below != kNone && close_off(v, node, nodes_[node].below)) {
      node = nodes_[node].below;
    }
    return node;
  }
  /// Closes off triangles upward from a node, and returns the last node that is visible from v.
  std::uint32_t walk_up(std::uint32_t v, std::uint32_t node) {
    while (nodes_[node].above != kNone && close_off(v, nodes_[node].above, node)) {
      node = nodes_[node].above;
    }
    return node;
  }
  /// Closes off the part between two edges that end in v.
  void close_all(std::uint32_t v, std::uint32_t lower) {
    for (std::uint32_t n = chain_[lower].first; nodes_[n].above != kNone; n = nodes_[n].above) {
      close_off(v, nodes_[n].above, n);
    }
  }

  // ---------------------------------------------------------------- one point

  /// Sweeps over one point. The part below its ending edges keeps the chain `low`, the part above
  /// `high`; parts between ending edges are closed. Returns false if there is no region.
  bool visit(std::uint32_t v) {
    const auto [begin, end] = edges_ending(v);
    const std::uint32_t below = edge_below(begin);
    const bool is_inside_below = below != kNone && edges_[below].is_lower;
    if (!alternates(begin, end, is_inside_below)) return false;

    // Between ending edges, the region is closed off completely. Below the lowest and above the
    // highest of them it continues, with the chains that are visible from v.
    ChainPart low, high;
    if (begin == end) {
      if (is_inside_below) split(v, chain_[below], low, high);
    } else {
      if (is_inside_below) low = {chain_[below].first, walk_down(v, chain_[below].last)};
      for (Place p = begin; p != end; ++p) {
        if (!edges_[*p].is_lower) continue;
        if (std::next(p) != end) close_all(v, *p);
        if (std::next(p) == end) high = {chain_[*p].last, walk_up(v, chain_[*p].first)};
      }
    }
    status_.erase(begin, end);
    return leave(v, below, low, high);
  }

  /// Whether edges alternate between lower and upper ones, starting outside or inside the region.
  bool alternates(Place begin, Place end, bool is_inside) const {
    for (; begin != end; ++begin) {
      if (edges_[*begin].is_lower == is_inside) return false;
      is_inside = !is_inside;
    }
    return true;
  }

  /// Divides the chain of the part above `below`, in which v lies, at its rightmost point, which
  /// both sides keep.
  void split(std::uint32_t v, const Chain& below, ChainPart& low, ChainPart& high) {
    // The rightmost point is the last one that was swept in this part, so no point lies between it
    // and v.
    const std::uint32_t middle = below.rightmost, above = nodes_[middle].above;
    const std::uint32_t copy = add_node(nodes_[middle].rank);
    if (above != kNone) link(copy, above);
    high = {below.last == middle ? copy : below.last, walk_up(v, copy)};
    low = {below.first, walk_down(v, middle)};
  }

  /// Starts the edges that leave v and gives the parts around them their chains.
  bool leave(std::uint32_t v, std::uint32_t below, ChainPart low, ChainPart high) {
    std::uint32_t top = kNone;
    bool is_inside = low.is_there();
    const bool alternates = insert_leaving(v, [&](std::uint32_t e) {
      if (edges_[e].is_lower == is_inside) return false;
      is_inside = !is_inside;
      const std::uint32_t node = add_node(v);
      chain_[e] = {node, node, node};
      top = e;
      return true;
    });
    if (!alternates || is_inside != high.is_there()) return false;
    // If no edges leave, the parts below and above become one part.
    if (top == kNone) {
      if (low.is_there()) close_parts(v, below, low, high);
      return true;
    }
    if (low.is_there()) {
      const std::uint32_t node = add_node(v);
      link(low.inner, node);
      chain_[below] = {low.outer, node, node};
    }
    if (high.is_there()) {
      const std::uint32_t node = chain_[top].first;
      link(node, high.inner);
      chain_[top] = {node, high.outer, node};
    }
    return true;
  }

  /// Links both sides at v, which no edge leaves.
  void close_parts(std::uint32_t v, std::uint32_t below, ChainPart low, ChainPart high) {
    const std::uint32_t node = add_node(v);
    link(low.inner, node);
    link(node, high.inner);
    chain_[below] = {low.outer, high.outer, node};
  }

  std::vector<Chain> chain_;  // The chain of each lower edge in the status.
  std::vector<ChainNode> nodes_;
  std::vector<IndexTriangle>* triangles_ = nullptr;
};

}  // namespace

bool triangulate(const PlanarPoints& points, std::span<const IndexEdge> edges,
                 std::vector<IndexTriangle>& triangles) {
  return RegionCut(points, edges).run(triangles);
}

// ---------------------------------------------------------------- Delaunay

namespace {

/// Flips sides of triangles. Side 3 t + i of triangle t leads from corner i to the next corner.
class DelaunayFlips {
 public:
  DelaunayFlips(const PlanarPoints& points, std::span<const IndexEdge> edges,
                std::span<IndexTriangle> triangles)
      : points_(points), triangles_(triangles) {
    pair_sides(edges);
  }

  void run() {
    std::vector<std::uint32_t> open;
    for (std::uint32_t s = 0; s < other_.size(); ++s) open.push_back(s);
    while (!open.empty()) {
      const std::uint32_t s = open.back();
      open.pop_back();
      if (other_[s] == kNone || !should_flip(s)) continue;
      const std::uint32_t t = other_[s];
      flip(s);
      for (const std::uint32_t changed : {s, after(s), before(s), t, after(t), before(t)}) {
        open.push_back(changed);
      }
    }
  }

 private:
  static std::uint32_t after(std::uint32_t s) { return s % 3 == 2 ? s - 2 : s + 1; }
  static std::uint32_t before(std::uint32_t s) { return s % 3 == 0 ? s + 2 : s - 1; }
  std::uint32_t& origin(std::uint32_t s) { return triangles_[s / 3][s % 3]; }

  /// For each side that is not a given edge, finds the side on the other side of it.
  void pair_sides(std::span<const IndexEdge> edges) {
    // The two ends in ascending order, and the side.
    using Entry = std::pair<IndexEdge, std::uint32_t>;
    std::vector<Entry> entries;
    const auto key = [](std::uint32_t a, std::uint32_t b) {
      return IndexEdge{std::min(a, b), std::max(a, b)};
    };
    other_.assign(3 * triangles_.size(), kNone);
    for (std::uint32_t s = 0; s < other_.size(); ++s) {
      entries.emplace_back(key(origin(s), origin(after(s))), s);
    }
    for (const IndexEdge& e : edges) entries.emplace_back(key(e[0], e[1]), kNone);
    std::sort(entries.begin(), entries.end());
    for (std::size_t i = 0; i < entries.size();) {
      std::size_t j = i;
      while (j < entries.size() && entries[j].first == entries[i].first) ++j;
      // Two entries of one pair of ends are two triangles; a third one is the given edge (kNone
      // sorts last), which must not be flipped.
      if (j == i + 2 && entries[i + 1].second != kNone) {
        other_[entries[i].second] = entries[i + 1].second;
        other_[entries[i + 1].second] = entries[i].second;
      }
      i = j;
    }
  }

  /// Whether the opposite point lies inside of the circle of the triangle, or on it, if the flip
  /// joins the lowest index.
  bool should_flip(std::uint32_t s) {
    const std::uint32_t a = origin(s), b = origin(after(s)), c = origin(before(s));
    const std::uint32_t d = origin(before(other_[s]));
    const Sign in = points_.incircle(a, b, c, d);
    return in == Sign::Positive || (in == Sign::Zero && std::min(c, d) < std::min(a, b));
  }

  /// Replaces triangles (a, b, c) and (b, a, d) by (d, c, a) and (c, d, b), with side s = d -> c.
  void flip(std::uint32_t s) {
    const std::uint32_t t = other_[s];
    const std::uint32_t c = origin(before(s)), d = origin(before(t));
    const std::uint32_t bc = other_[after(s)], ad = other_[after(t)];
    // The triangle (d, c, a) replaces (a, b, c), and (c, d, b) replaces (b, a, d).
    const std::uint32_t a = origin(s), b = origin(t);
    const std::uint32_t ca = other_[before(s)], db = other_[before(t)];
    set(s, d, c, a);
    set(t, c, d, b);
    pair_sides(after(s), ca);
    pair_sides(before(s), ad);
    pair_sides(after(t), db);
    pair_sides(before(t), bc);
  }
  void set(std::uint32_t s, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    origin(s) = i;
    origin(after(s)) = j;
    origin(before(s)) = k;
  }
  void pair_sides(std::uint32_t s, std::uint32_t t) {
    other_[s] = t;
    if (t != kNone) other_[t] = s;
  }

  const PlanarPoints& points_;
  std::span<IndexTriangle> triangles_;
  // For each side, the side on the other side of it; kNone at given edges.
  std::vector<std::uint32_t> other_;
};

}  // namespace

void make_delaunay(const PlanarPoints& points, std::span<const IndexEdge> edges,
                   std::span<IndexTriangle> triangles) {
  DelaunayFlips(points, edges, triangles).run();
}

}  // namespace plumb
