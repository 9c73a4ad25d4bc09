// The tables of the planes and points to which complexes in space refer.
//
// In every table, planes 0, 1 and 2 are x = 0, y = 0 and z = 0. A direction is given by a pair of
// planes. The directions of the axes can be given by pairs of the planes 0, 1 and 2.
//
// An operation on two sets first makes a common table. The operation copies the larger table by
// copy(), and adds the entries of the smaller table to the copy by merge(). The TableMap that
// merge() returns has the new ids for the set with the smaller table. Finally compacted() drops the
// planes and points that the result does not use. In a table, equal planes always have the same id.
// Equal points may have different ids, whether they are input points or constructed points. The
// function equal() compares points by their coordinates.
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
/// accident; use copy() instead.
struct SpaceTables {
  SpaceTables();  ///< Makes tables with planes 0, 1, 2 and no points.
  /// Makes tables with these planes and a copy of the points. Requires that the points refer to
  /// these planes.
  SpaceTables(PlaneTable planes, const Point3Table& points);
  SpaceTables(const SpaceTables&) = delete;
  SpaceTables& operator=(const SpaceTables&) = delete;

  PlaneTable planes;   ///< The planes, and the input points.
  Point3Table points;  ///< Constructed points, which refer to `planes`.
};

inline constexpr PlaneId kPlaneX{0};  ///< The plane x = 0.
inline constexpr PlaneId kPlaneY{1};  ///< The plane y = 0.
inline constexpr PlaneId kPlaneZ{2};  ///< The plane z = 0.

/// Returns a copy of the tables. Planes and points have the same ids in the copy. The cost is the
/// cost of copying the arrays.
std::shared_ptr<SpaceTables> copy(const SpaceTables& tables);

/// The result of merging a table into another table: maps each id in the merged table to the new id
/// in the other table.
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

/// Adds the planes and points of `other` to `into`, and returns their new ids. Requires that `into`
/// and `other` are different objects. A plane has the same canonical orientation in both tables, so
/// signs with respect to planes do not change. The function looks up each plane once in a hash
/// table, and copies each point.
TableMap merge(SpaceTables& into, const SpaceTables& other);

/// The result of compacted(): tables that contain only the needed planes and points, and the new
/// ids. The new id of a dropped plane or point is invalid.
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
/// - the input points that define these planes and points,
/// - planes 0 to 2.
///
/// The new ids have the same order as the old ids. If the planes that define a wall are dropped,
/// the wall remains the same plane. However, is_wall_of() no longer recognizes it as a wall of
/// these planes. Cost: O(size of the tables).
CompactedTables compacted(const SpaceTables& tables, std::span<const PlaneId> planes,
                          std::span<const SpacePoint> points);

/// Adds a point with arbitrary exact coordinates, and returns the point. If all three coordinates
/// are doubles, the new point is an input point. Otherwise it is a constructed point: the common
/// point of three planes that are parallel to the coordinate planes.
SpacePoint add_point(SpaceTables& tables, const RationalPoint3& at);

}  // namespace plumb
#pragma GCC visibility pop
