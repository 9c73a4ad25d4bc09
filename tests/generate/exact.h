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

/// 2^k for any k.
BigRational power_of_two(int k);

/// Exactly the value of a finite double.
BigRational exact_of(double value);
ExactPoint exact_of(Point2 point);

/// Between the independent rationals here and the public ones of plumb; both lossless.
BigRational exact_of(const Rational& value);
ExactPoint exact_of(const RationalPoint2& point);
Rational to_rational(const BigRational& value);

/// The double equal to `value`; false when there is none.
bool as_double(const BigRational& value, double& result);

}  // namespace plumb::testing
