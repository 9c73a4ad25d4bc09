#include "plumb/space/set/integer_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "plumb/predicates/arithmetic/scaled.h"
#include "plumb/predicates/arithmetic/vectors.h"

namespace plumb {
namespace {

/// Whether a positive integer is a power of two.
bool is_power_of_two(const Integer& x) { return lsb(x) == msb(x); }

/// Returns the exponent of the lowest bit of x / w, for a power of two w; 0 for x = 0.
int lowest_exponent(const Integer& x, const Integer& w) {
  return x.is_zero() ? 0 : trailing_zeros(x) - trailing_zeros(w);
}

/// Returns x / w for a power of two w if it is a double. Requires a lowest exponent far from the
/// ends of the range of doubles.
std::optional<double> as_double(const Integer& x, const Integer& w) {
  constexpr int kDigits = 53;
  if (x.is_zero()) return 0.0;
  const int low = trailing_zeros(x);
  if (bit_length(x) - low > kDigits) return {};
  return std::ldexp(mpz_get_d(Integer(x >> low).mpz()), lowest_exponent(x, w));
}

}  // namespace

OrientedPlane intern_row(PlaneTable& planes, IntegerRow row) {
  auto& [a, b, c, d] = row;
  return planes.intern(Rational(std::move(a)), Rational(std::move(b)), Rational(std::move(c)),
                       Rational(std::move(d)));
}

/// Nearly all denominators are powers of two, so no fraction needs to be reduced.
SpacePoint add_point(SpaceTables& tables, const IntegerRow& x) {
  constexpr int kMostExponent = 900;
  const Integer& w = x[3];
  const auto is_ordinary = [&](const Integer& c) {
    return std::abs(lowest_exponent(c, w)) <= kMostExponent;
  };
  if (!is_power_of_two(w) || !std::all_of(x.begin(), x.begin() + 3, is_ordinary)) {
    return add_point(tables,
                     RationalPoint3{Rational(x[0], w), Rational(x[1], w), Rational(x[2], w)});
  }
  const std::optional<double> a = as_double(x[0], w), b = as_double(x[1], w),
                              c = as_double(x[2], w);
  if (a && b && c) return SpacePoint(tables.planes.add_point({*a, *b, *c}));
  const std::array<PlaneId, 3> planes{intern_row(tables.planes, {w, 0, 0, -x[0]}).plane(),
                                      intern_row(tables.planes, {0, w, 0, -x[1]}).plane(),
                                      intern_row(tables.planes, {0, 0, w, -x[2]}).plane()};
  return tables.points.add(planes[0], planes[1], planes[2]);
}

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
  // The columns of adj A.
  const std::array<IntegerVector, 3> columns{cross(a[1], a[2]), cross(a[2], a[0]),
                                             cross(a[0], a[1])};
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
