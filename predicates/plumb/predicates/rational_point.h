// Points with exact rational coordinates. Such points are used for output, in readers and in
// reference implementations.
#pragma once

#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point of the plane with exact coordinates.
struct RationalPoint2 {
  Rational x;  ///< Exact coordinate.
  Rational y;  ///< Exact coordinate.
  friend bool operator==(const RationalPoint2&, const RationalPoint2&) = default;
  /// Returns the vector from b to a.
  friend RationalPoint2 operator-(const RationalPoint2& a, const RationalPoint2& b) {
    return {a.x - b.x, a.y - b.y};
  }
};

/// A point of space with exact coordinates.
struct RationalPoint3 {
  Rational x;  ///< Exact coordinate.
  Rational y;  ///< Exact coordinate.
  Rational z;  ///< Exact coordinate.
  friend bool operator==(const RationalPoint3&, const RationalPoint3&) = default;
  /// Returns the vector from b to a.
  friend RationalPoint3 operator-(const RationalPoint3& a, const RationalPoint3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
};

}  // namespace plumb
#pragma GCC visibility pop
