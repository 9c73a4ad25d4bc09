// Checks that bounds of points and arcs hold what they bound, and that the tree over them visits
// every pair with a common direction; the oracle are exact sides of integer vectors.
#include "plumb/sphere/arcs/sphere_bounds.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "plumb/sphere/set/sphere_vectors.h"
#include "plumb/testing/dice.h"

namespace plumb::sphere_bounds_test {

using testing::Dice;
using Vector = std::array<std::int64_t, 3>;

std::int64_t dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
constexpr Vector kZero{0, 0, 0};

std::array<double, 3> in_doubles(const Vector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
SphereVector exact(const Vector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// Whether the unit vector of v lies in the ball, up to roundings of the test.
bool holds(const UnitBall& ball, const Vector& v) {
  const double length = std::sqrt(static_cast<double>(dot(v, v)));
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double off = static_cast<double>(v[i]) / length - ball.middle[i];
    square += off * off;
  }
  return std::sqrt(square) <= ball.radius + 1e-12;
}

Vector any_vector(Dice& dice, std::int64_t reach) {
  Vector v = kZero;
  while (v == kZero) {
    for (std::int64_t& x : v) x = dice.between(-reach, reach);
  }
  return v;
}

/// Shorter arcs between directions, each with two points of its own; not a valid map otherwise.
struct Arcs {
  PlaneTable planes;
  SphereMap map;
  std::vector<std::array<Vector, 2>> ends;

  /// The longer arc if `is_long`.
  void add(const Vector& u, const Vector& v, bool is_long = false) {
    const OrientedPlane plane = intern_circle(planes, exact(cross(u, v)));
    const auto p = static_cast<std::uint32_t>(map.point_count());
    map.direction.push_back(intern_direction(planes, exact(u)));
    map.direction.push_back(intern_direction(planes, exact(v)));
    map.circle.push_back(plane.plane());
    const bool turned = plane.is_opposite() != is_long;
    map.origin.push_back(turned ? p + 1 : p);
    map.origin.push_back(turned ? p : p + 1);
    ends.push_back({u, v});
  }
};

bool is_on_short_arc(const std::array<Vector, 2>& ends, const Vector& w) {
  const Vector n = cross(ends[0], ends[1]);
  return dot(n, w) == 0 && dot(cross(ends[0], w), n) >= 0 && dot(cross(w, ends[1]), n) >= 0;
}

bool have_common_direction(const std::array<Vector, 2>& a, const std::array<Vector, 2>& b) {
  Vector w = cross(cross(a[0], a[1]), cross(b[0], b[1]));
  for (int sides = 0; sides < 2; ++sides) {
    if (w != kZero && is_on_short_arc(a, w) && is_on_short_arc(b, w)) return true;
    for (std::int64_t& x : w) x = -x;
  }
  for (const std::size_t i : {0U, 1U}) {
    if (is_on_short_arc(a, b[i]) || is_on_short_arc(b, a[i])) return true;
  }
  return false;
}

bool is_same_direction(const Vector& u, const Vector& v) {
  return cross(u, v) == kZero && dot(u, v) > 0;
}

TEST(SphereBounds, ABallHoldsWhatAVectorMayMean) {
  EXPECT_EQ(unit_ball({0, 0, 0}, 0).radius, 1);
  EXPECT_EQ(unit_ball({1, 1, 1}, 1).radius, 1);
  Dice dice(1);
  for (int round = 0; round < 2000; ++round) {
    const Vector meant = any_vector(dice, 100);
    Vector given = meant;
    for (std::int64_t& x : given) x += dice.between(-1, 1);
    const UnitBall ball = unit_ball(in_doubles(given), 1.7320508075688774);
    EXPECT_TRUE(holds(ball, meant)) << meant[0] << ' ' << meant[1] << ' ' << meant[2];
    EXPECT_LE(unit_ball(in_doubles(meant), 0).radius, 1e-13);
  }
}

TEST(SphereBounds, AWayTurnsCounterClockwiseAboutItsNormal) {
  Dice dice(2);
  for (int round = 0; round < 200; ++round) {
    const Vector start = any_vector(dice, 9);
    const Vector normal = cross(start, any_vector(dice, 9));
    if (normal == kZero) continue;
    const UnitWay way{unit_ball(in_doubles(normal), 0), unit_ball(in_doubles(start), 0)};
    ASSERT_TRUE(way.is_sharp());
    EXPECT_TRUE(holds(way.at(0), start));
    EXPECT_TRUE(holds(way.at(std::numbers::pi / 2), cross(normal, start)));
    for (const double angle : {-3.0, -1.0, 0.0, 0.5, 2.0}) {
      const UnitBall there = way.at(angle);
      EXPECT_NEAR(way.angle_of(there), angle, way.slack(there));
    }
  }
}

TEST(SphereBounds, PointsComeFirstAndLongArcsCountAsCircles) {
  Dice dice(3);
  Arcs arcs;
  std::vector<bool> is_long;
  while (is_long.size() < 40) {
    const Vector u = any_vector(dice, 5);
    const Vector v = any_vector(dice, 5);
    if (cross(u, v) == kZero) continue;
    is_long.push_back(dice.below(2) == 0);
    arcs.add(u, v, is_long.back());
  }
  const std::vector<SphereBound> bounds = bounds_of(arcs.planes, arcs.map);
  ASSERT_EQ(bounds.size(), 3 * is_long.size());
  for (std::size_t a = 0; a < is_long.size(); ++a) {
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_EQ(bounds[2 * a + i].kind, SphereBound::Kind::Point);
      EXPECT_TRUE(holds(bounds[2 * a + i].from, arcs.ends[a][i]));
    }
    const SphereBound& arc = bounds[2 * is_long.size() + a];
    EXPECT_EQ(arc.kind, is_long[a] ? SphereBound::Kind::Circle : SphereBound::Kind::ShortArc);
    const Vector n = cross(arcs.ends[a][0], arcs.ends[a][1]);
    EXPECT_TRUE(holds(arc.normal, n) || holds(arc.normal, {-n[0], -n[1], -n[2]}));
    if (is_long[a]) continue;
    const bool is_turned = holds(arc.from, arcs.ends[a][1]);
    EXPECT_TRUE(holds(arc.from, arcs.ends[a][is_turned ? 1 : 0]));
    EXPECT_TRUE(holds(arc.to, arcs.ends[a][is_turned ? 0 : 1]));
    EXPECT_EQ(holds(arc.normal, n), !is_turned);
  }
}

TEST(SphereBounds, TheTreeVisitsAllThatHaveACommonDirection) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Dice dice(seed);
    const auto reach = static_cast<std::int64_t>(1 + 2 * (seed % 3));  // 1: all meet at axes
    Arcs arcs;
    while (arcs.ends.size() < 40) {
      const Vector u = any_vector(dice, reach);
      const Vector v = any_vector(dice, reach);
      if (cross(u, v) != kZero) arcs.add(u, v);
    }
    const std::vector<SphereBound> bounds = bounds_of(arcs.planes, arcs.map);
    const SphereBoundTree tree(bounds);
    const auto points = static_cast<std::uint32_t>(2 * arcs.ends.size());
    const auto point = [&](std::uint32_t i) { return arcs.ends[i / 2][i % 2]; };
    for (std::uint32_t i = 0; i < bounds.size(); ++i) {
      std::set<std::uint32_t> visited;
      tree.for_each_meeting(bounds[i],
                            [&](std::uint32_t j) { EXPECT_TRUE(visited.insert(j).second) << j; });
      for (std::uint32_t j = 0; j < bounds.size(); ++j) {
        const bool meets = i < points
                               ? (j < points ? is_same_direction(point(i), point(j))
                                             : is_on_short_arc(arcs.ends[j - points], point(i)))
                               : (j < points ? is_on_short_arc(arcs.ends[i - points], point(j))
                                             : have_common_direction(arcs.ends[i - points],
                                                                     arcs.ends[j - points]));
        if (meets) {
          EXPECT_TRUE(visited.contains(j)) << seed << ": " << i << ' ' << j;
        }
      }
    }
  }
}

/// Arcs side by side, as on a cone with many ridges: boxes along the axes all overlap there.
TEST(SphereBounds, ASearchVisitsFewOfManyArcsSideBySide) {
  Arcs arcs;
  constexpr std::int64_t kCount = 400;
  for (std::int64_t i = 0; i < kCount; ++i) {
    arcs.add({kCount, 2 * i - kCount, -kCount}, {kCount, 2 * i - kCount, kCount});
  }
  const SphereBoundTree tree(bounds_of(arcs.planes, arcs.map));
  std::size_t visits = 0;
  const auto count = [&](std::uint32_t) { ++visits; };
  Arcs query;
  query.add({kCount, 100, -3}, {kCount, 100, 3});
  const std::vector<SphereBound> asked = bounds_of(query.planes, query.map);
  tree.for_each_meeting(asked[2], count);
  EXPECT_GE(visits, 1U);  // the arc with 2 i - kCount = 100 overlaps it
  EXPECT_LE(visits, 12U);
  visits = 0;
  EXPECT_FALSE(tree.find_meeting(asked[2], [&](std::uint32_t) {
    ++visits;
    return false;
  }));
  EXPECT_EQ(visits, 1U);
  EXPECT_TRUE(SphereBoundTree(std::vector<SphereBound>{}).find_meeting(asked[2], [](std::uint32_t) {
    return false;
  }));
}

}  // namespace plumb::sphere_bounds_test
