// Twins, components and borders of listed maps, against dictionaries over all corners of random
// listings: cycles repeat edges, run back on themselves and touch each other in vertices.
#include "plumb/plane/check/map_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::map_edges_test {

using Cycle = std::vector<std::uint32_t>;

Map listing(const std::vector<std::array<int, 2>>& points, const std::vector<Cycle>& cycles) {
  Map map;
  for (const auto& [x, y] : points) {
    map.points.push_back(Point2{static_cast<double>(x), static_cast<double>(y)});
  }
  for (const Cycle& c : cycles) map.add_cycle(c);
  return map;
}

/// Closed walks over `vertices` vertices, no vertex twice in a row.
std::vector<Cycle> random_walks(testing::Dice& dice, std::uint32_t vertices) {
  std::vector<Cycle> cycles(1 + dice.below(4));
  for (Cycle& c : cycles) {
    const std::size_t length = 3 + dice.below(4);
    while (c.size() < length || c.front() == c.back()) {
      const std::uint32_t v = dice.below(vertices);
      if (c.empty() || c.back() != v) c.push_back(v);
    }
  }
  return cycles;
}

TEST(MapEdges, TwinsAndUsesAreThoseOfADictionary) {
  testing::Dice dice(1);
  for (int round = 0; round < 400; ++round) {
    const std::uint32_t n = 4 + dice.below(4);
    const Map map = listing(std::vector<std::array<int, 2>>(n), random_walks(dice, n));
    std::map<std::pair<std::uint32_t, std::uint32_t>, Cycle> users;  // of a directed edge
    std::set<std::pair<std::uint32_t, std::uint32_t>> undirected;
    const MapEdges edges = match_twins(map);
    for (std::uint32_t c = 0; c < map.cycle_count(); ++c) {
      const auto cycle = map.cycle(c);
      for (std::uint32_t i = 0; i < cycle.size(); ++i) {
        const std::uint32_t u = cycle[i], v = cycle[(i + 1) % cycle.size()];
        users[{u, v}].push_back(c);
        undirected.insert(std::minmax(u, v));
        const std::uint32_t h = edges.at_corner[map.cycle_begin[c] + i];
        EXPECT_EQ(std::pair(edges.origin(h), edges.target(h)), std::pair(u, v));
      }
    }
    ASSERT_EQ(edges.edge_count(), undirected.size());
    ASSERT_EQ(edges.halfedge_count(), 2 * undirected.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> extra;
    std::uint32_t e = 0;
    for (const auto& [u, v] : undirected) {  // in order
      EXPECT_EQ(std::pair(edges.ends[e].from, edges.ends[e].to), std::pair(u, v));
      EXPECT_EQ(edges.find(u, v), e);
      EXPECT_EQ(edges.find(v, u), e);
      Cycle forward = users[{u, v}], backward = users[{v, u}], both;
      for (const Cycle* one : {&forward, &backward}) {
        const std::uint32_t h = 2 * e + (one == &forward ? 0 : 1);
        EXPECT_EQ(edges.uses(h), *one);
        for (std::size_t i = 1; i < one->size(); ++i) extra.emplace_back(h, (*one)[i]);
        const Cycle& other = one == &forward ? backward : forward;
        EXPECT_EQ(edges.is_open(h), !one->empty() && other.empty());
      }
      std::ranges::set_intersection(forward, backward, std::back_inserter(both));
      EXPECT_EQ(edges.cycle_on_both_sides(e), both.empty() ? MapEdges::kNoCycle : both.front());
      ++e;
    }
    ASSERT_EQ(edges.extra_uses.size(), extra.size());
    for (std::size_t i = 0; i < extra.size(); ++i) {
      EXPECT_EQ(std::pair(edges.extra_uses[i].halfedge, edges.extra_uses[i].cycle), extra[i]);
    }
    for (std::uint32_t u = 0; u < n; ++u) {
      for (std::uint32_t v = u + 1; v < n; ++v) {
        EXPECT_EQ(edges.find(u, v) == edges.edge_count(), !undirected.contains({u, v}));
      }
    }
  }
}

TEST(MapEdges, ComponentsAreFloodedParts) {
  testing::Dice dice(2);
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t n = 20;
    const Map map = listing(std::vector<std::array<int, 2>>(n), random_walks(dice, n));
    const MapEdges edges = match_twins(map);
    const MapComponents components = connect(map, edges);
    std::vector<std::uint32_t> flooded(n, MapComponents::kNoComponent);
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < n; ++v) {  // numbered by least vertex
      const bool is_used = std::ranges::count(map.corners, v) > 0;
      if (!is_used || flooded[v] != MapComponents::kNoComponent) continue;
      flooded[v] = count;
      for (bool grows = true; grows;) {
        grows = false;
        for (const SweepSegment& e : edges.ends) {
          if ((flooded[e.from] == count) == (flooded[e.to] == count)) continue;
          flooded[e.from] = flooded[e.to] = count;
          grows = true;
        }
      }
      ++count;
    }
    EXPECT_EQ(components.of_vertex, flooded);
    EXPECT_EQ(components.count, count);
  }
}

/// All cycles that hang together with `start` by listed edges at vertex v.
std::set<std::uint32_t> fan_of(const MapEdges& edges, std::uint32_t v, std::uint32_t start) {
  std::set<std::uint32_t> fan{start};
  for (std::size_t before = 0; before != fan.size();) {
    before = fan.size();
    for (std::uint32_t e = 0; e < edges.edge_count(); ++e) {
      const std::uint32_t left = edges.cycle_of[2 * e], right = edges.cycle_of[2 * e + 1];
      const bool is_here = edges.ends[e].from == v || edges.ends[e].to == v;
      if (!is_here || left == MapEdges::kNoCycle || right == MapEdges::kNoCycle) continue;
      if (fan.contains(left) || fan.contains(right)) fan.insert({left, right});
    }
  }
  return fan;
}

/// A random half of the triangles of a grid: gaps, islands, and vertices where borders meet.
TEST(MapEdges, BordersAreClosedAndStayWithTheirFaces) {
  testing::Dice dice(3);
  for (int round = 0; round < 100; ++round) {
    std::vector<std::array<int, 2>> points;
    for (int i = 0; i < 16; ++i) points.push_back({i % 4, i / 4});
    std::vector<Cycle> cycles;
    for (std::uint32_t i = 0; i < 12; ++i) {
      if (i % 4 == 3) continue;
      if (dice.below(2) == 0) cycles.push_back({i, i + 1, i + 5});
      if (dice.below(2) == 0) cycles.push_back({i, i + 5, i + 4});
    }
    const Map map = listing(points, cycles);
    const MapEdges edges = match_twins(map);
    std::set<std::uint32_t> met;
    std::uint32_t least_before = 0;
    for (const OpenChain& chain : trace_open_chains(map, edges)) {
      const Cycle& half = chain.halfedges;
      EXPECT_EQ(half.front(), *std::ranges::min_element(half));
      EXPECT_TRUE(met.empty() || least_before < half.front());
      least_before = half.front();
      const Cycle corners = cycle_of_chain(edges, chain);
      ASSERT_EQ(corners.size(), half.size());
      int area = 0;
      for (std::size_t i = 0; i < half.size(); ++i) {
        const std::uint32_t h = half[i], next = half[(i + 1) % half.size()];
        EXPECT_TRUE(edges.is_open(h ^ 1U));
        EXPECT_TRUE(met.insert(h).second);
        EXPECT_EQ(corners[i], edges.origin(h));
        EXPECT_EQ(edges.target(h), edges.origin(next));
        EXPECT_TRUE(fan_of(edges, edges.target(h), edges.cycle_of[h ^ 1U])
                        .contains(edges.cycle_of[next ^ 1U]));
        const auto& p = points[edges.origin(h)];
        const auto& q = points[edges.target(h)];
        area += p[0] * q[1] - p[1] * q[0];
      }
      EXPECT_EQ(chain.area, sign_of(area));
    }
    for (std::uint32_t h = 0; h < edges.halfedge_count(); ++h) {
      EXPECT_EQ(met.contains(h), edges.is_open(h ^ 1U));
    }
  }
}

/// A face that knows one edge a-b and a neighbour that knows it as a-m-b, in a map that is closed
/// otherwise: the border has no area. A bow tie without its outside has two borders.
TEST(MapEdges, BordersOfSlitsAndBowTies) {
  const Map slit =
      listing({{0, 0}, {4, 0}, {2, 3}, {2, -3}, {2, 0}}, {{0, 1, 2}, {3, 1, 4, 0}, {0, 2, 1, 3}});
  const std::vector<OpenChain> chains = trace_open_chains(slit, match_twins(slit));
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].halfedges.size(), 3U);
  EXPECT_EQ(chains[0].area, Sign::Zero);
  const Map bow = listing({{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, {{0, 1, 2}, {0, 3, 4}});
  const std::vector<OpenChain> outsides = trace_open_chains(bow, match_twins(bow));
  ASSERT_EQ(outsides.size(), 2U);
  for (const OpenChain& outside : outsides) {
    EXPECT_EQ(outside.halfedges.size(), 3U);
    EXPECT_EQ(outside.area, Sign::Negative);
  }
}

}  // namespace plumb::map_edges_test
