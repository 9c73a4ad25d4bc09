// Filter. Where three planes through input points meet, the quotient of two determinants is computed with some 100 bits
// (double_double.h), and what lies clearly between two doubles is rounded by that. Errors in u^2 terms:
//
//   n = (q - p) x (r - p)     products 9, their sum 6 more: 15
//   d = -n.p                  15 + 9, two sums 12 more: 36
//   minors n x m              15 + 15 + 9 + 6 = 45
//   w = n.(m x k)             15 + 45 + 9 + 12 = 81
//   x = sum of d (n x m)      36 + 45 + 9 + 12 = 102
//
// 2^7 u^2 terms is taken for w and x; the slack pays for the roundings of the terms and for products of errors. With E and F
// these bounds of x and w, the quotient q = q1 + q2, q1 = x.high / w.high, q2 = (x - q1 w).high / w.high, is off by at most
// 2 (E + |q| F) / |w.high|: E + |q| F for the operands, at most 64 u^2 terms for x - q1 w and q2, where |w.high| >= 2^20 F.
// q is taken for rounded if q.high is what both ends of an interval twice as wide round to, and none of its points is
// q.high itself: so the coordinate is no double.
//
// Range. Coordinates are 0 or in [2^-60, 2^60], multiples of 2^-112: what comes of up to seven of them, with what is lost
// on the way, is 0 or in [2^-784, 2^440]; that of x - q1 w, too, as |w.high| >= 2^-400 and |q1| >= 2^-200.
#include "plumb/predicates/rounded_point3.h"

#include <algorithm>
#include <cmath>

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/double_double.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

// ---------------------------------------------------------------- filter

/// n.x + d = 0
struct TwofoldPlane {
  std::array<Twofold, 3> n;
  Twofold d;
};

using Corners = std::array<const Point3*, 3>;

std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

/// By bits where it is about equality: subnormal numbers may compare as zero.
bool is_in_range(double c) {
  return is_equal(c, 0) || (std::fabs(c) >= 0x1p-60 && std::fabs(c) <= 0x1p60);
}

/// (a x b)_i
Twofold cross_component(const std::array<Twofold, 3>& a, const std::array<Twofold, 3>& b,
                        std::size_t i) {
  using namespace twofold;
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return sum(product(a[j], b[k]), negative(product(a[k], b[j])));
}

std::array<Twofold, 3> cross(const std::array<Twofold, 3>& a, const std::array<Twofold, 3>& b) {
  return {cross_component(a, b, 0), cross_component(a, b, 1), cross_component(a, b, 2)};
}

TwofoldPlane plane_through(const Corners& corners) {
  using namespace twofold;
  const std::array p = coordinates(*corners[0]), q = coordinates(*corners[1]),
                   r = coordinates(*corners[2]);
  std::array<Twofold, 3> to_q, to_r;
  for (std::size_t i = 0; i < 3; ++i) {
    to_q[i] = difference(q[i], p[i]);
    to_r[i] = difference(r[i], p[i]);
  }
  TwofoldPlane plane;
  plane.n = cross(to_q, to_r);
  plane.d = negative(
      sum(sum(product(plane.n[0], p[0]), product(plane.n[1], p[1])), product(plane.n[2], p[2])));
  return plane;
}

double error_of(const Twofold& x) { return 0x1p-99 * x.terms; }

/// -x / w rounded to nearest, if that is clear and not -x / w itself; else 0.
double clear_quotient(const Twofold& x, const Twofold& w) {
  using namespace twofold;
  if (!(std::fabs(w.high) >= std::max(0x1p-400, 0x1p20 * error_of(w)))) return 0;
  const double q1 = -x.high / w.high;
  const Twofold rest = sum(negative(x), negative(product(w, q1)));
  const Twofold q = exact_sum(q1, rest.high / w.high, 0);
  const double error = 4 * (error_of(x) + std::fabs(q.high) * error_of(w)) / std::fabs(w.high);
  const bool is_clear = q.high + (q.low + error) == q.high && q.high + (q.low - error) == q.high &&
                        std::fabs(q.low) > error;
  return is_clear && std::fabs(q1) >= 0x1p-200 ? q.high : 0;
}

/// Of the point of three planes, coordinates that are clear and not exact; the others are 0.
std::array<double, 3> clear_coordinates(const std::array<Corners, 3>& corners) {
  using namespace twofold;
  std::array<TwofoldPlane, 3> planes;
  std::transform(corners.begin(), corners.end(), planes.begin(), plane_through);
  std::array<std::array<Twofold, 3>, 3> minors;  // of the two planes after each
  for (std::size_t i = 0; i < 3; ++i) {
    minors[i] = cross(planes[(i + 1) % 3].n, planes[(i + 2) % 3].n);
  }
  const auto combination = [](const auto& factor, const auto& vector) {
    return sum(sum(product(factor(0), vector(0)), product(factor(1), vector(1))),
               product(factor(2), vector(2)));
  };
  const Twofold w = combination([&](std::size_t i) { return planes[0].n[i]; },
                                [&](std::size_t i) { return minors[0][i]; });
  std::array<double, 3> found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    found[axis] = clear_quotient(combination([&](std::size_t i) { return planes[i].d; },
                                             [&](std::size_t i) { return minors[i][axis]; }),
                                 w);
  }
  return found;
}

/// Have the corners of a plane one coordinate along the axis?
bool is_across(const Corners& corners, std::size_t axis) {
  const auto along = [axis](const Point3* p) { return coordinates(*p)[axis]; };
  return is_equal(along(corners[0]), along(corners[1])) &&
         is_equal(along(corners[0]), along(corners[2]));
}

/// Of the planes that define a point, if there are three, all through input points within range.
std::optional<std::array<Corners, 3>> corners_of_planes(const Point3Table& points, SpacePoint x) {
  const PointSource& source = points.source(x);
  if (source.is_line()) return {};
  std::array<Corners, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const PlaneSource& plane = points.planes().source(source.plane(i));
    if (plane.is_explicit()) return {};
    for (std::size_t j = 0; j < 3; ++j) {
      const Point3& p = points.planes().points()[plane.code[j]];
      if (!std::ranges::all_of(coordinates(p), is_in_range)) return {};
      corners[i][j] = &p;
    }
  }
  return corners;
}

// ---------------------------------------------------------------- exactly

/// Rounding divides; that a common factor is left in numerator and denominator does not matter there.
RoundedDouble round_quotient(Integer& numerator, Integer& denominator, Rational& scratch) {
  mpq_ptr q = scratch.backend().data();
  mpz_swap(mpq_numref(q), numerator.backend().data());
  mpz_swap(mpq_denref(q), denominator.backend().data());
  const RoundedDouble result = round_to_double(scratch);
  mpz_swap(mpq_numref(q), numerator.backend().data());
  mpz_swap(mpq_denref(q), denominator.backend().data());
  return result;
}

}  // namespace

std::optional<RoundedPoint3> rung::rounded_filter(const Point3Table& points, SpacePoint x) {
  const auto corners = corners_of_planes(points, x);
  if (!corners || !rounds_to_nearest()) return {};
  std::array<double, 3> at = clear_coordinates(*corners);
  bool is_exact = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto across = std::ranges::find_if(
        *corners, [axis](const Corners& plane) { return is_across(plane, axis); });
    if (across != corners->end()) {
      at[axis] = coordinates(*across->front())[axis] + 0.0;  // not -0.0
    } else if (at[axis] == 0) {
      return {};
    } else {
      is_exact = false;
    }
  }
  return RoundedPoint3{{at[0], at[1], at[2]}, is_exact};
}

RoundedPoint3 rung::rounded_exact(const Point3Table& points, SpacePoint x) {
  IntegerRow row = homogeneous(points, x);
  Rational scratch;
  std::array<RoundedDouble, 3> c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = round_quotient(row[i], row[3], scratch);
  const auto is_exact = [&](std::size_t i) { return c[i].error == Sign::Zero; };
  return {{c[0].value, c[1].value, c[2].value}, is_exact(0) && is_exact(1) && is_exact(2)};
}

RoundedPoint3 rounded(const Point3Table& points, SpacePoint x) {
  if (x.is_input()) return {points.planes().point(x.input()), true};
  const std::optional<RoundedPoint3> clear = rung::rounded_filter(points, x);
  return clear ? *clear : rung::rounded_exact(points, x);
}

}  // namespace plumb
