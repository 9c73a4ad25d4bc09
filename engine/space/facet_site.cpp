#include "plumb/space/facet_site.h"

namespace plumb {

OtherPlane other_plane(const SpaceComplex& complex, EdgeId e, PlaneId plane) {
  const auto [p, q] = complex.edge_planes[e.value()];
  if (p == plane) return {q, Sign::Positive};
  if (q == plane) return {p, Sign::Negative};
  return {p, turn_about_line(complex.planes(), p, q, plane, p)};
}

}  // namespace plumb
