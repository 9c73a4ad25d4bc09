// Finds the cells that a ray meets: parity of edges that pass the origin of the shadows, exact
// signs, distances.
//
// A point of the line of the ray has the shadow 0. A vertex is met if both coordinates of its
// shadow are 0, an edge if its shadow passes through 0 strictly between its ends, a facet if an odd
// number of its edges cross the half-axis to the right of 0, with ends on the axis counted as
// below. If the line lies in a facet's plane, all shadows are on one line and parity finds nothing,
// but vertices and edges of the boundary are found. Along an axis, one sign of a vertex suffices
// there, and facets in parallel planes are left out.
//
// Signs of shadows and their cross products are linear and quadratic in coordinates, which may
// depend on the symbol R of the frame (docs/design/frame.md, Lemma 2): an exact value is a
// FramedNumber, a product a polynomial of degree 2 in R, decided by its leading coefficient that is
// not 0. Balls decide nearly all signs before exact values are needed.
//
// Tested by tests/space/space_locator_test.cpp.

#include "plumb/space/query/space_ray.h"

#include <cmath>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

/// Returns a ball around a rational number. Half a unit in the last place is less than 2^-52 of the
/// value.
Ball ball_of(const Rational& value) {
  const double rounded = clamped_to_finite(nearest_double(value));
  return Ball::about(rounded, std::fabs(rounded) * 0x1p-52);
}

/// Returns the axis along which a direction is largest.
std::size_t largest_component(const RationalPoint3& d) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (abs(coordinate(d, i)) > abs(coordinate(d, k))) k = i;
  }
  return k;
}

}  // namespace

SpaceRay::SpaceRay(const SpaceComplex& complex, const QueryPoint3& origin, std::size_t axis,
                   bool is_reverse)
    : complex_(complex),
      origin_(origin),
      k_(axis),
      is_reverse_(is_reverse),
      is_axis_parallel_(true) {}

SpaceRay::SpaceRay(const SpaceComplex& complex, const QueryPoint3& origin,
                   const RationalPoint3& direction)
    : SpaceRay(complex, origin, largest_component(direction), false) {
  const Rational& along = coordinate(direction, k_);
  PLUMB_CHECK(along != 0);
  is_reverse_ = along < 0;
  std::array<Rational, 3>& slopes = exact_slope_.emplace();
  for (std::size_t c = 0; c < 2; ++c) {
    const std::size_t i = side_axis(c);
    slopes[i] = coordinate(direction, i) / along;
    slope_[i] = ball_of(slopes[i]);
    is_axis_parallel_ = is_axis_parallel_ && slopes[i] == 0;
  }
}

// --- quantities, in balls or exactly

/// Returns v - O along an axis.
template <>
Ball SpaceRay::offset<Ball>(VertexId v, std::size_t axis) const {
  const PointBox x = complex_.points().box(point_of(v)), &o = origin_.box();
  return Ball::about(x.mid[axis], x.radius) - Ball::about(o.mid[axis], o.radius);
}

template <>
FramedNumber SpaceRay::offset<FramedNumber>(VertexId v, std::size_t axis) const {
  const FramedPoint3 x = exact_parts(complex_.points(), point_of(v)), &o = origin_.parts();
  return {coordinate(x.finite, axis) - coordinate(o.finite, axis),
          coordinate(x.infinite, axis) - coordinate(o.infinite, axis)};
}

template <>
Ball SpaceRay::shadow<Ball>(VertexId v, std::size_t c) const {
  const std::size_t i = side_axis(c);
  if (is_axis_parallel_) return offset<Ball>(v, i);
  return offset<Ball>(v, i) - slope_[i] * offset<Ball>(v, k_);
}

template <>
FramedNumber SpaceRay::shadow<FramedNumber>(VertexId v, std::size_t c) const {
  const std::size_t i = side_axis(c);
  return offset<FramedNumber>(v, i) - exact_slope(i) * offset<FramedNumber>(v, k_);
}

/// Returns the slope at which the line leaves a plane: n . slope.
Ball SpaceRay::rough_climb(PlaneId plane) const {
  const PlaneRow& row = complex_.planes().row(plane);
  Ball climb = Ball::about(row.n[k_], row.normal_error);
  if (is_axis_parallel_) return climb;
  for (const std::size_t i : {side_axis(0), side_axis(1)}) {
    climb = climb + Ball::about(row.n[i], row.normal_error) * slope_[i];
  }
  return climb;
}

/// Returns the same value exactly.
Rational SpaceRay::climb(PlaneId plane) const {
  const IntegerRow row = complex_.planes().coefficients(plane);
  const std::size_t i = side_axis(0), j = side_axis(1);
  return row[k_] + row[i] * exact_slope(i) + row[j] * exact_slope(j);
}

/// Returns the place where the line meets a plane, along axis k: -s(O) / climb.
template <>
Ball SpaceRay::plane_distance<Ball>(PlaneId plane) const {
  const PlaneRow& row = complex_.planes().row(plane);
  const PointBox& o = origin_.box();
  Ball value = Ball::about(row.d, row.offset_error);
  for (std::size_t i = 0; i < 3; ++i) {
    value = value + Ball::about(row.n[i], row.normal_error) * Ball::about(o.mid[i], o.radius);
  }
  return -value / rough_climb(plane);
}

template <>
FramedNumber SpaceRay::plane_distance<FramedNumber>(PlaneId plane) const {
  const IntegerRow row = complex_.planes().coefficients(plane);
  FramedNumber value{0, 0};
  (complex_.planes().is_frame(plane) ? value.infinite : value.finite) = row[3];
  for (std::size_t i = 0; i < 3; ++i) {
    value.finite += row[i] * coordinate(origin_.parts().finite, i);
    value.infinite += row[i] * coordinate(origin_.parts().infinite, i);
  }
  return Rational(-1 / climb(plane)) * value;
}

template <class Number>
Number SpaceRay::distance(const SpaceRayHit& hit) const {
  const Number along = hit.item.kind() == SpaceItem::Kind::Vertex
                           ? offset<Number>(hit.item.vertex(), k_)
                           : plane_distance<Number>(hit.plane);
  return is_reverse_ ? -along : along;
}

SpaceRayHit SpaceRay::hit_of(SpaceItem item, PlaneId plane) const {
  SpaceRayHit hit{item, plane, {}};
  hit.distance = distance<Ball>(hit);
  return hit;
}

/// Returns the plane of the edge that the line certainly crosses more steeply, because it gives the
/// smaller error. The line crosses one of the planes, because it is not parallel to the edge.
PlaneId SpaceRay::crossing_plane(EdgeId e) const {
  const auto& [p, q] = complex_.edge_planes[e];
  const Ball at_p = rough_climb(p), at_q = rough_climb(q);
  const auto margin = [](const Ball& b) { return std::fabs(b.mid) - b.error; };
  if (margin(at_p) > 0 || margin(at_q) > 0) return margin(at_p) < margin(at_q) ? q : p;
  return climb(p) != 0 ? p : q;
}

// --- signs

Sign SpaceRay::shadow_sign(VertexId v, std::size_t c) const {
  if (is_axis_parallel_) {
    return compare_axis(complex_.points(), point_of(v), origin_, side_axis(c));
  }
  const FilteredSign s = shadow<Ball>(v, c).sign();
  return is_decided(s) ? decided(s) : shadow<FramedNumber>(v, c).sign();
}

namespace {

/// Returns the sign of a d - b c, a polynomial in R.
Sign cross_sign(const FramedNumber& a, const FramedNumber& b, const FramedNumber& c,
                const FramedNumber& d) {
  const Rational square = a.infinite * d.infinite - b.infinite * c.infinite;
  if (square != 0) return sign_of(square.sign());
  const Rational infinite =
      a.infinite * d.finite + a.finite * d.infinite - b.infinite * c.finite - b.finite * c.infinite;
  if (infinite != 0) return sign_of(infinite.sign());
  const Rational finite = a.finite * d.finite - b.finite * c.finite;
  return sign_of(finite.sign());
}

}  // namespace

/// Returns the sign of the cross product of two shadows. Along an axis, with doubles only, it is an
/// orient2d.
Sign SpaceRay::turn(VertexId a, VertexId b) const {
  const PointBox x = complex_.points().box(point_of(a)), y = complex_.points().box(point_of(b));
  if (is_axis_parallel_ && x.radius == 0 && y.radius == 0 && origin_.is_double()) {
    const std::size_t i = side_axis(0), j = side_axis(1);
    const auto& o = origin_.box().mid;
    return orient2d({x.mid[i], x.mid[j]}, {y.mid[i], y.mid[j]}, {o[i], o[j]});
  }
  const Ball rough =
      shadow<Ball>(a, 0) * shadow<Ball>(b, 1) - shadow<Ball>(a, 1) * shadow<Ball>(b, 0);
  if (is_decided(rough.sign())) return decided(rough.sign());
  return cross_sign(shadow<FramedNumber>(a, 0), shadow<FramedNumber>(a, 1),
                    shadow<FramedNumber>(b, 0), shadow<FramedNumber>(b, 1));
}

Sign SpaceRay::side(const SpaceRayHit& hit) const {
  const FilteredSign s = hit.distance.sign();
  return is_decided(s) ? decided(s) : distance<FramedNumber>(hit).sign();
}

Sign SpaceRay::compare(const SpaceRayHit& x, const SpaceRayHit& y) const {
  if (x.item == y.item) return Sign::Zero;
  const FilteredSign s = (x.distance - y.distance).sign();
  if (is_decided(s)) return decided(s);
  return (distance<FramedNumber>(x) - distance<FramedNumber>(y)).sign();
}

RationalPoint3 SpaceRay::point(const SpaceRayHit& hit) const {
  const Rational t = distance<FramedNumber>(hit).finite;
  const Rational along = is_reverse_ ? Rational(-t) : t;
  std::array<Rational, 3> x;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = coordinate(origin_.exact(), i) + (i == k_ ? along : Rational(along * exact_slope(i)));
  }
  return {x[0], x[1], x[2]};
}

// --- what the line meets

/// Returns how the shadow of an edge passes the origin. Requires that neither end is at the origin.
/// An edge passes on the right if it crosses the axis j = 0 at i > 0. Points with j = 0 count as
/// below, so that crossings are counted consistently along a cycle.
SpaceRay::Passing SpaceRay::passing(const End& a, const End& b) const {
  const auto &p = a.place.at, &q = b.place.at;
  // Both ends are on one side of an axis, and not on the right.
  for (std::size_t c = 0; c < 2; ++c) {
    if (p[c] == q[c] && p[c] != Sign::Zero && (c == 1 || p[c] == Sign::Negative)) {
      return Passing::Aside;
    }
  }
  // A sign of the cross product is needed only if both ends are not on the right of the axis.
  const bool rises = q[1] == Sign::Positive;
  const bool crosses = rises != (p[1] == Sign::Positive);
  if (p[0] == Sign::Positive && q[0] == Sign::Positive) {
    return crosses ? Passing::OnRight : Passing::Aside;
  }
  const Sign t = turn(a.vertex, b.vertex);
  if (t == Sign::Zero) {
    const bool is_between = p[0] * q[0] == Sign::Negative || p[1] * q[1] == Sign::Negative;
    return is_between ? Passing::Through : Passing::Aside;
  }
  return crosses && (t == Sign::Positive) == rises ? Passing::OnRight : Passing::Aside;
}

void SpaceRay::add_hits(VertexId v, std::vector<SpaceRayHit>& hits) const {
  if (end(v).place.is_origin()) hits.push_back(hit_of(v, PlaneId()));
}

/// Adds an edge that the line meets inside. Returns whether the edge passes on the right.
bool SpaceRay::add_hit_inside_edge(EdgeId e, const End& a, const End& b,
                                   std::vector<SpaceRayHit>& hits) const {
  if (a.place.is_origin() || b.place.is_origin()) return false;
  const Passing how = passing(a, b);
  if (how == Passing::Through) hits.push_back(hit_of(e, crossing_plane(e)));
  return how == Passing::OnRight;
}

void SpaceRay::add_hits(EdgeId e, std::vector<SpaceRayHit>& hits) const {
  const HalfedgeId h(2 * std::size_t{e.value()});
  const VertexId a = complex_.origin[h], b = complex_.target(h);
  add_hits(a, hits);
  add_hits(b, hits);
  add_hit_inside_edge(e, end(a), end(b), hits);
}

/// Adds the cells of a cycle that the line meets, and returns whether there are any. Each edge that
/// passes on the right inverts is_inside. Nearly all edges have both ends strictly on one side
/// along j, which one sign of each vertex shows.
bool SpaceRay::add_hits_of_cycle(UseId first, bool& is_inside,
                                 std::vector<SpaceRayHit>& hits) const {
  const std::size_t before = hits.size();
  const auto end_at = [&](VertexId v, Sign along_j) {
    return End{v, {{shadow_sign(v, 0), along_j}}};
  };
  VertexId v = complex_.use_origin(first);
  const Sign start = shadow_sign(v, 1);
  Sign here = start;
  UseId u = first;
  do {
    const UseId after = complex_.use_next[u];
    const VertexId next = complex_.use_origin(after);
    const Sign there = after == first ? start : shadow_sign(next, 1);
    if (here * there != Sign::Positive) {
      const End a = end_at(v, here);
      if (a.place.is_origin()) hits.push_back(hit_of(v, PlaneId()));
      const EdgeId e = SpaceComplex::edge_of(complex_.use_halfedge[u]);
      if (add_hit_inside_edge(e, a, end_at(next, there), hits)) is_inside = !is_inside;
    }
    v = next;
    here = there;
    u = after;
  } while (u != first);
  return hits.size() > before;
}

// Seen against the axis, the direction of the corners follows from the normal. The facet is not met
// if the origin lies beyond one of the sides.
bool SpaceRay::passes_by(FacetId f) const {
  const PlaneRow& row = complex_.planes().row(complex_.facet_plane[f]);
  // The facet is not parallel to the ray.
  const bool is_seen = std::fabs(row.n[k_]) > static_cast<double>(row.normal_error);
  if (!is_seen || !is_axis_parallel_ || !origin_.is_double()) return false;
  if (complex_.cycles_of(f).size() != 1) return false;
  const std::size_t i = side_axis(0), j = side_axis(1);
  const UseId first = complex_.cycles_of(f)[0];
  std::array<Point2, 3> corner;
  UseId u = first;
  for (Point2& at : corner) {
    const SpacePoint p = point_of(complex_.use_origin(u));
    if (!p.is_input()) return false;
    const PointBox box = complex_.points().box(p);
    at = {box.mid[i], box.mid[j]};
    u = complex_.use_next[u];
  }
  if (u != first) return false;
  const Point2 o{origin_.box().mid[i], origin_.box().mid[j]};
  const Sign outside = row.n[k_] > 0 ? Sign::Negative : Sign::Positive;
  return orient2d(corner[0], corner[1], o) == outside ||
         orient2d(corner[1], corner[2], o) == outside ||
         orient2d(corner[2], corner[0], o) == outside;
}

/// Whether the ray runs along an axis that is parallel to a plane. Sets `row` to the coefficients
/// of the plane in that case.
bool SpaceRay::runs_along(PlaneId plane, IntegerRow& row) const {
  const PlaneRow& rough = complex_.planes().row(plane);
  const bool may_run_along =
      is_axis_parallel_ && std::fabs(rough.n[k_]) <= static_cast<double>(rough.normal_error);
  if (!may_run_along) return false;
  row = complex_.planes().coefficients(plane);
  return row[k_].is_zero();
}

// The shadow (s, t) of a vertex satisfies m s + n t = 0, where m and n are the coefficients of the
// plane along the two side axes. Therefore the sign of one coordinate determines the sign of the
// other one. An edge meets the line if these signs differ at its ends.
void SpaceRay::add_hits_in_plane(FacetId f, const IntegerRow& row,
                                 std::vector<SpaceRayHit>& hits) const {
  // The coordinate along c is 0 only if the coordinate along the other axis is 0, too.
  const std::size_t c = abs(row[side_axis(0)]) <= abs(row[side_axis(1)]) ? 0 : 1;
  const auto sign = [&](VertexId v) { return shadow_sign(v, c); };
  const std::size_t before = hits.size();
  for (const UseId first : complex_.cycles_of(f)) {
    const Sign start = sign(complex_.use_origin(first));
    Sign here = start;
    UseId u = first;
    do {
      const UseId after = complex_.use_next[u];
      const Sign there = after == first ? start : sign(complex_.use_origin(after));
      const EdgeId e = SpaceComplex::edge_of(complex_.use_halfedge[u]);
      if (here == Sign::Zero) hits.push_back(hit_of(complex_.use_origin(u), PlaneId()));
      if (here * there == Sign::Negative) hits.push_back(hit_of(e, crossing_plane(e)));
      here = there;
      u = after;
    } while (u != first);
  }
  if (hits.size() == before) return;
  for (const VertexId v : complex_.inner_of(f)) {
    if (sign(v) == Sign::Zero) hits.push_back(hit_of(v, PlaneId()));
  }
}

void SpaceRay::add_hits(FacetId f, std::vector<SpaceRayHit>& hits) const {
  if (passes_by(f)) return;
  const PlaneId plane = complex_.facet_plane[f];
  if (IntegerRow row; runs_along(plane, row)) {
    if (plumb::side(complex_.points(), origin_, plane) != Sign::Zero) return;
    return add_hits_in_plane(f, row, hits);
  }
  bool is_inside = false, meets_boundary = false;
  for (const UseId first : complex_.cycles_of(f)) {
    if (add_hits_of_cycle(first, is_inside, hits)) meets_boundary = true;
  }
  // Inner vertices are tested before the facet itself, because the line may meet one of them.
  if (!is_inside && !meets_boundary) return;
  const std::size_t before = hits.size();
  for (const VertexId v : complex_.inner_of(f)) add_hits(v, hits);
  if (meets_boundary || hits.size() > before) return;
  hits.push_back(hit_of(f, plane));
}

}  // namespace plumb
