// Pairs of triangles held against clipping in rationals, groups against counts, and boxes of
// directions against points of arcs.
#include "plumb/space/mesh/triangle_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "oracle/facet_contacts.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/testing/dice.h"

namespace plumb::triangle_crossing_test {

using testing::Dice;

Point3 random_point(Dice& dice, int size, double unit) {
  const auto c = [&] { return unit * static_cast<double>(dice.between(0, size)); };
  return {c(), c(), c()};
}

/// Points of a grid, or thirds of them, as vertices; triangles between them.
struct Grid {
  SpaceTables tables;
  std::vector<RationalPoint3> place;
  std::vector<SpacePoint> point;

  VertexId add(const RationalPoint3& p) {
    const auto known = std::ranges::find(place, p);
    if (known != place.end()) return VertexId(static_cast<std::size_t>(known - place.begin()));
    place.push_back(p);
    point.push_back(add_point(tables, p));
    return VertexId(place.size() - 1);
  }
  /// Counter-clockwise, seen from the positive side of its plane; no plane: corners on a line.
  FacetTriangle triangle(std::array<VertexId, 3> v, std::uint32_t facet) {
    const auto at = [&](std::size_t i) { return point[v[i].value()]; };
    const OrientedPlane plane = plane_through(tables, at(0), at(1), at(2));
    if (!plane.is_valid()) return {};
    if (plane.orientation() == Sign::Negative) std::swap(v[1], v[2]);
    FacetTriangle t{{}, plane.plane(), FacetId(facet), 0, 0};
    for (std::size_t i = 0; i < 3; ++i) t.corner[i] = {v[i], at(i)};
    return t;
  }
  testing::FacetPolygon polygon(const FacetTriangle& t) const {
    testing::FacetPolygon polygon;
    for (const TriangleCorner& c : t.corner) polygon.push_back(place[c.vertex.value()]);
    return polygon;
  }
};

// Of few places, so that corners coincide and lie on sides and planes. Heights of 0 only: all
// triangles in one plane.
TEST(TriangleCrossing, OfPairsAsClipping) {
  Dice dice(61);
  std::array<int, 4> seen{};
  for (int round = 0; round < 1500; ++round) {
    Grid grid;
    const std::int64_t height = round % 4 == 0 ? 0 : 2, divisor = round % 3 == 0 ? 3 : 1;
    const auto corner = [&] {
      const auto c = [&](std::int64_t most) {
        return Rational(dice.between(0, most), dice.below(2) == 0 ? divisor : 1);
      };
      const Rational x = c(2), y = c(2), z = c(height);
      return grid.add({x, y, z});
    };
    std::array<std::array<VertexId, 3>, 2> v;
    for (auto& corners : v) {
      for (VertexId& c : corners) c = corner();
    }
    if (round % 2 == 0) v[1][dice.below(3)] = v[0][dice.below(3)];
    const FacetTriangle s = grid.triangle(v[0], 0), t = grid.triangle(v[1], 1);
    if (!s.plane.is_valid() || !t.plane.is_valid()) continue;
    const TriangleCrossing cross(grid.tables.points);
    const bool expected = testing::meet_elsewhere(grid.polygon(s), grid.polygon(t));
    EXPECT_EQ(cross(s, t), expected) << round;
    EXPECT_EQ(cross(t, s), expected) << round;
    ++seen[(s.plane == t.plane ? 2U : 0U) + (expected ? 1U : 0U)];
  }
  for (const int n : seen) EXPECT_GT(n, 40);
}

// Two triangles with one common side in two planes, and with one common corner in one plane.
TEST(TriangleCrossing, AsksNothingAtFansAndKnowsDiagonals) {
  Grid grid;
  const VertexId a = grid.add({0, 0, 0}), b = grid.add({2, 0, 0}), c = grid.add({0, 2, 0}),
                 d = grid.add({0, 0, 2}), e = grid.add({1, 1, 0});
  const TriangleCrossing cross(grid.tables.points);
  FacetTriangle s = grid.triangle({a, b, c}, 0);
  const FacetTriangle beside = grid.triangle({b, a, d}, 1), within = grid.triangle({a, b, e}, 1);
  EXPECT_FALSE(cross(s, beside));
  EXPECT_TRUE(cross(s, within));
  for (std::size_t i = 0; i < 3; ++i) {
    s.diagonals = static_cast<std::uint8_t>(1U << i);
    const VertexId from = s.corner[i].vertex, to = s.corner[(i + 1) % 3].vertex;
    EXPECT_EQ(cross(s, beside), from != c && to != c);
    EXPECT_EQ(cross(beside, s), from != c && to != c);
    s.diagonals = 0;
    s.fans = static_cast<std::uint8_t>(1U << i);
    EXPECT_EQ(cross(s, within), from == c);
    s.fans = 0;
  }
}

// Facets of 64 and 65 triangles, and corners where 64 and 65 of others meet.
TEST(TriangleGroups, TakeMoreThanMany) {
  const auto triangle = [](std::uint32_t facet, std::uint32_t v, std::uint32_t w, std::uint32_t x) {
    FacetTriangle t{};
    t.facet = FacetId(facet);
    t.corner[0].vertex = VertexId(v);
    t.corner[1].vertex = VertexId(w);
    t.corner[2].vertex = VertexId(x);
    return t;
  };
  std::vector<FacetTriangle> triangles;
  std::uint32_t vertex = 2, facet = 0;
  const auto add = [&](std::uint32_t count, bool is_one_facet, std::uint32_t hub) {
    for (std::uint32_t i = 0; i < count; ++i, vertex += 3) {
      triangles.push_back(triangle(facet, vertex, hub < 2 ? hub : vertex + 1, vertex + 2));
      if (!is_one_facet || i + 1 == count) ++facet;
    }
  };
  constexpr std::uint32_t kMany = TriangleGroups::kMany;
  add(kMany, true, kNone);
  add(kMany + 1, true, kNone);
  add(kMany, false, 0);
  add(kMany + 1, false, 1);
  const TriangleGroups groups = group_triangles(triangles, vertex);
  ASSERT_EQ(groups.hub.size(), 2U);
  EXPECT_FALSE(groups.hub[0].is_valid());
  EXPECT_EQ(groups.hub[1], VertexId(1));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool is_large = t >= kMany && t < 2 * kMany + 1, is_around = t >= 3 * kMany + 1;
    EXPECT_EQ(groups.of[t], is_large ? 0U : is_around ? 1U : kNone) << t;
  }
  EXPECT_EQ(groups.pairs, 2U * (kMany + 1) * kMany / 2);
}

// The points of an arc are within its box.
TEST(TriangleGroups, DirectionsAreWithinTheirBoxes) {
  Dice dice(20);
  const auto box = [](const Point3& p) { return PointBox{{p.x, p.y, p.z}, 0}; };
  for (int round = 0; round < 3000; ++round) {
    const double unit = round % 3 == 0 ? 1e-200 : round % 3 == 1 ? 1 : 1e200;
    const int size = round % 2 == 0 ? 3 : 1000;
    const Point3 v = random_point(dice, size, unit);
    const Point3 a = random_point(dice, size, unit);
    const Point3 b = random_point(dice, size, unit);
    const Box3 directions = box_of_directions(box(v), box(a), box(b));
    for (int i = 0; i <= 8; ++i) {
      const double s = i / 8.0, t = 1 - s;
      const std::array to{(s * a.x + t * b.x - v.x) / unit, (s * a.y + t * b.y - v.y) / unit,
                          (s * a.z + t * b.z - v.z) / unit};
      const double length = std::hypot(to[0], to[1], to[2]);
      if (length < 1e-3) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LE(directions.low[k], to[k] / length + 1e-13);
        EXPECT_GE(directions.high[k], to[k] / length - 1e-13);
      }
    }
  }
}

}  // namespace plumb::triangle_crossing_test
