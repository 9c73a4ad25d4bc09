// Affine maps: rotations are orthogonal exactly and turn by the angle asked for.
#include "plumb/model/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plumb/model/primitives.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb::testing::transform_test {
namespace {

using Row = std::array<Rational, 3>;

void expect_orthogonal(const AffineMap3& map) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_EQ(dot(map.matrix[i], map.matrix[j]), Rational(i == j ? 1 : 0));
    }
  }
}

TEST(Transform, RotationsAreOrthogonal) {
  for (const double degrees : {0., 1e-9, 10., 33.3, 90., 179.999, 180., 181., 359., -45., 1000.}) {
    const AffineMap3 map = rotation({1, -2, 0.5}, degrees);
    expect_orthogonal(map);
    EXPECT_EQ(determinant(map), Rational(1));
    const Rational trace = map.matrix[0][0] + map.matrix[1][1] + map.matrix[2][2];
    EXPECT_NEAR(nearest_double(trace), 1 + 2 * std::cos(degrees * std::numbers::pi / 180), 1e-14);
  }
}

TEST(Transform, QuarterTurnsAreExact) {
  const AffineMap3 z = rotation({0, 0, 2}, 90);
  EXPECT_EQ(z.matrix, (std::array<Row, 3>{Row{0, -1, 0}, Row{1, 0, 0}, Row{0, 0, 1}}));
  const AffineMap3 x = rotation({1, 0, 0}, -90);
  EXPECT_EQ(x.matrix, (std::array<Row, 3>{Row{1, 0, 0}, Row{0, 0, 1}, Row{0, -1, 0}}));
  EXPECT_EQ(composed(z, composed(z, composed(z, z))).matrix, rotation({0, 0, 1}, 0).matrix);
}

TEST(Transform, ReflectionsComposedAreTheIdentity) {
  const AffineMap3 map = reflection({1, 2, 3});
  expect_orthogonal(map);
  EXPECT_EQ(determinant(map), Rational(-1));
  EXPECT_EQ(composed(map, map).matrix, translation({0, 0, 0}).matrix);
  EXPECT_THROW(static_cast<void>(reflection({0, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(rotation({0, 0, 0}, 1)), Error);
}

TEST(Transform, ComposesInOrder) {
  const AffineMap3 map = composed(translation({1, 2, 3}), scaling({2, 3, 4}));
  const Nef3 box = Nef3::from_mesh(box_mesh({1, 1, 1}, Placement::Corner)).transformed(map);
  const auto bounds = bounding_box(box);
  EXPECT_EQ(bounds->low, (RationalPoint3{1, 2, 3}));
  EXPECT_EQ(bounds->high, (RationalPoint3{3, 5, 7}));
  EXPECT_EQ(box.volume(), determinant(map));
}

TEST(Transform, ResizesToABox) {
  const Nef3 box = Nef3::from_mesh(box_mesh({2, 4, 8}, Placement::Corner));
  const auto size_after = [&](const Row& size, const std::array<bool, 3>& automatic) {
    const Nef3 resized = box.transformed(resizing(*bounding_box(box), size, automatic));
    return bounding_box(resized)->high;
  };
  EXPECT_EQ(size_after({1, 1, 1}, {}), (RationalPoint3{1, 1, 1}));
  EXPECT_EQ(size_after({1, 0, 0}, {}), (RationalPoint3{1, 4, 8}));
  EXPECT_EQ(size_after({1, 0, 0}, {true, true, true}), (RationalPoint3{1, 2, 4}));
  EXPECT_THROW(static_cast<void>(resizing(*bounding_box(box), {-1, 1, 1})), Error);
}

TEST(Transform, BoundingBoxes) {
  EXPECT_FALSE(bounding_box(Nef3::empty()));
  EXPECT_THROW(static_cast<void>(bounding_box(Nef3::whole())), Error);
  const auto point = bounding_box(Nef3::point({Rational(1) / 3, 2, 3}));
  EXPECT_EQ(point->low, point->high);
}

}  // namespace
}  // namespace plumb::testing::transform_test
