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
// Fixed widths. The top 106 bits of exact integers x and w are mantissas of 1/2 at least, off by 2 u^2 at most: they go the same
// way, with themselves for terms.
//
// Range. Coordinates are 0 or in [2^-60, 2^60], multiples of 2^-112: what comes of up to seven of them, with what is lost
// on the way, is 0 or in [2^-784, 2^440]; that of x - q1 w, too, as |w.high| >= 2^-400 and |q1| >= 2^-200. Quotients of mantissas
// lie between 1/2 and 2; a coordinate in [2^-1000, 2^1000] is such a one times a power of two.
#include "plumb/predicates/rounded_point3.h"

#include <algorithm>
#include <cmath>

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/double_double.h"
#include "plumb/predicates/point3_exact.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/scaled.h"

namespace plumb {
namespace {

// ---------------------------------------------------------------- filter

using twofold::difference;
using twofold::exact_sum;
using twofold::negative;
using twofold::product;
using twofold::sum;

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
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return sum(product(a[j], b[k]), negative(product(a[k], b[j])));
}

std::array<Twofold, 3> cross(const std::array<Twofold, 3>& a, const std::array<Twofold, 3>& b) {
  return {cross_component(a, b, 0), cross_component(a, b, 1), cross_component(a, b, 2)};
}

TwofoldPlane plane_through(const Corners& corners) {
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

/// Of a plane, if it goes through input points.
std::optional<Corners> corners_of(const PlaneTable& planes, PlaneId plane) {
  const PlaneSource& source = planes.source(plane);
  if (source.is_explicit()) return {};
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = &planes.points()[source.code[i]];
  return corners;
}

/// Of the planes that define a point, if there are three, all through input points within range.
std::optional<std::array<Corners, 3>> corners_of_planes(const Point3Table& points, SpacePoint x) {
  const PointSource& source = points.source(x);
  if (source.is_line()) return {};
  std::array<Corners, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Corners> found = corners_of(points.planes(), source.plane(i));
    if (!found) return {};
    for (const Point3* p : *found) {
      if (!std::ranges::all_of(coordinates(*p), is_in_range)) return {};
    }
    corners[i] = *found;
  }
  return corners;
}

/// `clear`: coordinates that are not exact, 0 for others; these have to be those of planes across their axes.
std::optional<RoundedPoint3> with_coordinates_across(std::array<double, 3> clear,
                                                     std::span<const Corners> planes) {
  bool is_exact = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto across = std::ranges::find_if(
        planes, [axis](const Corners& plane) { return is_across(plane, axis); });
    if (across != planes.end()) {
      const double c = coordinates(*across->front())[axis];
      clear[axis] = is_equal(c, 0) ? 0 : c;  // not -0.0
    } else if (clear[axis] == 0) {
      return {};
    } else {
      is_exact = false;
    }
  }
  return RoundedPoint3{{clear[0], clear[1], clear[2]}, is_exact};
}

// ---------------------------------------------------------------- fixed widths

/// value ~ mantissa * 2^exponent
struct TwofoldScaled {
  Twofold mantissa;
  int exponent;
};

/// Requires x != 0.
template <int L>
TwofoldScaled top_bits(const Fixed<L>& x) {
  const bool is_negative = x.is_negative();
  const Fixed<L> magnitude = is_negative ? -x : x;
  int top = L - 1;
  while (magnitude.limb(top) == 0) --top;
  const int zeros = std::countl_zero(magnitude.limb(top));
  const auto bits = [&](int limb) {  // 64 of them, from the highest 1 of the number on
    const std::uint64_t high = limb >= 0 ? magnitude.limb(limb) << zeros : 0;
    return limb > 0 && zeros > 0 ? high | (magnitude.limb(limb - 1) >> (64 - zeros)) : high;
  };
  const auto as_double = [](std::uint64_t b) {
    return static_cast<double>(static_cast<std::int64_t>(b));
  };
  const std::uint64_t first = bits(top), second = bits(top - 1);
  const double high = as_double(first >> 11U) * 0x1p-53;
  const double low = as_double(((first & 0x7ffU) << 42U) | (second >> 22U)) * 0x1p-106;
  const Twofold mantissa = exact_sum(high, low, high);
  return {is_negative ? negative(mantissa) : mantissa, 64 * top + 64 - zeros};
}

/// As clear_coordinates(). The width is the operand's at least.
template <class W>
std::optional<std::array<double, 3>> clear_coordinates_in(const exact3::PointOperand& operand) {
  using Plane = exact3::FixedPlane<W>;
  exact3::PointOf<Plane> point;
  if (operand.width > W::kIndex ||
      !exact3::load_point<Plane>(operand, exact3::Part::Finite, point)) {
    return {};
  }
  const TwofoldScaled w = top_bits(point.w);
  std::array<double, 3> found{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.x[i].is_zero()) continue;
    const TwofoldScaled x = top_bits(point.x[i]);
    const int exponent = x.exponent - w.exponent + point.scale;
    if (std::abs(exponent) > 1000) continue;
    found[i] = clear_quotient(negative(x.mantissa), w.mantissa) * power_of_two(exponent);
  }
  return found;
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
  return with_coordinates_across(clear_coordinates(*corners), *corners);
}

std::optional<RoundedPoint3> rung::rounded_fixed(const Point3Table& points, SpacePoint x) {
  if (!rounds_to_nearest()) return {};
  const exact3::PointOperand operand = exact3::operand(points, x);
  auto clear = clear_coordinates_in<exact3::Narrow>(operand);
  if (!clear) clear = clear_coordinates_in<exact3::Medium>(operand);
  if (!clear) clear = clear_coordinates_in<exact3::Wide>(operand);
  if (!clear) return {};
  const PointSource& source = points.source(x);
  std::array<Corners, 3> planes;
  std::size_t count = 0;
  for (std::size_t i = 0; i < source.plane_count(); ++i) {
    const std::optional<Corners> corners = corners_of(points.planes(), source.plane(i));
    if (corners) planes[count++] = *corners;
  }
  return with_coordinates_across(*clear, std::span(planes).first(count));
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
  std::optional<RoundedPoint3> clear = rung::rounded_filter(points, x);
  if (!clear) clear = rung::rounded_fixed(points, x);
  return clear ? *clear : rung::rounded_exact(points, x);
}

}  // namespace plumb
