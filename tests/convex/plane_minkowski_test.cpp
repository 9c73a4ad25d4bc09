// Minkowski sums of sets of the plane: p lies in A + B if and only if A meets p - B, which the
// Boolean of the plane decides.
#include "plumb/convex/plane_minkowski.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "generate/plane_families.h"
#include "generate/plane_program.h"
#include "generate/test_share.h"
#include "oracle/plane_set.h"
#include "oracle/plane_sum_check.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::plane_minkowski_test {
namespace {

using Points = std::vector<Point2>;

Nef2 polygon(const Points& points) { return Nef2::polygon(points); }
Nef2 box(double x, double y, double to_x, double to_y, Boundary boundary = Boundary::Closed) {
  const Points corners{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}};
  return Nef2::polygon(corners, boundary);
}
Nef2 segment(Point2 a, Point2 b) { return Nef2::polyline(Points{a, b}); }

void expect_sum(const Nef2& a, const Nef2& b) { EXPECT_EQ(flaw_of_sum(a, b), ""); }

std::vector<Nef2> closed_sets() {
  const Nef2 ring = box(0, 0, 4, 4) - box(1, 1, 3, 3, Boundary::Open);
  return {
      Nef2::point({Rational(1) / 3, 2}),
      segment({0, 0}, {2, 1}),
      box(0, 0, 1, 2),
      polygon({{0, 0}, {3, 1}, {1, 3}}),
      polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}),
      ring,
      ring + segment({4, 4}, {6, 5}) + Nef2::point({2, 2}) + segment({1.5, 1.5}, {1.75, 2}),
      box(0, 0, 1, 1) + box(1, 1, 2, 2),
      segment({0, 0}, {1, 0}) + segment({1, 0}, {1, 1}) + segment({1, 0}, {2, -1}),
  };
}

TEST(PlaneMinkowski, OfClosedSets) {
  const std::vector<Nef2> sets = closed_sets();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t j = i; j < sets.size(); ++j) {
      SCOPED_TRACE(std::to_string(i) + " + " + std::to_string(j));
      expect_sum(sets[i], sets[j]);
    }
  }
}

TEST(PlaneMinkowski, OfSetsThatAreNotClosed) {
  const Nef2 square = box(0, 0, 2, 2);
  const std::vector<Nef2> sets{
      box(0, 0, 2, 2, Boundary::Open),
      square - segment({0, 0}, {2, 0}),
      square - Nef2::point({1, 1}),
      square - segment({0, 0}, {1, 1}),
      box(0, 0, 2, 2, Boundary::Open) + Nef2::point({2, 2}) + segment({0, 0}, {0, 1}),
      segment({0, 0}, {2, 1}) - Nef2::point({0, 0}),
  };
  const std::vector<Nef2> others{Nef2::point({1, 0}), segment({0, 0}, {1, 0}), sets[1], sets[4]};
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t j = 0; j < others.size(); ++j) {
      SCOPED_TRACE(std::to_string(i) + " + " + std::to_string(j));
      expect_sum(sets[i], others[j]);
    }
  }
}

TEST(PlaneMinkowski, HasItsMeasures) {
  const Nef2 square = box(0, 0, 2, 2);
  EXPECT_EQ(minkowski_sum(square, square), box(0, 0, 4, 4));
  EXPECT_EQ(minkowski_sum(square, box(-1, -1, 1, 1)), box(-1, -1, 3, 3));
  // Of convex sets: the mixed area of a square and a segment is their widths' product.
  EXPECT_EQ(minkowski_sum(square, segment({0, 0}, {3, 1})).area(), Rational(4 + 2 * (3 + 1)));
  // A hole that the other operand fits into just once, and not at all.
  const Nef2 ring = box(0, 0, 6, 6) - box(1, 1, 5, 5, Boundary::Open);
  const Nef2 filled = minkowski_sum(ring, box(0, 0, 5, 1));
  EXPECT_EQ(filled, box(0, 0, 11, 7));
  const Nef2 left = minkowski_sum(ring, box(0, 0, 1, 1));
  EXPECT_EQ(left, box(0, 0, 7, 7) - box(2, 2, 5, 5, Boundary::Open));
  EXPECT_EQ(minkowski_sum(ring, box(0, 0, 4, 1)), box(0, 0, 10, 7));
}

TEST(PlaneMinkowski, OfRandomSets) {
  const Nef2 frame = box(-20, -20, 20, 20);
  for (std::uint64_t seed = 0; seed < share_of(60); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef2 a = polygon(lattice_polygon(dice, 3 + dice.below(8), 3 + dice.below(5)));
    const Nef2 b = polygon(lattice_polygon(dice, 3 + dice.below(5), 3 + dice.below(4)));
    expect_sum(a, b);
    Points hole = lattice_polygon(dice, 3 + dice.below(4), 4);
    for (Point2& p : hole) p = {p.x / 8 + 1, p.y / 8 + 1};
    expect_sum((box(0, 0, 3, 3) - Nef2::polygon(hole, Boundary::Open)) * frame, b);
  }
}

/// Expressions of half-planes, lines and points: all kinds of marks.
TEST(PlaneMinkowski, OfRandomExpressions) {
  const Nef2 frame = box(-1, -1, 3, 3);
  for (std::uint64_t seed = 0; seed < share_of(40); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef2 a =
        to_nef(*set_of_program(random_program(dice, ProgramValues::Plain, 4), 5)) * frame;
    const Nef2 b =
        to_nef(*set_of_program(random_program(dice, ProgramValues::Plain, 2), 3)) * frame;
    if (a.counts().edges + b.counts().edges > 24) continue;
    expect_sum(a, b);
  }
}

TEST(PlaneMinkowski, IsDistributive) {
  const std::vector<Nef2> sets = closed_sets();
  for (std::size_t i = 0; i + 2 < sets.size(); ++i) {
    const Nef2 left = minkowski_sum(sets[i] + sets[i + 1], sets[i + 2]);
    const Nef2 right =
        minkowski_sum(sets[i], sets[i + 2]) + minkowski_sum(sets[i + 1], sets[i + 2]);
    EXPECT_EQ(left, right);
  }
}

TEST(PlaneMinkowski, OfTheEmptySetAndUnboundedSets) {
  const Nef2 half = Nef2::half_plane({{0, 0}, {1, 0}}, Boundary::Closed);
  EXPECT_TRUE(minkowski_sum(Nef2::empty(), box(0, 0, 1, 1)).is_empty());
  EXPECT_TRUE(minkowski_sum(half, Nef2::empty()).is_empty());
  EXPECT_THROW(static_cast<void>(minkowski_sum(half, box(0, 0, 1, 1))), Error);
}

TEST(PlaneMinkowski, StopsAtItsLimits) {
  Limits limits;
  limits.max_memory_bytes = 1 << 16;
  Context little(limits);
  const Nef2 star = polygon(star_polygon(1000, 1));
  EXPECT_THROW(static_cast<void>(minkowski_sum(star, star, little)), Error);
}

TEST(PlaneMinkowski, AddsAnyNumberOfSets) {
  const std::vector<Nef2> sets{box(0, 0, 1, 2), segment({0, 0}, {3, 1}), box(0, 0, 2, 1)};
  EXPECT_EQ(minkowski_sum(sets), minkowski_sum(minkowski_sum(sets[2], sets[0]), sets[1]));
  EXPECT_EQ(minkowski_sum(std::span<const Nef2>()), Nef2::point({0, 0}));
}

}  // namespace
}  // namespace plumb::testing::plane_minkowski_test
