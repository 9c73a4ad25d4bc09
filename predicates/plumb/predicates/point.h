// Input points with finite double coordinates.
#pragma once

#pragma GCC visibility push(default)
namespace plumb {

/// A point of the plane. Every predicate requires finite coordinates. The readers and the public
/// constructors of the engine reject infinities and NaNs.
struct Point2 {
  double x = 0;  ///< Finite coordinate.
  double y = 0;  ///< Finite coordinate.
  friend bool operator==(const Point2&, const Point2&) = default;
};

/// A point of space. Every predicate requires finite coordinates, as for Point2.
struct Point3 {
  double x = 0;  ///< Finite coordinate.
  double y = 0;  ///< Finite coordinate.
  double z = 0;  ///< Finite coordinate.
  friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace plumb
#pragma GCC visibility pop
