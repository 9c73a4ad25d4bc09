#include "plumb/predicates/plane/plane_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/input/rung_counters.h"

namespace plumb {
namespace {

// Returns the sign of the sum of (p_i - o) x (p_{i+1} - o), with o the first point, if it exceeds
// its error bound.
//
// eps = 2^-52 covers every rounding mode. Each term dx ey - dy ex has an error of at most
// (3 + small) eps of |dx ey| + |dy ex|, as in orient2d. The sum of n terms adds less than n eps of
// the sum of these magnitudes. 4 + n covers both and the rounding of the bound itself. With
// differences of at most 2^500 and n <= 2^20 terms, sums stay below 2^1022, so nothing overflows.
// Flushing, and subnormal inputs that are read as zero, change a difference by at most 3 * 2^-1022,
// a term by less than 2^-518, and the sum by less than n 2^-518, which the last term of the bound
// covers.
FilteredSign area_filter(const PointTable2& points, std::span<const std::uint32_t> polygon) {
  const auto n = static_cast<double>(polygon.size());
  const Point2 o = points.approx(polygon[0]);
  double sum = 0;
  double magnitude = 0;
  double reach = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point2 p = points.approx(polygon[i]);
    const Point2 q = points.approx(polygon[i + 1]);
    const double dx = p.x - o.x;
    const double dy = p.y - o.y;
    const double ex = q.x - o.x;
    const double ey = q.y - o.y;
    const double left = dx * ey;
    const double right = dy * ex;
    sum += left - right;
    magnitude += std::fabs(left) + std::fabs(right);
    reach = std::max({reach, std::fabs(dx), std::fabs(dy), std::fabs(ex), std::fabs(ey)});
  }
  constexpr double kUnit = std::numeric_limits<double>::epsilon();
  const double bound = (n + 4) * kUnit * magnitude * (1 + 4 * kUnit) + n * 0x1p-517;
  if (!(reach <= 0x1p500) || polygon.size() > (1U << 20U)) return FilteredSign::Unsure;
  if (sum > bound) return FilteredSign::Positive;
  return -sum > bound ? FilteredSign::Negative : FilteredSign::Unsure;
}

}  // namespace

Rational twice_polygon_area(const PointTable2& points, std::span<const std::uint32_t> polygon) {
  Rational sum = 0;
  RationalPoint2 previous = points.exact(polygon.back());
  for (const std::uint32_t i : polygon) {
    RationalPoint2 p = points.exact(i);
    sum += previous.x * p.y - previous.y * p.x;
    previous = std::move(p);
  }
  return sum;
}

Sign polygon_area_sign(const PointTable2& points, std::span<const std::uint32_t> polygon) {
  if (polygon.size() < 3) return Sign::Zero;
  if (points.all_double()) {
    const FilteredSign s = area_filter(points, polygon);
    if (is_decided(s)) return decided(s);
  }
  return sign_of(twice_polygon_area(points, polygon));
}

namespace {

/// Returns a bound of the distance of x from its approximation. The relative error of the
/// approximation is at most 2^-53.
double reach_of(const PointTable2& inputs, std::uint32_t i) {
  return inputs.is_double(i) ? 0 : 0x1p-52 * std::fabs(inputs.approx(i).x);
}

Sign compare_x_inputs(const PointTable2& inputs, std::uint32_t i, std::uint32_t j) {
  if (i == j) return Sign::Zero;
  const Sign seen = compare(inputs.approx(i).x, inputs.approx(j).x);
  // Rounding is monotone, so approximations that differ have the same order as the exact numbers.
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
