// A walk along a ray, from cell to cell.
//
// All questions are signs about the line of the ray, which runs to the right or upward: the side of
// a vertex, the turn from the line of an edge, and the order of a crossing and a vertex. In a
// trapezoid the ray meets the bottom or the top if it approaches that edge and crosses its line
// before the wall ahead; otherwise it passes the wall above or below its vertex, or meets the
// vertex. "Before" is lexicographic, because the trapezoids belong to the sheared plane. So
// vertical rays and edges need no cases of their own, except at the walls of ends at infinity.
//
// Tested by tests/plane/ray_walk_test.cpp.

#include "plumb/plane/query/ray_walk.h"

#include <algorithm>

namespace plumb {

RayWalk::RayWalk(const PlaneComplex& complex, const PlaneLocator& locator,
                 const PlaneTrapezoids& trapezoids, const QueryRay2& ray)
    : complex_(complex),
      points_(complex.points),
      locator_(locator),
      trapezoids_(trapezoids),
      ray_(ray),
      here_(locator.locate(ray.origin())),
      at_vertex_(here_.vertex) {
  if (here_.edge.is_valid()) is_along_ = turn_from(here_.edge) == Sign::Zero;
}

RationalPoint2 RayWalk::point() const {
  if (at_vertex_.is_valid()) return exact(points_, complex_.vertex_point[at_vertex_]);
  if (!at_edge_.is_valid()) return ray_.origin().exact();
  const PlaneLine& l = complex_.line[at_edge_];
  return crossing(points_, ray_, l.a, l.b);
}

bool RayWalk::advance() {
  if (here_.vertex.is_valid()) return leave_vertex();
  return here_.edge.is_valid() ? leave_edge() : leave_face();
}

// ---------------------------------------------------------------- cells

void RayWalk::enter(VertexId v) {
  here_ = {v, EdgeId(), FaceId(), complex_.mark(v)};
  at_vertex_ = v;
  at_edge_ = EdgeId();
}

void RayWalk::enter(EdgeId e) { here_ = {VertexId(), e, FaceId(), complex_.mark(e)}; }

void RayWalk::enter(FaceId f) { here_ = {VertexId(), EdgeId(), f, complex_.mark(f)}; }

// ---------------------------------------------------------------- vertices

// Of the edges to the right of a vertex, higher edges are steeper. Of the edges to the left, higher
// edges are less steep. Therefore bisection by turns finds the direction of the ray among them.
bool RayWalk::leave_vertex() {
  const VertexId v = here_.vertex;
  const bool right = ray_.goes_right();
  const auto edges = right ? trapezoids_.outgoing(v) : trapezoids_.incoming(v);
  const auto first = std::partition_point(edges.begin(), edges.end(), [&](EdgeId e) {
    return turn_from(e) == (right ? Sign::Positive : Sign::Negative);
  });
  if (first != edges.end() && turn_from(*first) == Sign::Zero) {
    enter(*first);
    is_along_ = true;
    return true;
  }
  const auto edges_below = static_cast<std::size_t>(first - edges.begin());
  trapezoid_ = right ? trapezoids_.right_of(v, edges_below) : trapezoids_.left_of(v, edges_below);
  enter_gap(v, edges, edges_below);
  return true;
}

/// Enters the face between two neighbours among the edges on one side of v.
void RayWalk::enter_gap(VertexId v, std::span<const EdgeId> edges, std::size_t edges_below) {
  const Dcel& dcel = complex_.dcel;
  if (edges_below > 0) {
    enter(dcel.face(first_half(edges[edges_below - 1])));
  } else if (!edges.empty()) {
    enter(dcel.face(twin(first_half(edges.front()))));
  } else if (dcel.is_isolated(v)) {
    enter(dcel.face(dcel.isolated_loop(v)));
  } else {  // The face above the highest edge on the other side.
    const auto others = ray_.goes_right() ? trapezoids_.incoming(v) : trapezoids_.outgoing(v);
    enter(dcel.face(first_half(others.back())));
  }
}

// ---------------------------------------------------------------- edges

bool RayWalk::leave_edge() {
  const EdgeId e = here_.edge;
  if (is_along_) return go_along(e);
  const bool goes_above = (turn_from(e) == Sign::Positive) == ray_.goes_right();
  trapezoid_ = beside(e, goes_above);
  const HalfedgeId h = first_half(e);
  enter(complex_.dcel.face(goes_above ? h : twin(h)));
  return true;
}

bool RayWalk::go_along(EdgeId e) {
  const HalfedgeId h = first_half(e);
  const VertexId end = ray_.goes_right() ? complex_.dcel.target(h) : complex_.dcel.origin(h);
  if (complex_.is_at_infinity(end)) return false;
  enter(end);
  return true;
}

/// Returns the trapezoid at the current place along an edge, above or below it. Without an edge,
/// returns the lowest trapezoid.
TrapezoidId RayWalk::beside(EdgeId e, bool is_above) const {
  const auto along = is_above ? trapezoids_.above(e) : trapezoids_.below(e);
  return *std::partition_point(along.begin(), along.end(), [&](TrapezoidId t) {
    const VertexId wall = trapezoids_[t].right;
    if (!wall.is_valid()) return false;
    return !(at_edge_.is_valid() ? is_left_of(at_edge_, wall) : is_start_left_of(wall));
  });
}

// ---------------------------------------------------------------- faces

bool RayWalk::leave_face() {
  if (!trapezoid_.is_valid()) trapezoid_ = beside(locator_.edge_below(ray_.origin()), true);
  for (;;) {
    const PlaneTrapezoid& t = trapezoids_[trapezoid_];
    const VertexId wall = ray_.goes_right() ? t.right : t.left;
    const Sign side = wall.is_valid() ? side_of(wall) : Sign::Zero;
    if (wall.is_valid() && side == Sign::Zero) {
      enter(wall);
      return true;
    }
    // If the vertex of the wall lies above the ray, the ray cannot meet the top before the wall,
    // and it passes the wall below the vertex. The same holds with above and below exchanged.
    for (const bool is_top : {false, true}) {
      const EdgeId e = is_top ? t.top : t.bottom;
      if (!e.is_valid() || side == (is_top ? Sign::Positive : Sign::Negative)) continue;
      if (!meets_before_wall(e, is_top, wall)) continue;
      at_vertex_ = VertexId();
      at_edge_ = e;
      is_along_ = false;
      enter(e);
      return true;
    }
    if (!wall.is_valid() || ray_.is_vertical()) return false;
    const bool passes_below = side == Sign::Positive;
    trapezoid_ = ray_.goes_right() ? (passes_below ? t.right_lower : t.right_upper)
                                   : (passes_below ? t.left_lower : t.left_upper);
  }
}

/// Whether the ray approaches an edge and crosses its line before the wall.
bool RayWalk::meets_before_wall(EdgeId e, bool is_top, VertexId wall) const {
  const Sign turn = turn_from(e);
  const bool approaches =
      turn != Sign::Zero && (turn == Sign::Positive) == (is_top == ray_.goes_right());
  if (!approaches) return false;
  return !wall.is_valid() || is_left_of(e, wall) == ray_.goes_right();
}

/// Returns Positive if the vertex of a wall lies above the ray's line. For a vertex at infinity it
/// returns whether that is the upper end, which is right for a vertical ray, too: the ray never
/// passes the wall, and the edge that is not tested for that reason, the bottom (top) of a
/// trapezoid beside a wall that starts below (above) everything, is at infinity itself.
Sign RayWalk::side_of(VertexId wall) const {
  if (!complex_.is_at_infinity(wall)) {
    return side(points_, ray_, complex_.vertex_point[wall]);
  }
  return trapezoids_.is_low(wall) ? Sign::Negative : Sign::Positive;
}

/// Whether the ray crosses the line of an edge on the left of the wall. The ray never crosses
/// exactly at the vertex of the wall, because the walk would then be at that vertex.
bool RayWalk::is_left_of(EdgeId crossed, VertexId wall) const {
  const PlaneLine& l = complex_.line[crossed];
  if (!complex_.is_at_infinity(wall)) {
    const std::uint32_t p = complex_.vertex_point[wall];
    return compare_crossing_xy(points_, ray_, l.a, l.b, p) == Sign::Negative;
  }
  const std::uint32_t p = complex_.line[trapezoids_.vertical_edge(wall)].a;
  const Sign order = compare_crossing_x(points_, ray_, l.a, l.b, p);
  return order == Sign::Negative || (order == Sign::Zero && !trapezoids_.is_low(wall));
}

bool RayWalk::is_start_left_of(VertexId wall) const {
  if (!complex_.is_at_infinity(wall)) {
    const std::uint32_t p = complex_.vertex_point[wall];
    return compare_xy(points_, p, ray_.origin()) == Sign::Positive;
  }
  const std::uint32_t p = complex_.line[trapezoids_.vertical_edge(wall)].a;
  const Sign order = compare_x(points_, p, ray_.origin());
  return order == Sign::Positive || (order == Sign::Zero && !trapezoids_.is_low(wall));
}

Sign RayWalk::turn_from(EdgeId e) const {
  const PlaneLine& l = complex_.line[e];
  return turn(points_, l.a, l.b, ray_);
}

}  // namespace plumb
