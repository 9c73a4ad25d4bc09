#include "plumb/predicates/plane_points.h"

#include <cmath>

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/rung_counters.h"

namespace plumb {
namespace {

/// A coordinate that is no double is within 2^-53 of its size from its approximation.
double reach_of(const PointTable2& inputs, std::uint32_t i) {
  return inputs.is_double(i) ? 0 : 0x1p-52 * std::fabs(inputs.approx(i).x);
}

Sign compare_x_inputs(const PointTable2& inputs, std::uint32_t i, std::uint32_t j) {
  if (i == j) return Sign::Zero;
  const Sign seen = compare(inputs.approx(i).x, inputs.approx(j).x);
  // Rounding is monotone: different approximations are in the right order.
  const bool is_known = seen != Sign::Zero || (inputs.is_double(i) && inputs.is_double(j));
  count_rung(Predicate::ComparePoints2, is_known ? Rung::Filter : Rung::Big);
  if (is_known) return seen;
  return sign_of(inputs.exact(i).x.compare(inputs.exact(j).x));
}

}  // namespace

Sign compare_xy(const PlanePointsView& points, std::uint32_t i, std::uint32_t j) {
  if (i == j) return Sign::Zero;
  const PointTable2& inputs = points.inputs();
  if (points.is_input(i)) {
    return points.is_input(j) ? compare_xy(inputs, i, j)
                              : -compare_xy(inputs, points.crossing(j), i);
  }
  return compare_xy(points, points.crossing(i), j);
}

Sign compare_xy(const PlanePointsView& points, const Crossing2& p, std::uint32_t i) {
  return points.is_input(i) ? compare_xy(points.inputs(), p, i)
                            : compare_xy(points.inputs(), p, points.crossing(i));
}

Sign compare_x(const PlanePointsView& points, const Crossing2& p, std::uint32_t i) {
  const PointTable2& inputs = points.inputs();
  const bool is_input = points.is_input(i);
  const double x = is_input ? inputs.approx(i).x : points.crossing(i).x;
  const double radius = p.radius + (is_input ? reach_of(inputs, i) : points.crossing(i).radius);
  const FilteredSign f = detail::compare_apart(p.x, x, radius);
  if (is_decided(f)) return decide(Predicate::CompareCrossings2, Rung::Filter, f);
  count_rung(Predicate::CompareCrossings2, Rung::Big);
  return sign_of(exact(inputs, p).x.compare(exact(points, i).x));
}

Sign compare_x(const PlanePointsView& points, std::uint32_t i, std::uint32_t j) {
  if (!points.is_input(i)) return compare_x(points, points.crossing(i), j);
  return points.is_input(j) ? compare_x_inputs(points.inputs(), i, j)
                            : -compare_x(points, points.crossing(j), i);
}

RationalPoint2 exact(const PlanePointsView& points, std::uint32_t i) {
  return points.is_input(i) ? points.inputs().exact(i) : exact(points.inputs(), points.crossing(i));
}

}  // namespace plumb
