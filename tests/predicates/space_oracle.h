// Planes and points of space in Boost cpp_int, written from the textbook and sharing no code with
// the library: doubles are taken apart by std::frexp, determinants are expanded row by row.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "plumb/predicates/point.h"

namespace plumb::oracle {

using Int = boost::multiprecision::cpp_int;
using Row = std::array<Int, 4>;  // a b c d, or x y z w

inline int sgn(const Int& x) { return x.sign(); }

inline int least_exponent(double value) {
  if (value == 0) return 2000;
  int exponent = 0;
  auto mantissa = static_cast<long long>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent;
  }
  return exponent;
}

/// The unit exponent of the finest grid among the coordinates.
inline int unit_of(const std::vector<Point3>& points) {
  int unit = 2000;
  for (const Point3& p : points) {
    unit = std::min({unit, least_exponent(p.x), least_exponent(p.y), least_exponent(p.z)});
  }
  return unit == 2000 ? 0 : unit;
}

/// value / 2^unit. Requires the result to be an integer.
inline Int to_int(double value, int unit) {
  if (value == 0) return 0;
  const int exponent = least_exponent(value);
  return Int(static_cast<long long>(std::ldexp(value, -exponent))) << (exponent - unit);
}

/// (x, y, z, 1) in units of the grid.
inline Row point_row(const Point3& p, int unit) {
  return {to_int(p.x, unit), to_int(p.y, unit), to_int(p.z, unit), 1};
}

inline Int det3(const Row& a, const Row& b, const Row& c, int i, int j, int k) {
  const auto at = [](const Row& r, int n) -> const Int& { return r[static_cast<std::size_t>(n)]; };
  return at(a, i) * (at(b, j) * at(c, k) - at(b, k) * at(c, j)) -
         at(a, j) * (at(b, i) * at(c, k) - at(b, k) * at(c, i)) +
         at(a, k) * (at(b, i) * at(c, j) - at(b, j) * at(c, i));
}

inline Int det3(const Row& a, const Row& b, const Row& c) { return det3(a, b, c, 0, 1, 2); }

/// Expanded along the last row.
inline Int det4(const Row& a, const Row& b, const Row& c, const Row& d) {
  return -d[0] * det3(a, b, c, 1, 2, 3) + d[1] * det3(a, b, c, 0, 2, 3) -
         d[2] * det3(a, b, c, 0, 1, 3) + d[3] * det3(a, b, c, 0, 1, 2);
}

/// The plane through three points: the cofactors of the last row of det4(p, q, r, x), with the sign
/// that makes it positive where p, q, r turn counter-clockwise.
inline Row plane_through(const Row& p, const Row& q, const Row& r) {
  return {det3(p, q, r, 1, 2, 3), -det3(p, q, r, 0, 2, 3), det3(p, q, r, 0, 1, 3),
          -det3(p, q, r, 0, 1, 2)};
}

/// Negated if its first nonzero coefficient is negative.
inline Row canonical(Row plane) {
  for (const Int& c : plane) {
    if (c == 0) continue;
    if (c < 0) {
      for (Int& x : plane) x = -x;
    }
    break;
  }
  return plane;
}

inline bool is_plane(const Row& p) { return p[0] != 0 || p[1] != 0 || p[2] != 0; }

/// Equal as homogeneous rows, up to any factor.
inline bool is_proportional(const Row& p, const Row& q) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (p[i] * q[j] != p[j] * q[i]) return false;
    }
  }
  return true;
}

/// The common point of three planes as (x, y, z, w); w = 0 when there is none.
inline Row common_point(const Row& p, const Row& q, const Row& r) {
  return {-det3(p, q, r, 1, 2, 3), det3(p, q, r, 0, 2, 3), -det3(p, q, r, 0, 1, 3),
          det3(p, q, r, 0, 1, 2)};
}

inline Int value_at(const Row& plane, const Row& point) {
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] * point[3];
}

/// The line a b against a plane, as (x, y, z, w).
inline Row line_point(const Row& a, const Row& b, const Row& plane) {
  const Int at_a = value_at(plane, a), at_b = value_at(plane, b);
  Row x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = a[i] * at_b - b[i] * at_a;
  return x;
}

inline int side(const Row& plane, const Row& point) {
  return sgn(value_at(plane, point)) * sgn(point[3]);
}

inline int compare_axis(const Row& x, const Row& y, std::size_t i) {
  return sgn(x[i] * y[3] - y[i] * x[3]) * sgn(x[3]) * sgn(y[3]);
}

}  // namespace plumb::oracle
