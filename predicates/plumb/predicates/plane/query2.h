// A point that is in no table: what a user asks about. Predicates against the points of a table.
#pragma once

#include <cstdint>

#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

class QueryPoint2 {
 public:
  /// Requires finite coordinates.
  explicit QueryPoint2(Point2 p);
  explicit QueryPoint2(const RationalPoint2& p);

  bool is_double() const { return is_double_; }
  /// The nearest doubles, clamped as in PointTable2; the point itself when is_double().
  Point2 approx() const { return approx_; }
  const RationalPoint2& exact() const { return exact_; }

 private:
  Point2 approx_;
  RationalPoint2 exact_;
  bool is_double_;
};

/// Order of point i against the query point, by x and then y, or by x alone.
Sign compare_xy(const PlanePointsView& points, std::uint32_t i, const QueryPoint2& q);
Sign compare_x(const PlanePointsView& points, std::uint32_t i, const QueryPoint2& q);

/// Side of the line through input points a -> b on which the query point lies: Positive = left.
/// Doubles throughout: as orient2d of three points; else exact rationals.
Sign orient2d(const PlanePointsView& points, std::uint32_t a, std::uint32_t b,
              const QueryPoint2& q);

// A ray whose points are in no table: what a user shoots. Predicates against the points of a table.
//
// The line of a ray is taken to run to the right, or upward, whichever way the ray goes: "above" is
// left of that line.

class QueryRay2 {
 public:
  /// Requires a direction that is not zero.
  QueryRay2(const RationalPoint2& origin, const RationalPoint2& direction);

  const QueryPoint2& origin() const { return origin_; }
  /// Turned to the right, or upward.
  const QueryPoint2& direction() const { return direction_; }
  /// Does the ray go the way of direction()?
  bool goes_right() const { return goes_right_; }
  bool is_vertical() const { return direction_.exact().x == 0; }

 private:
  QueryPoint2 origin_;
  bool goes_right_;
  QueryPoint2 direction_;
};

/// Side of the ray's line on which point i lies: Positive = above.
Sign side(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t i);

/// The turn from line a -> b, of input points, to the ray's line: Positive when the ray's is
/// steeper, for a -> b to the right or upward.
Sign turn(const PlanePointsView& points, std::uint32_t a, std::uint32_t b, const QueryRay2& ray);

/// Order of the crossing of the ray's line and line a -> b against point i, by x and then y, or by
/// x alone. Requires that the lines are not parallel.
Sign compare_crossing_xy(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                         std::uint32_t b, std::uint32_t i);
Sign compare_crossing_x(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                        std::uint32_t b, std::uint32_t i);

/// That crossing.
RationalPoint2 crossing(const PlanePointsView& points, const QueryRay2& ray, std::uint32_t a,
                        std::uint32_t b);

}  // namespace plumb
#pragma GCC visibility pop
