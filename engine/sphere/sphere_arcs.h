// What arcs and rings of a map answer: where circles cross an arc, what lies inside it, between which
// half-arcs a heading leaves a point. Internal to engine/sphere.
#pragma once

#include "plumb/sphere/sphere_directions.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// Which of the two points +-(n_c x n_d) lie strictly inside an arc of circle c.
struct ArcCrossings {
  bool ahead = false;   ///< n_c x n_d: the circle goes from the positive side of d to the negative
  bool behind = false;  ///< the opposite one
  /// The same points as seen from circle d.
  constexpr ArcCrossings swapped() const { return {behind, ahead}; }
};
constexpr ArcCrossings operator&(ArcCrossings a, ArcCrossings b) {
  return {a.ahead && b.ahead, a.behind && b.behind};
}

/// Requires d != circle[arc]; the sides of d on which the arc begins and ends (of a loop: any).
ArcCrossings crossings(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc, PlaneId d,
                       Sign from_side, Sign to_side);
/// The same, asking for the sides.
ArcCrossings crossings(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
                       PlaneId d);

/// The place of the origin of a half-arc on its circle.
inline CirclePlace origin_place(const PlaneTable& planes, const SphereMap& map,
                                std::uint32_t half_arc) {
  return place_on(planes, map.circle[half_arc / 2], map.direction[map.origin[half_arc]]);
}

/// Is a place on the arc's circle strictly inside the arc? Everything is inside a loop.
bool is_inside_arc(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
                   CirclePlace place);

/// Does a direction lie strictly inside an arc?
bool is_on_arc(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
               SphereDirection u);

inline OrientedPlane heading_of(const SphereMap& map, std::uint32_t half_arc) {
  return {map.circle[half_arc / 2], (half_arc & 1U) != 0};
}

/// The half-arc that leaves the point next clockwise of a heading, so that its left sector holds the
/// heading; kNone when the heading runs along an arc. Requires a point with arcs.
std::uint32_t sector_at(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                        OrientedPlane heading);

}  // namespace plumb
