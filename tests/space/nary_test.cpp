// Unions, intersections and differences of many sets are those from left to right, in any order,
// for bounded and unbounded, open and closed sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "plumb/space/nef3.h"

namespace plumb::testing::nary_test {
namespace {

Nef3 box(int x, int y, int z, int size) {
  const std::array<int, 3> at{x, y, z};
  std::vector<HalfSpace3> sides;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<Rational, 3> normal{0, 0, 0};
    normal[static_cast<std::size_t>(axis)] = 1;
    const int low = at[static_cast<std::size_t>(axis)];
    sides.push_back({{-normal[0], -normal[1], -normal[2], low}, Boundary::Closed});
    sides.push_back({{normal[0], normal[1], normal[2], -low - size}, Boundary::Closed});
  }
  return Nef3::intersection(sides);
}

/// Returns boxes, some of them open, flat, empty or unbounded.
Nef3 random_set(std::mt19937& random, int range) {
  const auto number = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most));
  };
  const Nef3 set = box(number(range), number(range), number(range), 1 + number(3));
  switch (number(12)) {
    case 0:
      return set.interior();
    case 1:
      return set.complement();
    case 2:
      return set.boundary();
    case 3:
      return Nef3::empty();
    case 4:
      return Nef3::half_space({1, 2, number(3), -number(range)}, Boundary::Open);
    default:
      return set;
  }
}

Nef3 folded(const std::vector<Nef3>& sets, Nef3 value, MarkFunction f) {
  for (const Nef3& set : sets) value = boolean_op(value, set, f);
  return value;
}

TEST(Nary, AllOrdersGiveTheSetFromLeftToRight) {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const int range = round % 3 == 0 ? 3 : 12;  // Crowded, or mostly apart.
    std::vector<Nef3> sets;
    for (int i = 0; i < 2 + round % 9; ++i) sets.push_back(random_set(random, range));
    const Nef3 all = folded(sets, Nef3::empty(), kUnion);
    const Nef3 common = folded(sets, Nef3::whole(), kIntersection);
    const Nef3 first = sets[0];
    const std::vector<Nef3> others(sets.begin() + 1, sets.end());
    const Nef3 left = folded(others, first, kDifference);
    EXPECT_EQ(difference_of(first, others), left);
    EXPECT_EQ(union_of(sets), all);
    EXPECT_EQ(intersection_of(sets), common);
    std::shuffle(sets.begin(), sets.end(), random);
    EXPECT_EQ(union_of(sets), all);
    EXPECT_EQ(intersection_of(sets), common);
  }
}

TEST(Nary, AHeavySetAmongLightOnesIsUnitedOnce) {
  std::vector<Nef3> comb;
  for (int i = 0; i < 40; ++i) comb.push_back(box(4 * i, 0, 0, 2));
  std::vector<Nef3> sets{union_of(comb)};
  for (int i = 0; i < 5; ++i) sets.push_back(box(4 * i + 1, 1, 1, 2));
  EXPECT_EQ(union_of(sets), folded(sets, Nef3::empty(), kUnion));
}

TEST(Nary, NothingIsEmptyAndWhole) {
  EXPECT_TRUE(union_of(std::vector<Nef3>{}).is_empty());
  EXPECT_TRUE(intersection_of(std::vector<Nef3>{}).is_whole());
  const Nef3 cube = box(0, 0, 0, 1);
  EXPECT_EQ(difference_of(cube, std::vector<Nef3>{}), cube);
  EXPECT_TRUE(difference_of(Nef3::empty(), std::vector<Nef3>{cube}).is_empty());
}

}  // namespace
}  // namespace plumb::testing::nary_test
