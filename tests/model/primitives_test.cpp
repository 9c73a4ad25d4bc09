// Primitives: closed meshes of the right volume, in the right place.
#include "plumb/model/primitives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "plumb/model/transform.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/nef3.h"

namespace plumb::testing::primitives_test {
namespace {

Nef3 solid(const PolygonMesh& mesh) {
  Nef3 set = Nef3::from_mesh(mesh, {.rule = WindingRule::Positive});
  EXPECT_FALSE(set.audit());
  EXPECT_TRUE(set.is_simple());
  return set;
}
double volume(const Nef3& set) { return nearest_double(set.volume().value()); }
/// The area of a regular polygon in a circle of radius 1.
double polygon_area(double chords) { return chords / 2 * std::sin(2 * std::numbers::pi / chords); }

TEST(Primitives, BoxesAreExact) {
  const Nef3 box = solid(box_mesh({2, 3, 4}, Placement::Corner));
  EXPECT_EQ(box.volume(), Rational(24));
  EXPECT_TRUE(box.contains(Point3{0, 0, 0}));
  const auto centred = bounding_box(solid(box_mesh({2, 3, 4}, Placement::Centred)));
  EXPECT_EQ(centred->low, (RationalPoint3{-1, Rational(-3) / 2, -2}));
  EXPECT_EQ(centred->high, (RationalPoint3{1, Rational(3) / 2, 2}));
}

TEST(Primitives, CylindersHaveTheirVolumes) {
  for (const std::uint32_t chords : {3U, 7U, 24U}) {
    const double area = polygon_area(chords);
    EXPECT_NEAR(volume(solid(cylinder_mesh(5, 2, 2, chords, Placement::Corner))), 5 * 4 * area,
                1e-12);
    EXPECT_NEAR(volume(solid(cylinder_mesh(3, 2, 0, chords, Placement::Centred))), 4 * area, 1e-12);
    EXPECT_NEAR(volume(solid(cylinder_mesh(3, 1, 2, chords, Placement::Corner))), 7 * area, 1e-12);
    EXPECT_TRUE(solid(cylinder_mesh(3, 1, 2, chords, Placement::Corner)).is_convex());
    EXPECT_TRUE(solid(cylinder_mesh(3, 2, 2, chords, Placement::Corner)).is_convex());
  }
}

/// A ball of rings is a stack of frustums.
TEST(Primitives, SpheresHaveTheirVolumes) {
  for (const std::uint32_t chords : {3U, 5U, 8U, 31U}) {
    const std::uint32_t rings = (chords + 1) / 2;
    double expected = 0;
    for (std::uint32_t i = 0; i + 1 < rings; ++i) {
      const double a = std::numbers::pi * (i + 0.5) / rings;
      const double b = std::numbers::pi * (i + 1.5) / rings;
      const double r = std::sin(a), s = std::sin(b);
      expected += (std::cos(a) - std::cos(b)) * (r * r + r * s + s * s) / 3;
    }
    expected *= polygon_area(chords);
    EXPECT_NEAR(volume(solid(sphere_mesh(3, chords))), 27 * expected, 1e-11) << chords;
  }
}

TEST(Primitives, ATorusHasItsVolume) {
  const Nef3 torus = solid(torus_mesh(3, 1, 60, 40));
  EXPECT_NEAR(volume(torus), 2 * std::numbers::pi * std::numbers::pi * 3, 0.5);
}

TEST(Primitives, OfThePlane) {
  EXPECT_EQ(rectangle({2, 3}, Placement::Centred).area(), Rational(6));
  EXPECT_EQ(disk(2, 4).area(), Rational(8));
  EXPECT_EQ(disk(1, 12).counts().vertices, 12U);
}

TEST(Primitives, AnglesAreExactWhereTheyCanBe) {
  EXPECT_EQ(sine_of_degrees(30), 0.5);
  EXPECT_EQ(sine_of_degrees(-150), -0.5);
  EXPECT_EQ(cosine_of_degrees(60), 0.5);
  EXPECT_EQ(cosine_of_degrees(120), -0.5);
  EXPECT_EQ(cosine_of_degrees(90), 0);
  EXPECT_EQ(sine_of_degrees(180), 0);
  EXPECT_EQ(sine_of_degrees(45), cosine_of_degrees(45));
  EXPECT_EQ(sine_of_degrees(720 + 90), 1);
  for (int angle = -400; angle <= 400; ++angle) {
    const double radians = angle * std::numbers::pi / 180;
    EXPECT_NEAR(sine_of_degrees(angle), std::sin(radians), 1e-14);
    EXPECT_NEAR(cosine_of_degrees(angle), std::cos(radians), 1e-14);
    EXPECT_EQ(sine_of_degrees(angle), -sine_of_degrees(-angle));
    EXPECT_EQ(cosine_of_degrees(angle), cosine_of_degrees(-angle));
  }
}

TEST(Primitives, CirclesAreDividedAsInOpenSCAD) {
  EXPECT_EQ(chords_of(10, {.count = 7.9}), 7U);
  EXPECT_EQ(chords_of(10, {.count = 1}), 3U);
  EXPECT_EQ(chords_of(10, {}), 30U);
  EXPECT_EQ(chords_of(1, {}), 5U);
  EXPECT_EQ(chords_of(5, {}), 16U);  // ceil(2 pi 5 / 2)
  EXPECT_EQ(chords_of(1e-9, {.count = 100}), 3U);
  EXPECT_THROW(static_cast<void>(chords_of(1, {.count = 1e9})), Error);
}

TEST(Primitives, RefusesWrongSizes) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(box_mesh({1, 0, 1}, Placement::Corner)), Error);
  EXPECT_THROW(static_cast<void>(box_mesh({1, nan, 1}, Placement::Corner)), Error);
  EXPECT_THROW(static_cast<void>(box_mesh({0x1p-1074, 1, 1}, Placement::Centred)), Error);
  EXPECT_THROW(static_cast<void>(torus_mesh(2, 1, 1U << 20U, 1U << 20U)), Error);
  EXPECT_THROW(static_cast<void>(sphere_mesh(1, 1U << 21U)), Error);
  EXPECT_THROW(static_cast<void>(sphere_mesh(-1, 8)), Error);
  EXPECT_THROW(static_cast<void>(sphere_mesh(1, 2)), Error);
  EXPECT_THROW(static_cast<void>(cylinder_mesh(1, 0, 0, 8, Placement::Corner)), Error);
  EXPECT_THROW(static_cast<void>(torus_mesh(1, 1, 8, 8)), Error);
  EXPECT_THROW(static_cast<void>(disk(0, 8)), Error);
}

}  // namespace
}  // namespace plumb::testing::primitives_test
