// Slices and shadows: a point of the plane belongs to a slice if the point above it belongs to the
// set, and to a shadow if a vertical line through it meets the set.
#include "plumb/model/slice.h"

#include <gtest/gtest.h>

#include <vector>

#include "generate/space_program.h"
#include "generate/test_share.h"
#include "oracle/nef3_check.h"
#include "plumb/model/primitives.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::slice_test {
namespace {

Nef3 box(double x, double y, double z) {
  return Nef3::from_mesh(box_mesh({x, y, z}, Placement::Corner));
}

std::vector<RationalPoint2> samples(const Nef2& set) {
  std::vector<RationalPoint2> points;
  const PlaneComplex& c = set.complex();
  for (const std::uint32_t p : c.vertex_point) points.push_back(exact(c.points, p));
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const RationalPoint2& p = points[i];
    const RationalPoint2& q = points[(i * 7 + 1) % n];
    points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
  }
  for (int x = -1; x <= 4; ++x) {
    for (int y = -1; y <= 4; ++y) {
      points.push_back({Rational(x) / 2, Rational(y) / 2});
      points.push_back({1000 * x - 1500, 1000 * y - 1700});
    }
  }
  return points;
}

void expect_slice(const Nef3& set, const Rational& height) {
  const Nef2 flat = slice(set, height);
  EXPECT_FALSE(flat.audit());
  for (const RationalPoint2& p : samples(flat)) {
    ASSERT_EQ(flat.contains(p), set.contains(RationalPoint3{p.x, p.y, height}));
  }
}

/// Whether the vertical line through p meets the closure of the set.
bool is_shaded(const Nef3& set, const RationalPoint2& p) {
  return !(set.closure() * Nef3::segment({p.x, p.y, -100}, {p.x, p.y, 100})).is_empty();
}

void expect_shadow(const Nef3& set) {
  const Nef2 flat = shadow(set);
  EXPECT_FALSE(flat.audit());
  EXPECT_TRUE(flat.is_closed());
  for (const RationalPoint2& p : samples(flat)) ASSERT_EQ(flat.contains(p), is_shaded(set, p));
}

std::vector<Nef3> sets() {
  const Nef3 cube = box(2, 2, 2);
  const Nef3 dent = cube - box(1, 1, 1);
  const std::vector<Point3> triangle{{0, 0, 0}, {1, 0, 1}, {0, 1, 2}};
  const std::vector<Point3> wall{{0, 0, 0}, {2, 2, 0}, {2, 2, 1}};
  return {cube,
          cube.interior(),
          dent,
          dent + Nef3::facet(triangle).translated({2, 0, 0}) + Nef3::facet(wall),
          Nef3::segment({0, 0, 0}, {2, 1, 2}) + Nef3::point({1, 0, 1}),
          cube - Nef3::segment({0, 0, 0}, {2, 2, 2}),
          Nef3::facet(triangle) - Nef3::point({0, 0, 0}),
          Nef3::from_mesh(sphere_mesh(1.5, 10)) - Nef3::from_mesh(sphere_mesh(1, 8))};
}

TEST(Slice, OfSets) {
  for (const Nef3& set : sets()) {
    for (const int height : {0, 1, 2}) expect_slice(set, height);
    expect_slice(set, Rational(1) / 3);
    expect_slice(set, Rational(-7) / 5);
  }
}

TEST(Slice, OfRandomSets) {
  for (std::uint64_t seed = 0; seed < share_of(60); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef3 set =
        to_nef(*space_set_of_program(random_space_program(dice, ProgramValues::Plain, 6), 9)) *
        box(3, 3, 3);
    expect_slice(set, 0);
    expect_slice(set, 1);
    expect_slice(set, Rational(1) / 2);
    expect_shadow(set);
  }
}

TEST(Slice, Several) {
  const std::vector<Rational> heights{0, 1, 3};
  const std::vector<Nef2> layers = slices(box(2, 2, 2), heights);
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0], layers[1]);
  EXPECT_TRUE(layers[2].is_empty());
}

TEST(Slice, SeveralOfUnboundedSets) {
  // A stack through an open wedge without a box and with a line: below, at, and above each of them.
  const Nef3 wedge = Nef3::half_space({1, 0, 1, -5}, Boundary::Open) *
                     Nef3::half_space({-1, 2, 1, -5}, Boundary::Closed);
  const Nef3 line = Nef3::plane({1, 1, 0, -1}) * Nef3::plane({0, 0, 1, -1});
  const Nef3 set = (wedge - box(2, 2, 2)) + line;
  const std::vector<Rational> heights{-100, 0, 1, 2, 5, Rational(11) / 2, 1000};
  const std::vector<Nef2> layers = slices(set, heights);
  ASSERT_EQ(layers.size(), heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    SCOPED_TRACE(heights[i].str());
    EXPECT_EQ(layers[i], slice(set, heights[i]));
    EXPECT_FALSE(layers[i].is_bounded());
    EXPECT_EQ(slices(set.complement(), heights)[i], layers[i].complement());
  }
  EXPECT_FALSE(layers[0].is_open());  // The wedge is closed on one side.
  EXPECT_TRUE(layers[2].contains(RationalPoint2{1, 0}));
}

TEST(Shadow, OfSets) {
  for (const Nef3& set : sets()) expect_shadow(set);
  EXPECT_TRUE(shadow(Nef3::empty()).is_empty());
}

TEST(Slice, OfUnboundedSets) {
  EXPECT_TRUE(slice(Nef3::whole(), 3).is_whole());
  const Nef3 below = Nef3::half_space({1, 2, 3, 4}, Boundary::Open);
  EXPECT_EQ(slice(below, -1), Nef2::half_plane(Line2::from_coefficients(1, 2, 1), Boundary::Open));
  const Nef3 floor = Nef3::half_space({0, 0, 1, 0}, Boundary::Closed);
  EXPECT_TRUE(slice(floor, 0).is_whole());
  EXPECT_TRUE(slice(floor, 1).is_empty());
  EXPECT_TRUE(slice(floor.interior(), 0).is_empty());
  const Nef3 holed = floor - Nef3::point({1, 2, 0});
  EXPECT_EQ(slice(holed, 0), Nef2::whole() - Nef2::point({1, 2}));
  const Nef3 outside = box(2, 2, 2).complement();
  EXPECT_EQ(slice(outside, 1), slice(box(2, 2, 2), 1).complement());
  const Nef3 line = Nef3::plane({1, 1, 0, -1}) * floor;
  EXPECT_EQ(slice(line, 0), Nef2::line({{1, 0}, {0, 1}}));
}

TEST(Slice, OfRandomUnboundedSets) {
  std::size_t unbounded = 0;
  for (std::uint64_t seed = 0; seed < share_of(150); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef3 set =
        to_nef(*space_set_of_program(random_space_program(dice, ProgramValues::Plain, 6), 9));
    for (const Rational& height : {Rational(0), Rational(1), Rational(1) / 3, Rational(-20)}) {
      expect_slice(set, height);
      const Nef2 flat = slice(set, height);
      if (!flat.is_bounded()) ++unbounded;
      EXPECT_EQ(slice(set.complement(), height), flat.complement());
    }
  }
  EXPECT_GT(unbounded, share_of(150) / 4);
}

TEST(Shadow, RefusesUnboundedSets) {
  EXPECT_THROW(static_cast<void>(shadow(Nef3::whole())), Error);
}

}  // namespace
}  // namespace plumb::testing::slice_test
