// Points with exact rational coordinates, for output, readers and oracles.
#pragma once

#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An exact point of the plane.
struct RationalPoint2 {
  Rational x;  ///< exact
  Rational y;  ///< exact
  friend bool operator==(const RationalPoint2&, const RationalPoint2&) = default;
};

/// An exact point of space.
struct RationalPoint3 {
  Rational x;  ///< exact
  Rational y;  ///< exact
  Rational z;  ///< exact
  friend bool operator==(const RationalPoint3&, const RationalPoint3&) = default;
};

}  // namespace plumb
#pragma GCC visibility pop
