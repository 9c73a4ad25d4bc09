// Checks the places where two maps meet against locating them and against all pairs of arcs, by
// tables as well as by bounds, and what large overlays are charged for.
#include "plumb/sphere/overlay/sphere_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "generate/sphere_program.h"
#include "generate/test_share.h"
#include "plumb/predicates/error.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb::sphere_contacts_test {

using testing::Dice;

/// Two maps over one table of planes.
struct TwoMaps {
  PlaneTable planes;
  SphereMap a;
  SphereMap b;

  TwoMaps(const NefSphere& first, const NefSphere& second)
      : planes(first.planes()), a(first.map()), b(second.map()) {
    const std::vector<PlaneId> to = planes.merge(second.planes());
    for (PlaneId& c : b.circle) c = to[c.value()];
    for (SphereDirection& u : b.direction) u = {to[u.p.value()], to[u.q.value()]};
  }
  const SphereMap& map(std::size_t k) const { return k == 0 ? a : b; }
};

/// The first two sets of a random program; two empty ones if it leaves fewer.
std::vector<NefSphere> any_two(std::uint64_t seed) {
  Dice dice(seed);
  const auto values = static_cast<testing::SphereValues>(seed % testing::kSphereValues);
  std::vector<NefSphere> sets =
      testing::sets_on_sphere(testing::random_sphere_program(dice, values, 10), 12);
  sets.resize(2);
  return sets;
}

/// The number of different directions at which the maps have a point or cross.
std::size_t count_contacts(const TwoMaps& maps) {
  const PlaneTable& planes = maps.planes;
  std::size_t count = maps.a.point_count() + maps.b.point_count();
  for (const SphereDirection u : maps.a.direction) {
    for (const SphereDirection v : maps.b.direction) {
      if (is_same(planes, u, v)) --count;
    }
  }
  for (std::uint32_t i = 0; i < maps.a.arc_count(); ++i) {
    for (std::uint32_t j = 0; j < maps.b.arc_count(); ++j) {
      if (maps.a.circle[i] == maps.b.circle[j]) continue;
      const SphereDirection u{maps.a.circle[i], maps.b.circle[j]};
      for (const SphereDirection w : {u, u.opposite()}) {
        if (is_on_arc(planes, maps.a, i, w) && is_on_arc(planes, maps.b, j, w)) ++count;
      }
    }
  }
  return count;
}

void expect_contacts(const TwoMaps& maps, const SphereContacts& found) {
  ASSERT_EQ(found.direction.size(), found.cell.size());
  EXPECT_EQ(found.direction.size(), count_contacts(maps));
  for (std::size_t k = 0; k < 2; ++k) {
    const SphereMap& map = maps.map(k);
    std::size_t on_arcs = 0;
    for (std::size_t i = 0; i < found.direction.size(); ++i) {
      const SphereCell at = locate(maps.planes, map, found.direction[i]);
      const SphereCell cell = found.cell[i][k];
      if (at.kind() == SphereCell::Kind::Face) {
        EXPECT_FALSE(cell.is_valid());
      } else {
        EXPECT_EQ(cell, at);
      }
      if (at.kind() == SphereCell::Kind::Arc) ++on_arcs;
    }
    ASSERT_EQ(found.point_of[k].size(), map.point_count());
    for (std::uint32_t v = 0; v < map.point_count(); ++v) {
      EXPECT_EQ(found.cell[found.point_of[k][v]][k], SphereCell::point(v));
    }
    EXPECT_EQ(found.stops[k].size(), on_arcs);
    std::set<std::uint32_t> stopped;
    for (const SphereContacts::Stop& stop : found.stops[k]) {
      EXPECT_TRUE(stopped.insert(stop.point).second);
      EXPECT_EQ(found.cell[stop.point][k], SphereCell::arc(stop.arc));
      EXPECT_TRUE(is_same(maps.planes, direction_of(map.circle[stop.arc], stop.place),
                          found.direction[stop.point]));
    }
  }
}

TEST(SphereContacts, AreThePlacesWhereMapsMeet) {
  std::size_t most = 0;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<NefSphere> sets = any_two(seed);
    const TwoMaps maps(sets[0], sets[1]);
    SphereContacts found;
    found.find(maps.planes, maps.a, maps.b);
    expect_contacts(maps, found);
    most = std::max(most, found.direction.size());
  }
  EXPECT_GT(most, 8U);
}

/// Loops have no ends, and arcs of one circle meet at their ends alone.
TEST(SphereContacts, OfLoopsAndOfArcsOfOneCircle) {
  const SphereVector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), between(1, 1, 0), minus(-1, 1, 0);
  const std::pair<NefSphere, NefSphere> cases[] = {
      {NefSphere::circle(x), NefSphere::circle(y)},
      {NefSphere::circle(z), NefSphere::circle(z)},
      {NefSphere::circle(z), NefSphere::arc(x, y)},
      {NefSphere::arc(x, y), NefSphere::arc(between, minus)},
      {NefSphere::arc(x, y), NefSphere::arc(y, x, z)},
      {NefSphere::arc(x, y), NefSphere::arc(x, y)},
      {NefSphere::arc(x, y), NefSphere::point(between)},
      {NefSphere::point(x), NefSphere::point(x)},
      {NefSphere::arc(x, y), NefSphere::arc(between, z)},
  };
  const std::array<std::size_t, std::size(cases)> counts{2, 0, 2, 4, 2, 2, 3, 1, 4};
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    SCOPED_TRACE(i);
    for (const bool is_swapped : {false, true}) {
      const TwoMaps maps(is_swapped ? cases[i].second : cases[i].first,
                         is_swapped ? cases[i].first : cases[i].second);
      for (const std::size_t most_tabled : {std::size_t{0}, SphereContacts::kMostTabled}) {
        SphereContacts found;
        found.find(maps.planes, maps.a, maps.b, most_tabled);
        EXPECT_EQ(found.direction.size(), counts[i]);
        EXPECT_EQ(found.shares_circles, i >= 1 && i <= 5);
        expect_contacts(maps, found);
      }
    }
  }
}

TEST(SphereContacts, AreTheSameByTablesAndByBoxes) {
  for (std::uint64_t seed = 0; seed < testing::share_of(300) && !::testing::Test::HasFailure();
       ++seed) {
    const std::vector<NefSphere> sets = any_two(seed);
    const TwoMaps maps(sets[0], sets[1]);
    SphereContacts by_tables;
    SphereContacts by_boxes;
    by_tables.find(maps.planes, maps.a, maps.b);
    by_boxes.find(maps.planes, maps.a, maps.b, 0);
    EXPECT_TRUE(by_tables.direction == by_boxes.direction) << seed;
    EXPECT_TRUE(by_tables.cell == by_boxes.cell) << seed;
    EXPECT_TRUE(by_tables.point_of == by_boxes.point_of) << seed;
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_EQ(by_tables.stops[k].size(), by_boxes.stops[k].size()) << seed;
      for (std::size_t i = 0; i < by_tables.stops[k].size(); ++i) {
        EXPECT_EQ(by_tables.stops[k][i].arc, by_boxes.stops[k][i].arc);
        EXPECT_EQ(by_tables.stops[k][i].point, by_boxes.stops[k][i].point);
      }
    }
  }
}

/// Only growth is charged, and all of it is released with the limits.
TEST(SphereContacts, LimitsChargeWhatHasGrownUntilTheyEnd) {
  Limits limits;
  limits.max_memory_bytes = 1200 * 100;
  Context context(limits);
  const auto is_refused = [](SphereLimits& some, std::uint64_t crossings) {
    try {
      some.look(0, crossings);
    } catch (const Error& e) {
      return e.code() == ErrorCode::ResourceLimit;
    }
    return false;
  };
  for (int round = 0; round < 2; ++round) {
    SphereLimits charged(context);
    EXPECT_FALSE(is_refused(charged, 60));
    EXPECT_FALSE(is_refused(charged, 10));
    EXPECT_FALSE(is_refused(charged, 100));
    EXPECT_TRUE(is_refused(charged, 101));
    SphereLimits beside(context);
    EXPECT_TRUE(is_refused(beside, 1));
    look(nullptr);
  }
}

}  // namespace plumb::sphere_contacts_test
