#include "plumb/predicates/query_point2.h"

#include <cmath>

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/rung_counters.h"
#include "plumb/predicates/segment2.h"

namespace plumb {
namespace {

/// By x and the box of a crossing; the query's rounding is within 2^-52 of its size.
FilteredSign compare_x_filter(const PlanePointsView& points, std::uint32_t i,
                              const QueryPoint2& q) {
  const double x = q.approx().x;
  if (!points.is_input(i)) {
    const Crossing2& c = points.crossing(i);
    return detail::compare_apart(c.x, x, c.radius + 0x1p-52 * std::fabs(x));
  }
  // Rounding is monotone: different approximations are in the right order.
  const Sign s = compare(points.inputs().approx(i).x, x);
  const bool is_exact = points.inputs().is_double(i) && q.is_double();
  return s != Sign::Zero || is_exact ? filtered(s) : FilteredSign::Unsure;
}

}  // namespace

QueryPoint2::QueryPoint2(Point2 p)
    : approx_(p), exact_{exact_rational(p.x), exact_rational(p.y)}, is_double_(true) {}

QueryPoint2::QueryPoint2(const RationalPoint2& p) : exact_(p) {
  const RoundedDouble x = round_to_double(p.x);
  const RoundedDouble y = round_to_double(p.y);
  is_double_ = x.error == Sign::Zero && y.error == Sign::Zero;
  approx_ = {clamped_to_finite(x.value), clamped_to_finite(y.value)};
}

Sign compare_x(const PlanePointsView& points, std::uint32_t i, const QueryPoint2& q) {
  const FilteredSign f = compare_x_filter(points, i, q);
  if (is_decided(f)) return decide(Predicate::PointQuery2, Rung::Filter, f);
  count_rung(Predicate::PointQuery2, Rung::Big);
  return sign_of(exact(points, i).x.compare(q.exact().x));
}

Sign compare_xy(const PlanePointsView& points, std::uint32_t i, const QueryPoint2& q) {
  const FilteredSign f = compare_x_filter(points, i, q);
  if (is_decided(f) && decided(f) != Sign::Zero) {
    return decide(Predicate::PointQuery2, Rung::Filter, f);
  }
  count_rung(Predicate::PointQuery2, Rung::Big);
  return compare_xy(exact(points, i), q.exact());
}

Sign orient2d(const PlanePointsView& points, std::uint32_t a, std::uint32_t b,
              const QueryPoint2& q) {
  const PointTable2& inputs = points.inputs();
  if (q.is_double() && inputs.is_double(a) && inputs.is_double(b)) {
    return orient2d(inputs.approx(a), inputs.approx(b), q.approx());
  }
  return orient2d(inputs.exact(a), inputs.exact(b), q.exact());
}

}  // namespace plumb
