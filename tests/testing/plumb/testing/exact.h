// Exact numbers of tests: Boost cpp_int and cpp_rational, which share nothing with predicates/.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "plumb/predicates/point.h"
#include "plumb/predicates/point_table2.h"

namespace plumb::testing {

using BigInt = boost::multiprecision::cpp_int;
using BigRational = boost::multiprecision::cpp_rational;

/// A point of a test map. Lexicographic order: x, then y.
struct ExactPoint {
  BigRational x;
  BigRational y;
  friend bool operator==(const ExactPoint&, const ExactPoint&) = default;
};
bool operator<(const ExactPoint& a, const ExactPoint& b);

/// A point of space, in the same order.
struct ExactPoint3 {
  BigRational x;
  BigRational y;
  BigRational z;
  friend bool operator==(const ExactPoint3&, const ExactPoint3&) = default;
};
bool operator<(const ExactPoint3& a, const ExactPoint3& b);
ExactPoint3 operator+(const ExactPoint3& a, const ExactPoint3& b);
ExactPoint3 operator-(const ExactPoint3& a, const ExactPoint3& b);
ExactPoint3 operator*(const BigRational& factor, const ExactPoint3& p);
ExactPoint3 cross(const ExactPoint3& a, const ExactPoint3& b);
BigRational dot(const ExactPoint3& a, const ExactPoint3& b);

/// 2^k for any k.
BigRational power_of_two(int k);

/// Exactly the value of a finite double.
BigRational exact_of(double value);
ExactPoint exact_of(Point2 point);
ExactPoint3 exact_of(const Point3& point);

/// Between the independent rationals here and the public ones of plumb; both lossless.
BigRational exact_of(const Rational& value);
ExactPoint exact_of(const RationalPoint2& point);
ExactPoint3 exact_of(const RationalPoint3& point);
Rational to_rational(const BigRational& value);

/// The double equal to `value`; false when there is none.
bool as_double(const BigRational& value, double& result);
bool as_double(const ExactPoint3& point, Point3& result);

}  // namespace plumb::testing
