#include "plumb/predicates/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

// Sum of (p_i - o) x (p_{i+1} - o) with o the first point, and a bound on its error.
//
// u = 2^-52 covers every rounding mode. Each term (dx * ey - dy * ex) carries a relative error of
// at most (3 + small)u of |dx ey| + |dy ex|, as orient2d does; summing n terms adds less than n*u
// of the sum of the magnitudes. 4 + n covers both with room for the rounding of the bound itself.
// Gate: with every difference at most 2^500 nothing overflows for n <= 2^20 terms a sum of which
// stays below 2^1022; flushing and subnormal inputs read as zero change a difference by at most 3 *
// 2^-1022, a term by less than 2^-518, the sum by less than n * 2^-518, which `floor` covers.
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

}  // namespace plumb
