// Query points in space, and predicates that compare them with the planes and the points of a
// table. A query point may be a point of the table, but need not be.
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

/// A point of a query. Only one thread may use a query point, because its exact coordinates are
/// computed when they are first needed.
class QueryPoint3 {
 public:
  /// Constructs a query point with double coordinates. Requires finite coordinates.
  explicit QueryPoint3(const Point3& p) : box_{{p.x, p.y, p.z}, 0} {}
  /// Constructs a query point with rational coordinates.
  explicit QueryPoint3(const RationalPoint3& p);
  /// Constructs the query point that equals the point p of the table `points`. The table must
  /// neither change nor move while the query point is used.
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
  /// Returns the exact coordinates as a finite part and a factor of R (FramedPoint3).
  const FramedPoint3& parts() const;

 private:
  PointBox box_;
  const Point3Table* points_ = nullptr;
  SpacePoint source_;
  mutable std::optional<FramedPoint3> parts_;
};

// If the query point comes from the table, the functions below call the predicates on points of the
// table. If the query point has double coordinates and the plane is defined by input points, these
// functions call the predicates on doubles. In all other cases, they first try a filter. If the
// filter cannot decide, they compute with rational numbers.

/// Returns the side of `plane`, in its canonical orientation, on which the query point lies. The
/// signs have the same meaning as the results of side() in point3_signs.h.
Sign side(const Point3Table& points, const QueryPoint3& q, PlaneId plane);

/// Compares a coordinate of the point x of the table with the same coordinate of the query point q.
/// Returns the sign of x - q along axis 0, 1 or 2.
Sign compare_axis(const Point3Table& points, SpacePoint x, const QueryPoint3& q, std::size_t axis);

/// Returns the coordinate of p along axis 0, 1 or 2.
inline const Rational& coordinate(const RationalPoint3& p, std::size_t axis) {
  return axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
}

}  // namespace plumb
#pragma GCC visibility pop
