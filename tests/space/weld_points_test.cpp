// Welding held against the definition, with exact distances between all pairs of points.
#include "plumb/space/weld_points.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "generate/meshes.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::weld_points_test {
namespace {

/// Points in faces of their own, so that all are used.
PolygonMesh cloud(std::vector<Point3> points) {
  PolygonMesh mesh;
  mesh.points = std::move(points);
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) mesh.add_face(std::array{i});
  return mesh;
}

RationalPoint3 place(const PolygonMesh& mesh, std::uint32_t i) {
  for (const auto& [index, p] : mesh.exact) {
    if (index == i) return p;
  }
  const Point3& p = mesh.points[i];
  return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
}

Rational square(const RationalPoint3& a, const RationalPoint3& b) {
  const Rational x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
  return x * x + y * y + z * z;
}

PointWeld welded(PolygonMesh mesh, double tolerance) {
  return weld_points(mesh, tolerance, unlimited_context());
}

/// What the header promises, for all pairs.
void expect_promises(const PolygonMesh& mesh, double tolerance) {
  PolygonMesh after = mesh;
  const PointWeld weld = weld_points(after, tolerance, unlimited_context());
  const Rational most = exact_rational(tolerance) * exact_rational(tolerance);
  const Rational told = exact_rational(weld.farthest) * exact_rational(weld.farthest);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_EQ(after.corners[i], weld.kept[i]);
    const RationalPoint3 p = place(mesh, i);
    if (weld.kept[i] == i) {
      for (const std::uint32_t k : kept) EXPECT_GT(square(p, place(mesh, k)), most);
      kept.push_back(i);
      continue;
    }
    // It went to a point that is kept, near enough, and as near as any.
    ASSERT_LT(weld.kept[i], i);
    ASSERT_EQ(weld.kept[weld.kept[i]], weld.kept[i]);
    const Rational moved = square(p, place(mesh, weld.kept[i]));
    EXPECT_LE(moved, most);
    EXPECT_LE(moved, told);
    // A point follows the first one with its coordinates, which knew fewer that are kept.
    bool is_first = true;
    for (std::uint32_t j = 0; j < i; ++j) is_first = is_first && square(p, place(mesh, j)) != 0;
    for (const std::uint32_t k : is_first ? kept : std::vector<std::uint32_t>()) {
      const double other = nearest_double(square(p, place(mesh, k)));
      EXPECT_LE(nearest_double(moved), other * (1 + 1e-12));
    }
  }
  EXPECT_LE(weld.farthest, tolerance);
  const PointWeld again = welded(after, tolerance);
  EXPECT_EQ(again.moved, 0U);
}

TEST(WeldPoints, KeepsItsPromisesAtEveryScale) {
  Dice dice(17);
  for (const double scale : {1.0, 1e-3, 0x1p-1070, 1e-200, 1e200, 0x1p1000}) {
    for (const double shift : {0.0, 1.0, 1e6}) {
      for (int round = 0; round < 6; ++round) {
        std::vector<Point3> points;
        const auto at = [&] { return (shift + dice.below(40)) * scale; };
        for (int i = 0; i < 60; ++i) points.push_back({at(), at(), at()});
        expect_promises(cloud(std::move(points)), (1 + dice.below(12)) * scale);
      }
    }
  }
}

// Neighbouring doubles, and a tolerance about as large as their distance.
TEST(WeldPoints, FindsTheLastBits) {
  Dice dice(18);
  for (const double start : {1.0, 1e20, 1e-20, 0x1p52}) {
    for (const double ulps : {0.3, 0.5, 1.0, 1.5, 3.0, 64.0}) {
      const double ulp = std::nextafter(start, 2 * start) - start;
      std::vector<Point3> points;
      const auto at = [&] { return start + static_cast<double>(dice.below(6)) * ulp; };
      for (int i = 0; i < 40; ++i) points.push_back({at(), at(), start});
      expect_promises(cloud(std::move(points)), ulps * ulp);
    }
  }
}

TEST(WeldPoints, ChainsDragNoPointFarther) {
  std::vector<Point3> points;
  for (int i = 0; i < 100; ++i) points.push_back({0.75 * i, 0, 0});
  const PointWeld weld = welded(cloud(points), 1);
  for (std::uint32_t i = 0; i < 100; ++i) EXPECT_EQ(weld.kept[i], i - i % 2);
  EXPECT_EQ(weld.moved, 50U);
  EXPECT_GE(weld.farthest, 0.75);
  EXPECT_LT(weld.farthest, 0.7500001);
}

TEST(WeldPoints, AtTheToleranceIsNear) {
  EXPECT_EQ(welded(cloud({{0, 0, 0}, {3, 4, 0}}), 5).moved, 1U);
  EXPECT_EQ(welded(cloud({{0, 0, 0}, {3, 4, 0}}), std::nextafter(5, 0)).moved, 0U);
  EXPECT_EQ(welded(cloud({{0, 0, 0}, {3, 4, 1e-300}}), 5).moved, 0U);
}

TEST(WeldPoints, EqualPointsAreOneWithoutATolerance) {
  const PointWeld weld = welded(cloud({{0, 1, 2}, {3, 1, 2}, {-0.0, 1, 2}, {0, 1, 0x1p-1074}}), 0);
  EXPECT_EQ(weld.kept, (std::vector<std::uint32_t>{0, 1, 0, 3}));
  EXPECT_EQ(weld.equal, 1U);
  EXPECT_EQ(weld.moved, 0U);
}

TEST(WeldPoints, ExactPointsAreComparedExactly) {
  PolygonMesh mesh = cloud({{1.0 / 3, 0, 0}, {1.0 / 3, 0, 0}, {2.0 / 3, 0, 0}});
  mesh.exact.emplace_back(1, RationalPoint3{Rational(1) / 3, 0, 0});
  mesh.exact.emplace_back(2, RationalPoint3{Rational(2) / 3, 0, 0});
  EXPECT_EQ(welded(mesh, 0).kept, (std::vector<std::uint32_t>{0, 1, 2}));
  expect_promises(mesh, 1e-20);
  expect_promises(mesh, 1e-16);
  EXPECT_EQ(welded(mesh, 1e-16).kept, (std::vector<std::uint32_t>{0, 0, 2}));
  EXPECT_EQ(welded(mesh, 0.5).kept, (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST(WeldPoints, RefusesWhatIsNoTolerance) {
  for (const double bad :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(welded(cloud({{0, 0, 0}}), bad), Error);
  }
}

}  // namespace
}  // namespace plumb::testing::weld_points_test
