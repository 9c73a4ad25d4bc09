// The direction that walls run along, and the planes that hold it (internal to walls).
#pragma once

#include <array>
#include <vector>

#include "plumb/predicates/rational.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// "Up" is a vector of integers; "vertical" is along it.
class Vertical {
 public:
  /// Requires a direction that is not zero. The tables must outlive it; walls are interned there.
  Vertical(const std::array<Integer, 3>& direction, SpaceTables& tables);

  /// Does the (canonical) normal point up? Zero: the plane is vertical.
  Sign rise(PlaneId p);
  /// Requires planes of one line.
  bool is_vertical(const std::array<PlaneId, 2>& line) {
    return rise(line[0]) == Sign::Zero && rise(line[1]) == Sign::Zero;
  }
  /// The vertical plane through a line that is not vertical: of the pencil of the two.
  OrientedPlane through(const std::array<PlaneId, 2>& line);
  /// A vertical plane through a point, another one than `avoided`.
  PlaneId through(SpacePoint x, PlaneId avoided);

  /// A coordinate plane that is not vertical. Its normal points up.
  PlaneId level() const { return PlaneId(axis_); }
  std::size_t axis() const { return axis_; }
  /// How far aside one goes along `axis` for a unit along axis(), in doubles.
  double slope(std::size_t axis) const;

 private:
  std::array<Integer, 3> direction_;
  SpaceTables& tables_;
  std::size_t axis_ = 0;
  std::vector<FilteredSign> rise_;  // per plane; Unsure: not asked yet
};

}  // namespace plumb
