// Offsets of solids against distances: a point of an offset is near the set, and a point of the set
// that stays is far from the complement.
#include "plumb/model/solid_offset.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "generate/test_share.h"
#include "plumb/convex/minkowski.h"
#include "plumb/model/distance.h"
#include "plumb/model/primitives.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::solid_offset_test {
namespace {

Nef3 box(double x, double y, double z) {
  return Nef3::from_mesh(box_mesh({x, y, z}, Placement::Corner));
}

Rational square(const Rational& x) { return x * x; }

/// Corners, middles of pairs of corners, and random points.
std::vector<RationalPoint3> samples(const Nef3& set, Dice& dice) {
  std::vector<RationalPoint3> points;
  const SpaceComplex& c = set.complex();
  for (const SpacePoint p : c.vertex_point) points.push_back(exact(c.points(), p));
  for (std::size_t i = points.size(); i-- > 0;) {
    const RationalPoint3 &p = points[i], &q = points[(7 * i + 1) % points.size()];
    points.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
  }
  for (int i = 0; i < 60; ++i) {
    const auto coordinate = [&dice] { return Rational(dice.between(-40, 80)) / 16; };
    points.push_back({coordinate(), coordinate(), coordinate()});
  }
  return points;
}

/// Returns the square of a distance, enlarged because the corners of a ball are rounded.
Rational outer_square(double by) { return square(exact_rational(by) * (1 + Rational(0x1p-50))); }

/// Every point of the result is within the distance of the set, and every point within the inner
/// radius belongs to the result.
void expect_grown(const Nef3& set, double by, unsigned rounds, Dice& dice) {
  const Nef3 grown = offset(set, by, {rounds});
  EXPECT_FALSE(grown.audit());
  EXPECT_TRUE(grown.is_closed());
  const Rational outer = outer_square(by);
  const Rational inner = square(exact_rational(by) * exact_rational(inner_radius(rounds)));
  const DistanceIndex index(set);
  for (const RationalPoint3& p : samples(grown, dice)) {
    const Rational squared = index.to(p).squared;
    if (squared > outer) {
      EXPECT_FALSE(grown.contains(p));
    }
    if (squared <= inner) {
      EXPECT_TRUE(grown.contains(p));
    }
  }
}

void expect_shrunk(const Nef3& set, double by, unsigned rounds, Dice& dice) {
  const Nef3 shrunk = offset(set, -by, {rounds});
  EXPECT_FALSE(shrunk.audit());
  EXPECT_TRUE(shrunk.is_closed());
  EXPECT_EQ(shrunk, minkowski_erosion(set.closure(), polyhedral_ball(by, rounds)));
  const Rational outer = outer_square(by);
  const Rational inner = square(exact_rational(by) * exact_rational(inner_radius(rounds)));
  const Nef3 room = box(100, 100, 100).translated({-50, -50, -50});
  const DistanceIndex outside(room - set.closure());
  for (const RationalPoint3& p : samples(shrunk, dice)) {
    const Rational squared = outside.to(p).squared;
    if (squared < inner) {
      EXPECT_FALSE(shrunk.contains(p));
    }
    if (squared >= outer) {
      EXPECT_TRUE(shrunk.contains(p));
    }
  }
}

std::vector<Nef3> sets() {
  const Nef3 cube = box(2, 2, 2), dent = cube - box(1, 1, 1);
  const std::vector<Point3> triangle{{0, 0, 0}, {2, 0, 1}, {0, 1, 2}};
  return {cube,
          dent,
          dent.interior(),
          cube - box(0.5, 0.5, 3).translated({Rational(3) / 4, Rational(3) / 4, -1}),
          Nef3::facet(triangle),
          Nef3::segment({0, 0, 0}, {2, 1, 2}) + Nef3::point({3, 0, 1}),
          cube + cube.translated({2, 2, 2})};
}

TEST(SolidOffset, GrowsByADistance) {
  Dice dice(1);
  for (const Nef3& set : sets()) {
    expect_grown(set, 0.5, 0, dice);
    expect_grown(set, 0.75, 1, dice);
  }
  expect_grown(box(2, 2, 2), 1, 2, dice);
}

TEST(SolidOffset, ShrinksByADistance) {
  Dice dice(2);
  for (const Nef3& set : sets()) {
    expect_shrunk(set, 0.25, 0, dice);
    expect_shrunk(set, 0.125, 1, dice);
  }
  expect_shrunk(box(2, 2, 2), 0.5, 2, dice);
}

// A slab whose thickness is twice the distance shrinks to a facet, a cube to a point.
TEST(SolidOffset, KeepsWhatIsJustThickEnough) {
  const Nef3 slab = offset(box(4, 4, 1), -0.5, {0});
  EXPECT_TRUE(slab.contains(RationalPoint3{2, 2, Rational(1) / 2}));
  EXPECT_EQ(slab.volume(), Rational(0));
  EXPECT_EQ(offset(box(1, 1, 1), -0.5, {0}),
            Nef3::point({Rational(1) / 2, Rational(1) / 2, Rational(1) / 2}));
  EXPECT_TRUE(offset(box(1, 1, 1), -0.75, {0}).is_empty());
}

TEST(SolidOffset, OfUnboundedSets) {
  const Nef3 hole = box(2, 2, 2).interior().complement();
  const Nef3 shrunk = offset(hole, -1, {1});
  EXPECT_EQ(shrunk.complement(), offset(box(2, 2, 2), 1, {1}).interior());
  EXPECT_THROW(static_cast<void>(offset(hole, 1)), Error);
  EXPECT_TRUE(offset(Nef3::whole(), 1).is_whole());
  EXPECT_TRUE(offset(Nef3(), 1).is_empty());
}

TEST(SolidOffset, HasRadiiThatAreTrue) {
  for (unsigned rounds = 0; rounds <= 4; ++rounds) {
    const Nef3 surface = polyhedral_ball(1, rounds).boundary();
    const Rational squared = distance(surface, RationalPoint3{0, 0, 0}).squared;
    const Rational claimed = exact_rational(inner_radius(rounds));
    EXPECT_GE(squared, claimed * claimed);
    EXPECT_LT(root_of(squared), inner_radius(rounds) + 2e-6);
  }
}

TEST(SolidOffset, RefusesBadOptions) {
  EXPECT_THROW(static_cast<void>(offset(box(1, 1, 1), 1, {8})), Error);
  EXPECT_THROW(static_cast<void>(offset(box(1, 1, 1), std::numeric_limits<double>::infinity())),
               Error);
  EXPECT_EQ(offset(box(1, 1, 1).interior(), 0), box(1, 1, 1));
}

}  // namespace
}  // namespace plumb::testing::solid_offset_test
