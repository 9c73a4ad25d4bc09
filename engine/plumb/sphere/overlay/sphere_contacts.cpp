// The contacts of two sphere maps: equal points, points on arcs, and crossings of arcs.
//
// All contacts follow from the sides of the points of one map on the circles of the other. For
// small maps, these sides are computed once and stored, so that each det3 is computed at most once
// and later calls allocate no memory. For large maps, only pairs of items whose bounds meet are
// tested. The order of pairs does not depend on the way they are found, so both ways give the same
// numbers to the points.
//
// docs/design/sphere.md, Crossings from sides, proves that two arcs of different circles cross if
// and only if both have the same one of the two common points of their circles inside (Lemma 1).
//
// Tested by tests/sphere/sphere_overlay_test.cpp.

#include "plumb/sphere/overlay/sphere_contacts.h"

#include <algorithm>

#include "plumb/sphere/arcs/sphere_bounds.h"

namespace plumb {

namespace {

bool have_common(const std::vector<PlaneId>& sorted_a, const std::vector<PlaneId>& sorted_b) {
  return std::any_of(sorted_a.begin(), sorted_a.end(), [&](PlaneId c) {
    return std::binary_search(sorted_b.begin(), sorted_b.end(), c);
  });
}

}  // namespace

/// Adds a point to the overlay.
std::uint32_t SphereContacts::add(SphereDirection u, SphereCell in_a, SphereCell in_b) {
  direction.push_back(u);
  cell.push_back({in_a, in_b});
  return static_cast<std::uint32_t>(direction.size() - 1);
}

/// Lists the circles of map k, each once, and numbers the circles of its arcs.
void SphereContacts::number_circles(const SphereMap& map, std::size_t k) {
  std::vector<PlaneId>& circles = circles_[k];
  circles = map.circle;
  std::sort(circles.begin(), circles.end());
  circles.erase(std::unique(circles.begin(), circles.end()), circles.end());
  circle_of_[k].clear();
  for (const PlaneId c : map.circle) {
    const auto at = std::lower_bound(circles.begin(), circles.end(), c);
    circle_of_[k].push_back(static_cast<std::uint32_t>(at - circles.begin()));
  }
}

Sign SphereContacts::compute_side(std::size_t k, std::uint32_t point, std::uint32_t circle) const {
  return side_of(*planes_, map_[k]->direction[point], circles_[1 - k][circle]);
}

Sign SphereContacts::side(std::size_t k, std::uint32_t point, std::uint32_t circle) const {
  return is_tabled_ ? sides_[k][point * circles_[1 - k].size() + circle]
                    : compute_side(k, point, circle);
}

/// Arcs on the circle itself have no crossings with it. A loop on another circle has both
/// crossings.
ArcCrossings SphereContacts::compute_crossings(std::size_t k, std::uint32_t arc,
                                               std::uint32_t circle) const {
  const SphereMap& map = *map_[k];
  const PlaneId d = circles_[1 - k][circle];
  if (map.circle[arc] == d) return {};
  if (map.is_loop(arc)) return {true, true};
  return crossings(*planes_, map, arc, d, side(k, map.origin[2 * arc], circle),
                   side(k, map.origin[2 * arc + 1], circle));
}

ArcCrossings SphereContacts::crossings_of(std::size_t k, std::uint32_t arc,
                                          std::uint32_t circle) const {
  return is_tabled_ ? crossings_[k][arc * circles_[1 - k].size() + circle]
                    : compute_crossings(k, arc, circle);
}

/// Computes each sign of the phase once, because several pairs may need it.
void SphereContacts::make_tables() {
  for (std::size_t k = 0; k < 2; ++k) {
    const auto count = static_cast<std::uint32_t>(circles_[1 - k].size());
    sides_[k].clear();
    crossings_[k].clear();
    for (std::uint32_t v = 0; v < map_[k]->point_count(); ++v) {
      for (std::uint32_t c = 0; c < count; ++c) sides_[k].push_back(compute_side(k, v, c));
    }
    for (std::uint32_t a = 0; a < map_[k]->arc_count(); ++a) {
      for (std::uint32_t c = 0; c < count; ++c) crossings_[k].push_back(compute_crossings(k, a, c));
    }
  }
}

/// Finds the pairs of items whose bounds meet, and sorts them into the order of the tables.
void SphereContacts::find_pairs() {
  for (std::vector<Pair>& pairs : pairs_) pairs.clear();
  const auto points_a = static_cast<std::uint32_t>(map_[0]->point_count());
  const auto points_b = static_cast<std::uint32_t>(map_[1]->point_count());
  look_at_limits();
  const SphereBoundTree tree(bounds_of(*planes_, *map_[1]));
  look_at_limits();
  const std::vector<SphereBound> bounds = bounds_of(*planes_, *map_[0]);
  for (std::uint32_t i = 0; i < bounds.size(); ++i) {
    if (i % 256 == 0) look_at_limits();
    tree.for_each_meeting(bounds[i], [&](std::uint32_t j) {
      const std::size_t kind = (i < points_a ? 0U : 2U) + (j < points_b ? 0U : 1U);
      if (pairs_[kind].size() % 4096 == 4095) look_at_limits();
      pairs_[kind].push_back({i < points_a ? i : i - points_a, j < points_b ? j : j - points_b});
    });
  }
  for (std::vector<Pair>& pairs : pairs_) std::sort(pairs.begin(), pairs.end());
}

void SphereContacts::look_at_limits() const {
  if (limits_ == nullptr) return;
  std::size_t pairs = 0;
  for (const std::vector<Pair>& some : pairs_) pairs += some.size();
  limits_->look(pairs, direction.size());
}

template <class Visit>
void SphereContacts::for_each_pair(PairKind kind, Visit visit) const {
  if (!is_tabled_) {
    std::size_t visited = 0;
    for (const auto& [i, j] : pairs_[kind]) {
      if (++visited % 1024 == 0) look_at_limits();
      visit(i, j);
    }
    return;
  }
  const bool is_point_a = kind == PointPoint || kind == PointArc;
  const bool is_point_b = kind == PointPoint || kind == ArcPoint;
  const std::size_t count_a = is_point_a ? map_[0]->point_count() : map_[0]->arc_count();
  const std::size_t count_b = is_point_b ? map_[1]->point_count() : map_[1]->arc_count();
  for (std::uint32_t i = 0; i < count_a; ++i) {
    for (std::uint32_t j = 0; j < count_b; ++j) visit(i, j);
  }
}

/// Points are compared exactly only if one of them lies on a circle through the other.
void SphereContacts::join_points() {
  equal_.assign(map_[1]->point_count(), kNone);
  for_each_pair(PointPoint, [&](std::uint32_t v, std::uint32_t w) {
    const std::uint32_t h = map_[1]->first_out[w];
    if (h != kNone && side(0, v, circle_of_[1][h / 2]) != Sign::Zero) return;
    if (is_same(*planes_, map_[0]->direction[v], map_[1]->direction[w])) equal_[w] = v;
  });
  for (std::uint32_t v = 0; v < map_[0]->point_count(); ++v) {
    point_of[0].push_back(add(map_[0]->direction[v], SphereCell::point(v), {}));
  }
  for (std::uint32_t w = 0; w < map_[1]->point_count(); ++w) {
    if (equal_[w] == kNone) {
      point_of[1].push_back(add(map_[1]->direction[w], {}, SphereCell::point(w)));
    } else {
      point_of[1].push_back(equal_[w]);
      cell[equal_[w]][1] = SphereCell::point(w);
    }
  }
}

/// Finds points of map k that lie strictly inside of arcs of the other map. Each point lies inside
/// of at most one arc.
void SphereContacts::add_points_on(std::size_t k) {
  const std::size_t other = 1 - k;
  const SphereMap& arcs = *map_[other];
  const auto test = [&](std::uint32_t v, std::uint32_t a) {
    const std::uint32_t p = point_of[k][v];
    if (cell[p][other].is_valid() || side(k, v, circle_of_[other][a]) != Sign::Zero) return;
    const CirclePlace place = place_on(*planes_, arcs.circle[a], direction[p]);
    if (!is_inside_arc(*planes_, arcs, a, place)) return;
    cell[p][other] = SphereCell::arc(a);
    stops[other].push_back({a, p, place});
  };
  if (k == 0) {
    for_each_pair(PointArc, test);
  } else {
    for_each_pair(ArcPoint, [&](std::uint32_t a, std::uint32_t v) { test(v, a); });
  }
}

/// Adds the crossing of arcs a and b at n_a x n_b, or at the opposite point.
void SphereContacts::add_crossing(std::uint32_t a, std::uint32_t b, bool is_opposite) {
  const CirclePlace on_a{map_[1]->circle[b], is_opposite};
  const CirclePlace on_b{map_[0]->circle[a], !is_opposite};
  const std::uint32_t p =
      add(direction_of(map_[0]->circle[a], on_a), SphereCell::arc(a), SphereCell::arc(b));
  stops[0].push_back({a, p, on_a});
  stops[1].push_back({b, p, on_b});
}

/// In the two maps, the names of the common points of two circles are exchanged. Therefore
/// swapped() is applied.
void SphereContacts::add_crossings() {
  for_each_pair(ArcArc, [&](std::uint32_t a, std::uint32_t b) {
    const ArcCrossings on_a = crossings_of(0, a, circle_of_[1][b]);
    if (!on_a.ahead && !on_a.behind) return;
    const ArcCrossings both = on_a & crossings_of(1, b, circle_of_[0][a]).swapped();
    if (both.ahead) add_crossing(a, b, false);
    if (both.behind) add_crossing(a, b, true);
  });
}

void SphereContacts::find(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
                          std::size_t most_tabled, SphereLimits* limits) {
  planes_ = &planes;
  limits_ = limits;
  map_ = {&a, &b};
  direction.clear();
  cell.clear();
  for (std::size_t k = 0; k < 2; ++k) {
    point_of[k].clear();
    stops[k].clear();
    number_circles(*map_[k], k);
  }
  shares_circles = have_common(circles_[0], circles_[1]);
  is_tabled_ = are_small(a, b, most_tabled);
  if (is_tabled_) {
    make_tables();
  } else {
    find_pairs();
  }
  join_points();
  for (std::size_t k = 0; k < 2; ++k) add_points_on(k);
  add_crossings();
  if (!is_tabled_) look_at_limits();
  limits_ = nullptr;
}

}  // namespace plumb
