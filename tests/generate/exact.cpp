#include "plumb/testing/exact.h"

#include <cmath>

namespace plumb::testing {
namespace {

BigInt big(const Integer& value) { return BigInt(value.str()); }

bool is_small_integer(const BigRational& value) {
  static const BigInt kLimit = BigInt(1) << 53;
  return denominator(value) == 1 && numerator(value) <= kLimit && numerator(value) >= -kLimit;
}

// Doubles are the numbers m * 2^e with |m| < 2^53, e >= -1074 and a magnitude below 2^1024.
bool is_dyadic_in_range(const BigRational& value) {
  const BigInt den = denominator(value);
  if ((den & (den - 1)) != 0 || msb(den) > 1074) return false;
  const BigInt num = abs(numerator(value));
  const std::size_t digits = msb(num) - lsb(num) + 1;
  return digits <= 53 && msb(num) < 1024 + msb(den);
}

}  // namespace

bool operator<(const ExactPoint& a, const ExactPoint& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

bool operator<(const ExactPoint3& a, const ExactPoint3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}
ExactPoint3 operator+(const ExactPoint3& a, const ExactPoint3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
ExactPoint3 operator-(const ExactPoint3& a, const ExactPoint3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
ExactPoint3 operator*(const BigRational& factor, const ExactPoint3& p) {
  return {factor * p.x, factor * p.y, factor * p.z};
}
ExactPoint3 cross(const ExactPoint3& a, const ExactPoint3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
BigRational dot(const ExactPoint3& a, const ExactPoint3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

BigRational power_of_two(int k) {
  const BigInt power = BigInt(1) << static_cast<unsigned>(std::abs(k));
  return k >= 0 ? BigRational(power) : BigRational(BigInt(1), power);
}

BigRational exact_of(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  return BigRational(mantissa) * power_of_two(exponent - 53);
}

ExactPoint exact_of(Point2 point) { return {exact_of(point.x), exact_of(point.y)}; }

ExactPoint3 exact_of(const Point3& point) {
  return {exact_of(point.x), exact_of(point.y), exact_of(point.z)};
}

BigRational exact_of(const Rational& value) {
  return BigRational(big(numerator(value)), big(denominator(value)));
}

ExactPoint exact_of(const RationalPoint2& point) { return {exact_of(point.x), exact_of(point.y)}; }

ExactPoint3 exact_of(const RationalPoint3& point) {
  return {exact_of(point.x), exact_of(point.y), exact_of(point.z)};
}

Rational to_rational(const BigRational& value) {
  return Rational(Integer(numerator(value).str()), Integer(denominator(value).str()));
}

bool as_double(const BigRational& value, double& result) {
  if (is_small_integer(value)) {
    result = static_cast<double>(static_cast<std::int64_t>(numerator(value)));
    return true;
  }
  if (!is_dyadic_in_range(value)) return false;
  BigInt num = abs(numerator(value));
  const auto zeros = static_cast<int>(lsb(num));
  num >>= zeros;
  const double magnitude = std::ldexp(static_cast<double>(static_cast<std::int64_t>(num)),
                                      zeros - static_cast<int>(msb(denominator(value))));
  result = value < 0 ? -magnitude : magnitude;
  return true;
}

bool as_double(const ExactPoint3& point, Point3& result) {
  return as_double(point.x, result.x) && as_double(point.y, result.y) &&
         as_double(point.z, result.z);
}

}  // namespace plumb::testing
