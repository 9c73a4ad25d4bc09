#include "plumb/space/set/integer_map.h"

#include "plumb/predicates/arithmetic/vectors.h"

namespace plumb {

IntegerMap::IntegerMap(const AffineMap3& map) {
  for (const RationalRow& row : map.matrix) take_denominators(row);
  take_denominators(map.offset);
  std::array<IntegerVector, 3> a;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) point_[i][j] = a[i][j] = whole(map.matrix[i][j]);
    point_[i][3] = whole(map.offset[i]);
  }
  set_planes(a);
}

void IntegerMap::take_denominators(const RationalRow& row) {
  for (const Rational& x : row) weight_ = lcm(weight_, denominator(x));
}

void IntegerMap::set_planes(const std::array<IntegerVector, 3>& a) {
  const std::array<IntegerVector, 3> columns{cross(a[1], a[2]), cross(a[2], a[0]),
                                             cross(a[0], a[1])};  // Of adj A.
  const Integer det = dot(a[0], columns[0]);
  determinant_ = sign_of(det.sign());
  const Integer sign = det.sign();
  plane_[3][3] = abs(det);
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k < 3; ++k) {
      plane_[k][j] = weight_ * sign * columns[k][j];
      plane_[3][j] -= sign * columns[k][j] * point_[k][3];
    }
  }
  divide_planes();
}

/// Divides the map of planes by the common factor of its numbers.
void IntegerMap::divide_planes() {
  Integer common = 0;
  for (const IntegerRow& row : plane_) {
    for (const Integer& x : row) common = gcd(common, x);
  }
  for (IntegerRow& row : plane_) {
    for (Integer& x : row) x /= common;
  }
}

Integer IntegerMap::product(const IntegerRow& a, const IntegerRow& b) {
  Integer sum;
  for (std::size_t i = 0; i < 4; ++i) mpz_addmul(sum.mpz(), a[i].mpz(), b[i].mpz());
  return sum;
}

}  // namespace plumb
