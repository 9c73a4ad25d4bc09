// Signs about directions and great circles: all that a sphere map asks of numbers.
//
// Notation. A direction u = n_p x n_q is a pair of planes, a circle c a plane, both through the
// centre. Two things are ordered cyclically: directions on a circle, and circles through a direction.
//
//   place on c      u = +-(n_c x n_m), named by m and the sign: u in normal form on c
//   turn on c       (n_c x m1) x (n_c x m2) = n_c det3(c, m1, m2): one determinant
//   heading at u    a circle through u with a direction along it: counter-clockwise about +-n_c
//   turn at u       (m1 x u) x (m2 x u) = u [u, m1, m2]: the turn from n_m1 to n_m2 about u
//
// A turn in four classes, counter-clockwise seen from outside (from the positive side of c):
// 0 none, 1 less than half a circle, 2 half a circle, 3 more. Classes order all turns from one start
// but those in one open half, which a second sign orders.
//
// Planes with different ids have different normals (one vertex, one table), so equal ids are asked
// before any arithmetic, and two headings are along one circle exactly when their ids are equal.
// Source: SPACE.md 2; degree 6 in coordinates of input planes' points (det3), 4 (turns at u).
#pragma once

#include "plumb/predicates/plane_table.h"
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

/// Does x lie strictly between, going counter-clockwise? From a place to itself is the whole circle.
bool is_between_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to,
                   CirclePlace x);

/// The turn at u from one heading to another. Requires circles through u.
TurnClass turn_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from,
                  OrientedPlane to);

/// Is x met strictly before y, turning counter-clockwise at u from the heading `from`?
bool is_before_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from, OrientedPlane x,
                  OrientedPlane y);

}  // namespace plumb
