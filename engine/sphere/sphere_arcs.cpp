#include "plumb/sphere/sphere_arcs.h"

namespace plumb {
namespace {

/// Going counter-clockwise on c one is on the positive side of d, at n_c x n_d, on the negative side,
/// at the opposite point, and so on: four stations in this order.
enum Station : unsigned { kPositive = 0, kAhead = 1, kNegative = 2, kBehind = 3 };

Station station(const PlaneTable& planes, const SphereMap& map, std::uint32_t half_arc, PlaneId d,
                Sign side) {
  if (side == Sign::Positive) return kPositive;
  if (side == Sign::Negative) return kNegative;
  const PlaneId c = map.circle[half_arc / 2];
  const CirclePlace place = origin_place(planes, map, half_arc);
  return turn_on(planes, c, {d, false}, place) == TurnClass::None ? kAhead : kBehind;
}

/// Both ends at one station: does the arc go all the way round?
bool goes_round(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc, Station at) {
  if (map.origin[2 * arc] == map.origin[2 * arc + 1]) return true;
  if (at == kAhead || at == kBehind) return false;  // different points are never at one of these
  return turn_on(planes, map.circle[arc], origin_place(planes, map, 2 * arc),
                 origin_place(planes, map, 2 * arc + 1)) == TurnClass::Right;
}

}  // namespace

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
    if (heading_of(map, h) == heading) return SphereMap::kNone;
    // The last one counter-clockwise from the heading is the next one clockwise.
    if (is_before_at(planes, u, heading, heading_of(map, best), heading_of(map, h))) best = h;
    h = map.clockwise(h);
    if (h == first) return best;
  }
}

}  // namespace plumb
