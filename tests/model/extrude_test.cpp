// Extrusions: points of the solid lie over points of the outline; volumes in closed form.
#include "plumb/model/extrude.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "generate/plane_families.h"
#include "generate/test_share.h"
#include "plumb/model/primitives.h"
#include "plumb/model/slice.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::extrude_test {
namespace {

Nef2 box(double x, double y, double to_x, double to_y, Boundary boundary = Boundary::Closed) {
  const std::vector<Point2> corners{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}};
  return Nef2::polygon(corners, boundary);
}
double volume(const Nef3& set) { return nearest_double(set.volume().value()); }

std::vector<Nef2> outlines() {
  const Nef2 ring = box(0, 0, 4, 4) - box(1, 1, 3, 3, Boundary::Open);
  return {
      box(0, 0, 2, 3),
      ring,
      box(0, 0, 1, 1) + box(1, 1, 2, 2),
      ring + box(1.5, 1.5, 2, 2) + Nef2::polyline(std::vector<Point2>{{4, 4}, {6, 5}}),
      ring - Nef2::polygon(std::vector<Point2>{{0, 0}, {1, 0.5}, {0.5, 1}}, Boundary::Open),
      box(0, 0, 3, 3).transformed({Rational(1) / 3, 1, 0, 0, Rational(1) / 7, 2}),
  };
}

TEST(Extrusion, StraightIsExact) {
  for (const Nef2& outline : outlines()) {
    const Nef3 solid = linear_extrusion(outline, {.height = 2, .centred = true});
    EXPECT_FALSE(solid.audit());
    EXPECT_TRUE(solid.is_closed());
    EXPECT_EQ(solid.volume(), 2 * outline.area().value());
    const Nef2 regular = outline.regularization();
    for (const Rational& height : {Rational(-1), Rational(1) / 3, Rational(1)}) {
      EXPECT_EQ(slice(solid, height), regular);
    }
    EXPECT_TRUE(slice(solid, Rational(5) / 4).is_empty());
    EXPECT_EQ(shadow(solid), regular);
  }
}

TEST(Extrusion, OfRandomPolygons) {
  for (std::uint64_t seed = 0; seed < share_of(40); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef2 outline = Nef2::polygon(lattice_polygon(dice, 3 + dice.below(12), 7));
    const Nef3 solid = linear_extrusion(outline, {.height = 3});
    EXPECT_EQ(solid.volume(), 3 * outline.area().value());
    EXPECT_EQ(slice(solid, 1), outline);
    const Nef3 twisted = linear_extrusion(outline, {.height = 3, .twist = 20, .slices = 4});
    EXPECT_FALSE(twisted.audit());
    EXPECT_NEAR(volume(twisted), 3 * nearest_double(outline.area().value()), 0.1 * volume(twisted));
  }
}

TEST(Extrusion, ScaledIsAFrustum) {
  const Nef2 square = rectangle({2, 2}, Placement::Centred);
  EXPECT_EQ(linear_extrusion(square, {.height = 3, .scale = {0, 0}}).volume(), Rational(4));
  EXPECT_EQ(linear_extrusion(square, {.height = 3, .scale = {0.5, 0.5}}).volume(), Rational(7));
  EXPECT_EQ(linear_extrusion(square, {.height = 3, .scale = {0, 1}}).volume(), Rational(6));
}

TEST(Extrusion, ATwistTurnsTheTopClockwise) {
  const Nef2 bar = box(0, 0, 4, 1);
  const Nef3 solid = linear_extrusion(bar, {.height = 1, .twist = 90, .slices = 1});
  EXPECT_EQ(slice(solid, 1), box(0, -4, 1, 0));
}

/// Pappus: area times the way of the centroid, for the polygon that the turn is.
TEST(Extrusion, ATurnHasItsVolume) {
  const Nef2 square = box(2, 0, 3, 1);
  for (const std::uint32_t steps : {3U, 4U, 24U}) {
    const double ring = steps / 2. * std::sin(2 * std::numbers::pi / steps) * (9 - 4);
    const Nef3 full = rotational_extrusion(square, 360, steps);
    EXPECT_FALSE(full.audit());
    EXPECT_TRUE(full.is_simple());
    EXPECT_NEAR(volume(full), ring, 1e-12);
    EXPECT_NEAR(volume(rotational_extrusion(square, -360, steps)), ring, 1e-12);
    const double quarter = steps / 2. * std::sin(std::numbers::pi / 2 / steps) * 5;
    const Nef3 left = rotational_extrusion(square, 90, steps);
    EXPECT_NEAR(volume(left), quarter, 1e-12);
    EXPECT_TRUE(left.contains(Point3{2.5, 0, 0.5}));
    EXPECT_TRUE(left.contains(Point3{0, 2.5, 0.5}));
    const Nef3 right = rotational_extrusion(square, -90, steps);
    EXPECT_NEAR(volume(right), quarter, 1e-12);
    EXPECT_TRUE(right.contains(Point3{0, -2.5, 0.5}));
    EXPECT_FALSE(right.contains(Point3{0, 2.5, 0.5}));
  }
  // An outline on the left of the axis, and one that touches the axis: a double cone.
  const Nef2 mirrored = box(-3, 0, -2, 1);
  EXPECT_NEAR(volume(rotational_extrusion(mirrored, 360, 24)),
              volume(rotational_extrusion(square, 360, 24)), 1e-12);
  EXPECT_NEAR(volume(rotational_extrusion(mirrored, 90, 24)),
              volume(rotational_extrusion(square, 90, 24)), 1e-12);
  const Nef2 triangle = Nef2::polygon(std::vector<Point2>{{0, -1}, {1, 0}, {0, 1}});
  EXPECT_EQ(rotational_extrusion(triangle, 360, 4).volume(), Rational(4) / 3);
}

/// Volumes that OpenSCAD 2021.01 gives for the same extrusions, to the six digits of its files: its
/// layers, diagonals and steps.
TEST(Extrusion, AgreesWithOpenSCAD) {
  const Nef2 plate = box(0, 0, 4, 2) - box(1, 0.5, 2, 1.5, Boundary::Open);
  const auto twisted = [](const Nef2& outline, double twist, std::uint32_t slices) {
    return volume(linear_extrusion(outline, {.height = 3, .twist = twist, .slices = slices}));
  };
  EXPECT_NEAR(twisted(plate, 60, 4), 23.34967, 1e-4);
  EXPECT_NEAR(twisted(plate, -60, 4), 23.34966, 1e-4);
  EXPECT_NEAR(twisted(box(1, 1, 5, 3), 60, 4), 23.72741, 1e-4);
  const Nef2 triangle = Nef2::polygon(std::vector<Point2>{{1, 0}, {3, 0}, {2, 2}});
  EXPECT_NEAR(twisted(triangle, -60, 1), 5.86603, 1e-4);
  EXPECT_NEAR(twisted(triangle, 60, 1), 5.86603, 1e-4);
  const LinearExtrusion narrowed{.height = 3, .twist = 60, .slices = 4, .scale = {1.5, 0.5}};
  EXPECT_NEAR(volume(linear_extrusion(plate, narrowed)), 19.85260, 1e-4);
  // Towards a segment, it takes the longer diagonals.
  const LinearExtrusion wedge{.height = 5, .slices = 1, .scale = {0, 2}};
  EXPECT_NEAR(volume(linear_extrusion(disk(5, 16), wedge)), 271.69836, 1e-4);
  EXPECT_TRUE(linear_extrusion(disk(5, 16), wedge).contains(Point3{0, 10, 5}));
  const Nef2 tip = Nef2::polygon(std::vector<Point2>{{2, 0}, {4, 0}, {3, 2}});
  EXPECT_NEAR(volume(rotational_extrusion(tip, 200, 5)), 19.28360, 1e-4);
  EXPECT_NEAR(volume(rotational_extrusion(tip, 360, 7)), 32.83693, 1e-4);
}

TEST(Extrusion, RefusesWhatItCannotDo) {
  const Nef2 square = box(0, 0, 1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(linear_extrusion(square, {.height = 0})), Error);
  EXPECT_THROW(static_cast<void>(linear_extrusion(square, {.height = nan})), Error);
  EXPECT_THROW(static_cast<void>(linear_extrusion(square, {.slices = 0})), Error);
  EXPECT_THROW(static_cast<void>(linear_extrusion(!square, {})), Error);
  EXPECT_THROW(static_cast<void>(rotational_extrusion(box(-1, 0, 1, 1), 360, 8)), Error);
  EXPECT_THROW(static_cast<void>(rotational_extrusion(square, 360, 2)), Error);
  EXPECT_THROW(static_cast<void>(rotational_extrusion(square, 270, 1)), Error);
  EXPECT_THROW(static_cast<void>(rotational_extrusion(square, -180, 1)), Error);
  EXPECT_THROW(static_cast<void>(rotational_extrusion(square, 90, 0)), Error);
  EXPECT_TRUE(linear_extrusion(Nef2::point({1, 1}), {}).is_empty());
  EXPECT_TRUE(rotational_extrusion(square, 0, 8).is_empty());
}

}  // namespace
}  // namespace plumb::testing::extrude_test
