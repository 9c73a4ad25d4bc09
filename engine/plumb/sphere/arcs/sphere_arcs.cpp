// Signs about directions and great circles, crossings of arcs and circles, walks along circles, and
// the connected parts of a sphere map.
//
// All order on a circle and around a direction is reduced to det3 and to single components of cross
// products (docs/design/sphere.md, The signs). Whether a circle crosses an arc follows from the
// sides of the arc's ends alone: going around, one passes four stations in a fixed order (Crossings
// from sides, and Lemma 1 there). No circle through two directions is ever formed, so degrees stay
// at 6.
//
// Faces of a map that is not connected are found by walks from part to part, each along one circle
// to the circle of a common root arc and along that to the arc; Lemmas 2 and 3 of that page prove
// that their links join all boundary cycles of each face.
//
// Tested by tests/sphere/sphere_overlay_test.cpp and tests/sphere/nef_sphere_test.cpp.

#include "plumb/sphere/arcs/sphere_arcs.h"

#include <algorithm>
#include <numeric>

#include "plumb/predicates/plane_signs.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

void SphereMap::clear() {
  for (auto* marks : {&point_mark, &arc_mark, &face_mark}) marks->clear();
  for (auto* ids : {&first_out, &point_face, &origin, &next, &face}) ids->clear();
  direction.clear();
  circle.clear();
  centre_mark = 0;
}

namespace {

/// Returns the sign of l in n_m1 x n_m2 = l u. Requires that both circles contain u.
Sign turn_between(const PlaneTable& planes, SphereDirection u, PlaneId m1, PlaneId m2) {
  if (m1 == m2) return Sign::Zero;
  if (m1 == u.p && m2 == u.q) return Sign::Positive;
  if (m1 == u.q && m2 == u.p) return Sign::Negative;
  return turn_about_line(planes, u.p, u.q, m1, m2);
}

/// Returns the half of the circle, seen from the first place, that contains the second place:
/// Positive if the turn is less than half a circle, Negative if it is more, Zero if the places are
/// equal or opposite.
Sign half_on(const PlaneTable& planes, PlaneId circle, CirclePlace from, CirclePlace to) {
  if (from.other == to.other) return Sign::Zero;
  return det3_sign(planes, circle, from.other, to.other) * from.sign() * to.sign();
}

/// Returns the same result for two headings at u.
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

/// v lies on both circles of u if and only if it is u or -u; the turn distinguishes the two.
bool is_same(const PlaneTable& planes, SphereDirection u, SphereDirection v) {
  if (u == v) return true;
  if (u == v.opposite()) return false;
  return side_of(planes, v, u.p) == Sign::Zero && side_of(planes, v, u.q) == Sign::Zero &&
         turn_between(planes, u, v.p, v.q) == Sign::Positive;
}

/// For another circle, u is a multiple of n_c x n_(u.p), whose sign is that of a turn at u.
CirclePlace place_on(const PlaneTable& planes, PlaneId circle, SphereDirection u) {
  if (circle == u.p) return {u.q, false};
  if (circle == u.q) return {u.p, true};
  return {u.p, turn_between(planes, u, circle, u.p) == Sign::Negative};
}

/// If det3 is zero, the places are equal or opposite, and one component of a cross product decides.
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

namespace {

/// A counter-clockwise walk on c is first on the positive side of d, then at n_c x n_d, then on the
/// negative side, and then at the opposite point. These are the four stations.
enum Station : unsigned { kPositive = 0, kAhead = 1, kNegative = 2, kBehind = 3 };

/// Returns the station of the origin of a half-arc, which its side of d determines unless it lies
/// on d.
Station station(const PlaneTable& planes, const SphereMap& map, std::uint32_t half_arc, PlaneId d,
                Sign side) {
  if (side == Sign::Positive) return kPositive;
  if (side == Sign::Negative) return kNegative;
  const PlaneId c = map.circle[half_arc / 2];
  const CirclePlace place = origin_place(planes, map, half_arc);
  return turn_on(planes, c, {d, false}, place) == TurnClass::None ? kAhead : kBehind;
}

/// Whether an arc whose two ends are at the same station goes once around the circle, instead of
/// staying at the station.
bool goes_round(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc, Station at) {
  if (map.origin[2 * arc] == map.origin[2 * arc + 1]) return true;
  // Two points are never at the same one of these stations.
  if (at == kAhead || at == kBehind) return false;
  return turn_on(planes, map.circle[arc], origin_place(planes, map, 2 * arc),
                 origin_place(planes, map, 2 * arc + 1)) == TurnClass::Right;
}

}  // namespace

/// Passes the stations from the start to the end. A station is strictly inside of the arc unless it
/// is the first or the last station.
ArcCrossings crossings(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc, PlaneId d,
                       Sign from_side, Sign to_side) {
  if (map.is_loop(arc)) return {true, true};
  const Station from = station(planes, map, 2 * arc, d, from_side);
  const Station to = station(planes, map, 2 * arc + 1, d, to_side);
  unsigned steps = (to - from) & 3U;
  if (steps == 0 && goes_round(planes, map, arc, from)) steps = 4;
  ArcCrossings found;
  for (unsigned i = 1; i <= steps; ++i) {
    const unsigned at = (from + i) & 3U;
    const bool is_end = i == steps;
    if (at == kAhead && !is_end) found.ahead = true;
    if (at == kBehind && !is_end) found.behind = true;
  }
  return found;
}

ArcCrossings crossings(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
                       PlaneId d) {
  if (map.is_loop(arc)) return {true, true};
  return crossings(planes, map, arc, d, side_of(planes, map.direction[map.origin[2 * arc]], d),
                   side_of(planes, map.direction[map.origin[2 * arc + 1]], d));
}

bool is_inside_arc(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
                   CirclePlace place) {
  return map.is_loop(arc) ||
         is_between_on(planes, map.circle[arc], origin_place(planes, map, 2 * arc),
                       origin_place(planes, map, 2 * arc + 1), place);
}

bool is_on_arc(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
               SphereDirection u) {
  const PlaneId c = map.circle[arc];
  return side_of(planes, u, c) == Sign::Zero &&
         is_inside_arc(planes, map, arc, place_on(planes, c, u));
}

std::uint32_t sector_at(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                        OrientedPlane heading) {
  const SphereDirection u = map.direction[point];
  const std::uint32_t first = map.first_out[point];
  std::uint32_t best = first;
  for (std::uint32_t h = first;;) {
    if (heading_of(map, h) == heading) return kNone;
    // The last half-arc counter-clockwise from the heading is the first one clockwise from it.
    if (is_before_at(planes, u, heading, heading_of(map, best), heading_of(map, h))) best = h;
    h = map.clockwise(h);
    if (h == first) return best;
  }
}

bool Leg::is_on(CirclePlace place) const {
  return turn_on(planes_, circle_, from_, place) == TurnClass::None ||
         turn_on(planes_, circle_, to_, place) == TurnClass::None ||
         is_between_on(planes_, circle_, from_, to_, place);
}

void Leg::add_point(std::uint32_t v, std::vector<PathHit>& hits) const {
  if (side_of(planes_, map_.direction[v], circle_) != Sign::Zero) return;
  const CirclePlace place = place_on(planes_, circle_, map_.direction[v]);
  if (!is_on(place)) return;
  hits.push_back({place, SphereCell::point(v), slot_towards(v, true), slot_towards(v, false)});
}

/// Returns the slot of the face that the leg enters, or leaves, at a point.
SphereSlot Leg::slot_towards(std::uint32_t v, bool backward) const {
  if (map_.first_out[v] == kNone) return {kNone, v};
  return {sector_at(planes_, map_, v, {circle_, backward}), kNone};
}

void Leg::add_arc(std::uint32_t a, std::vector<PathHit>& hits) const {
  if (map_.circle[a] == circle_) return;
  const ArcCrossings on_leg = crossings(planes_, map_, a, circle_).swapped();
  if (on_leg.ahead) add_crossing(a, false, hits);
  if (on_leg.behind) add_crossing(a, true, hits);
}

/// At n_c x n_m, the leg leaves the positive side of m, which is to the left of the even half-arc
/// of the arc on m. Therefore the entry is that half-arc at this point, and the odd half-arc at the
/// opposite point.
void Leg::add_crossing(std::uint32_t a, bool is_opposite, std::vector<PathHit>& hits) const {
  const CirclePlace place{map_.circle[a], is_opposite};
  if (!is_on(place)) return;
  const std::uint32_t entry = 2 * a + (is_opposite ? 1U : 0U);
  hits.push_back({place, SphereCell::arc(a), {entry, kNone}, {SphereMap::twin(entry), kNone}});
}

namespace {

bool is_on_closed_arc(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc,
                      CirclePlace place) {
  if (is_inside_arc(planes, map, arc, place)) return true;
  const PlaneId c = map.circle[arc];
  return turn_on(planes, c, origin_place(planes, map, 2 * arc), place) == TurnClass::None ||
         turn_on(planes, c, origin_place(planes, map, 2 * arc + 1), place) == TurnClass::None;
}

}  // namespace

void walk_leg(const PlaneTable& planes, const SphereMap& map, PlaneId circle, CirclePlace from,
              CirclePlace to, std::vector<PathHit>& hits) {
  const auto first = static_cast<std::ptrdiff_t>(hits.size());
  const Leg leg(planes, map, circle, from, to);
  for (std::uint32_t v = 0; v < map.point_count(); ++v) leg.add_point(v, hits);
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) leg.add_arc(a, hits);
  std::sort(hits.begin() + first, hits.end(), [&](const PathHit& x, const PathHit& y) {
    return is_before_on(planes, circle, from, x.place, y.place);
  });
}

/// The first leg follows u.p to the nearer of its two common points with the circle r of the arc,
/// the corner; the second follows r. If u lies on r, there is no first leg. At the corner, the walk
/// turns. Therefore a hit at the corner has no exit on the first leg and no entry on the second
/// leg, because the places before and after the corner may lie in different faces.
void walk_to_arc(const PlaneTable& planes, const SphereMap& map, SphereDirection u,
                 std::uint32_t arc, std::vector<PathHit>& hits) {
  const PlaneId r = map.circle[arc];
  const Sign side = side_of(planes, u, r);
  CirclePlace corner;  // The place on r.
  if (side == Sign::Zero) {
    corner = place_on(planes, r, u);
  } else {
    const CirclePlace end{r, side == Sign::Negative};
    corner = CirclePlace{u.p, !end.is_opposite};
    walk_leg(planes, map, u.p, {u.q, false}, end, hits);
    if (is_on_closed_arc(planes, map, arc, corner)) return;
    if (!hits.empty() && turn_on(planes, u.p, end, hits.back().place) == TurnClass::None) {
      hits.back().exit = {};
    }
  }
  const std::size_t first = hits.size();
  walk_leg(planes, map, r, corner, origin_place(planes, map, 2 * arc), hits);
  if (first < hits.size() && turn_on(planes, r, corner, hits[first].place) == TurnClass::None) {
    hits[first].entry = {};
  }
}

void unite(std::vector<std::uint32_t>& parent, std::uint32_t i, std::uint32_t j) {
  i = find_root(parent, i);
  j = find_root(parent, j);
  parent[std::max(i, j)] = std::min(i, j);
}

void make_singles(std::vector<std::uint32_t>& parent, std::size_t count) {
  parent.resize(count);
  std::iota(parent.begin(), parent.end(), std::uint32_t{0});
}

std::size_t SphereParts::count() const {
  std::size_t roots = 0;
  for (std::uint32_t i = 0; i < parent_.size(); ++i) {
    if (parent_[i] == i) ++roots;
  }
  return roots;
}

void SphereParts::walk_from(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                            std::uint32_t root_arc) {
  hits_.clear();
  walk_to_arc(planes, map, map.direction[point], root_arc, hits_);
  for (std::size_t i = 0; i + 1 < hits_.size(); ++i) {
    if (hits_[i].exit.is_valid() && hits_[i + 1].entry.is_valid()) {
      links_.push_back({hits_[i].exit, hits_[i + 1].entry});
    }
  }
}

/// Arcs with a common point belong to the same part. No walk starts from a loop. There is at most
/// one loop, because two loops would cross, and it is used as the root arc. Every other part has
/// points, and its least point is its root in the union-find.
void SphereParts::find(const PlaneTable& planes, const SphereMap& map,
                       const std::function<void()>& look) {
  point_count_ = static_cast<std::uint32_t>(map.point_count());
  make_singles(parent_, map.point_count() + map.arc_count());
  for (std::uint32_t h = 0; h < map.origin.size(); ++h) {
    if (map.origin[h] != kNone) unite(parent_, map.origin[h], point_count_ + h / 2);
  }
  links_.clear();
  if (map.arc_count() == 0) return;
  std::uint32_t root = 0;
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (map.is_loop(a)) root = a;
  }
  const std::uint32_t root_part = of_arc(root);
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (of_point(v) != v || v == root_part) continue;
    look();
    walk_from(planes, map, v, root);
  }
}

}  // namespace plumb
