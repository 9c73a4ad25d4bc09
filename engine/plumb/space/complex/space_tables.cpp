// Copying, merging and compacting the tables of planes and points.
//
// Ids are indices: merging appends input points and constructed points after those of the other
// table, so one offset each maps them; planes are interned again, because equal planes must have
// the same id. Compacting keeps all objects that define a kept object, and keeps the order of ids.
//
// Tested by tests/space/space_tables_test.cpp.

#include "plumb/space/complex/space_tables.h"

#include <array>
#include <cstddef>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {

namespace {

/// Returns a table of planes 0, 1, 2. It is made once, as every set begins with a copy of it.
const PlaneTable& axis_planes() {
  static const PlaneTable made = [] {
    PlaneTable planes;
    PLUMB_CHECK(planes.intern(1, 0, 0, 0).plane() == kPlaneX);
    PLUMB_CHECK(planes.intern(0, 1, 0, 0).plane() == kPlaneY);
    PLUMB_CHECK(planes.intern(0, 0, 1, 0).plane() == kPlaneZ);
    return planes;
  }();
  return made;
}

}  // namespace

SpaceTables::SpaceTables() : planes(axis_planes()), points(planes) {}

SpaceTables::SpaceTables(PlaneTable own, const Point3Table& other)
    : planes(std::move(own)), points(planes, other) {}

std::shared_ptr<SpaceTables> copy(const SpaceTables& tables) {
  return std::make_shared<SpaceTables>(PlaneTable(tables.planes), tables.points);
}

// Planes are copied first, because constructed points refer to them by their new ids.
TableMap merge(SpaceTables& into, const SpaceTables& other) {
  TableMap map;
  map.input_offset = static_cast<std::uint32_t>(into.planes.points().size());
  map.plane = into.planes.merge(other.planes);
  map.point_offset = into.points.merge(other.points, map.plane, map.input_offset);
  return map;
}

// --- compaction
// ----------------------------------------------------------------------------------

namespace {

/// The objects that are kept, by old ids. If an object is kept, all objects that define it are
/// kept.
class Kept {
 public:
  explicit Kept(const SpaceTables& tables)
      : tables_(tables),
        plane_(tables.planes.size()),
        input_(tables.planes.points().size()),
        constructed_(tables.points.size()) {}

  void keep(InputPointId p) { input_[p.value()] = true; }
  void keep(PlaneId p) {
    if (plane_[p.value()]) return;
    plane_[p.value()] = true;
    const PlaneSource& source = tables_.planes.source(p);
    if (source.is_explicit()) return;
    for (const std::uint32_t corner : source.code) keep(InputPointId(corner));
  }
  void keep(SpacePoint p) {
    if (p.is_input()) return keep(p.input());
    constructed_[p.index()] = true;
    const PointSource& source = tables_.points.source(p);
    for (std::size_t i = 0; i < source.plane_count(); ++i) keep(source.plane(i));
    for (std::size_t i = 0; source.is_line() && i < 2; ++i) keep(source.end(i));
  }

  /// Returns the new id of each object that is kept; ids keep their order.
  template <class Id, class Make>
  static std::vector<Id> numbered(const std::vector<bool>& kept, const Make& make) {
    std::vector<Id> ids(kept.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (kept[i]) ids[i] = make(next++);
    }
    return ids;
  }
  std::vector<PlaneId> planes() const {
    return numbered<PlaneId>(plane_, [](std::size_t i) { return PlaneId(i); });
  }
  std::vector<InputPointId> inputs() const {
    return numbered<InputPointId>(input_, [](std::size_t i) { return InputPointId(i); });
  }
  std::vector<SpacePoint> constructed() const {
    return numbered<SpacePoint>(constructed_, SpacePoint::constructed);
  }

 private:
  const SpaceTables& tables_;
  std::vector<bool> plane_, input_, constructed_;
};

}  // namespace

CompactedTables compacted(const SpaceTables& tables, std::span<const PlaneId> planes,
                          std::span<const SpacePoint> points) {
  Kept kept(tables);
  for (const PlaneId p : {kPlaneX, kPlaneY, kPlaneZ}) kept.keep(p);
  for (const PlaneId p : planes) kept.keep(p);
  for (const SpacePoint p : points) kept.keep(p);
  CompactedTables result{nullptr, kept.planes(), kept.inputs(), kept.constructed()};
  result.tables = std::make_shared<SpaceTables>(
      PlaneTable(tables.planes, result.plane, result.input), Point3Table(tables.planes));
  for (std::size_t i = 0; i < tables.points.size(); ++i) {
    if (!result.constructed[i].is_valid()) continue;
    const SpacePoint old = SpacePoint::constructed(i);
    result.tables->points.add(
        tables.points.source(old).mapped([&](PlaneId p) { return result.plane[p.value()]; },
                                         [&](InputPointId p) { return result.input[p.value()]; }),
        tables.points.box(old), tables.points.is_nearest(old));
  }
  return result;
}

// --- points with exact coordinates
// ---------------------------------------------------------------

SpacePoint add_point(SpaceTables& tables, const RationalPoint3& at) {
  const RoundedDouble x = round_to_double(at.x), y = round_to_double(at.y),
                      z = round_to_double(at.z);
  if (x.error == Sign::Zero && y.error == Sign::Zero && z.error == Sign::Zero) {
    return SpacePoint(tables.planes.add_point({x.value, y.value, z.value}));
  }
  const std::array<PlaneId, 3> planes = {tables.planes.intern(1, 0, 0, Rational(-at.x)).plane(),
                                         tables.planes.intern(0, 1, 0, Rational(-at.y)).plane(),
                                         tables.planes.intern(0, 0, 1, Rational(-at.z)).plane()};
  return tables.points.add(planes[0], planes[1], planes[2]);
}

}  // namespace plumb
