// Vectors and 3 x 3 matrices of rationals, for maps and the boxes they move.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/rational.h"

namespace plumb {

using RationalRow = std::array<Rational, 3>;
using RationalMatrix = std::array<RationalRow, 3>;  ///< of rows

inline Rational dot(const RationalRow& a, const RationalRow& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline RationalRow cross(const RationalRow& a, const RationalRow& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The columns of determinant(m) m^-1, as rows.
inline RationalMatrix cofactors(const RationalMatrix& m) {
  return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

inline Rational determinant(const RationalMatrix& m) { return dot(m[0], cross(m[1], m[2])); }

/// |r[0]| + |r[1]| + |r[2]|: the largest r.x in the cube |x|, |y|, |z| <= 1.
inline Rational sum_of_magnitudes(const RationalRow& r) {
  Rational sum = 0;
  for (const Rational& x : r) sum += x < 0 ? Rational(-x) : x;
  return sum;
}

}  // namespace plumb
