// Convex hulls: all points behind all faces, corners among the points, and what is known of flat
// input.
#include "plumb/model/hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "generate/test_share.h"
#include "plumb/model/primitives.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::hull_test {
namespace {

RationalPoint3 exact_point(const Point3& p) {
  return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
}
RationalPoint3 point_of(const PolygonMesh& mesh, std::uint32_t i) {
  for (const auto& [at, point] : mesh.exact) {
    if (at == i) return point;
  }
  return exact_point(mesh.points[i]);
}

/// A hull is right if it is convex, its corners are input points, and it contains all of them.
void expect_hull(const Nef3& hull, const std::vector<RationalPoint3>& points) {
  EXPECT_FALSE(hull.audit());
  EXPECT_TRUE(hull.is_closed());
  EXPECT_TRUE(hull.is_convex());
  for (const RationalPoint3& p : points) ASSERT_TRUE(hull.contains(p));
  const SpaceComplex& c = hull.complex();
  for (const SpacePoint p : c.vertex_point) {
    const RationalPoint3 corner = exact(c.points(), p);
    ASSERT_NE(std::find(points.begin(), points.end(), corner), points.end());
  }
}

std::vector<RationalPoint3> exact_points(const std::vector<Point3>& points) {
  std::vector<RationalPoint3> result;
  for (const Point3& p : points) result.push_back(exact_point(p));
  return result;
}

TEST(ConvexHull, OfPointsOfALattice) {
  for (std::uint64_t seed = 0; seed < share_of(300); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const std::uint32_t size = 2 + dice.below(4);
    std::vector<Point3> points;
    const std::size_t n = dice.below(20);
    for (std::size_t i = 0; i < n; ++i) {
      const double x = dice.below(size), y = dice.below(size);
      points.push_back({x, y, seed % 3 == 0 ? x + y : static_cast<double>(dice.below(size))});
    }
    const Nef3 hull = convex_hull(points);
    if (points.empty()) {
      EXPECT_TRUE(hull.is_empty());
      continue;
    }
    expect_hull(hull, exact_points(points));
    // The same points as fractions, moved by a third.
    std::vector<RationalPoint3> moved;
    const Rational third = Rational(1) / 3;
    for (const Point3& p : points) {
      const RationalPoint3 q = exact_point(p);
      moved.push_back({q.x + third, q.y, q.z - third});
    }
    EXPECT_EQ(convex_hull(moved), hull.translated({third, 0, -third}));
  }
}

TEST(ConvexHull, OfManyPoints) {
  Dice dice(7);
  std::vector<Point3> points;
  for (int i = 0; i < 2000; ++i) {
    const auto number = [&] { return static_cast<double>(dice.between(-1000000, 1000000)); };
    points.push_back({number(), number(), number()});
  }
  const PolygonMesh mesh = hull_mesh(points);
  ASSERT_GT(mesh.face_count(), 100U);
  EXPECT_EQ(mesh.face_count(), 2 * mesh.points.size() - 4);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (const Point3& p : points) {
      ASSERT_NE(orient3d(point_of(mesh, face[0]), point_of(mesh, face[1]), point_of(mesh, face[2]),
                         exact_point(p)),
                Sign::Negative);
    }
  }
}

TEST(ConvexHull, OfNearlyFlatPoints) {
  for (std::uint64_t seed = 0; seed < share_of(60); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    std::vector<Point3> points;
    for (int i = 0; i < 25; ++i) {
      const double x = dice.below(5), y = dice.below(5);
      points.push_back({0.1 * x, 0.1 * y, 0.1 * x + 0.1 * y + 0x1p-52 * dice.below(3)});
    }
    expect_hull(convex_hull(points), exact_points(points));
  }
}

TEST(ConvexHull, OfFlatPoints) {
  const std::vector<Point3> one{{1, 2, 3}, {1, 2, 3}};
  EXPECT_EQ(convex_hull(one), Nef3::point({1, 2, 3}));
  const std::vector<Point3> line{{0, 0, 0}, {2, 4, 6}, {1, 2, 3}};
  EXPECT_EQ(convex_hull(line), Nef3::segment({0, 0, 0}, {2, 4, 6}));
  const std::vector<Point3> square{{0, 0, 1}, {2, 0, 1}, {2, 2, 1},
                                   {0, 2, 1}, {1, 1, 1}, {1, 0, 1}};
  EXPECT_EQ(convex_hull(square),
            Nef3::facet(std::vector<Point3>{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}));
}

TEST(ConvexHull, OfSets) {
  const Nef3 box = Nef3::from_mesh(box_mesh({1, 1, 1}, Placement::Corner));
  const std::vector<Nef3> sets{box, box.translated({3, 0, 0})};
  EXPECT_EQ(convex_hull(sets), Nef3::from_mesh(box_mesh({4, 1, 1}, Placement::Corner)));
  const std::vector<Nef3> with_point{box.interior(), Nef3::point({0, 0, 4})};
  EXPECT_EQ(convex_hull(with_point).volume(), Rational(2));
  EXPECT_THROW(static_cast<void>(convex_hull(std::vector<Nef3>{!box})), Error);
}

TEST(ConvexHull, OfTheSphereIsConvex) {
  for (const std::uint32_t chords : {3U, 4U, 5U, 8U, 16U, 30U}) {
    const Nef3 sphere = Nef3::from_mesh(sphere_mesh(6.5, chords));
    EXPECT_TRUE(sphere.is_convex()) << chords;
    EXPECT_EQ(sphere.counts().vertices, std::size_t{chords} * ((chords + 1) / 2));
  }
}

TEST(ConvexHull, OfPlanePoints) {
  for (std::uint64_t seed = 0; seed < share_of(200); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    std::vector<RationalPoint2> points;
    const std::size_t n = 1 + dice.below(12);
    for (std::size_t i = 0; i < n; ++i) {
      points.push_back({Rational(dice.below(5)) / 3, Rational(dice.below(5)) / 3});
    }
    const Nef2 hull = convex_hull(points);
    EXPECT_FALSE(hull.audit());
    EXPECT_TRUE(hull.is_closed());
    for (const RationalPoint2& p : points) ASSERT_TRUE(hull.contains(p));
    // Convex: the middle of any two corners belongs to it.
    const PlaneComplex& c = hull.complex();
    for (const std::uint32_t a : c.vertex_point) {
      const RationalPoint2 p = exact(c.points, a);
      ASSERT_NE(std::find(points.begin(), points.end(), p), points.end());
      for (const std::uint32_t b : c.vertex_point) {
        const RationalPoint2 q = exact(c.points, b);
        ASSERT_TRUE(hull.contains(RationalPoint2{(p.x + q.x) / 2, (p.y + q.y) / 2}));
      }
    }
  }
  const std::vector<Nef2> sets{disk(1, 4), Nef2::point({3, 0})};
  EXPECT_EQ(convex_hull(sets).area(), Rational(4));
  EXPECT_TRUE(convex_hull(std::vector<Point2>{}).is_empty());
}

TEST(ConvexHull, RefusesNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(convex_hull(std::vector<Point3>{{nan, 0, 0}})), Error);
  EXPECT_THROW(static_cast<void>(convex_hull(std::vector<Point2>{{nan, 0}})), Error);
}

}  // namespace
}  // namespace plumb::testing::hull_test
