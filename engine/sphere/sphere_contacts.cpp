#include "plumb/sphere/sphere_contacts.h"

#include <algorithm>

namespace plumb {

namespace {

constexpr std::uint32_t kNone = SphereMap::kNone;

bool have_common(const std::vector<PlaneId>& sorted_a, const std::vector<PlaneId>& sorted_b) {
  return std::any_of(sorted_a.begin(), sorted_a.end(), [&](PlaneId c) {
    return std::binary_search(sorted_b.begin(), sorted_b.end(), c);
  });
}

}  // namespace

std::uint32_t SphereContacts::add(SphereDirection u, SphereCell in_a, SphereCell in_b) {
  direction.push_back(u);
  cell.push_back({in_a, in_b});
  return static_cast<std::uint32_t>(direction.size() - 1);
}

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

void SphereContacts::find_sides(std::size_t k) {
  sides_[k].clear();
  for (const SphereDirection u : map_[k]->direction) {
    for (const PlaneId c : circles_[1 - k]) sides_[k].push_back(side_of(*planes_, u, c));
  }
}

void SphereContacts::find_crossings(std::size_t k) {
  const SphereMap& map = *map_[k];
  const auto count = static_cast<std::uint32_t>(circles_[1 - k].size());
  crossings_[k].clear();
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    for (std::uint32_t c = 0; c < count; ++c) {
      const PlaneId d = circles_[1 - k][c];
      const bool asks = map.circle[a] != d && !map.is_loop(a);
      const Sign from = asks ? side(k, map.origin[2 * a], c) : Sign::Zero;
      const Sign to = asks ? side(k, map.origin[2 * a + 1], c) : Sign::Zero;
      crossings_[k].push_back(map.circle[a] == d ? ArcCrossings{}
                                                 : crossings(*planes_, map, a, d, from, to));
    }
  }
}

std::uint32_t SphereContacts::find_equal(std::uint32_t point_of_b) const {
  const std::uint32_t h = map_[1]->first_out[point_of_b];
  for (std::uint32_t v = 0; v < map_[0]->point_count(); ++v) {
    if (h != kNone && side(0, v, circle_of_[1][h / 2]) != Sign::Zero) continue;
    if (is_same(*planes_, map_[0]->direction[v], map_[1]->direction[point_of_b])) return v;
  }
  return kNone;
}

void SphereContacts::join_points() {
  for (std::uint32_t v = 0; v < map_[0]->point_count(); ++v) {
    point_of[0].push_back(add(map_[0]->direction[v], SphereCell::point(v), {}));
  }
  for (std::uint32_t v = 0; v < map_[1]->point_count(); ++v) {
    const std::uint32_t equal = find_equal(v);
    if (equal == kNone) {
      point_of[1].push_back(add(map_[1]->direction[v], {}, SphereCell::point(v)));
    } else {
      point_of[1].push_back(equal);
      cell[equal][1] = SphereCell::point(v);
    }
  }
}

/// Points of map k on arcs of the other.
void SphereContacts::add_points_on(std::size_t k) {
  const std::size_t other = 1 - k;
  const SphereMap& arcs = *map_[other];
  for (std::uint32_t v = 0; v < map_[k]->point_count(); ++v) {
    const std::uint32_t p = point_of[k][v];
    for (std::uint32_t a = 0; a < arcs.arc_count() && !cell[p][other].is_valid(); ++a) {
      if (side(k, v, circle_of_[other][a]) != Sign::Zero) continue;
      const CirclePlace place = place_on(*planes_, arcs.circle[a], direction[p]);
      if (!is_inside_arc(*planes_, arcs, a, place)) continue;
      cell[p][other] = SphereCell::arc(a);
      stops[other].push_back({a, p, place});
    }
  }
}

void SphereContacts::add_crossing(std::uint32_t a, std::uint32_t b, bool is_opposite) {
  const CirclePlace on_a{map_[1]->circle[b], is_opposite};
  const CirclePlace on_b{map_[0]->circle[a], !is_opposite};
  const std::uint32_t p =
      add(direction_of(map_[0]->circle[a], on_a), SphereCell::arc(a), SphereCell::arc(b));
  stops[0].push_back({a, p, on_a});
  stops[1].push_back({b, p, on_b});
}

void SphereContacts::add_crossings() {
  const std::size_t count_a = circles_[0].size();
  const std::size_t count_b = circles_[1].size();
  for (std::uint32_t a = 0; a < map_[0]->arc_count(); ++a) {
    for (std::uint32_t b = 0; b < map_[1]->arc_count(); ++b) {
      const ArcCrossings on_a = crossings_[0][a * count_b + circle_of_[1][b]];
      const ArcCrossings on_b = crossings_[1][b * count_a + circle_of_[0][a]];
      const ArcCrossings both = on_a & on_b.swapped();
      if (both.ahead) add_crossing(a, b, false);
      if (both.behind) add_crossing(a, b, true);
    }
  }
}

void SphereContacts::find(const PlaneTable& planes, const SphereMap& a, const SphereMap& b) {
  planes_ = &planes;
  map_ = {&a, &b};
  direction.clear();
  cell.clear();
  for (std::size_t k = 0; k < 2; ++k) {
    point_of[k].clear();
    stops[k].clear();
    number_circles(*map_[k], k);
  }
  shares_circles = have_common(circles_[0], circles_[1]);
  for (std::size_t k = 0; k < 2; ++k) find_sides(k);
  for (std::size_t k = 0; k < 2; ++k) find_crossings(k);
  join_points();
  for (std::size_t k = 0; k < 2; ++k) add_points_on(k);
  add_crossings();
}

}  // namespace plumb
