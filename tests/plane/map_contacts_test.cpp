// Contacts of edges against all pairs in integers, on so small a grid that overlaps, vertices of
// equal coordinates and edges without length are the rule; the rotation system against sorting by
// angle.
#include "plumb/plane/check/map_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::map_contacts_test {

using Place = std::array<int, 2>;  // compared by x, then y
using Pair = std::pair<std::uint32_t, std::uint32_t>;

int turn(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

struct Scene {
  Map map;
  MapEdges edges;
  std::vector<Place> place;

  Scene(std::vector<Place> places, const std::set<Pair>& pairs) : place(std::move(places)) {
    for (const auto& [x, y] : place) {
      map.points.push_back(Point2{static_cast<double>(x), static_cast<double>(y)});
    }
    for (const auto& [u, v] : pairs) edges.ends.push_back({u, v});
    edges.cycle_of.assign(2 * pairs.size(), MapEdges::kNoCycle);
  }
  Place left(std::uint32_t e) const {
    return std::min(place[edges.ends[e].from], place[edges.ends[e].to]);
  }
  Place right(std::uint32_t e) const {
    return std::max(place[edges.ends[e].from], place[edges.ends[e].to]);
  }
  bool contains(std::uint32_t e, const Place& p) const {
    return turn(left(e), right(e), p) == 0 && left(e) <= p && p <= right(e);
  }
  bool has_end(std::uint32_t e, const Place& p) const { return left(e) == p || right(e) == p; }
  bool share_vertex(std::uint32_t e, std::uint32_t f) const {
    const SweepSegment &p = edges.ends[e], &q = edges.ends[f];
    return p.from == q.from || p.from == q.to || p.to == q.from || p.to == q.to;
  }
  MapContacts contacts(std::uint64_t max_described = 1000000) const {
    return find_contacts(map, edges, connect(map, edges), max_described, unlimited_context());
  }

  struct Meeting {
    EdgeContact::Kind kind;
    RationalPoint2 point;  ///< the least common one
  };
  std::optional<Meeting> meeting(std::uint32_t e, std::uint32_t f) const {
    std::set<Place> common;
    for (const Place& p : {left(e), right(e), left(f), right(f)}) {
      if (contains(e, p) && contains(f, p)) common.insert(p);
    }
    using Kind = EdgeContact::Kind;
    if (common.empty()) {
      const int a = turn(left(e), right(e), left(f)), b = turn(left(e), right(e), right(f));
      const int c = turn(left(f), right(f), left(e)), d = turn(left(f), right(f), right(e));
      if (a * b >= 0 || c * d >= 0) return std::nullopt;
      const Rational t = Rational(a) / (a - b);
      const auto along = [&](std::size_t k) { return left(f)[k] + t * (right(f)[k] - left(f)[k]); };
      return Meeting{Kind::Cross, {along(0), along(1)}};
    }
    if (common.size() == 1 && share_vertex(e, f)) return std::nullopt;
    const Place p = *common.begin();
    const bool both = has_end(e, p) && has_end(f, p);
    const Kind kind = common.size() > 1 ? Kind::Overlap : (both ? Kind::Alias : Kind::Touch);
    return Meeting{kind, {p[0], p[1]}};
  }
};

Scene random_scene(testing::Dice& dice) {
  std::vector<Place> places(4 + dice.below(6));
  const std::int64_t range = dice.between(2, 5);
  for (Place& p : places) {
    p = {static_cast<int>(dice.between(0, range)), static_cast<int>(dice.between(0, range))};
  }
  std::set<Pair> pairs;
  for (int i = 0; i < 10; ++i) {
    const std::uint32_t u = dice.below(places.size()), v = dice.below(places.size());
    if (u != v) pairs.insert(std::minmax(u, v));
  }
  return {places, pairs};
}

TEST(MapContacts, AreThoseOfAllPairs) {
  testing::Dice dice(1);
  for (int round = 0; round < 1000; ++round) {
    const Scene scene = random_scene(dice);
    const MapContacts found = scene.contacts();
    std::vector<Pair> expected, described;
    for (std::uint32_t e = 0; e < scene.edges.edge_count(); ++e) {
      for (std::uint32_t f = e + 1; f < scene.edges.edge_count(); ++f) {
        if (scene.meeting(e, f)) expected.emplace_back(e, f);
      }
    }
    EXPECT_EQ(found.count, expected.size());
    for (const EdgeContact& contact : found.described) {
      described.emplace_back(contact.edge_a, contact.edge_b);
      const auto meeting = scene.meeting(contact.edge_a, contact.edge_b);
      ASSERT_TRUE(meeting.has_value());
      EXPECT_EQ(contact.kind, meeting->kind);
      const RationalPoint2 at = contact.crossing ? exact(scene.map.points, *contact.crossing)
                                                 : scene.map.points.exact(contact.vertex);
      EXPECT_EQ(at, meeting->point);
      if (contact.kind == EdgeContact::Kind::Cross) continue;
      EXPECT_TRUE(scene.has_end(contact.edge_a, scene.place[contact.vertex]) ||
                  scene.has_end(contact.edge_b, scene.place[contact.vertex]));
    }
    EXPECT_EQ(described, expected);
  }
}

/// Those where a contact begins: a vertex where an overlap just ends is not among them.
TEST(MapContacts, ListVerticesInsideEdgesInOrder) {
  testing::Dice dice(2);
  for (int round = 0; round < 500; ++round) {
    const Scene scene = random_scene(dice);
    std::set<std::uint32_t> used;
    for (const SweepSegment& e : scene.edges.ends) used.insert({e.from, e.to});
    std::vector<RationalPoint2> begins;  // of contacts
    for (std::uint32_t e = 0; e < scene.edges.edge_count(); ++e) {
      for (std::uint32_t f = e + 1; f < scene.edges.edge_count(); ++f) {
        if (const auto meeting = scene.meeting(e, f)) begins.push_back(meeting->point);
      }
    }
    std::set<Pair> expected, found;
    for (std::uint32_t e = 0; e < scene.edges.edge_count(); ++e) {
      for (const std::uint32_t v : used) {
        const Place& p = scene.place[v];
        if (!scene.contains(e, p) || scene.has_end(e, p)) continue;
        if (std::ranges::count(begins, RationalPoint2{p[0], p[1]}) > 0) expected.insert({e, v});
      }
    }
    std::pair<std::uint32_t, Place> before{0, {-1, -1}};
    for (const VertexOnEdge& on : scene.contacts().on_edge) {
      const std::pair now(on.edge, scene.place[on.vertex]);
      EXPECT_LE(before, now);
      before = now;
      EXPECT_TRUE(found.insert({on.edge, on.vertex}).second);
    }
    EXPECT_EQ(found, expected);
  }
}

TEST(MapContacts, AreCountedBeyondTheLimitOfThoseDescribed) {
  testing::Dice dice(3);
  for (int round = 0; round < 50; ++round) {
    const Scene scene = random_scene(dice);
    const std::uint64_t all = scene.contacts().count;
    for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{1}, all / 2}) {
      const MapContacts found = scene.contacts(limit);
      EXPECT_EQ(found.count, all);
      EXPECT_EQ(found.described.size(), std::min(limit, all));
      EXPECT_LE(found.on_edge.size(), limit);
    }
  }
}

/// 0 to 7, counter-clockwise from the right, of edges between neighbours of a grid.
int eighth(const Place& from, const Place& to) {
  constexpr std::array<std::array<int, 3>, 3> kEighths = {{{5, 4, 3}, {6, -1, 2}, {7, 0, 1}}};
  return kEighths[static_cast<std::size_t>(to[0] - from[0] + 1)]
                 [static_cast<std::size_t>(to[1] - from[1] + 1)];
}

/// Random edges between neighbours of a grid, vertices numbered at random: nothing meets but at
/// common vertices, and parts lie above each other.
TEST(MapContacts, RotationIsThatOfAngles) {
  testing::Dice dice(4);
  for (int round = 0; round < 200; ++round) {
    const int side = 5;
    std::vector<std::uint32_t> name(side * side);
    std::iota(name.begin(), name.end(), 0U);
    for (std::size_t i = 1; i < name.size(); ++i) std::swap(name[i], name[dice.below(i + 1)]);
    const auto at = [&](int x, int y) { return name[static_cast<std::size_t>(x * side + y)]; };
    std::vector<Place> places(name.size());
    std::set<Pair> pairs;
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        places[at(x, y)] = {x, y};
        const bool has_right = x + 1 < side, has_up = y + 1 < side;
        if (has_right && dice.below(3) == 0) pairs.insert(std::minmax(at(x, y), at(x + 1, y)));
        if (has_up && dice.below(3) == 0) pairs.insert(std::minmax(at(x, y), at(x, y + 1)));
        if (!has_right || !has_up) continue;
        const std::uint32_t kind = dice.below(6);
        if (kind == 0) pairs.insert(std::minmax(at(x, y), at(x + 1, y + 1)));
        if (kind == 1) pairs.insert(std::minmax(at(x, y + 1), at(x + 1, y)));
      }
    }
    const Scene scene(places, pairs);
    const MapContacts found = scene.contacts();
    ASSERT_EQ(found.count, 0U);
    const MapEdges& edges = scene.edges;
    for (std::uint32_t h = 0; h < edges.halfedge_count(); ++h) {
      const std::uint32_t v = edges.target(h);
      const int back = eighth(places[v], places[edges.origin(h)]);
      std::pair<int, std::uint32_t> first{9, 0};  // clockwise from where h comes from
      for (std::uint32_t g = 0; g < edges.halfedge_count(); ++g) {
        if (edges.origin(g) != v) continue;
        const int by = (back - eighth(places[v], places[edges.target(g)]) + 7) % 8 + 1;
        first = std::min(first, {by, g});
      }
      EXPECT_EQ(found.rotation.orbit_next[h], first.second);
    }
    std::map<Place, std::uint32_t> used;
    for (const SweepSegment& e : edges.ends) {
      used[places[e.from]] = e.from;
      used[places[e.to]] = e.to;
    }
    const MapComponents components = connect(scene.map, edges);
    std::vector<bool> is_placed(components.count);
    std::uint32_t order = 0;
    for (const auto& [p, v] : used) {  // by x, then y
      EXPECT_EQ(found.rotation.order[v], order++);
      const std::uint32_t component = components.of_vertex[v];
      if (is_placed[component]) continue;
      is_placed[component] = true;
      std::optional<std::pair<std::array<Rational, 2>, std::uint32_t>> highest;
      for (std::uint32_t e = 0; e < edges.edge_count(); ++e) {
        const Place l = scene.left(e), r = scene.right(e);
        if (!(l < p && p < r) || turn(l, r, p) <= 0) continue;
        const Rational slope = Rational(r[1] - l[1]) / (r[0] - l[0]);
        const std::pair one(std::array<Rational, 2>{l[1] + slope * (p[0] - l[0]), slope}, e);
        if (!highest || *highest < one) highest = one;
      }
      EXPECT_EQ(found.rotation.edge_below[component], highest ? highest->second : 0xffffffffU);
    }
  }
}

}  // namespace plumb::map_contacts_test
