// Boxes around items hold them: compared with coordinates in rationals. Axes of boxes are those of
// an eigenvalue problem, and the expected number of pairs is that of a formula.
#include "plumb/space/complex/space_boxes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::space_boxes_test {
namespace {

using testing::Dice;
using testing::SpaceScene;

constexpr double kInfinity = Box3::kInfinity;

std::array<Rational, 3> coordinates(const RationalPoint3& p) { return {p.x, p.y, p.z}; }

bool holds(const Box3& box, const RationalPoint3& p) {
  const std::array<Rational, 3> at = coordinates(p);
  for (std::size_t i = 0; i < 3; ++i) {
    if (exact_rational(box.low[i]) > at[i] || exact_rational(box.high[i]) < at[i]) return false;
  }
  return true;
}

Box3 box_at(double x, double y, double z, double side = 0) {
  return {{x, y, z}, {x + side, y + side, z + side}};
}

TEST(SpaceBoxes, HoldAllThatAPointBoxMayMean) {
  for (const double mid : {0.0, 1.0, -1.0 / 3, 0x1p900, -0x1p-1060, 1e-300}) {
    for (const double radius : {0.0, 0x1p-1074, 0x1p-60, 0x1.8p-53, 0.1, 0x1p900}) {
      const Box3 box = box_of(PointBox{{mid, -mid, 0}, radius});
      const Rational m = exact_rational(mid), r = exact_rational(radius);
      EXPECT_TRUE(holds(box, {m - r, -m - r, -r})) << mid << ' ' << radius;
      EXPECT_TRUE(holds(box, {m + r, -m + r, r})) << mid << ' ' << radius;
      if (radius == 0) {
        EXPECT_EQ(box, (Box3{{mid, -mid, 0}, {mid, -mid, 0}}));
      }
    }
  }
  const Box3 unknown = box_of(PointBox{{1, 2, 3}, kInfinity});
  EXPECT_EQ(unknown,
            (Box3{{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}}));
}

/// Common points of nearly parallel planes.
TEST(SpaceBoxes, HoldConstructedPoints) {
  Dice dice(1);
  SpaceTables tables;
  int made = 0;
  for (int round = 0; round < 150; ++round) {
    std::array<PlaneId, 3> planes;
    const std::array<double, 3> base{static_cast<double>(dice.between(1, 9)),
                                     static_cast<double>(dice.between(-9, 9)), 1.0};
    const double tilt = round % 2 == 0 ? 1 : 0x1p-45;
    for (PlaneId& p : planes) {
      const auto small = [&] { return tilt * static_cast<double>(dice.between(-3, 3)); };
      const double a = base[0] + small(), b = base[1] + small(), c = base[2] + small();
      p = tables.planes.intern(a, b, c, static_cast<double>(dice.between(-9, 9))).plane();
    }
    const SpacePoint p = tables.points.add(planes[0], planes[1], planes[2]);
    if (!p.is_valid()) continue;
    EXPECT_TRUE(holds(box_of(tables.points, p), exact(tables.points, p)));
    ++made;
  }
  EXPECT_GT(made, 60);
}

/// Boxes of items are the least ones around their vertices, all of which are doubles here.
TEST(SpaceBoxes, OfItemsAreLeast) {
  SpaceScene scene;
  testing::add_box(scene, {0, 0, 0}, {2, 3, 4});
  testing::add_tetrahedron(scene, {{{7, 1, 0}, {9, -2, 1}, {8, 5, 5}, {7, 7, -7}}});
  scene.add_free_edge({-5, 0, 0}, {0, -6, 0});
  scene.add_point({0, 0, 50});
  const SpaceComplex c = testing::complex_of(scene);
  const auto around = [&](const std::vector<VertexId>& vertices) {
    Box3 box;
    for (const VertexId v : vertices) {
      const RationalPoint3 p = exact(c.points(), c.vertex_point[v.value()]);
      box.add(box_at(nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)));
    }
    return box;
  };
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    EXPECT_EQ(box_of(c, EdgeId(e)), around({c.origin[2 * e], c.origin[2 * e + 1]}));
  }
  for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
    std::vector<VertexId> corners;
    for (std::uint32_t u = 0; u < c.use_count(); ++u) {
      if (c.use_facet[u] == FacetId(f)) corners.push_back(c.use_origin(UseId(u)));
    }
    EXPECT_EQ(box_of(c, FacetId(f)), around(corners));
  }
  EXPECT_EQ(box_of(c), (Box3{{-5, -6, -7}, {9, 7, 50}}));
}

/// A coordinate that R moves is beyond all numbers; another one is where it is without R.
TEST(SpaceBoxes, OfPointsOfTheFrame) {
  SpaceScene scene;
  testing::add_slabs(scene, {-2, 5}, 0);
  const SpaceComplex finite = testing::complex_of(scene);
  const SpaceComplex c = testing::framed(finite);
  int near = 0;
  for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
    const auto at = coordinates(exact(finite.points(), finite.vertex_point[v]));
    const Box3 box = box_of(c, VertexId(v));
    for (std::size_t i = 0; i < 3; ++i) {
      if (at[i] == testing::kFar) {
        EXPECT_EQ(box.high[i], kInfinity);
        EXPECT_EQ(box.low[i], std::numeric_limits<double>::max());
      } else if (at[i] == -testing::kFar) {
        EXPECT_EQ(box.low[i], -kInfinity);
        EXPECT_EQ(box.high[i], std::numeric_limits<double>::lowest());
      } else {
        EXPECT_LE(exact_rational(box.low[i]), at[i]);
        EXPECT_GE(exact_rational(box.high[i]), at[i]);
        EXPECT_LT(box.high[i] - box.low[i], 1);
        ++near;
      }
    }
  }
  EXPECT_EQ(near, 8);
}

double product(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

TEST(SpaceBoxes, PrincipalAxesAreEigenvectors) {
  Dice dice(2);
  std::vector<Matrix3> matrices = {{}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  matrices.push_back({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}});
  matrices.push_back({{{0, 0, 5}, {0, 0, 0}, {5, 0, 0}}});
  for (int i = 0; i < 40; ++i) {
    Matrix3 m{};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k <= j; ++k) {
        m[j][k] = m[k][j] = static_cast<double>(dice.between(-100, 100));
      }
    }
    matrices.push_back(m);
  }
  for (const Matrix3& m : matrices) {
    const Matrix3 axes = principal_axes(m);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_NEAR(product(axes[i], axes[j]), i == j ? 1 : 0, 1e-14);
        const Vector3 image{product(m[0], axes[j]), product(m[1], axes[j]), product(m[2], axes[j])};
        if (i != j) {
          EXPECT_NEAR(product(axes[i], image), 0, 1e-11);
        }
      }
    }
  }
  const Matrix3 axes = principal_axes({{{1, kInfinity, 0}, {kInfinity, 1, 0}, {0, 0, 1}}});
  EXPECT_EQ(axes, (Matrix3{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
}

/// Boxes that meet in one point meet in any frame; parallel edges along a diagonal come apart.
TEST(SpaceBoxes, TurnedBoxesStayLargeEnough) {
  Dice dice(3);
  SpaceScene scene;
  for (const int x : {0, 1}) scene.add_free_edge({x, 0, 0}, {x + 60, 61, 59});
  const SpaceComplex c = testing::complex_of(scene);
  const std::array<const SpaceComplex*, 1> all{&c};
  const BoxFrame frame = BoxFrame::of_edges(all);
  EXPECT_TRUE(box_of(c, EdgeId(0)).meets(box_of(c, EdgeId(1))));
  EXPECT_FALSE(frame.box_of(c, EdgeId(0)).meets(frame.box_of(c, EdgeId(1))));
  const auto number = [&] { return 0.1 * static_cast<double>(dice.between(-30, 30)); };
  for (int i = 0; i < 300; ++i) {
    const double x = number(), y = number(), z = number(), side = 0.1 * (i % 4);
    const Box3 low = {{x - side, y - side, z - side}, {x, y, z}};
    const Box3 high = {{x, y, z}, {x + side, y + 2 * side, z + 3 * side}};
    EXPECT_TRUE(frame.turned(low).meets(frame.turned(high)));
    EXPECT_EQ(BoxFrame().turned(low), low);
  }
  const Box3 unknown = frame.turned({{0, 0, -kInfinity}, {1, 1, kInfinity}});
  EXPECT_EQ(unknown.high[0] - unknown.low[0], kInfinity);
}

TEST(SpaceBoxes, ExpectedPairsAreOfRandomPlaces) {
  const std::vector<Box3> one = {box_at(0, 0, 0, 1)};
  const std::vector<Box3> two = {box_at(0, 0, 0, 1), box_at(3, 3, 3, 1)};
  EXPECT_DOUBLE_EQ(expected_pairs(one, one), 1);
  EXPECT_DOUBLE_EQ(expected_pairs(two, one), 0.25);  // 2 pairs, each axis 2 of 4
  EXPECT_DOUBLE_EQ(expected_pairs(one, two), 0.25);
  const std::vector<Box3> unknown = {box_of(PointBox{{0, 0, 0}, kInfinity})};
  EXPECT_FALSE(std::isfinite(expected_pairs(two, unknown)));
  EXPECT_FALSE(has_many_pairs(kInfinity, 1));
  EXPECT_TRUE(has_many_pairs(9e6, 1000000) && !has_many_pairs(7e6, 1000000));
  EXPECT_TRUE(is_better_frame(24, 100) && !is_better_frame(26, 100));
}

}  // namespace
}  // namespace plumb::space_boxes_test
