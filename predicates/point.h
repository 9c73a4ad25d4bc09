// Input points: plain finite doubles, no more.
#pragma once

#pragma GCC visibility push(default)
namespace plumb {

/// A point of the plane. Every predicate requires finite coordinates; readers and public
/// constructors of the engine refuse anything else.
struct Point2 {
  double x = 0;  ///< finite
  double y = 0;  ///< finite
  friend bool operator==(const Point2&, const Point2&) = default;
};

/// A point of space; the same requirement.
struct Point3 {
  double x = 0;  ///< finite
  double y = 0;  ///< finite
  double z = 0;  ///< finite
  friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace plumb
#pragma GCC visibility pop
