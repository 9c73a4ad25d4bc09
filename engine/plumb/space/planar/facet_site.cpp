#include "plumb/space/planar/facet_site.h"

namespace plumb {

OtherPlane other_plane(const SpaceComplex& complex, EdgeId e, PlaneId plane) {
  const auto [p, q] = complex.edge_planes[e.value()];
  if (p == plane) return {q, Sign::Positive};
  if (q == plane) return {p, Sign::Negative};
  return {p, turn_about_line(complex.planes(), p, q, plane, p)};
}

Sign side_in_plane(const SpaceComplex& complex, PlaneId n, HalfedgeId h, const Point3Table& points,
                   SpacePoint x) {
  const OtherPlane m = other_plane(complex, SpaceComplex::edge_of(h), n);
  const Sign s = SpaceComplex::is_reverse(h) ? -m.turn : m.turn;
  return -(s * side(points, x, m.plane));
}

}  // namespace plumb
