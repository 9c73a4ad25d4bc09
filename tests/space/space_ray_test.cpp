// What the line of a ray meets of triangles, held against exact solutions: places, items and order.
#include "plumb/space/query/space_ray.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/testing/dice.h"

namespace plumb::space_ray_test {

using testing::cross;
using testing::Dice;
using testing::dot;
using testing::rational_point;
using testing::SpaceScene;
using testing::operator+;
using testing::operator*;

struct Met {
  SpaceItem::Kind kind;
  Rational t;
  RationalPoint3 at;
};

/// Requires a line that is not parallel to the triangle's plane.
std::optional<Met> meet(const std::array<RationalPoint3, 3>& p, const RationalPoint3& o,
                        const RationalPoint3& d) {
  const RationalPoint3 n = cross(p[1] - p[0], p[2] - p[0]);
  const Rational t = dot(n, p[0] - o) / dot(n, d);
  const RationalPoint3 at = o + t * d;
  int on_sides = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational turn = dot(n, cross(p[(i + 1) % 3] - p[i], at - p[i]));
    if (turn < 0) return std::nullopt;
    if (turn == 0) ++on_sides;
  }
  constexpr std::array kKinds{SpaceItem::Kind::Facet, SpaceItem::Kind::Edge,
                              SpaceItem::Kind::Vertex};
  return Met{kKinds[static_cast<std::size_t>(on_sides)], t, at};
}

// Few places and directions, so that lines often pass through edges and vertices; along axes, as
// from doubles and from fractions, too.
TEST(SpaceRay, MeetsTrianglesAsExactly) {
  Dice dice(101);
  std::array<int, 3> seen{};
  for (int round = 0; round < 600; ++round) {
    const int divisor = round % 3 == 0 ? 3 : 1;
    const auto random = [&](std::int64_t low, std::int64_t high) {
      const auto x = static_cast<int>(dice.between(low, high));
      const auto y = static_cast<int>(dice.between(low, high));
      return Rational(1, divisor) * rational_point(x, y, static_cast<int>(dice.between(low, high)));
    };
    std::array<std::array<RationalPoint3, 3>, 2> corners;
    SpaceScene scene;
    for (auto& p : corners) {
      RationalPoint3 n;
      do {
        for (RationalPoint3& corner : p) corner = random(0, 3);
        n = cross(p[1] - p[0], p[2] - p[0]);
      } while (dot(n, n) == 0);
      scene.add_facet({p[0], p[1], p[2]});
    }
    const SpaceComplex c = testing::complex_without_volumes(scene);
    const RationalPoint3 o = random(0, 3);
    const bool is_along_axis = round % 2 == 0;
    RationalPoint3 d = rational_point(0, 0, 0);
    const std::size_t axis = dice.below(3);
    const bool is_reverse = dice.below(2) == 0;
    const Rational one(is_reverse ? -1 : 1);
    if (is_along_axis) d = {axis == 0 ? one : 0, axis == 1 ? one : 0, axis == 2 ? one : 0};
    while (dot(d, d) == 0) d = random(-2, 2);
    const QueryPoint3 origin(o);
    const SpaceRay ray =
        is_along_axis ? SpaceRay(c, origin, axis, is_reverse) : SpaceRay(c, origin, d);
    std::vector<std::pair<SpaceRayHit, Rational>> all;
    for (std::uint32_t f = 0; f < 2; ++f) {
      const auto& p = corners[f];
      if (dot(cross(p[1] - p[0], p[2] - p[0]), d) == 0) continue;
      const std::optional<Met> expected = meet(p, o, d);
      std::vector<SpaceRayHit> hits;
      ray.add_hits(FacetId(f), hits);
      ASSERT_EQ(hits.size(), expected ? 1U : 0U) << round;
      if (!expected) continue;
      EXPECT_FALSE(ray.passes_by(FacetId(f)));
      EXPECT_EQ(hits[0].item.kind(), expected->kind);
      EXPECT_EQ(ray.point(hits[0]), expected->at);
      EXPECT_EQ(ray.side(hits[0]), sign_of(expected->t.sign()));
      ++seen[static_cast<std::size_t>(expected->kind)];
      all.emplace_back(hits[0], expected->t);
    }
    if (all.size() < 2) continue;
    EXPECT_EQ(ray.compare(all[0].first, all[1].first),
              sign_of(Rational(all[0].second - all[1].second).sign()));
  }
  for (const int n : seen) EXPECT_GT(n, 20);
}

// Along a triangle's plane a ray meets what it meets of the boundary.
TEST(SpaceRay, MeetsTheBoundaryOfWhatItRunsAlong) {
  SpaceScene scene;
  scene.add_facet({rational_point(0, 0, 0), rational_point(4, 0, 0), rational_point(0, 4, 0)});
  const SpaceComplex c = testing::complex_without_volumes(scene);
  const auto hits_from = [&](const RationalPoint3& o) {
    const QueryPoint3 origin(o);
    std::vector<SpaceRayHit> hits;
    SpaceRay(c, origin, 0, false).add_hits(FacetId(0), hits);
    return hits.size();
  };
  EXPECT_EQ(hits_from(rational_point(9, 1, 0)), 2U);
  EXPECT_EQ(hits_from(rational_point(9, 0, 0)), 2U);
  EXPECT_EQ(hits_from(rational_point(9, 4, 0)), 1U);
  EXPECT_EQ(hits_from(rational_point(9, 5, 0)), 0U);
  EXPECT_EQ(hits_from(rational_point(9, 1, 1)), 0U);
}

}  // namespace plumb::space_ray_test
