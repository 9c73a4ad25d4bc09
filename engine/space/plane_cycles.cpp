#include "plumb/space/plane_cycles.h"

#include <cmath>

#include "plumb/base/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {

namespace {

/// The direction of a half-edge in plane n, as sign (n x m).
struct DirectionInPlane {
  PlaneId m;
  Sign sign;
};

DirectionInPlane direction_in_plane(const SpaceComplex& complex, PlaneId n, HalfedgeId h) {
  const auto& [p, q] = complex.edge_planes[h.value() >> 1U];
  const Sign along = SpaceComplex::is_reverse(h) ? Sign::Negative : Sign::Positive;
  if (p == n) return {q, along};
  if (q == n) return {p, -along};
  return {p, along * same_direction(complex.planes(), p, q, n, p)};
}

/// A coordinate that is not constant in the plane.
std::size_t scan_axis(const PlaneTable& planes, PlaneId plane) {
  const auto& n = planes.row(plane).n;
  // |n| <= 1 with the greatest component at least 1/2: the least one is below 0.58 of the length.
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(n[i]) < std::abs(n[least])) least = i;
  }
  return least;
}

/// Is x, a point of the line of h, between its ends (or one of them)?
bool is_between(const SpaceComplex& complex, HalfedgeId h, SpacePoint x) {
  const auto& [p, q] = complex.edge_planes[h.value() >> 1U];
  const Point3Table& points = complex.points();
  std::size_t axis = 0;
  while (minor_sign(complex.planes(), p, q, axis) == Sign::Zero) ++axis;
  const SpacePoint a = complex.vertex_point[complex.origin[h.value()].value()];
  const SpacePoint b = complex.vertex_point[complex.target(h).value()];
  const Sign from = compare_axis(points, a, x, axis), to = compare_axis(points, x, b, axis);
  return from == to || from == Sign::Zero || to == Sign::Zero;
}

}  // namespace

Sign same_direction(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  if (p == r && q == s) return Sign::Positive;
  if (p == s && q == r) return Sign::Negative;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Sign first = minor_sign(planes, p, q, axis);
    if (first != Sign::Zero) return first * minor_sign(planes, r, s, axis);
  }
  PLUMB_CHECK(false);
  return Sign::Zero;
}

// Of a directed edge d = s (n x m) and a point x of the plane: x - a = alpha d + beta (n x d), and
// m.(n x d) = s m.(n x (n x m)) = s ((n.m)^2 - n^2 m^2), which has the sign -s. So x lies to the left of
// the edge exactly when -s times its side of m is positive.
CycleSide side_of_cycle(const SpaceComplex& complex, UseId cycle, SpacePoint x) {
  const PlaneId plane = complex.facet_plane.empty()
                            ? PlaneId()
                            : complex.facet_plane[complex.use_facet[cycle.value()].value()];
  const Point3Table& points = complex.points();
  const std::size_t axis = scan_axis(complex.planes(), plane);
  int winding = 0;
  UseId u = cycle;
  Sign from = compare_axis(points, complex.vertex_point[complex.use_origin(u).value()], x, axis);
  do {
    const HalfedgeId h = complex.use_halfedge[u.value()];
    const SpacePoint end = complex.vertex_point[complex.target(h).value()];
    const Sign to = compare_axis(points, end, x, axis);
    const bool rises = from != Sign::Positive && to == Sign::Positive;
    const bool falls = from == Sign::Positive && to != Sign::Positive;
    if (rises || falls || from == Sign::Zero || to == Sign::Zero) {
      const DirectionInPlane d = direction_in_plane(complex, plane, h);
      const Sign left = -(d.sign * side(points, x, d.m));
      if (left == Sign::Zero && is_between(complex, h, x)) return CycleSide::On;
      if (rises && left == Sign::Positive) ++winding;
      if (falls && left == Sign::Negative) --winding;
    }
    from = to;
    u = complex.use_next[u.value()];
  } while (u != cycle);
  return winding != 0 ? CycleSide::Inside : CycleSide::Outside;
}

Sign corner_sign(const SpaceComplex& complex, UseId u) {
  const PlaneId plane = complex.facet_plane[complex.use_facet[u.value()].value()];
  const UseId before = complex.use_prev[u.value()];
  const HalfedgeId back = SpaceComplex::twin(complex.use_halfedge[before.value()]);
  const DirectionInPlane d1 = direction_in_plane(complex, plane, complex.use_halfedge[u.value()]);
  const DirectionInPlane d2 = direction_in_plane(complex, plane, back);
  return d1.sign * d2.sign * det3_sign(complex.planes(), plane, d1.m, d2.m);
}

bool is_outer(const SpaceComplex& complex, UseId cycle) {
  const Point3Table& points = complex.points();
  VertexId least = complex.use_origin(cycle);
  for (UseId u = complex.use_next[cycle.value()]; u != cycle; u = complex.use_next[u.value()]) {
    const VertexId v = complex.use_origin(u);
    if (v != least && compare_xyz(points, complex.vertex_point[v.value()],
                                  complex.vertex_point[least.value()]) == Sign::Negative) {
      least = v;
    }
  }
  UseId u = cycle;
  do {
    if (complex.use_origin(u) == least && corner_sign(complex, u) != Sign::Positive) return false;
    u = complex.use_next[u.value()];
  } while (u != cycle);
  return true;
}

}  // namespace plumb
