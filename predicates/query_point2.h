// A point that is in no table: what a user asks about. Predicates against the points of a table.
#pragma once

#include <cstdint>

#include "plumb/predicates/plane_points.h"
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

}  // namespace plumb
#pragma GCC visibility pop
