// The planes and points that complexes in space refer to.
//
// Planes 0, 1, 2 are x = 0, y = 0, z = 0 in every table, so that the directions of the axes are
// pairs of planes like any other direction.
//
// An operation on two sets brings their tables together. It makes a copy() of the larger table,
// merges the other table into the copy by merge(), and reads the other set through the TableMap.
// compacted() drops the planes and points that the result does not use. Equal planes have one id in
// a table. Equal points may have several ids, whether they are input or constructed; equal()
// compares them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The planes and points of complexes. There is no copy constructor, so that no copy is made by
/// accident; copy() makes one.
struct SpaceTables {
  SpaceTables();  ///< Makes tables with planes 0, 1, 2 and no points.
  /// Makes tables with these planes and a copy of the points. Requires that the points refer to
  /// these planes.
  SpaceTables(PlaneTable planes, const Point3Table& points);
  SpaceTables(const SpaceTables&) = delete;
  SpaceTables& operator=(const SpaceTables&) = delete;

  PlaneTable planes;   ///< The planes, with the input points.
  Point3Table points;  ///< Constructed points, which refer to `planes`.
};

inline constexpr PlaneId kPlaneX{0};  ///< The plane x = 0.
inline constexpr PlaneId kPlaneY{1};  ///< The plane y = 0.
inline constexpr PlaneId kPlaneZ{2};  ///< The plane z = 0.

/// Returns the same planes and points under the same ids. Costs as much as copying the arrays.
std::shared_ptr<SpaceTables> copy(const SpaceTables& tables);

/// Maps the ids of a table to those in the table into which it was merged.
struct TableMap {
  std::vector<PlaneId> plane;      ///< The new id of each plane.
  std::uint32_t input_offset = 0;  ///< The number that is added to ids of input points.
  std::uint32_t point_offset = 0;  ///< The number that is added to ids of constructed points.

  /// Returns the new id of a plane.
  PlaneId operator()(PlaneId p) const { return plane[p.value()]; }
  /// Returns the new id of a point.
  SpacePoint operator()(SpacePoint p) const {
    if (p.is_input()) return SpacePoint(InputPointId(p.input().value() + input_offset));
    return SpacePoint::constructed(p.index() + point_offset);
  }
};

/// Adds the planes and points of `other` to `into`, and returns their new ids. Requires that the
/// two are different tables. A plane has the same canonical orientation in both tables, so signs
/// with respect to planes do not change. Costs a hash look-up for each plane, and a copy of the
/// points.
TableMap merge(SpaceTables& into, const SpaceTables& other);

/// Tables with only the planes and points that are needed, and the new ids. The new id of a dropped
/// plane or point is invalid.
struct CompactedTables {
  std::shared_ptr<SpaceTables> tables;  ///< The new tables.
  std::vector<PlaneId> plane;           ///< The new id of each plane.
  std::vector<InputPointId> input;      ///< The new id of each input point.
  std::vector<SpacePoint> constructed;  ///< The new id of each constructed point.

  /// Returns the new id of a plane.
  PlaneId operator()(PlaneId p) const { return plane[p.value()]; }
  /// Returns the new id of a point.
  SpacePoint operator()(SpacePoint p) const {
    return p.is_input() ? SpacePoint(input[p.input().value()]) : constructed[p.index()];
  }
};

/// Returns tables with:
/// - the given planes and points,
/// - the planes that define these points,
/// - the input points that define all of these,
/// - planes 0 to 2.
///
/// Ids keep their order. A wall whose parents are dropped remains the same plane, but is_wall_of()
/// does not recognize it any more as a wall of its parents. O(size of the tables).
CompactedTables compacted(const SpaceTables& tables, std::span<const PlaneId> planes,
                          std::span<const SpacePoint> points);

/// Adds a point with any exact coordinates and returns it. The new point is an input point if all
/// three coordinates are doubles. Otherwise it is the common point of three planes parallel to the
/// coordinate planes.
SpacePoint add_point(SpaceTables& tables, const RationalPoint3& at);

}  // namespace plumb
#pragma GCC visibility pop
