// The faces of a complex cut into trapezoids, by repeating the sweep that numbered the complex.
//
// Vertices and edges are numbered in the order of the sweep, so the order of events and of outgoing
// edges is known. For each edge, the trapezoids directly above and below it are stored. At a
// vertex, these trapezoids end and give the incoming edges of the vertex in their order, and new
// trapezoids begin. Only a vertex without edges to its left needs a search. Reference: M. de Berg,
// O. Cheong, M. van Kreveld, M. Overmars, Computational Geometry, 3rd edition (2008), chapter 6,
// for trapezoidal maps and their shear.
//
// Tested by tests/plane/ray_walk_test.cpp.

#include "plumb/plane/query/plane_trapezoids.h"

#include <algorithm>
#include <utility>

namespace plumb {

class PlaneTrapezoids::Builder {
 public:
  Builder(PlaneTrapezoids& result, const PlaneLocator& locator)
      : r_(result),
        c_(result.complex_),
        points_(c_.points),
        locator_(locator),
        above_(c_.edge_count()),
        below_(c_.edge_count()) {}

  void run();

 private:
  void list_edges();
  void open_left();
  bool next_wall();
  void add_wall(VertexId v, std::span<const EdgeId> incoming, std::span<const EdgeId> outgoing);
  TrapezoidId end_incoming(VertexId v, std::span<const EdgeId> incoming);
  TrapezoidId trapezoid_at(VertexId v) const;
  TrapezoidId begin(EdgeId bottom, EdgeId top, VertexId left);
  void order_incoming(VertexId v, std::span<EdgeId> edges) const;
  void list_along();

  VertexId left(EdgeId e) const { return c_.dcel.origin(first_half(e)); }
  VertexId right(EdgeId e) const { return c_.dcel.target(first_half(e)); }
  bool is_vertical(EdgeId e) const {
    const PlaneLine& l = c_.line[e];
    return compare_x(points_, l.a, l.b) == Sign::Zero;
  }
  std::uint32_t point_on(EdgeId e) const { return c_.line[e].a; }

  PlaneTrapezoids& r_;
  const PlaneComplex& c_;
  PlanePointsView points_;
  const PlaneLocator& locator_;

  std::vector<TrapezoidId> above_;  // The trapezoid above each edge at the sweep line.
  std::vector<TrapezoidId> below_;  // The trapezoid below each edge at the sweep line.
  TrapezoidId bottom_;              // The lowest trapezoid at the sweep line.
  std::vector<EdgeId> from_below_;  // The vertical edges from infinity, from left to right.
  std::vector<EdgeId> to_above_;    // The vertical edges to infinity, from left to right.
  std::size_t next_from_below_ = 0;
  std::size_t next_to_above_ = 0;
  std::size_t next_vertex_ = 0;
};

void PlaneTrapezoids::Builder::run() {
  list_edges();
  open_left();
  while (next_wall()) {
  }
  list_along();
}

// Sorts the edges by their ends with counting sorts, which are stable. Therefore outgoing edges are
// listed from bottom to top.
void PlaneTrapezoids::Builder::list_edges() {
  const std::size_t vertices = c_.vertex_count();
  for (auto* lists : {&r_.outgoing_, &r_.incoming_}) {
    const bool is_outgoing = lists == &r_.outgoing_;
    const auto slot = [&](std::size_t e) {
      const VertexId v = is_outgoing ? left(EdgeId(e)) : right(EdgeId(e));
      return c_.is_at_infinity(v) ? vertices : v.value();
    };
    lists->begin.assign(vertices + 2, 0);
    for (std::size_t e = 0; e < c_.edge_count(); ++e) ++lists->begin[slot(e) + 1];
    for (std::size_t v = 0; v <= vertices; ++v) lists->begin[v + 1] += lists->begin[v];
    std::vector<std::uint32_t> fill = lists->begin;
    lists->items.resize(c_.edge_count());
    for (std::size_t e = 0; e < c_.edge_count(); ++e) lists->items[fill[slot(e)]++] = EdgeId(e);
  }
  r_.first_right_.resize(vertices);
  r_.first_left_.resize(vertices);
}

// Edges from the left infinity have the least numbers, from bottom to top.
void PlaneTrapezoids::Builder::open_left() {
  std::vector<EdgeId> from_left;
  if (c_.has_frame()) {
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      const EdgeId e(i);
      const bool from_infinity = c_.is_at_infinity(left(e));
      const bool to_infinity = c_.is_at_infinity(right(e));
      if (!from_infinity && !to_infinity) continue;
      const bool vertical = is_vertical(e);
      if (from_infinity) (vertical ? from_below_ : from_left).push_back(e);
      if (to_infinity && vertical) to_above_.push_back(e);
    }
  }
  bottom_ = begin(EdgeId(), from_left.empty() ? EdgeId() : from_left.front(), VertexId());
  for (std::size_t i = 0; i < from_left.size(); ++i) {
    begin(from_left[i], i + 1 < from_left.size() ? from_left[i + 1] : EdgeId(), VertexId());
  }
}

// Adds the next wall, or returns false if there is none. At one x, the vertical edge from below is
// first, then the vertices, and then the edge that leads upward.
bool PlaneTrapezoids::Builder::next_wall() {
  const std::uint32_t low =
      next_from_below_ < from_below_.size() ? point_on(from_below_[next_from_below_]) : kNone;
  const std::uint32_t high =
      next_to_above_ < to_above_.size() ? point_on(to_above_[next_to_above_]) : kNone;
  const std::uint32_t here =
      next_vertex_ < c_.vertex_count() ? c_.vertex_point[next_vertex_] : kNone;
  const auto is_before = [&](std::uint32_t p, std::uint32_t q, bool at_same_x) {
    if (p == kNone || q == kNone) return p != kNone;
    const Sign order = compare_x(points_, p, q);
    return order == Sign::Negative || (order == Sign::Zero && at_same_x);
  };
  if (is_before(low, high, true) && is_before(low, here, true)) {
    const EdgeId e = from_below_[next_from_below_++];
    add_wall(left(e), {}, {&e, 1});
  } else if (is_before(high, here, false)) {
    const EdgeId e = to_above_[next_to_above_++];
    add_wall(right(e), {&e, 1}, {});
  } else if (here != kNone) {
    const VertexId v(next_vertex_++);
    const std::span<const EdgeId> listed = r_.incoming_.of(v);
    order_incoming(v, {r_.incoming_.items.data() + r_.incoming_.begin[v.value()], listed.size()});
    add_wall(v, listed, r_.outgoing_.of(v));
  } else {
    return false;
  }
  return true;
}

// Sorts the incoming edges of a vertex from bottom to top. The walk starts at any of them, and goes
// down to the lowest edge and then up, from trapezoid to trapezoid. The trapezoids between the
// edges end at this vertex.
void PlaneTrapezoids::Builder::order_incoming(VertexId v, std::span<EdgeId> edges) const {
  if (edges.size() < 2) return;
  const auto ends_here = [&](EdgeId e) { return e.is_valid() && right(e) == v; };
  const auto lower = [&](EdgeId e) { return r_[below_[e.value()]].bottom; };
  EdgeId e = edges.front();
  while (ends_here(lower(e))) e = lower(e);
  for (EdgeId& place : edges) {
    place = e;
    e = r_[above_[e.value()]].top;
  }
}

// Begins a trapezoid.
TrapezoidId PlaneTrapezoids::Builder::begin(EdgeId bottom, EdgeId top, VertexId left) {
  const TrapezoidId t(r_.trapezoids_.size());
  r_.trapezoids_.push_back({bottom, top, left, VertexId(), {}, {}, {}, {}});
  (bottom.is_valid() ? above_[bottom.value()] : bottom_) = t;
  if (top.is_valid()) below_[top.value()] = t;
  return t;
}

// Returns the trapezoid in which a vertex without edges to its left lies.
TrapezoidId PlaneTrapezoids::Builder::trapezoid_at(VertexId v) const {
  if (c_.is_at_infinity(v)) return bottom_;
  const EdgeId bottom = locator_.edge_below(v);
  return bottom.is_valid() ? above_[bottom.value()] : bottom_;
}

/// Ends the trapezoids on the left of a wall, and returns the highest of them.
TrapezoidId PlaneTrapezoids::Builder::end_incoming(VertexId v, std::span<const EdgeId> incoming) {
  TrapezoidId highest = incoming.empty() ? trapezoid_at(v) : below_[incoming.front().value()];
  r_.trapezoids_[highest].right = v;
  for (const EdgeId e : incoming) {
    highest = above_[e.value()];
    r_.trapezoids_[highest].right = v;
  }
  return highest;
}

void PlaneTrapezoids::Builder::add_wall(VertexId v, std::span<const EdgeId> incoming,
                                        std::span<const EdgeId> outgoing) {
  const bool is_ordinary = !c_.is_at_infinity(v);
  const TrapezoidId left_upper = end_incoming(v, incoming);
  const TrapezoidId left_lower = incoming.empty() ? left_upper : below_[incoming.front().value()];
  const EdgeId bottom = r_[left_lower].bottom;
  const EdgeId top = r_[left_upper].top;
  const TrapezoidId right_lower = begin(bottom, outgoing.empty() ? top : outgoing.front(), v);
  TrapezoidId right_upper = right_lower;
  for (std::size_t i = 0; i < outgoing.size(); ++i) {
    right_upper = begin(outgoing[i], i + 1 < outgoing.size() ? outgoing[i + 1] : top, v);
  }
  if (is_ordinary || !outgoing.empty()) {
    r_.trapezoids_[left_upper].right_upper = right_upper;
    r_.trapezoids_[right_upper].left_upper = left_upper;
  }
  if (is_ordinary || !incoming.empty()) {
    r_.trapezoids_[left_lower].right_lower = right_lower;
    r_.trapezoids_[right_lower].left_lower = left_lower;
  }
  if (!is_ordinary) return;
  r_.first_left_[v] = left_lower;
  r_.first_right_[v] = right_lower;
}

// Trapezoids are numbered from left to right along every edge.
void PlaneTrapezoids::Builder::list_along() {
  for (auto* lists : {&r_.above_, &r_.below_}) {
    const bool is_above = lists == &r_.above_;
    const auto slot = [&](const PlaneTrapezoid& t) {
      const EdgeId e = is_above ? t.bottom : t.top;
      return e.is_valid() ? e.value() : c_.edge_count();
    };
    lists->begin.assign(c_.edge_count() + 2, 0);
    for (const PlaneTrapezoid& t : r_.trapezoids_) ++lists->begin[slot(t) + 1];
    for (std::size_t e = 0; e <= c_.edge_count(); ++e) lists->begin[e + 1] += lists->begin[e];
    std::vector<std::uint32_t> fill = lists->begin;
    lists->items.resize(r_.trapezoids_.size());
    for (std::size_t t = 0; t < r_.trapezoids_.size(); ++t) {
      lists->items[fill[slot(r_.trapezoids_[t])]++] = TrapezoidId(t);
    }
  }
}

PlaneTrapezoids::PlaneTrapezoids(const PlaneComplex& complex, const PlaneLocator& locator)
    : complex_(complex) {
  Builder(*this, locator).run();
}

// ---------------------------------------------------------------- questions

TrapezoidId PlaneTrapezoids::right_of(VertexId v, std::size_t edges_below) const {
  return TrapezoidId(first_right_[v].value() + edges_below);
}

TrapezoidId PlaneTrapezoids::left_of(VertexId v, std::size_t edges_below) const {
  if (edges_below == 0) return first_left_[v];
  return above(incoming(v)[edges_below - 1]).back();
}

EdgeId PlaneTrapezoids::vertical_edge(VertexId at_infinity) const {
  for (const HalfedgeId h : complex_.dcel.around(at_infinity)) {
    if (!complex_.is_frame(h)) return edge_of(h);
  }
  return EdgeId();
}

bool PlaneTrapezoids::is_low(VertexId at_infinity) const {
  return complex_.dcel.origin(first_half(vertical_edge(at_infinity))) == at_infinity;
}

}  // namespace plumb
