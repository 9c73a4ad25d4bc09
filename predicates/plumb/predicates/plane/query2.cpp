// Predicates on points and rays of queries, which are in no table.
//
// Each is a filter and exact rationals; queries are too few for stages between. The filter carries
// an error bound with every number (Rough): each operation adds its rounding and what flushing
// subnormal numbers may lose, so a sign is certain if the value exceeds its error.
//
// Tested by tests/predicates/plane_points_test.cpp and tests/plane/ray_walk_test.cpp.

#include "plumb/predicates/plane/query2.h"

#include <cmath>
#include <limits>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/segment2.h"

namespace plumb {
namespace {

/// Compares x of a point, or the box of a crossing, with the nearest double of the query. The
/// relative error of this double is at most 2^-52.
FilteredSign compare_x_filter(const PlanePointsView& points, std::uint32_t i,
                              const QueryPoint2& q) {
  const double x = q.approx().x;
  if (!points.is_input(i)) {
    const Crossing2& c = points.crossing(i);
    return detail::compare_apart(c.x, x, c.radius + 0x1p-52 * std::fabs(x));
  }
  // Rounding is monotone, so approximations that differ have the same order as the exact numbers.
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

namespace {

// A number with a bound of its error. Every operation adds 2^-52 of its result, which is its
// rounding in any direction, and kUnderflow: a product has up to six places where flushing to zero,
// or reading a subnormal number as zero, loses less than kLeast. The factor 1 + 2^-48 covers the
// roundings of errors themselves, six operations for a product, each down by at most 2^-52.
struct Rough {
  double value;
  double error;
};

constexpr double kLeast = std::numeric_limits<double>::min();
constexpr double kGreatest = std::numeric_limits<double>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnderflow = 8 * kLeast;

Rough rough(double value, double error) {
  const double size = std::fabs(value);
  const double bound = (error + 0x1p-52 * size) * (1 + 0x1p-48) + kUnderflow;
  // In a mode that rounds toward zero, the result of an overflow is the greatest double and not
  // infinity.
  return {value, size < kGreatest && bound < kGreatest ? bound : kInfinity};
}
Rough operator-(Rough p, Rough q) { return rough(p.value - q.value, p.error + q.error); }
Rough operator+(Rough p, Rough q) { return rough(p.value + q.value, p.error + q.error); }
Rough operator*(Rough p, Rough q) {
  return rough(p.value * q.value,
               std::fabs(p.value) * q.error + std::fabs(q.value) * p.error + p.error * q.error);
}

FilteredSign known_sign(Rough r) {
  // For NaNs and for infinite errors, both comparisons are false.
  if (r.value > r.error) return filtered(Sign::Positive);
  if (-r.value > r.error) return filtered(Sign::Negative);
  return FilteredSign::Unsure;
}

struct RoughPoint {
  Rough x;
  Rough y;
};

/// Returns a double that represents a number: the number itself, or the nearest double, clamped to
/// the greatest double. Any operation may read a subnormal double as zero.
Rough rounded(double value, bool is_exact) {
  const double size = std::fabs(value);
  if (is_exact) return {value, size < kLeast ? kLeast : 0};
  return {value, size < kGreatest ? 0x1p-52 * size + kLeast : kInfinity};
}
RoughPoint rough(const QueryPoint2& q) {
  return {rounded(q.approx().x, q.is_double()), rounded(q.approx().y, q.is_double())};
}
RoughPoint rough(const PlanePointsView& points, std::uint32_t i) {
  if (!points.is_input(i)) {
    const Crossing2& c = points.crossing(i);
    return {{c.x, c.radius}, {c.y, c.radius}};
  }
  const Point2 p = points.inputs().approx(i);
  const bool is_exact = points.inputs().is_double(i);
  return {rounded(p.x, is_exact), rounded(p.y, is_exact)};
}

template <class Point>
auto cross(const Point& u, const Point& v) {
  return u.x * v.y - u.y * v.x;
}
RationalPoint2 difference(const RationalPoint2& p, const RationalPoint2& q) {
  return {p.x - q.x, p.y - q.y};
}
RoughPoint difference(const RoughPoint& p, const RoughPoint& q) { return {p.x - q.x, p.y - q.y}; }

/// The parameter of the crossing of two lines, which is origin + direction numerator / denominator.
template <class Number>
struct Share {
  Number numerator;
  Number denominator;
};
template <class Number, class Point>
Share<Number> share(const Point& origin, const Point& direction, const Point& a, const Point& b) {
  const Point along = difference(b, a);
  return {cross(difference(a, origin), along), cross(direction, along)};
}

FilteredSign compare_crossing_x_filter(const PlanePointsView& points, const QueryRay2& ray,
                                       std::uint32_t a, std::uint32_t b, std::uint32_t i) {
  const RoughPoint origin = rough(ray.origin());
  const RoughPoint direction = rough(ray.direction());
  const auto [numerator, denominator] =
      share<Rough>(origin, direction, rough(points, a), rough(points, b));
  const FilteredSign below = known_sign(denominator);
  const FilteredSign above =
      known_sign((origin.x - rough(points, i).x) * denominator + direction.x * numerator);
  if (!is_decided(below) || !is_decided(above)) return FilteredSign::Unsure;
  return filtered(decided(below) == decided(above) ? Sign::Positive : Sign::Negative);
}

RationalPoint2 turned_right(const RationalPoint2& d, bool goes_right) {
  if (goes_right) return d;
  return {-d.x, -d.y};
}

}  // namespace

QueryRay2::QueryRay2(const RationalPoint2& origin, const RationalPoint2& direction)
    : origin_(origin),
      goes_right_(direction.x > 0 || (direction.x == 0 && direction.y > 0)),
      direction_(turned_right(direction, goes_right_)) {}

Sign side(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t i) {
  const FilteredSign f =
      known_sign(cross(rough(ray.direction()), difference(rough(points, i), rough(ray.origin()))));
  if (is_decided(f)) return decide(Predicate::RayQuery2, Rung::Filter, f);
  count_rung(Predicate::RayQuery2, Rung::Big);
  const Rational exactly =
      cross(ray.direction().exact(), difference(exact(points, i), ray.origin().exact()));
  return sign_of(exactly.sign());
}

Sign turn(const PlanePointsView& points, std::uint32_t a, std::uint32_t b, const QueryRay2& ray) {
  const FilteredSign f =
      known_sign(cross(difference(rough(points, b), rough(points, a)), rough(ray.direction())));
  if (is_decided(f)) return decide(Predicate::RayQuery2, Rung::Filter, f);
  count_rung(Predicate::RayQuery2, Rung::Big);
  const Rational exactly =
      cross(difference(exact(points, b), exact(points, a)), ray.direction().exact());
  return sign_of(exactly.sign());
}

Sign compare_crossing_x(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                        std::uint32_t b, std::uint32_t i) {
  const FilteredSign f = compare_crossing_x_filter(points, ray, a, b, i);
  if (is_decided(f)) return decide(Predicate::RayQuery2, Rung::Filter, f);
  count_rung(Predicate::RayQuery2, Rung::Big);
  return sign_of(crossing(points, ray, a, b).x.compare(exact(points, i).x));
}

Sign compare_crossing_xy(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                         std::uint32_t b, std::uint32_t i) {
  const FilteredSign f = compare_crossing_x_filter(points, ray, a, b, i);
  if (is_decided(f)) return decide(Predicate::RayQuery2, Rung::Filter, f);
  count_rung(Predicate::RayQuery2, Rung::Big);
  const RationalPoint2 p = crossing(points, ray, a, b);
  const RationalPoint2 q = exact(points, i);
  const Sign by_x = sign_of(p.x.compare(q.x));
  return by_x != Sign::Zero ? by_x : sign_of(p.y.compare(q.y));
}

RationalPoint2 crossing(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                        std::uint32_t b) {
  const RationalPoint2& origin = ray.origin().exact();
  const RationalPoint2& direction = ray.direction().exact();
  const auto [numerator, denominator] =
      share<Rational>(origin, direction, exact(points, a), exact(points, b));
  const Rational t = numerator / denominator;
  return {origin.x + t * direction.x, origin.y + t * direction.y};
}

}  // namespace plumb
