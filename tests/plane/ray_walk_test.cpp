// Rays through sets of some size, against asking every edge. (Small sets of every kind, against
// brute force over all cells: nef2_property_test.)
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

#include "generate/plane_families.h"
#include "oracle/ray_twin.h"
#include "plumb/plane/nef2.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::ray_walk_test {
namespace {

std::string to_text(const RationalPoint2& p) { return "(" + p.x.str() + ", " + p.y.str() + ")"; }

std::string to_text(const std::optional<PlaneHit>& hit) {
  if (!hit) return "nothing";
  return to_text(hit->point) + " of vertex " + std::to_string(hit->location.vertex.value()) +
         ", edge " + std::to_string(hit->location.edge.value()) + ", face " +
         std::to_string(hit->location.face.value());
}

void expect_right(const Nef2& set, const RationalPoint2& origin, const RationalPoint2& direction) {
  const auto marked = set.shoot(origin, direction);
  const auto slow = shoot_slowly(set, origin, direction);
  EXPECT_EQ(to_text(marked), to_text(slow)) << to_text(origin) << " + t " << to_text(direction);
  EXPECT_TRUE(!marked || marked->location.marked);
  EXPECT_EQ(to_text(set.shoot_to_boundary(origin, direction)),
            to_text(shoot_to_boundary_slowly(set, origin, direction)))
      << to_text(origin) << " + t " << to_text(direction);
}

RationalPoint2 vertex(const Nef2& set, Dice& dice) {
  const PlaneComplex& c = set.complex();
  return exact(c.points, c.vertex_point[dice.below(c.vertex_count())]);
}

RationalPoint2 towards(const RationalPoint2& from, const RationalPoint2& to) {
  return {to.x - from.x, to.y - from.y};
}

RationalPoint2 middle(const RationalPoint2& p, const RationalPoint2& q) {
  return {(p.x + q.x) / 2, (p.y + q.y) / 2};
}

/// From vertices, from between vertices, towards vertices, along the axes.
void shoot_around(const Nef2& set, std::uint64_t seed, int rounds) {
  Dice dice(seed);
  for (int round = 0; round < rounds && !::testing::Test::HasFailure(); ++round) {
    const RationalPoint2 p = vertex(set, dice);
    const RationalPoint2 q = vertex(set, dice);
    const RationalPoint2 r = vertex(set, dice);
    if (p == q || q == r) continue;
    expect_right(set, p, towards(p, q));
    const RationalPoint2 m = middle(p, q);
    expect_right(set, m, towards(q, r));
    for (const RationalPoint2& axis : {RationalPoint2{1, 0}, RationalPoint2{-1, 0},
                                       RationalPoint2{0, 1}, RationalPoint2{0, -1}}) {
      expect_right(set, p, axis);
      expect_right(set, m, axis);
    }
  }
}

TEST(Rays, ThroughStars) {
  const Nef2 a = Nef2::polygon(star_polygon(100, 1));
  const Nef2 b = Nef2::polygon(star_polygon(100, 2));
  shoot_around(a, 1, 15);
  shoot_around(a ^ b, 2, 15);
  shoot_around((!a * b).interior(), 3, 15);
}

// Everything on a few integers: verticals, many vertices of one x, rays along edges, isolated
// points.
Nef2 grid_set(Dice& dice, int parts) {
  Nef2 set;
  const auto corner = [&dice] {
    const double x = dice.below(9);
    const double y = dice.below(9);
    return Point2{x, y};
  };
  for (int i = 0; i < parts; ++i) {
    std::vector<Point2> points;
    for (std::uint32_t k = 1 + dice.below(5); k > 0; --k) points.push_back(corner());
    const Nef2 next = dice.below(3) == 0 ? Nef2::polyline(points) : Nef2::polygon(points);
    set = dice.below(4) == 0 ? set - next : set ^ next;
  }
  return set;
}

// Lines, rays and half-planes, upright ones too, up and down.
Nef2 with_unbounded(const Nef2& set, Dice& dice) {
  Nef2 result = set;
  for (int i = 0; i < 4; ++i) {
    const auto x = static_cast<int>(dice.below(9));
    const auto y = static_cast<int>(dice.below(9));
    const auto dx = static_cast<int>(dice.below(3)) - 1;
    const auto dy = static_cast<int>(dice.below(3)) - 1;
    const int rise = dx == 0 && dy == 0 ? 1 : dy;
    const Line2 line{{x, y}, {x + dx, y + rise}};
    switch (dice.below(4)) {
      case 0:
        result = result ^ Nef2::line(line);
        break;
      case 1:
        result = result + Nef2::half_plane(line, Boundary::Open);
        break;
      default:
        result = result ^ Nef2::ray(line, Boundary::Closed);
        break;
    }
  }
  return result;
}

TEST(Rays, ThroughSetsOnAGrid) {
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef2 set = grid_set(dice, 6);
    if (set.complex().vertex_count() > 0) shoot_around(set, seed, 6);
  }
}

TEST(Rays, ThroughUnboundedSetsOnAGrid) {
  for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed + 1000);
    const Nef2 small = grid_set(dice, 3);
    const Nef2 set = with_unbounded(small, dice);
    if (set.complex().vertex_count() > 0) shoot_around(set, seed, 6);
  }
}

TEST(Rays, OfCoordinatesOfEverySize) {
  const Nef2 set =
      Nef2::polygon(std::vector<Point2>{{-1e300, -1e300}, {1e300, -1e300}, {0, 1e300}}) -
      Nef2::polygon(std::vector<Point2>{{0, 0}, {1e-300, 0}, {0, 1e-300}});
  shoot_around(set, 5, 20);
}

TEST(Rays, WithoutVerticesGoOnForEver) {
  EXPECT_FALSE(Nef2().shoot({0, 0}, {1, 2}));
  EXPECT_FALSE(Nef2::whole().shoot_to_boundary({0, 0}, {0, -1}));
  EXPECT_TRUE(Nef2::whole().shoot({0, 0}, {1, 2}));
  const Nef2 upright = Nef2::line({{1, 0}, {1, 1}});
  const auto hit = upright.shoot({0, 0}, {1, 1});
  ASSERT_TRUE(hit);
  EXPECT_TRUE((hit->point == RationalPoint2{1, 1}));
  EXPECT_FALSE(upright.shoot({0, 0}, {0, 1}));
  EXPECT_FALSE(upright.shoot({2, 0}, {1, 0}));
  EXPECT_TRUE(upright.shoot({2, 0}, {-1, 0}));
}

TEST(Rays, BetweenUprightLines) {
  const Nef2 set = Nef2::line({{1, 0}, {1, 1}}) ^ Nef2::line({{3, 0}, {3, 1}});
  for (const int x : {0, 1, 2, 3, 4}) {
    for (const RationalPoint2& direction :
         {RationalPoint2{1, 0}, RationalPoint2{-1, 0}, RationalPoint2{1, 1}, RationalPoint2{-1, 1},
          RationalPoint2{0, 1}, RationalPoint2{0, -1}}) {
      expect_right(set, {x, 0}, direction);
    }
  }
}

// What the first call builds is built once.
TEST(Rays, FromSeveralThreadsAtOnce) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const std::vector<Point2> corners = star_polygon(50, seed);
    const Nef2 other = Nef2::polygon(corners);
    const auto hit = other.shoot({-1000, 0}, {1, 0});
    const PlaneLocation place = other.locate(corners.front());
    const Nef2 set = Nef2::polygon(corners);
    std::array<bool, 4> is_right{};
    std::vector<std::jthread> threads;
    for (bool& right : is_right) {
      threads.emplace_back([&] {
        const bool same_hit = to_text(set.shoot({-1000, 0}, {1, 0})) == to_text(hit);
        right = same_hit && set.locate(corners.front()).vertex == place.vertex;
      });
    }
    threads.clear();
    EXPECT_EQ(is_right, (std::array<bool, 4>{true, true, true, true}));
  }
}

}  // namespace
}  // namespace plumb::testing::ray_walk_test
