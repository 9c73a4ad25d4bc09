#include "plumb/sphere/sphere_path.h"

#include <algorithm>

namespace plumb {
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

SphereSlot Leg::slot_towards(std::uint32_t v, bool backward) const {
  if (map_.first_out[v] == SphereMap::kNone) return {SphereMap::kNone, v};
  return {sector_at(planes_, map_, v, {circle_, backward}), SphereMap::kNone};
}

void Leg::add_arc(std::uint32_t a, std::vector<PathHit>& hits) const {
  if (map_.circle[a] == circle_) return;
  const ArcCrossings on_leg = crossings(planes_, map_, a, circle_).swapped();
  if (on_leg.ahead) add_crossing(a, false, hits);
  if (on_leg.behind) add_crossing(a, true, hits);
}

/// At n_c x n_m the leg leaves the positive side of m, which is to the left of the even half-arc.
void Leg::add_crossing(std::uint32_t a, bool is_opposite, std::vector<PathHit>& hits) const {
  const CirclePlace place{map_.circle[a], is_opposite};
  if (!is_on(place)) return;
  const std::uint32_t entry = 2 * a + (is_opposite ? 1U : 0U);
  hits.push_back({place,
                  SphereCell::arc(a),
                  {entry, SphereMap::kNone},
                  {SphereMap::twin(entry), SphereMap::kNone}});
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

void walk_to_arc(const PlaneTable& planes, const SphereMap& map, SphereDirection u,
                 std::uint32_t arc, std::vector<PathHit>& hits) {
  const PlaneId r = map.circle[arc];
  const Sign side = side_of(planes, u, r);
  CirclePlace corner;  // on r
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

}  // namespace plumb
