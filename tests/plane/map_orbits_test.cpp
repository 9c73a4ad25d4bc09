// Orbits of maps on a grid against their definitions: areas in integers, sets of listed cycles, and
// points in polygons. Cycles are listed, left out, joined and split at random.
#include "plumb/plane/check/map_orbits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::map_orbits_test {

using Place = std::array<int, 2>;
using Cycle = std::vector<std::uint32_t>;
constexpr int kSide = 7;
constexpr std::uint32_t kNoCycle = MapEdges::kNoCycle;

/// 0 to 7, counter-clockwise from the right, of the way from one neighbour on the grid to another.
int eighth(const Place& from, const Place& to) {
  constexpr std::array<std::array<int, 3>, 3> kEighths = {{{5, 4, 3}, {6, -1, 2}, {7, 0, 1}}};
  return kEighths[static_cast<std::size_t>(to[0] - from[0] + 1)]
                 [static_cast<std::size_t>(to[1] - from[1] + 1)];
}

int twice_area(const std::vector<Place>& place, std::span<const std::uint32_t> cycle) {
  int sum = 0;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Place &p = place[cycle[i]], &q = place[cycle[(i + 1) % cycle.size()]];
    sum += p[0] * q[1] - p[1] * q[0];
  }
  return sum;
}

/// All orbits of a set of edges, given in both directions: on to the next edge clockwise.
std::vector<Cycle> orbits_of(const std::vector<Place>& place,
                             const std::set<std::pair<std::uint32_t, std::uint32_t>>& directed) {
  std::vector<Cycle> orbits;
  auto left = directed;
  while (!left.empty()) {
    Cycle& orbit = orbits.emplace_back();
    std::pair<std::uint32_t, std::uint32_t> h = *left.begin();
    while (left.erase(h) > 0) {
      orbit.push_back(h.first);
      const int back = eighth(place[h.second], place[h.first]);
      std::pair<int, std::uint32_t> first{9, 0};
      for (const auto& [u, v] : directed) {
        if (u != h.second) continue;
        first = std::min(first, {(back - eighth(place[u], place[v]) + 7) % 8 + 1, v});
      }
      h = {h.second, first.second};
    }
  }
  return orbits;
}

/// Exchanges the tails of two visits of one vertex: two cycles become one, or one becomes two.
void exchange_tails(std::vector<Cycle>& cycles, testing::Dice& dice) {
  std::map<std::uint32_t, std::vector<std::pair<std::size_t, std::size_t>>> visits;
  for (std::size_t c = 0; c < cycles.size(); ++c) {
    for (std::size_t i = 0; i < cycles[c].size(); ++i) visits[cycles[c][i]].emplace_back(c, i);
  }
  std::erase_if(visits, [](const auto& v) { return v.second.size() < 2; });
  if (visits.empty()) return;
  const auto& here = std::next(visits.begin(), dice.below(visits.size()))->second;
  const std::size_t k = dice.below(here.size() - 1);
  const auto [c, i] = here[k];
  const auto [d, j] = here[k + 1];
  const auto at = [](std::size_t n) { return static_cast<std::ptrdiff_t>(n); };
  Cycle first = cycles[c], second = cycles[d];
  std::rotate(first.begin(), first.begin() + at(i), first.end());
  if (c == d) {
    second.assign(first.begin() + at(j - i), first.end());
    first.resize(j - i);
    cycles.push_back(second);
  } else {
    std::rotate(second.begin(), second.begin() + at(j), second.end());
    first.insert(first.end(), second.begin(), second.end());
    cycles[d].clear();
  }
  cycles[c] = first;
  std::erase_if(cycles, [](const Cycle& one) { return one.empty(); });
}

struct Scene {
  Map map;
  std::vector<Place> place;
  MapEdges edges;
  MapComponents components;
  MapContacts contacts;
  MapOrbits orbits;

  /// Some of nested squares, some of the other edges of the grid.
  explicit Scene(testing::Dice& dice) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
    for (int i = 0; i < kSide * kSide; ++i) place.push_back({i / kSide, i % kSide});
    std::array<bool, kSide> has_square{};
    for (bool& one : has_square) one = dice.below(3) != 0;
    const auto depth = [](int x, int y) {
      return std::min(std::min(x, y), std::min(kSide - 1 - x, kSide - 1 - y));
    };
    const auto add = [&](int x, int y, int dx, int dy) {
      if (std::max(x + dx, y + dy) >= kSide) return;
      const int d = depth(x, y);
      const bool on_square = depth(x + dx, y + dy) == d && dx != dy;
      const bool chosen = on_square ? has_square[static_cast<std::size_t>(d)] : dice.below(14) == 0;
      if (!chosen) return;
      const auto u = static_cast<std::uint32_t>(x * kSide + y);
      const auto v = static_cast<std::uint32_t>((x + dx) * kSide + y + dy);
      directed.insert({{u, v}, {v, u}});
    };
    for (int x = 0; x < kSide; ++x) {
      for (int y = 0; y < kSide; ++y) {
        add(x, y, 1, 0);
        add(x, y, 0, 1);
        add(x, y, 1, 1);
      }
    }
    std::vector<Cycle> cycles = orbits_of(place, directed);
    for (std::uint32_t k = dice.below(4) * 3; k > 0; --k) exchange_tails(cycles, dice);
    if (dice.below(2) == 0) {
      std::erase_if(cycles, [&](const Cycle&) { return dice.below(4) == 0; });
    }
    for (const Place& p : place) {
      map.points.push_back(Point2{static_cast<double>(p[0]), static_cast<double>(p[1])});
    }
    for (const Cycle& c : cycles) map.add_cycle(c);
    edges = match_twins(map);
    components = connect(map, edges);
    contacts = find_contacts(map, edges, components, 1, unlimited_context());
    orbits = trace_orbits(map, edges, components, contacts.rotation);
  }

  std::vector<std::uint32_t> halfedges(std::uint32_t orbit) const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t h = 0; h < edges.halfedge_count(); ++h) {
      if (orbits.of_halfedge[h] == orbit) all.push_back(h);
    }
    return all;
  }
  int twice_area_of(std::uint32_t orbit) const {
    int sum = 0;
    for (const std::uint32_t h : halfedges(orbit)) {
      const std::array<std::uint32_t, 2> ends{edges.origin(h), edges.target(h)};
      const Place &p = place[ends[0]], &q = place[ends[1]];
      sum += p[0] * q[1] - p[1] * q[0];
    }
    return sum;
  }
  /// Whether p, on no edge of the orbit, lies inside: edges above p that span its x, halfway open.
  bool is_inside(std::uint32_t orbit, const Place& p) const {
    bool inside = false;
    for (const std::uint32_t h : halfedges(orbit)) {
      const Place a = std::min(place[edges.origin(h)], place[edges.target(h)]);
      const Place b = std::max(place[edges.origin(h)], place[edges.target(h)]);
      const int turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
      if (a[0] <= p[0] && p[0] < b[0] && turn < 0) inside = !inside;
    }
    return inside;
  }
};

/// Orbits are the cycles that a walk by angles finds, outsides run clockwise, one per component.
TEST(MapOrbits, AreThoseOfAnglesAndAreas) {
  testing::Dice dice(1);
  for (int round = 0; round < 60; ++round) {
    const Scene s(dice);
    std::set<std::pair<std::uint32_t, std::uint32_t>> directed;
    for (const SweepSegment& e : s.edges.ends) directed.insert({{e.from, e.to}, {e.to, e.from}});
    const std::vector<Cycle> expected = orbits_of(s.place, directed);
    ASSERT_EQ(s.orbits.orbits.size(), expected.size());
    std::set<std::uint32_t> found;
    for (const Cycle& cycle : expected) {
      std::set<std::uint32_t> ids;
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        const std::uint32_t u = cycle[i], v = cycle[(i + 1) % cycle.size()];
        const auto e = static_cast<std::uint32_t>(s.edges.find(u, v));
        ids.insert(s.orbits.of_halfedge[2 * e + (u < v ? 0 : 1)]);
      }
      ASSERT_EQ(ids.size(), 1U);
      EXPECT_TRUE(found.insert(*ids.begin()).second);
      const MapOrbits::Orbit& orbit = s.orbits.orbits[*ids.begin()];
      EXPECT_EQ(orbit.counterclockwise, twice_area(s.place, cycle) > 0);
      EXPECT_EQ(s.edges.origin(orbit.halfedge), *std::ranges::min_element(cycle));
      EXPECT_EQ(s.orbits.of_halfedge[orbit.halfedge], *ids.begin());
      if (orbit.counterclockwise) continue;
      EXPECT_EQ(s.orbits.outside[s.components.of_vertex[cycle.front()]], *ids.begin());
    }
    EXPECT_EQ(std::ranges::count_if(s.orbits.orbits, [](auto& o) { return !o.counterclockwise; }),
              static_cast<std::ptrdiff_t>(s.components.count));
  }
}

TEST(MapOrbits, AreMixedAsDefined) {
  testing::Dice dice(2);
  int mixed = 0;
  for (int round = 0; round < 200; ++round) {
    const Scene s(dice);
    for (std::uint32_t o = 0; o < s.orbits.orbits.size(); ++o) {
      std::set<std::uint32_t> cycles;
      bool is_complete = true;
      for (const std::uint32_t h : s.halfedges(o)) {
        if (s.edges.cycle_of[h] != kNoCycle) cycles.insert(s.edges.cycle_of[h]);
        is_complete = is_complete && s.edges.cycle_of[h] != kNoCycle;
      }
      const MapOrbits::Orbit& orbit = s.orbits.orbits[o];
      const auto area = [&](std::uint32_t c) { return twice_area(s.place, s.map.cycle(c)); };
      bool expected = false;
      if (s.twice_area_of(o) > 0) {
        expected = cycles.size() > 1 || (cycles.size() == 1 && area(*cycles.begin()) <= 0);
      } else if (cycles.size() == 1) {
        expected = area(*cycles.begin()) > 0;
      } else {
        expected = std::ranges::any_of(cycles, [&](std::uint32_t c) { return area(c) >= 0; });
      }
      EXPECT_EQ(orbit.mixed, expected);
      EXPECT_EQ(orbit.complete, is_complete);
      EXPECT_EQ(orbit.cycle, cycles.empty() ? kNoCycle : *cycles.begin());
      EXPECT_EQ(cycles_of_orbit(s.edges, s.contacts.rotation, orbit.halfedge),
                Cycle(cycles.begin(), cycles.end()));
      mixed += expected ? 1 : 0;
    }
  }
  EXPECT_GT(mixed, 50);
}

TEST(MapOrbits, ComponentsLieInTheLeastOrbitAroundThem) {
  testing::Dice dice(3);
  int nested = 0;
  for (int round = 0; round < 200; ++round) {
    const Scene s(dice);
    const std::vector<std::uint32_t> parent =
        nest_components(s.edges, s.components, s.contacts.rotation, s.orbits);
    ASSERT_EQ(parent.size(), s.components.count);
    for (std::uint32_t c = 0; c < parent.size(); ++c) {
      const std::uint32_t h = s.orbits.orbits[s.orbits.outside[c]].halfedge;
      std::optional<std::pair<int, std::uint32_t>> least;
      for (std::uint32_t o = 0; o < s.orbits.orbits.size(); ++o) {
        const std::uint32_t any = s.edges.origin(s.orbits.orbits[o].halfedge);
        const int area = s.twice_area_of(o);
        if (area <= 0 || s.components.of_vertex[any] == c) continue;
        if (!s.is_inside(o, s.place[s.edges.origin(h)])) continue;
        if (!least || area < least->first) least = {area, o};
      }
      EXPECT_EQ(parent[c], least ? least->second : 0xffffffffU);
      nested += least ? 1 : 0;
    }
  }
  EXPECT_GT(nested, 50);
}

TEST(MapOrbits, PinchAtVerticesTheyPassTwice) {
  testing::Dice dice(4);
  for (int round = 0; round < 60; ++round) {
    const Scene s(dice);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;  // of a vertex by an orbit
    for (std::uint32_t h = 0; h < s.edges.halfedge_count(); ++h) {
      ++passes[{s.edges.origin(h), s.orbits.of_halfedge[h]}];
    }
    std::set<std::uint32_t> expected;
    for (const auto& [at, count] : passes) {
      if (count > 1) expected.insert(at.first);
    }
    EXPECT_EQ(find_pinches(s.map, s.edges, s.orbits), Cycle(expected.begin(), expected.end()));
  }
}

}  // namespace plumb::map_orbits_test
