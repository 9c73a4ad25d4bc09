#include "plumb/sphere/sphere_directions.h"

#include "plumb/predicates/plane_signs.h"

namespace plumb {
namespace {

/// The sign of l in n_m1 x n_m2 = l u. Requires both circles through u.
Sign turn_between(const PlaneTable& planes, SphereDirection u, PlaneId m1, PlaneId m2) {
  if (m1 == m2) return Sign::Zero;
  if (m1 == u.p && m2 == u.q) return Sign::Positive;
  if (m1 == u.q && m2 == u.p) return Sign::Negative;
  return turn_about_line(planes, u.p, u.q, m1, m2);
}

/// Zero: the same place or the opposite one.
Sign half_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to) {
  if (from.other == to.other) return Sign::Zero;
  return det3_sign(planes, circle, from.other, to.other) * from.sign() * to.sign();
}

Sign half_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from, OrientedPlane to) {
  return turn_between(planes, u, from.plane(), to.plane()) * from.orientation() * to.orientation();
}

TurnClass class_of(Sign half, bool is_none) {
  if (half == Sign::Positive) return TurnClass::Left;
  if (half == Sign::Negative) return TurnClass::Right;
  return is_none ? TurnClass::None : TurnClass::Back;
}

}  // namespace

Sign side_of(const PlaneTable& planes, SphereDirection u, PlaneId circle) {
  return det3_sign(planes, u.p, u.q, circle);
}

bool is_same(const PlaneTable& planes, SphereDirection u, SphereDirection v) {
  if (u == v) return true;
  if (u == v.opposite()) return false;
  return side_of(planes, v, u.p) == Sign::Zero && side_of(planes, v, u.q) == Sign::Zero &&
         turn_between(planes, u, v.p, v.q) == Sign::Positive;
}

CirclePlace place_on(const PlaneTable& planes, PlaneId circle, SphereDirection u) {
  if (circle == u.p) return {u.q, false};
  if (circle == u.q) return {u.p, true};
  return {u.p, turn_between(planes, u, circle, u.p) == Sign::Negative};
}

TurnClass turn_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to) {
  const Sign half = half_on(planes, circle, from, to);
  if (half != Sign::Zero) return class_of(half, false);
  const Sign along = from.other == to.other
                         ? Sign::Positive
                         : turn_between(planes, {circle, from.other}, circle, to.other);
  return class_of(half, along * from.sign() * to.sign() == Sign::Positive);
}

bool is_before_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace x,
                  CirclePlace y) {
  const TurnClass to_x = turn_on(planes, circle, from, x);
  const TurnClass to_y = turn_on(planes, circle, from, y);
  return to_x != to_y ? to_x < to_y : half_on(planes, circle, x, y) == Sign::Positive;
}

bool is_between_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to,
                   CirclePlace x) {
  const TurnClass to_x = turn_on(planes, circle, from, x);
  if (to_x == TurnClass::None) return false;
  const TurnClass to_end = turn_on(planes, circle, from, to);
  if (to_end == TurnClass::None) return true;
  return to_x != to_end ? to_x < to_end : half_on(planes, circle, x, to) == Sign::Positive;
}

TurnClass turn_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from,
                  OrientedPlane to) {
  return class_of(half_at(planes, u, from, to), from == to);
}

bool is_before_at(const PlaneTable& planes, SphereDirection u, OrientedPlane from, OrientedPlane x,
                  OrientedPlane y) {
  const TurnClass to_x = turn_at(planes, u, from, x);
  const TurnClass to_y = turn_at(planes, u, from, y);
  return to_x != to_y ? to_x < to_y : half_at(planes, u, x, y) == Sign::Positive;
}

}  // namespace plumb
