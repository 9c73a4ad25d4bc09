// Signs about directions and great circles: all that a sphere map asks of numbers.
//
// Notation. A direction u = n_p x n_q is a pair of planes, a circle c a plane, both through the
// centre. Two things are ordered cyclically: directions on a circle, and circles through a
// direction.
//
//   place on c      u = +-(n_c x n_m), named by m and the sign: u in normal form on c
//   turn on c       (n_c x m1) x (n_c x m2) = n_c det3(c, m1, m2): one determinant
//   heading at u    a circle through u with a direction along it: counter-clockwise about +-n_c
//   turn at u       (m1 x u) x (m2 x u) = u [u, m1, m2]: the turn from n_m1 to n_m2 about u
//
// A turn in four classes, counter-clockwise seen from outside (from the positive side of c): 0
// none, 1 less than half a circle, 2 half a circle, 3 more. Classes order all turns from one start
// but those in one open half, which a second sign orders.
//
// Planes with different ids have different normals (one vertex, one table), so equal ids are asked
// before any arithmetic, and two headings are along one circle exactly when their ids are equal.
// Source: SPACE.md 2; degree 6 in coordinates of input planes' points (det3), 4 (turns at u).
#pragma once

#include <vector>

#include "plumb/predicates/space/plane_table.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// The direction n_c x n_other on a circle c, or the opposite one.
struct CirclePlace {
  PlaneId other;  ///< not c
  bool is_opposite = false;
  constexpr CirclePlace opposite() const { return {other, !is_opposite}; }
  constexpr Sign sign() const { return is_opposite ? Sign::Negative : Sign::Positive; }
};

/// Whole turns in four classes.
enum class TurnClass : std::uint8_t { None, Left, Back, Right };

inline SphereDirection direction_of(PlaneId circle, CirclePlace place) {
  return place.is_opposite ? SphereDirection{place.other, circle}
                           : SphereDirection{circle, place.other};
}

/// Positive: u lies on the side of the circle's normal.
Sign side_of(const PlaneTable& planes, SphereDirection u, PlaneId circle);

bool is_same(const PlaneTable& planes, SphereDirection u, SphereDirection v);
inline bool is_opposite(const PlaneTable& planes, SphereDirection u, SphereDirection v) {
  return is_same(planes, u.opposite(), v);
}

/// Requires u on the circle.
CirclePlace place_on(const PlaneTable& planes, PlaneId circle, SphereDirection u);

/// The turn from one place to another, counter-clockwise about the circle's normal.
TurnClass turn_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to);

/// Is x met strictly before y, going counter-clockwise from `from` (which is met first)?
bool is_before_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace x,
                  CirclePlace y);

/// Does x lie strictly between, going counter-clockwise? From a place to itself is the whole
/// circle.
bool is_between_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to,
                   CirclePlace x);

/// The turn at u from one heading to another. Requires circles through u.
TurnClass turn_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from,
                  OrientedPlane to);

/// Is x met strictly before y, turning counter-clockwise at u from the heading `from`?
bool is_before_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from, OrientedPlane x,
                  OrientedPlane y);

// What arcs and rings of a map answer: where circles cross an arc, what lies inside it, between
// which half-arcs a heading leaves a point. Internal to engine/sphere.

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

/// The half-arc that leaves the point next clockwise of a heading, so that its left sector holds
/// the heading; kNone when the heading runs along an arc. Requires a point with arcs.
std::uint32_t sector_at(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                        OrientedPlane heading);

// Walks over a sphere map along great circles: what is met, and from which side.
//
// Main flow: a leg runs counter-clockwise along one circle. The first leg from u along a circle
// through u ends where it meets the circle of a given arc; the second follows that circle to the
// arc. Both circles are circles of the maps, so nothing but det3 is ever asked: no circle through
// two points has to be made. Cost: O(size of the map) signs, a sort of what is met. Internal.

/// Where something of a face's boundary is: a half-arc with the face to its left, or an isolated
/// point.
struct SphereSlot {
  std::uint32_t half_arc = kNone;
  std::uint32_t point = kNone;
  bool is_valid() const { return half_arc != kNone || point != kNone; }
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
  return slot.half_arc != kNone ? map.face[slot.half_arc] : map.point_face[slot.point];
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

// Connected parts of a map, and which of their cycles bound one face. Internal.
//
// Each part but one walks to a given arc (sphere_arcs.h). What follows each other on a walk bounds
// one face; and since the faces and parts of a sphere form a tree, the walks tell this of all
// cycles: on its way a walk passes through every face between its ends. Reads no face and no mark
// of the map. Cost: O(n a(n)), and O(n log n) for each part but one.

// Union-find: the root of a set is its least member.
inline std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}
void unite(std::vector<std::uint32_t>& parent, std::uint32_t i, std::uint32_t j);
void make_singles(std::vector<std::uint32_t>& parent, std::size_t count);

/// Keeps its memory between calls.
class SphereParts {
 public:
  /// Two places on the boundary of one face, of different parts or not.
  struct Link {
    SphereSlot first;
    SphereSlot second;
  };

  void find(const PlaneTable& planes, const SphereMap& map);

  // Parts are named by numbers below bound(), not all of which are used.
  std::uint32_t bound() const { return static_cast<std::uint32_t>(parent_.size()); }
  std::uint32_t of_point(std::uint32_t v) { return find_root(parent_, v); }
  std::uint32_t of_arc(std::uint32_t a) { return find_root(parent_, point_count_ + a); }
  std::uint32_t of(SphereSlot slot) {
    return slot.half_arc != kNone ? of_arc(slot.half_arc / 2) : of_point(slot.point);
  }
  std::size_t count() const;

  /// Unite what they link, and the cycles of one face are one. Without arcs none: there is one
  /// face.
  const std::vector<Link>& links() const { return links_; }

 private:
  void walk_from(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                 std::uint32_t root_arc);

  std::uint32_t point_count_ = 0;
  std::vector<std::uint32_t> parent_;  // points, then arcs
  std::vector<Link> links_;
  std::vector<PathHit> hits_;
};

}  // namespace plumb
