// Sums of closed convex sets: bodies by Euler's formula and their normals, directions against all
// triples of sums of vertices, sums against their hull.
#include "plumb/convex/sum/convex_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/testing/dice.h"

namespace plumb::convex_sum_test {

using testing::Dice;
using Corners = std::vector<RationalPoint3>;

RationalPoint3 plus(const RationalPoint3& a, const RationalPoint3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
bool is_zero(const RationalPoint3& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

Corners lattice_points(Dice& dice, std::size_t count) {
  Corners points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = dice.between(-2, 2), y = dice.between(-2, 2), z = dice.between(-2, 2);
    points.push_back({x, y, z});
  }
  return points;
}

/// A tetrahedron, triangle, segment or point; edges and facets are often parallel.
ConvexBody random_body(Dice& dice) {
  const std::size_t corners = 1 + dice.below(5);
  for (;;) {
    const Corners p = lattice_points(dice, corners);
    if (corners == 1) return convex_body_of(p);
    if (corners == 2 && p[0] != p[1]) return convex_body_of(p);
    if (corners < 3) continue;
    const RationalPoint3 normal = cross(p[1] - p[0], p[2] - p[0]);
    if (is_zero(normal)) continue;
    if (corners == 3) return convex_body_of(p);
    if (dot(normal, p[3] - p[0]) == 0) continue;
    std::vector<Point3> q;
    for (const RationalPoint3& r : p) {
      q.push_back({r.x.convert_to<double>(), r.y.convert_to<double>(), r.z.convert_to<double>()});
    }
    return convex_body_of(
        testing::solid(testing::make_mesh({q[0], q[1], q[2], q[3]},
                                          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
                       WindingRule::NonZero)
            .complex());
  }
}

/// The vertices that are greatest in a direction.
std::vector<std::uint32_t> extreme(const ConvexBody& body, const RationalPoint3& u) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t v = 0; v < body.point.size(); ++v) {
    const int order = all.empty() ? 1 : dot(u, body.point[v] - body.point[all[0]]).sign();
    if (order > 0) all.clear();
    if (order >= 0) all.push_back(v);
  }
  return all;
}
std::vector<std::uint32_t> sorted(std::span<const std::uint32_t> face) {
  std::vector<std::uint32_t> all(face.begin(), face.end());
  std::ranges::sort(all);
  return all;
}

/// Of length 1 along its first coordinate that is not zero.
std::array<std::string, 3> direction_of(const RationalPoint3& u) {
  Rational size = u.x != 0 ? u.x : (u.y != 0 ? u.y : u.z);
  if (size < 0) size = -size;
  return {Rational(u.x / size).str(), Rational(u.y / size).str(), Rational(u.z / size).str()};
}

void expect_body(const ConvexBody& body) {
  const std::size_t facets = body.facet_count();
  if (body.dimension >= 2) {
    EXPECT_EQ(body.point.size() + facets, body.edge.size() + 2);
  }
  for (std::size_t f = 0; f < facets; ++f) {
    const auto corners = body.corners(f);
    EXPECT_EQ(sorted(corners), extreme(body, body.normal[f]));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto at = [&](std::size_t k) { return body.point[corners[(i + k) % corners.size()]]; };
      const RationalPoint3 turn = cross(at(1) - at(0), at(2) - at(1));
      EXPECT_GT(dot(turn, body.normal[f]), 0);
    }
  }
  std::size_t neighbours = 0;
  for (const ConvexBody::Edge& e : body.edge) {
    for (const std::size_t k : {0U, 1U}) {
      const auto star = body.star(e.end[k]);
      EXPECT_EQ(std::ranges::count(star, e.end[1 - k]), 1);
      if (facets == 0) continue;
      const auto corners = body.corners(e.side[k]);
      const auto from = std::ranges::find(corners, e.end[k]) - corners.begin();
      EXPECT_EQ(corners[static_cast<std::size_t>(from + 1) % corners.size()], e.end[1 - k]);
    }
  }
  for (std::uint32_t v = 0; v < body.point.size(); ++v) neighbours += body.star(v).size();
  EXPECT_EQ(neighbours, 2 * body.edge.size());
}

TEST(ConvexSumBodies, HaveTheirFacetsOutsideAndTheirEdgesBetween) {
  expect_body(convex_body_of(box({0, 0, 0}, {1, 2, 3}).complex()));
  EXPECT_EQ(convex_body_of(box({0, 0, 0}, {1, 2, 3}).complex()).edge.size(), 12U);
  const std::vector<Point3> flat = {{0, 0, 0}, {2, 0, 1}, {2, 2, 1}, {0, 2, 0}};
  const ConvexBody facet = convex_body_of(Nef3::facet(flat).complex());
  EXPECT_EQ(facet.dimension, 2U);
  EXPECT_EQ(facet.facet_count(), 2U);
  expect_body(facet);
  const ConvexBody segment = convex_body_of(Nef3::segment({0, 0, 0}, {1, 2, 3}).complex());
  EXPECT_EQ(segment.dimension, 1U);
  EXPECT_EQ(segment.edge.size(), 1U);
  expect_body(segment);
  EXPECT_EQ(convex_body_of(Nef3::point({1, 2, 3}).complex()).point.size(), 1U);
  Dice dice(1);
  for (int round = 0; round < 40; ++round) expect_body(random_body(dice));
}

/// Planes through three sums with all others behind are the facets of the sum: each is told once,
/// with the faces of both operands there.
TEST(ConvexSumDirections, AreThoseOfSupportingPlanes) {
  Dice dice(2);
  int told = 0;
  for (int round = 0; round < 40; ++round) {
    const ConvexBody a = random_body(dice), b = random_body(dice);
    Corners sums;
    for (const RationalPoint3& p : a.point) {
      for (const RationalPoint3& q : b.point) sums.push_back(plus(p, q));
    }
    std::set<std::array<std::string, 3>> expected;
    bool is_solid = false;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          const RationalPoint3 n = cross(sums[j] - sums[i], sums[k] - sums[i]);
          if (is_zero(n)) continue;
          bool is_below = true, is_above = true;
          for (const RationalPoint3& s : sums) {
            const int side = dot(n, s - sums[i]).sign();
            is_below &= side <= 0;
            is_above &= side >= 0;
          }
          is_solid |= !is_below || !is_above;
          if (is_below) expected.insert(direction_of(n));
          if (is_above) expected.insert(direction_of({-n.x, -n.y, -n.z}));
        }
      }
    }
    if (!is_solid) continue;
    std::set<std::array<std::string, 3>> found;
    for_each_direction(
        a, b,
        [&](const FacetDirection& d) {
          EXPECT_TRUE(found.insert(direction_of(d.normal)).second);
          EXPECT_EQ(sorted(d.face_a), extreme(a, d.normal));
          EXPECT_EQ(sorted(d.face_b), extreme(b, d.normal));
          ++told;
        },
        unlimited_context());
    EXPECT_EQ(found, expected);
  }
  EXPECT_GT(told, 100);
}

/// Convex, holds all sums of two vertices, and its vertices are some of them.
void expect_hull_of_sums(const Nef3& sum, const ConvexBody& a, const ConvexBody& b) {
  EXPECT_FALSE(sum.audit());
  EXPECT_TRUE(sum.is_convex() && sum.is_closed());
  Corners sums;
  for (const RationalPoint3& p : a.point) {
    for (const RationalPoint3& q : b.point) sums.push_back(plus(p, q));
  }
  for (const RationalPoint3& p : sums) EXPECT_TRUE(sum.contains(p));
  const SpaceComplex& c = sum.complex();
  for (const SpacePoint x : c.vertex_point) {
    EXPECT_EQ(std::ranges::count(sums, exact(c.points(), x)) > 0, true);
  }
}

TEST(ConvexSums, AreTheHullOfAllSumsOfVertices) {
  Dice dice(3);
  std::array<int, 4> dimensions{};
  for (int round = 0; round < 150; ++round) {
    const ConvexBody a = random_body(dice), b = random_body(dice);
    const Nef3 sum = convex_sum(a, b, SumMarks::Closed, unlimited_context());
    expect_hull_of_sums(sum, a, b);
    ++dimensions[convex_body_of(sum.complex()).dimension];
    EXPECT_TRUE(sum == convex_sum(b, a, SumMarks::Closed, unlimited_context()));
  }
  for (const int count : dimensions) EXPECT_GT(count, 0);
}

TEST(ConvexSums, OpenOnesAreTheRelativeInterior) {
  const ConvexBody a = convex_body_of(box({0, 0, 0}, {1, 2, 3}).complex());
  const ConvexBody b = convex_body_of(box({-1, 0, 2}, {3, 1, 4}).complex());
  const Nef3 sum = convex_sum(a, b, SumMarks::Closed, unlimited_context());
  EXPECT_TRUE(sum == box({-1, 0, 2}, {4, 3, 7}));
  EXPECT_TRUE(convex_sum(a, b, SumMarks::Open, unlimited_context()) == sum.interior());
  const ConvexBody along = convex_body_of(Corners{{0, 0, 0}, {4, 0, 0}});
  const ConvexBody aside = convex_body_of(Corners{{0, 0, 0}, {0, 2, 0}});
  const Nef3 flat = convex_sum(along, aside, SumMarks::Open, unlimited_context());
  EXPECT_TRUE(flat.contains(Point3{1, 1, 0}));
  EXPECT_FALSE(flat.contains(Point3{0, 1, 0}) || flat.contains(Point3{0, 0, 0}));
  const Nef3 line = convex_sum(along, along, SumMarks::Open, unlimited_context());
  EXPECT_TRUE(line == Nef3::segment({0, 0, 0}, {8, 0, 0}) - Nef3::point({0, 0, 0}) -
                          Nef3::point({8, 0, 0}));
}

}  // namespace plumb::convex_sum_test
