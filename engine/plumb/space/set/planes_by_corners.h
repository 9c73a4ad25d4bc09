// Finds the planes of a table by the coordinates of the three input points that define them.
// Internal.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "plumb/predicates/arithmetic/seeded_hash.h"
#include "plumb/predicates/space/plane_table.h"

namespace plumb {

/// An index of the planes that three input points define. It tells a triangle of a mesh its plane
/// by one look-up, without arithmetic, if the plane is defined by the corners of this triangle.
class PlanesByCorners {
 public:
  /// A corner of a triangle.
  struct Corner {
    const Point3* at;    ///< Its coordinates.
    std::uint32_t hash;  ///< hash_of() of them.
  };

  /// Indexes the planes of `planes` whose entry in `is_left_out` is 0. Keeps a reference to the
  /// table, which may grow. O(n).
  PlanesByCorners(const PlaneTable& planes, std::span<const std::uint8_t> is_left_out);

  /// Returns the hash of the coordinates of a point.
  static std::uint32_t hash_of(const Point3& p);
  /// Returns the hash of a triangle, computed from the hashes of its corners in any order.
  static std::uint32_t hash_of_all(const std::array<Corner, 3>& corners) {
    return hash_of_all({corners[0].hash, corners[1].hash, corners[2].hash});
  }
  /// A plane, and the input points of the table at the corners by which it was found.
  struct Found {
    OrientedPlane plane;
    std::array<InputPointId, 3> points;
  };

  /// Whether three points define this plane in the table. If they do, fills `found`.
  static bool is_defined_by(const PlaneTable& planes, PlaneId plane,
                            const std::array<const Point3*, 3>& corners, Found& found);

  /// Prefetches the entry of the index that candidate() reads first.
  void prefetch(std::uint32_t hash) const { index_.prefetch(hash); }
  /// Returns the first plane whose corners have this hash, or a plane that is not valid, and
  /// prefetches its definition.
  PlaneId candidate(std::uint32_t hash) const;
  /// Prefetches the points that define a plane.
  void prefetch_points(PlaneId plane) const;
  /// Returns the plane that these three points define in the table. Seen from its positive side,
  /// the corners appear counter-clockwise. The plane is not valid if the table has no plane of
  /// this definition; it may have the plane with another definition. `first` is the candidate(),
  /// which is looked at first. The functions before this one are called for many triangles before
  /// it, because the index and the tables are larger than the caches. Expected cost: O(1).
  Found find(const std::array<Corner, 3>& corners, PlaneId first) const;

 private:
  static std::uint32_t hash_of_all(const std::array<std::uint32_t, 3>& corners);

  const PlaneTable& planes_;
  IdIndex index_;
};

}  // namespace plumb
