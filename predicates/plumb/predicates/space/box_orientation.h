// The orientation of four points that are known by boxes.
//
// Let r be the largest radius of the boxes. Each of the three differences of points differs from
// the difference of the middles by at most 2 r in each coordinate. Let s be the sums of the
// absolute coordinates of the three differences of the middles, each plus 6 r. The determinant is
// linear in each difference. If one difference is replaced by a vector whose coordinates are at
// most 2 r, it is at most 2 r times the product of the other two sums s. So the determinants of the
// points and of the middles differ by at most
//
//     2 r (s1 s2 + s2 s3 + s3 s1)
//
// The bound below is twice as large, which covers its own rounding errors. Its products that
// underflow are far below the floor of the filter. If a radius is infinite, no sign is certain.
#pragma once

#include <algorithm>
#include <cmath>

#include "plumb/predicates/input/input_filters.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/space/point3_table.h"

namespace plumb::rung {

/// Returns the sign of orient3d() of all points in the boxes, or Unsure if the filter does not show
/// that they have the same sign.
inline FilteredSign orient3d_filter(const PointBox& a, const PointBox& b, const PointBox& c,
                                    const PointBox& d) {
  const auto middle = [](const PointBox& box) {
    return Point3{box.mid[0], box.mid[1], box.mid[2]};
  };
  const auto distance = [&](const PointBox& box) {
    return std::fabs(box.mid[0] - d.mid[0]) + std::fabs(box.mid[1] - d.mid[1]) +
           std::fabs(box.mid[2] - d.mid[2]);
  };
  const double r = std::max({a.radius, b.radius, c.radius, d.radius});
  const double s1 = distance(a) + 6 * r, s2 = distance(b) + 6 * r, s3 = distance(c) + 6 * r;
  const double moved = 4 * r * (s1 * s2 + s2 * s3 + s3 * s1);
  return detail::certify(detail::orient3d(middle(a), middle(b), middle(c), middle(d)),
                         constants::kOrient3dError, constants::kOrient3dFloor + moved);
}

}  // namespace plumb::rung
