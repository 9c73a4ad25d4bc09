// Query points and query rays in the plane, and predicates that compare them with the points of a
// table. A query point or ray is not itself in the table.
#pragma once

#include <cstdint>

#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point of the plane that is passed to a query, with double or rational coordinates.
class QueryPoint2 {
 public:
  /// Constructs a query point with double coordinates. Requires finite coordinates.
  explicit QueryPoint2(Point2 p);
  /// Constructs a query point with rational coordinates.
  explicit QueryPoint2(const RationalPoint2& p);

  /// Whether both coordinates are doubles.
  bool is_double() const { return is_double_; }
  /// Returns the point rounded to the nearest doubles. If is_double(), the result is the point
  /// itself. Coordinates beyond the range of double are clamped as in PointTable2.
  Point2 approx() const { return approx_; }
  const RationalPoint2& exact() const { return exact_; }

 private:
  Point2 approx_;
  RationalPoint2 exact_;
  bool is_double_;
};

/// Compares point i with the query point lexicographically: Negative if point i is less.
Sign compare_xy(const PlanePointsView& points, std::uint32_t i, const QueryPoint2& q);
/// Compares point i with the query point by x alone.
Sign compare_x(const PlanePointsView& points, std::uint32_t i, const QueryPoint2& q);

/// Returns the side of a line on which the query point lies: Positive if it lies to the left. The
/// line is directed from input point a to input point b. If the coordinates of all three points are
/// doubles, the function calls orient2d for three points. Otherwise it computes with exact
/// rationals.
Sign orient2d(const PlanePointsView& points, std::uint32_t a, std::uint32_t b,
              const QueryPoint2& q);

/// A ray of a query. In the comments below, "the ray's line" is the line that contains the ray,
/// directed to the right, or upward if it is vertical. The ray itself may have the opposite
/// direction. A point is above the ray's line if it lies to the left of this directed line.
class QueryRay2 {
 public:
  /// Requires a direction that is not zero.
  QueryRay2(const RationalPoint2& origin, const RationalPoint2& direction);

  const QueryPoint2& origin() const { return origin_; }
  /// Returns the direction of the ray's line, which is to the right or upward.
  const QueryPoint2& direction() const { return direction_; }
  /// Whether the ray itself is directed to the right, or upward if it is vertical.
  bool goes_right() const { return goes_right_; }
  bool is_vertical() const { return direction_.exact().x == 0; }

 private:
  QueryPoint2 origin_;
  bool goes_right_;
  QueryPoint2 direction_;
};

/// Returns the side of the ray's line on which point i lies: Positive means above.
Sign side(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t i);

/// Returns the direction of the turn from the line through a and b to the ray's line. The line
/// through a and b is directed from a to b. The turn is Positive if the ray's line is steeper.
/// Requires that the direction from a to b is to the right or upward.
Sign turn(const PlanePointsView& points, std::uint32_t a, std::uint32_t b, const QueryRay2& ray);

/// Compares a crossing with point i lexicographically: Negative if the crossing is less. The
/// crossing is the common point of the ray's line and the line through a and b. Requires that the
/// two lines are not parallel.
Sign compare_crossing_xy(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                         std::uint32_t b, std::uint32_t i);
/// Compares the crossing with point i, like compare_crossing_xy(), but by x alone.
Sign compare_crossing_x(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                        std::uint32_t b, std::uint32_t i);

/// Returns the exact common point of the ray's line and the line through a and b. Requires that the
/// two lines are not parallel.
RationalPoint2 crossing(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                        std::uint32_t b);

}  // namespace plumb
#pragma GCC visibility pop
