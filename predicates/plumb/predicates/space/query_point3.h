// The points of queries in space, which need not be in a table, and the predicates on a query point
// and the planes and points of a table.
#pragma once

#include <cstddef>
#include <optional>

#include "plumb/predicates/point.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"
#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point of a query. Only one thread may use it, because its exact coordinates are computed when
/// they are first needed.
class QueryPoint3 {
 public:
  /// Makes a point of doubles. Requires finite coordinates.
  explicit QueryPoint3(const Point3& p) : box_{{p.x, p.y, p.z}, 0} {}
  /// Makes a rational point.
  explicit QueryPoint3(const RationalPoint3& p);
  /// Makes a point of a table, which must stay as it is while the query is used.
  QueryPoint3(const Point3Table& points, SpacePoint p)
      : box_(points.box(p)), points_(&points), source_(p) {}

  /// Returns a box around the point.
  const PointBox& box() const { return box_; }
  /// Returns the point of the table from which the query point was constructed, or an invalid point
  /// if the query point does not come from a table.
  SpacePoint source() const { return source_; }
  /// Whether the coordinates are known to be doubles.
  bool is_double() const { return box_.radius == 0; }
  /// Returns the doubles. Requires is_double().
  Point3 point() const { return {box_.mid[0], box_.mid[1], box_.mid[2]}; }
  /// Returns the exact coordinates. Requires a point that does not depend on the frame.
  const RationalPoint3& exact() const { return parts().finite; }
  /// Returns both parts of the exact coordinates.
  const FramedPoint3& parts() const;

 private:
  PointBox box_;
  const Point3Table* points_ = nullptr;
  SpacePoint source_;
  mutable std::optional<FramedPoint3> parts_;
};

// If the query point is a point of the table, the predicates on points of the table decide. If its
// coordinates are doubles and the plane passes through input points, the predicates on doubles
// decide. In all other cases a filter decides, or, if it cannot, rational numbers.

/// Returns the side of the canonical plane on which the point lies, as side() in point3_signs.h.
Sign side(const Point3Table& points, const QueryPoint3& q, PlaneId plane);

/// Returns the order of a point of the table and the query along axis 0, 1 or 2: the sign of x - q.
Sign compare_axis(const Point3Table& points, SpacePoint x, const QueryPoint3& q, std::size_t axis);

/// Returns coordinate 0, 1 or 2.
inline const Rational& coordinate(const RationalPoint3& p, std::size_t axis) {
  return axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
}

}  // namespace plumb
#pragma GCC visibility pop
