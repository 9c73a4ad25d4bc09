// Once around on a great circle, piece by piece: what is met, in order, without a look at the rest of the map.
//
// Main flow of next():
//  1. certain   the nearest thing found that has not been given yet, if it surely lies on the pieces looked at
//  2. further   else one more piece, twice as long as the last; the first is about as long as an arc of a map
//               that is spread evenly. What its bound may meet is asked exactly, over the whole circle (Leg). Where
//               that is much more than all asked before, the piece is halved first.
// All that a piece meets is found with it, so that nothing found later comes before what is certain. Doubles say
// which items are asked and how long one waits, never what is met.
//
// Cost: of the items near the way up to what is taken; a point on the way costs its degree. Internal.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/sphere/sphere_bounds.h"
#include "plumb/sphere/sphere_path.h"

namespace plumb {

/// What walks over one map leave to the next one.
struct WalkMemory {
  explicit WalkMemory(const SphereMap& map) : last_walk(map.point_count() + map.arc_count(), 0) {}
  void begin();

  std::vector<std::uint32_t> last_walk;  ///< that asked an item: of points, then of arcs
  std::uint32_t walk = 0;
  std::vector<PathHit> hits;
  std::vector<std::uint32_t> found;  ///< items of a piece
  std::uint64_t asked = 0;           ///< items, by all walks
};

class SphereWalk {
 public:
  /// From a place on the circle, in its orientation; `start` holds the place. `tree` is over bounds_of the map. All
  /// must outlive the walk, the table without change.
  SphereWalk(const PlaneTable& planes, const SphereMap& map, const SphereBoundTree& tree,
             WalkMemory& memory, OrientedPlane circle, CirclePlace from, const UnitBall& start);

  /// The next thing met, at last none. Entry and exit as one goes.
  std::optional<PathHit> next();

 private:
  bool is_certain(const PathHit& hit) const;
  bool is_before(const PathHit& x, const PathHit& y) const;
  SphereBound piece() const;
  void find_few();
  void look_further();

  const PlaneTable& planes_;
  const SphereMap& map_;
  const SphereBoundTree& tree_;
  WalkMemory& memory_;
  OrientedPlane circle_;
  CirclePlace from_;
  UnitWay way_;
  double step_;
  double done_ = 0;  ///< the angle looked at
  bool is_round_ = false;
  std::size_t asked_ = 0;
  std::size_t taken_ = 0;
};

}  // namespace plumb
