// A point of space that is in no table: what a user asks about. Predicates against the planes and
// points of a table.
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

/// Belongs to one thread: the exact coordinates are made when first asked for.
class QueryPoint3 {
 public:
  /// Requires finite coordinates.
  explicit QueryPoint3(const Point3& p) : box_{{p.x, p.y, p.z}, 0} {}
  explicit QueryPoint3(const RationalPoint3& p);
  /// A point of a table. Both must stay as they are while the query is used.
  QueryPoint3(const Point3Table& points, SpacePoint p)
      : box_(points.box(p)), points_(&points), source_(p) {}

  const PointBox& box() const { return box_; }
  /// Not valid unless made from a point of a table.
  SpacePoint source() const { return source_; }
  bool is_double() const { return box_.radius == 0; }
  /// Requires is_double().
  Point3 point() const { return {box_.mid[0], box_.mid[1], box_.mid[2]}; }
  /// Requires a point off the frame.
  const RationalPoint3& exact() const { return parts().finite; }
  const FramedPoint3& parts() const;

 private:
  PointBox box_;
  const Point3Table* points_ = nullptr;
  SpacePoint source_;
  mutable std::optional<FramedPoint3> parts_;
};

// Points of the table are asked about as points of the table. Others, in doubles against input
// points: as the predicates on input doubles. Else a filter, then rationals.

/// The side of the (canonical) plane: as point3_signs.h says.
Sign side(const Point3Table& points, const QueryPoint3& q, PlaneId plane);

/// The order of a point of the table and the query along coordinate axis 0, 1 or 2: the sign of
/// x - q.
Sign compare_axis(const Point3Table& points, SpacePoint x, const QueryPoint3& q, std::size_t axis);

/// Coordinate `axis` = 0, 1 or 2.
inline const Rational& coordinate(const RationalPoint3& p, std::size_t axis) {
  return axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
}

}  // namespace plumb
#pragma GCC visibility pop
