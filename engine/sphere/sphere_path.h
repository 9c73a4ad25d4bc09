// Walks over a sphere map along great circles: what is met, and from which side.
//
// Main flow: a leg runs counter-clockwise along one circle. The first leg from u along a circle
// through u ends where it meets the circle of a given arc; the second follows that circle to the
// arc. Both circles are circles of the maps, so nothing but det3 is ever asked: no circle through two
// points has to be made. Cost: O(size of the map) signs, a sort of what is met. Internal.
#pragma once

#include <vector>

#include "plumb/sphere/sphere_arcs.h"

namespace plumb {

/// Where something of a face's boundary is: a half-arc with the face to its left, or an isolated
/// point.
struct SphereSlot {
  std::uint32_t half_arc = SphereMap::kNone;
  std::uint32_t point = SphereMap::kNone;
  bool is_valid() const { return half_arc != SphereMap::kNone || point != SphereMap::kNone; }
};

/// What one comes to. Entry and exit: whose face one comes from and goes on into; not valid where
/// one comes or goes along an arc.
struct PathHit {
  CirclePlace place;
  SphereCell cell;
  SphereSlot entry;
  SphereSlot exit;
};

/// The face that a slot is of. Requires a valid one.
inline std::uint32_t face_of(const SphereMap& map, SphereSlot slot) {
  return slot.half_arc != SphereMap::kNone ? map.face[slot.half_arc] : map.point_face[slot.point];
}

/// A closed leg, from a place to itself the whole circle: what it meets of one point or arc.
class Leg {
 public:
  Leg(const PlaneTable& planes, const SphereMap& map, PlaneId circle, CirclePlace from,
      CirclePlace to)
      : planes_(planes), map_(map), circle_(circle), from_(from), to_(to) {}

  void add_point(std::uint32_t point, std::vector<PathHit>& hits) const;
  /// Strictly inside the arc. Nothing when the leg runs along its circle.
  void add_arc(std::uint32_t arc, std::vector<PathHit>& hits) const;

 private:
  bool is_on(CirclePlace place) const;
  SphereSlot slot_towards(std::uint32_t point, bool backward) const;
  void add_crossing(std::uint32_t arc, bool is_opposite, std::vector<PathHit>& hits) const;

  const PlaneTable& planes_;
  const SphereMap& map_;
  PlaneId circle_;
  CirclePlace from_;
  CirclePlace to_;
};

/// Adds what is met on the closed leg, in order. Reads no face and no mark of the map.
void walk_leg(const PlaneTable& planes, const SphereMap& map, PlaneId circle, CirclePlace from,
              CirclePlace to, std::vector<PathHit>& hits);

/// The way from u to an arc: what is met strictly after u, up to the arc. Requires that u is not on
/// the arc.
void walk_to_arc(const PlaneTable& planes, const SphereMap& map, SphereDirection u,
                 std::uint32_t arc, std::vector<PathHit>& hits);

}  // namespace plumb
