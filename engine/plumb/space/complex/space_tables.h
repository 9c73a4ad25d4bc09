// The planes and points that complexes in space refer to.
//
// Planes 0, 1, 2 are x = 0, y = 0, z = 0 in every table, so that the directions of the axes are
// pairs of planes like any other direction.
//
// An operation on two sets brings their tables together: copy() the larger one, merge() the other
// into it, read the other set through the TableMap. What the result does not use is dropped by
// compacted(). Equal planes have one id in a table; equal input or constructed points may have
// several (equal() tells).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb {

struct SpaceTables {
  SpaceTables();
  SpaceTables(PlaneTable planes, const Point3Table& points);
  SpaceTables(const SpaceTables&) = delete;
  SpaceTables& operator=(const SpaceTables&) = delete;

  PlaneTable planes;
  Point3Table points;  ///< of `planes`
};

inline constexpr PlaneId kPlaneX{0};
inline constexpr PlaneId kPlaneY{1};
inline constexpr PlaneId kPlaneZ{2};

/// The same planes and points under the same ids. Cost: that of copying the arrays.
std::shared_ptr<SpaceTables> copy(const SpaceTables& tables);

/// Where the planes and points of a merged table are.
struct TableMap {
  std::vector<PlaneId> plane;
  std::uint32_t input_offset = 0;
  std::uint32_t point_offset = 0;

  PlaneId operator()(PlaneId p) const { return plane[p.value()]; }
  SpacePoint operator()(SpacePoint p) const {
    if (p.is_input()) return SpacePoint(InputPointId(p.input().value() + input_offset));
    return SpacePoint::constructed(p.index() + point_offset);
  }
};

/// Adds the planes and points of `other`, which must be another table. Signs of planes and points
/// are those of their images: canonical orientation belongs to the plane.
/// Cost: a hash look-up a plane; points are copied.
TableMap merge(SpaceTables& into, const SpaceTables& other);

/// Tables with only what is needed, and the new ids. Dropped: invalid.
struct CompactedTables {
  std::shared_ptr<SpaceTables> tables;
  std::vector<PlaneId> plane;
  std::vector<InputPointId> input;
  std::vector<SpacePoint> constructed;

  PlaneId operator()(PlaneId p) const { return plane[p.value()]; }
  SpacePoint operator()(SpacePoint p) const {
    return p.is_input() ? SpacePoint(input[p.input().value()]) : constructed[p.index()];
  }
};

/// Keeps the given planes and points, the planes that define those points, the input points that
/// define all of these, and planes 0 to 2; ids keep their order. A wall whose parents are dropped
/// stays the same plane but is_wall_of() forgets it. Cost: linear in the tables.
CompactedTables compacted(const SpaceTables& tables, std::span<const PlaneId> planes,
                          std::span<const SpacePoint> points);

/// A point with any exact coordinates: an input point if doubles hold all three, else the common
/// point of planes parallel to the coordinate planes.
SpacePoint add_point(SpaceTables& tables, const RationalPoint3& at);

}  // namespace plumb
#pragma GCC visibility pop
