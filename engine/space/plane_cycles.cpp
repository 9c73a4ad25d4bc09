#include "plumb/space/plane_cycles.h"

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
