// Signs about directions and great circles, which are all the arithmetic of a sphere map; what arcs
// and rings of a map answer by them; walks along great circles; and the connected parts of a map.
// Internal to engine/sphere.
//
// Notation. A direction u = n_p x n_q is a pair of planes, a circle c is a plane, all through the
// centre. Two things are ordered cyclically: directions on a circle, and circles through a
// direction.
//
//   place on c      u = +-(n_c x n_m), given by m and the sign
//   turn on c       (n_c x m1) x (n_c x m2) = n_c det3(c, m1, m2): one determinant
//   heading at u    a circle through u with a direction along it, counter-clockwise about +-n_c
//   turn at u       (m1 x u) x (m2 x u) = u [u, m1, m2]: the turn from n_m1 to n_m2 about u
//
// A turn, counter-clockwise seen from outside (from the positive side of c), falls into one of four
// classes: none, less than half a circle, half a circle, more. Classes order all turns from one
// start, except the turns in one open half. A second sign orders these turns.
//
// Planes of one map with different ids have different normals, as all contain the centre. So equal
// ids are asked before any arithmetic, and two headings run along one circle if and only if their
// ids are equal. The degree in input coordinates is 6 (det3), and 4 for turns at u. Source:
// docs/design/sphere.md, The signs.
#pragma once

#include <functional>
#include <vector>

#include "plumb/predicates/space/plane_table.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// The direction n_c x n_other on a circle c, or the opposite one.
struct CirclePlace {
  PlaneId other;             ///< A circle other than c.
  bool is_opposite = false;  ///< Whether the direction is -(n_c x n_other).
  /// Returns the opposite direction.
  constexpr CirclePlace opposite() const { return {other, !is_opposite}; }
  /// Returns the factor of n_c x n_other.
  constexpr Sign sign() const { return is_opposite ? Sign::Negative : Sign::Positive; }
};

/// The class of a turn, in the order of growing turns: none, less than half a circle, half a
/// circle, more.
enum class TurnClass : std::uint8_t { None, Left, Back, Right };

/// Returns the direction at a place of a circle.
inline SphereDirection direction_of(PlaneId circle, CirclePlace place) {
  return place.is_opposite ? SphereDirection{place.other, circle}
                           : SphereDirection{circle, place.other};
}

/// Returns the side of the circle on which u lies. Positive is the side of the normal of the
/// circle.
Sign side_of(const PlaneTable& planes, SphereDirection u, PlaneId circle);

/// Whether u and v are one direction.
bool is_same(const PlaneTable& planes, SphereDirection u, SphereDirection v);
/// Whether u and v are opposite.
inline bool is_opposite(const PlaneTable& planes, SphereDirection u, SphereDirection v) {
  return is_same(planes, u.opposite(), v);
}

/// Returns the place of u on a circle. Requires that u lies on it.
CirclePlace place_on(const PlaneTable& planes, PlaneId circle, SphereDirection u);

/// Returns the class of the turn from one place to another, counter-clockwise about the circle's
/// normal.
TurnClass turn_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to);

/// Whether x is met strictly before y, going counter-clockwise from `from`, which is met first.
bool is_before_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace x,
                  CirclePlace y);

/// Whether x lies strictly between two places, going counter-clockwise from the first to the
/// second. From a place to itself is the whole circle.
bool is_between_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to,
                   CirclePlace x);

/// Returns the class of the turn at u from one heading to another. Requires circles through u.
TurnClass turn_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from,
                  OrientedPlane to);

/// Whether x is met strictly before y, turning counter-clockwise at u from the heading `from`.
bool is_before_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from, OrientedPlane x,
                  OrientedPlane y);

// Arcs and rings of a map: where circles cross an arc, what lies inside it, and between which
// half-arcs a heading leaves a point.

/// Which of the two points +-(n_c x n_d) lie strictly inside an arc of circle c.
struct ArcCrossings {
  bool ahead = false;   ///< Whether n_c x n_d does: c passes there to the negative side of d.
  bool behind = false;  ///< Whether the opposite point does.
  /// Returns the same points as seen from circle d.
  constexpr ArcCrossings swapped() const { return {behind, ahead}; }
};
/// Returns the points that are in both.
constexpr ArcCrossings operator&(ArcCrossings a, ArcCrossings b) {
  return {a.ahead && b.ahead, a.behind && b.behind};
}

/// Returns which of the points +-(n_c x n_d) lie strictly inside an arc, given the sides of d on
/// which the arc begins and ends (for a loop, these sides are not read). Requires d != circle[arc].
ArcCrossings crossings(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc, PlaneId d,
                       Sign from_side, Sign to_side);
/// Returns the same, and computes the sides.
ArcCrossings crossings(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
                       PlaneId d);

/// Returns the place of the origin of a half-arc on its circle. Requires that it is no loop.
inline CirclePlace origin_place(const PlaneTable& planes, const SphereMap& map,
                                std::uint32_t half_arc) {
  return place_on(planes, map.circle[half_arc / 2], map.direction[map.origin[half_arc]]);
}

/// Whether a place on the arc's circle is strictly inside the arc. Every place is inside a loop.
bool is_inside_arc(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
                   CirclePlace place);

/// Whether a direction lies strictly inside an arc.
bool is_on_arc(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
               SphereDirection u);

/// Returns the heading of a half-arc where it leaves its origin.
inline OrientedPlane heading_of(const SphereMap& map, std::uint32_t half_arc) {
  return {map.circle[half_arc / 2], (half_arc & 1U) != 0};
}

/// Returns the half-arc that leaves the point next clockwise of a heading, so that the heading lies
/// in the sector to its left; kNone if the heading runs along an arc. Requires a point with arcs.
std::uint32_t sector_at(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                        OrientedPlane heading);

// Walks over a sphere map along great circles: what is met, and from which side.
//
// A leg runs counter-clockwise along one circle. The first leg goes from u along a circle through u
// to the circle of a given arc; the second follows that circle to the arc. Both circles are planes
// that the maps have, so nothing but det3 is ever asked: no circle through two points is formed.
// Cost: O(size of the map) signs, and sorting what is met.

/// A place on the boundary of a face: a half-arc with the face to its left, or an isolated point.
struct SphereSlot {
  std::uint32_t half_arc = kNone;  ///< The half-arc, or kNone.
  std::uint32_t point = kNone;     ///< The isolated point, or kNone.
  /// Whether it is either.
  bool is_valid() const { return half_arc != kNone || point != kNone; }
};

/// A point or arc that a walk meets. Entry and exit are on the boundaries of the faces that the
/// walk comes from and goes on into; they are not valid where it comes or goes along an arc.
struct PathHit {
  CirclePlace place;  ///< The place on the circle of the leg.
  SphereCell cell;    ///< The point or arc.
  SphereSlot entry;   ///< A slot of the face before.
  SphereSlot exit;    ///< A slot of the face after.
};

/// Returns the face whose boundary a slot is on. Requires a valid slot.
inline std::uint32_t face_of(const SphereMap& map, SphereSlot slot) {
  return slot.half_arc != kNone ? map.face[slot.half_arc] : map.point_face[slot.point];
}

/// A leg with its ends; from a place to itself it is the whole circle. Finds where it meets single
/// points and arcs of the map.
class Leg {
 public:
  Leg(const PlaneTable& planes, const SphereMap& map, PlaneId circle, CirclePlace from,
      CirclePlace to)
      : planes_(planes), map_(map), circle_(circle), from_(from), to_(to) {}

  /// Appends the point if the leg meets it.
  void add_point(std::uint32_t point, std::vector<PathHit>& hits) const;
  /// Appends each place strictly inside the arc that the leg crosses; none if the leg runs along
  /// the circle of the arc.
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

/// Appends what is met on the leg, its ends included, in order. Reads no face and no mark of the
/// map.
void walk_leg(const PlaneTable& planes, const SphereMap& map, PlaneId circle, CirclePlace from,
              CirclePlace to, std::vector<PathHit>& hits);

/// Appends what is met on the way from u to an arc, in order; a point of the map at u comes first.
/// Where the way turns from the first circle to the second, a hit has no exit (at the end of the
/// first leg) or no entry (at the start of the second). Requires that u is not on the arc.
void walk_to_arc(const PlaneTable& planes, const SphereMap& map, SphereDirection u,
                 std::uint32_t arc, std::vector<PathHit>& hits);

// Connected parts of a map, and which of their cycles bound one face.
//
// A walk goes from each part but one to a given arc. Two things that a walk meets one after the
// other bound one face. The faces and parts of a sphere form a tree, so the walks join all cycles
// of every face: docs/design/sphere.md, Lemmas 2 and 3. Reads no face and no mark of the map. Cost:
// O(n a(n)) with the inverse Ackermann function a, and O(n log n) for each part but one.

// Union-find, where the root of a set is its least member.

/// Returns the root of the set of i, and shortens the path.
inline std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}
/// Unites the sets of i and j.
void unite(std::vector<std::uint32_t>& parent, std::uint32_t i, std::uint32_t j);
/// Makes `count` sets of one member each.
void make_singles(std::vector<std::uint32_t>& parent, std::size_t count);

/// The connected parts of a map. Keeps its memory between calls.
class SphereParts {
 public:
  /// Two places on the boundary of one face, of one part or of two.
  struct Link {
    SphereSlot first;   ///< The place that a walk leaves.
    SphereSlot second;  ///< The next place that it meets.
  };

  /// Finds the parts of a map and the links. Each part takes a walk over the whole map; `look` is
  /// called before each walk, and may throw.
  void find(
      const PlaneTable& planes, const SphereMap& map, const std::function<void()>& look = [] {});

  // A part is a number below bound(). Some of them may be unused.
  std::uint32_t bound() const { return static_cast<std::uint32_t>(parent_.size()); }
  std::uint32_t of_point(std::uint32_t v) { return find_root(parent_, v); }
  std::uint32_t of_arc(std::uint32_t a) { return find_root(parent_, point_count_ + a); }
  std::uint32_t of(SphereSlot slot) {
    return slot.half_arc != kNone ? of_arc(slot.half_arc / 2) : of_point(slot.point);
  }
  /// Returns the number of parts.
  std::size_t count() const;

  /// Returns the links. Uniting the cycles that they link unites all cycles of each face. A map
  /// without arcs has no links, as it has one face.
  const std::vector<Link>& links() const { return links_; }

 private:
  void walk_from(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                 std::uint32_t root_arc);

  std::uint32_t point_count_ = 0;
  std::vector<std::uint32_t> parent_;  // Union-find over points, then arcs.
  std::vector<Link> links_;
  std::vector<PathHit> hits_;
};

}  // namespace plumb
