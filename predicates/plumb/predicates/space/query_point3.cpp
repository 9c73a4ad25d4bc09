#include "plumb/predicates/space/query_point3.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

/// Returns a box around the nearest doubles. These are off by at most half a unit in the last
/// place, 2^-53 of the coordinate, or by half of the least subnormal number. If a coordinate
/// exceeds all doubles, the box is infinite.
PointBox rounded_box(const RationalPoint3& p) {
  PointBox box{{}, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const RoundedDouble x = round_to_double(coordinate(p, i));
    box.mid[i] = clamped_to_finite(x.value);
    if (x.error == Sign::Zero) continue;
    const double error = std::isinf(x.value) ? std::numeric_limits<double>::infinity()
                                             : 0x1p-52 * std::fabs(x.value) + 0x1p-1021;
    box.radius = std::max(box.radius, error);
  }
  return box;
}

Sign exact_side(const PlaneTable& planes, const RationalPoint3& q, PlaneId plane) {
  const IntegerRow row = planes.coefficients(plane);
  if (planes.is_frame(plane)) return sign_of(row[3].sign());
  const Rational value = row[0] * q.x + row[1] * q.y + row[2] * q.z + row[3];
  return sign_of(value.sign());
}

}  // namespace

QueryPoint3::QueryPoint3(const RationalPoint3& p)
    : box_(rounded_box(p)), parts_(FramedPoint3{p, {0, 0, 0}}) {}

const FramedPoint3& QueryPoint3::parts() const {
  if (parts_) return *parts_;
  if (points_ != nullptr) {
    parts_ = exact_parts(*points_, source_);
  } else {
    const auto& m = box_.mid;
    parts_ = {{exact_rational(m[0]), exact_rational(m[1]), exact_rational(m[2])}, {0, 0, 0}};
  }
  return *parts_;
}

Sign side(const Point3Table& points, const QueryPoint3& q, PlaneId plane) {
  if (q.source().is_valid()) return side(points, q.source(), plane);
  const PlaneTable& planes = points.planes();
  const FilteredSign s = rung::side_filter(q.box(), planes.row(plane));
  if (is_decided(s)) return decide(Predicate::SideOfPlane, Rung::Filter, s);
  const PlaneSource& source = planes.source(plane);
  if (!q.is_double() || source.is_explicit()) {
    count_rung(Predicate::SideOfPlane, Rung::Big);
    return exact_side(planes, q.exact(), plane);
  }
  const auto corner = [&](std::size_t i) { return planes.points()[source.code[i]]; };
  return -orient3d(corner(0), corner(1), corner(2), q.point());
}

Sign compare_axis(const Point3Table& points, SpacePoint x, const QueryPoint3& q, std::size_t axis) {
  if (q.source().is_valid()) return compare_axis(points, x, q.source(), axis);
  const PointBox box = points.box(x);
  if (box.radius == 0 && q.is_double()) {
    return decide(Predicate::CompareAxis, Rung::Filter,
                  filtered(compare(box.mid[axis], q.box().mid[axis])));
  }
  const FilteredSign s = rung::compare_axis_filter(box, q.box(), axis);
  if (is_decided(s)) return decide(Predicate::CompareAxis, Rung::Filter, s);
  if (is_far(box) && box.mid[axis] != 0) {
    return decide(Predicate::CompareAxis, Rung::Filter, filtered(sign_of(box.mid[axis])));
  }
  count_rung(Predicate::CompareAxis, Rung::Big);
  const FramedPoint3 at = exact_parts(points, x);
  const Sign infinite = sign_of(coordinate(at.infinite, axis).sign());
  if (infinite != Sign::Zero) return infinite;
  return sign_of(coordinate(at.finite, axis).compare(coordinate(q.exact(), axis)));
}

}  // namespace plumb
