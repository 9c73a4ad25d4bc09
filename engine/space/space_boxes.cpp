#include "plumb/space/space_boxes.h"

#include <cmath>
#include <limits>

namespace plumb {

namespace {

Box3 everywhere() {
  constexpr double kInfinity = Box3::kInfinity;
  return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
}

}  // namespace

// A sum of two doubles is off by one rounding, 2^-52 of it, and by what flushing subnormal operands
// loses.
Box3 box_of(const PointBox& point) {
  if (point.radius == 0) return {point.mid, point.mid};
  Box3 box;
  if (!std::isfinite(point.radius)) return everywhere();
  for (std::size_t i = 0; i < 3; ++i) {
    const double slack = 0x1p-50 * (std::fabs(point.mid[i]) + point.radius) + 0x1p-1000;
    box.low[i] = point.mid[i] - (point.radius + slack);
    box.high[i] = point.mid[i] + (point.radius + slack);
  }
  return box;
}

Box3 box_of_constructed(const Point3Table& points, SpacePoint p) {
  const PointBox point = points.box(p);
  if (!is_far(point)) return box_of(point);
  Box3 box = box_of(points.near_box(p));
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.mid[i] == 0) continue;
    const bool is_above = point.mid[i] > 0;
    box.low[i] = is_above ? std::numeric_limits<double>::max() : -Box3::kInfinity;
    box.high[i] = is_above ? Box3::kInfinity : std::numeric_limits<double>::lowest();
  }
  return box;
}

Box3 box_of(const SpaceComplex& complex, EdgeId e) {
  Box3 box = box_of(complex, complex.origin[2 * e.value()]);
  box.add(box_of(complex, complex.origin[2 * e.value() + 1]));
  return box;
}

Box3 box_of(const SpaceComplex& complex, FacetId f) {
  Box3 box;
  const UseId first = complex.cycles_of(f).front();
  UseId u = first;
  do {
    box.add(box_of(complex, complex.use_origin(u)));
    u = complex.use_next[u.value()];
  } while (u != first);
  return box;
}

Box3 box_of(const SpaceComplex& complex) {
  Box3 box;
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) box.add(box_of(complex, VertexId(v)));
  return box;
}

}  // namespace plumb
