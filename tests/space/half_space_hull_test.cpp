// Intersections of half-spaces against Booleans of the same half-spaces.
#include "plumb/space/half_space_hull.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "generate/dice.h"
#include "plumb/base/error.h"
#include "plumb/space/space_audit.h"

namespace plumb {
namespace {

using testing::Dice;

Nef3 fold(const std::vector<HalfSpace3>& half_spaces) {
  Nef3 result = Nef3::space();
  for (const HalfSpace3& h : half_spaces) result *= Nef3::half_space(h.plane, h.boundary);
  return result;
}

HalfSpace3 half_space(int a, int b, int c, int d, Boundary boundary = Boundary::Closed) {
  return {{a, b, c, d}, boundary};
}

std::vector<HalfSpace3> cube(int size, Boundary boundary = Boundary::Closed) {
  return {half_space(1, 0, 0, -size, boundary), half_space(-1, 0, 0, -size, boundary),
          half_space(0, 1, 0, -size, boundary), half_space(0, -1, 0, -size, boundary),
          half_space(0, 0, 1, -size, boundary), half_space(0, 0, -1, -size, boundary)};
}

/// Planes of small numbers: many through one point, parallel, equal, opposite ones.
std::vector<HalfSpace3> scene(Dice& dice) {
  std::vector<HalfSpace3> result;
  if (dice.between(0, 1) == 0) result = cube(2);
  const auto count = static_cast<std::size_t>(dice.between(1, 9));
  const std::int64_t least = dice.between(-3, 0);
  while (result.size() < count + 4) {
    const std::int64_t a = dice.between(-2, 2);
    const std::int64_t b = dice.between(-2, 2);
    const std::int64_t c = dice.between(-2, 2);
    const std::int64_t d = dice.between(least - 2, least + 1);
    const bool is_open = dice.between(0, 1) == 0;
    if (a == 0 && b == 0 && c == 0) continue;
    result.push_back({{a, b, c, d}, is_open ? Boundary::Open : Boundary::Closed});
  }
  return result;
}

TEST(HalfSpaceHull, IsTheFoldOfTheHalfSpaces) {
  Dice dice(7);
  std::size_t polytopes = 0, unbounded = 0, without_inside = 0, spared = 0;
  for (int i = 0; i < 120 && !HasFailure(); ++i) {
    const std::vector<HalfSpace3> half_spaces = scene(dice);
    const Nef3 expected = fold(half_spaces);
    Context context;
    const HalfSpaceHull hull = hull_of_half_spaces(half_spaces, context);
    const bool is_solid = !expected.interior().is_empty();
    ASSERT_EQ(hull.polytope.has_value(), is_solid && expected.is_bounded()) << i;
    if (hull.polytope) {
      const auto flaw = audit(*hull.polytope, true);
      ASSERT_FALSE(flaw) << i << ": " << flaw->invariant;
      EXPECT_EQ(Nef3::from_minimal(*hull.polytope), expected) << i;
    }
    std::vector<HalfSpace3> needed;
    for (const std::uint32_t k : hull.needed) needed.push_back(half_spaces[k]);
    EXPECT_EQ(fold(needed), expected) << i;
    EXPECT_EQ(Nef3::intersection(half_spaces, context), expected) << i;
    ++(!is_solid ? without_inside : hull.polytope ? polytopes : unbounded);
    spared += half_spaces.size() - needed.size();
  }
  EXPECT_GT(polytopes, 30u);
  EXPECT_GT(unbounded, 10u);
  EXPECT_GT(without_inside, 10u);
  EXPECT_GT(spared, 100u);
}

/// Open half-spaces that touch a cube in a vertex, an edge, a facet; closed ones that do so change nothing.
TEST(HalfSpaceHull, OpenOnesTakeAwayWhatTheyTouch) {
  for (const auto& [a, b, c, d] :
       {std::array{1, 1, 1, -3}, std::array{1, 1, 0, -2}, std::array{1, 0, 0, -1}}) {
    for (const Boundary boundary : {Boundary::Open, Boundary::Closed}) {
      std::vector<HalfSpace3> half_spaces = cube(1);
      half_spaces.push_back(half_space(a, b, c, d, boundary));
      Context context;
      const Nef3 set = Nef3::intersection(half_spaces, context);
      EXPECT_EQ(set, fold(half_spaces));
      EXPECT_EQ(set.contains(Point3{1, 1, 1}), boundary == Boundary::Closed);
      EXPECT_TRUE(set.contains(Point3{-1, 1, 1}));
      EXPECT_EQ(set.counts().facets, 6u);
    }
  }
}

TEST(HalfSpaceHull, NoneOneAndTwo) {
  Context context;
  EXPECT_TRUE(Nef3::intersection({}, context).is_space());
  const std::vector<HalfSpace3> one{half_space(1, 2, 3, 4)};
  EXPECT_EQ(Nef3::intersection(one, context), Nef3::half_space(one[0].plane, one[0].boundary));
  const std::vector<HalfSpace3> plane{half_space(1, 2, 3, 4), half_space(-1, -2, -3, -4)};
  EXPECT_EQ(Nef3::intersection(plane, context), Nef3::plane({1, 2, 3, 4}));
  EXPECT_THROW(Nef3::intersection(std::vector{half_space(0, 0, 0, 1)}, context), Error);
}

/// Every plane through one vertex; then the polar one: every vertex on one plane.
TEST(HalfSpaceHull, ConesOfManyFacets) {
  std::vector<HalfSpace3> cone{half_space(0, 0, -1, 0)};
  for (int i = -20; i <= 20; ++i) {
    cone.push_back(half_space(40, 2 * i, 50, -100));
    cone.push_back(half_space(-40, 2 * i, 50, -100));
    cone.push_back(half_space(2 * i, 40, 50, -100));
    cone.push_back(half_space(2 * i, -40, 50, -100, Boundary::Open));
  }
  Context context;
  const Nef3 set = Nef3::intersection(cone, context);
  EXPECT_EQ(set, fold(cone));
  EXPECT_FALSE(audit(set.complex(), true));
  EXPECT_FALSE(set.contains(Point3{0, 0, 2}));
}

}  // namespace
}  // namespace plumb
