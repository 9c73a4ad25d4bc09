// The nearest doubles to points of space: a filter with sums of two doubles, exact integers of
// fixed width, and division of exact integers.
//
// The filter. Where three planes through input points meet, the quotient of two determinants is
// computed with some 100 bits (nearest_quotient.h), and what lies clearly between two doubles is
// rounded by that. The errors, in multiples of u^2 terms with u = 2^-53, are proved in
// docs/design/numbers.md (Rounding to nearest):
//
//   n = (q - p) x (r - p)     products 9, their sum 6 more: 15
//   d = -n.p                  15 + 9, two sums 12 more: 36
//   minors n x m              15 + 15 + 9 + 6 = 45
//   w = n.(m x k)             15 + 45 + 9 + 12 = 81
//   x = sum of d (n x m)      36 + 45 + 9 + 12 = 102
//
// Where two planes go through two common points a and b, the point is
// a + s(a) (b - a) / (s(a) - s(b)), which takes a sixth of the products and loses no bits to planes
// that are nearly parallel to each other:
//
//   s = n.(x - p)             15 + 9, two sums 12 more: 36
//   w = s(a) - s(b)           36 + 6 = 42
//   x = s(a) (b - a)          36 + 9 = 45
//
// The code takes 2^7 u^2 terms for w and x (nearest_quotient.h); the rest pays for the roundings of
// the terms and for products of errors.
//
// Range. Coordinates are 0 or in [2^-60, 2^60], so multiples of 2^-112. Products of up to seven of
// them (four for a line), and what is lost in them, are 0 or in [2^-784, 2^440]; so is x - q1 w, as
// |w.high| >= 2^-400 and |q1| >= 2^-200. So nothing overflows or becomes subnormal.
//
// Tested by tests/predicates/rounded_point3_test.cpp.

#include "plumb/predicates/space/rounded_point3.h"

#include <algorithm>
#include <cmath>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/nearest_quotient.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/point3_exact.h"

namespace plumb {
namespace {

// ---------------------------------------------------------------- filter

using twofold::difference;
using twofold::is_divisor;
using twofold::nearest_to;
using twofold::negative;
using twofold::product;
using twofold::quotient;
using twofold::sum;

/// The plane n.x + d = 0.
struct TwofoldPlane {
  std::array<Twofold, 3> n;
  Twofold d;
};

/// Three points of a plane.
using Corners = std::array<Point3, 3>;

std::array<double, 3> coordinates(const Point3& p) { return {p.x, p.y, p.z}; }

/// Whether the filter accepts a point. Zero is recognized by its bits, because a subnormal number
/// may compare as equal to zero.
bool is_in_range(const Point3& p) {
  return std::ranges::all_of(coordinates(p), [](double c) {
    return is_equal(c, 0) || (std::fabs(c) >= 0x1p-60 && std::fabs(c) <= 0x1p60);
  });
}

bool are_in_range(const Corners& corners) {
  return std::ranges::all_of(corners, [](const Point3& p) { return is_in_range(p); });
}

/// Returns component i of a x b.
Twofold cross_component(const std::array<Twofold, 3>& a, const std::array<Twofold, 3>& b,
                        std::size_t i) {
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return sum(product(a[j], b[k]), negative(product(a[k], b[j])));
}

std::array<Twofold, 3> cross(const std::array<Twofold, 3>& a, const std::array<Twofold, 3>& b) {
  return {cross_component(a, b, 0), cross_component(a, b, 1), cross_component(a, b, 2)};
}

std::array<Twofold, 3> between(const Point3& from, const Point3& to) {
  return {difference(to.x, from.x), difference(to.y, from.y), difference(to.z, from.z)};
}

std::array<Twofold, 3> normal_of(const Corners& corners) {
  return cross(between(corners[0], corners[1]), between(corners[0], corners[2]));
}

TwofoldPlane plane_through(const Corners& corners) {
  const std::array p = coordinates(corners[0]);
  const std::array<Twofold, 3> n = normal_of(corners);
  return {n, negative(sum(sum(product(n[0], p[0]), product(n[1], p[1])), product(n[2], p[2])))};
}

/// Returns the coordinates of the point where a line through two input points meets a plane.
/// Coordinates that are clear and not doubles are rounded; all other coordinates are 0. Returns
/// nothing if the line may be parallel to the plane.
std::optional<std::array<double, 3>> clear_coordinates(const Point3& a, const Point3& b,
                                                       const Corners& corners) {
  const std::array<Twofold, 3> n = normal_of(corners);
  const auto side = [&](const Point3& x) {
    const std::array<Twofold, 3> to_x = between(corners[0], x);
    return sum(sum(product(n[0], to_x[0]), product(n[1], to_x[1])), product(n[2], to_x[2]));
  };
  const Twofold at_a = side(a), w = sum(at_a, negative(side(b)));
  if (!is_divisor(w)) return {};
  const std::array<Twofold, 3> step = between(a, b);
  const std::array<double, 3> from = coordinates(a);
  std::array<double, 3> found;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    found[axis] = nearest_to(sum(from[axis], quotient(product(at_a, step[axis]), w)));
  }
  return found;
}

/// Returns the same coordinates for the common point of three planes. All are 0 if the planes may
/// have no common point.
std::array<double, 3> clear_coordinates(const std::array<Corners, 3>& corners) {
  std::array<TwofoldPlane, 3> planes;
  std::transform(corners.begin(), corners.end(), planes.begin(), plane_through);
  // For each plane, the cross product of the normals of the next two planes.
  std::array<std::array<Twofold, 3>, 3> minors;
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
    const Twofold x = combination([&](std::size_t i) { return planes[i].d; },
                                  [&](std::size_t i) { return minors[i][axis]; });
    found[axis] = nearest_to(quotient(negative(x), w));
  }
  return found;
}

/// Returns the input points that define a plane, or three points of a plane across an axis whose
/// equation is stored; otherwise nothing.
std::optional<Corners> corners_of(const PlaneTable& planes, PlaneId plane) {
  const PlaneSource& source = planes.source(plane);
  if (!source.is_explicit()) {
    const auto corner = [&](std::size_t i) { return planes.points()[source.code[i]]; };
    return Corners{corner(0), corner(1), corner(2)};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!exact3::is_across(planes, plane, axis)) continue;
    const std::optional<double> c = exact3::coordinate_across(planes, plane, axis);
    if (!c) return {};
    if (axis == 0) return Corners{Point3{*c, 0, 0}, {*c, 1, 0}, {*c, 0, 1}};
    if (axis == 1) return Corners{Point3{0, *c, 0}, {0, *c, 1}, {1, *c, 0}};
    return Corners{Point3{0, 0, *c}, {1, 0, *c}, {0, 1, *c}};
  }
  return {};
}

/// Returns corners_of() the three planes that define a point, if all planes have such, within
/// range; otherwise nothing.
std::optional<std::array<Corners, 3>> corners_of_planes(const PlaneTable& planes,
                                                        const PointSource& source) {
  std::array<Corners, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Corners> found = corners_of(planes, source.plane(i));
    if (!found || !are_in_range(*found)) return {};
    corners[i] = *found;
  }
  return corners;
}

// ---------------------------------------------------------------- fixed widths

/// Rounds in the width W. Returns false if W is less than the width of the operand, or if a scale
/// breaks (L).
template <class W>
bool round_in(const exact3::PointOperand& operand, const Point3Table& points, SpacePoint x,
              std::optional<RoundedPoint3>& rounded) {
  using Plane = exact3::FixedPlane<W>;
  exact3::PointOf<Plane> point;
  if (operand.width > W::kIndex ||
      !exact3::load_point<Plane>(operand, exact3::Part::Finite, point)) {
    return false;
  }
  rounded = exact3::rounded_fixed(point, points.planes(), points.source(x));
  return true;
}

// ---------------------------------------------------------------- exact integers

/// Returns the rounded quotient. The numbers are passed to a Rational without removing common
/// factors, which does not matter for the division.
RoundedDouble round_quotient(Integer& numerator, Integer& denominator, Rational& scratch) {
  mpq_ptr q = scratch.mpq();
  mpz_swap(mpq_numref(q), numerator.mpz());
  mpz_swap(mpq_denref(q), denominator.mpz());
  const RoundedDouble result = round_to_double(scratch);
  mpz_swap(mpq_numref(q), numerator.mpz());
  mpz_swap(mpq_denref(q), denominator.mpz());
  return result;
}

}  // namespace

std::optional<RoundedPoint3> exact3::with_coordinates_across(std::array<double, 3> clear,
                                                             const PlaneTable& planes,
                                                             const PointSource& source) {
  bool is_exact = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (clear[axis] != 0) {
      is_exact = false;
      continue;
    }
    std::optional<double> only;
    for (std::size_t i = 0; i < source.plane_count() && !only; ++i) {
      if (is_across(planes, source.plane(i), axis)) {
        only = coordinate_across(planes, source.plane(i), axis);
      }
    }
    if (!only) only = coordinate_along(planes, source, axis);
    if (!only) return {};
    clear[axis] = is_equal(*only, 0) ? 0 : *only;  // The result is never -0.0.
  }
  return RoundedPoint3{{clear[0], clear[1], clear[2]}, is_exact};
}

std::optional<RoundedPoint3> exact3::rounded_on_line(const PlaneTable& planes,
                                                     const PointSource& source) {
  const PointSource line = as_line(planes, source);
  if (!line.is_line() || !rounds_to_nearest()) return {};
  const std::optional<Corners> corners = corners_of(planes, line.plane(0));
  const Point3 &a = planes.point(line.end(0)), &b = planes.point(line.end(1));
  if (!corners || !are_in_range(*corners) || !is_in_range(a) || !is_in_range(b)) return {};
  const auto clear = clear_coordinates(a, b, *corners);
  if (!clear) return {};
  return with_coordinates_across(*clear, planes, source);
}

std::optional<RoundedPoint3> rung::rounded_filter(const Point3Table& points, SpacePoint x) {
  const PlaneTable& planes = points.planes();
  const PointSource& source = points.source(x);
  auto rounded = exact3::rounded_on_line(planes, source);
  if (rounded || source.is_line() || !rounds_to_nearest()) return rounded;
  const auto corners = corners_of_planes(planes, source);
  if (!corners) return {};
  return exact3::with_coordinates_across(clear_coordinates(*corners), planes, source);
}

std::optional<RoundedPoint3> rung::rounded_fixed(const Point3Table& points, SpacePoint x) {
  const exact3::PointOperand operand = exact3::operand(points, x);
  std::optional<RoundedPoint3> rounded;
  round_in<exact3::Narrow>(operand, points, x, rounded) ||
      round_in<exact3::Medium>(operand, points, x, rounded) ||
      round_in<exact3::Wide>(operand, points, x, rounded);
  return rounded;
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
  if (points.is_nearest(x)) {
    const PointBox box = points.box(x);
    return {{box.mid[0], box.mid[1], box.mid[2]}, box.radius == 0};
  }
  std::optional<RoundedPoint3> clear = rung::rounded_filter(points, x);
  if (!clear) clear = rung::rounded_fixed(points, x);
  return clear ? *clear : rung::rounded_exact(points, x);
}

}  // namespace plumb
