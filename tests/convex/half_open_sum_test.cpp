// Minkowski sums of solids with parts of their boundaries, against the same sums of their interiors
// and of what is left of their boundaries. Those sums need no marks of faces of convex pieces.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "generate/meshes.h"
#include "oracle/minkowski_check.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

Nef3 solid(const PolygonMesh& mesh) {
  return Nef3::from_mesh(mesh, {.rule = WindingRule::Positive});
}
Nef3 brick(Point3 low, Point3 high) { return solid(box_mesh(low, high)); }

/// Solids with faces that are parallel to faces of others, and with faces that are not.
std::vector<Nef3> solids() {
  const Nef3 block = brick({0, 0, 0}, {2, 2, 1}) - brick({1, 1, -1}, {3, 3, 2}).interior();
  const Nef3 ring = brick({0, 0, 0}, {3, 3, 1}) - brick({1, 1, -1}, {2, 2, 2}).interior();
  const Nef3 octahedron = polyhedral_ball(1, 0);
  const Nef3 dent = brick({-1, -1, -1}, {1, 1, 1}) - polyhedral_ball(1.5, 0).interior();
  const Nef3 corner =
      solid(make_mesh(std::vector<Point3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}},
                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  const Nef3 touching = brick({0, 0, 0}, {1, 1, 1}) + brick({1, 1, 0}, {2, 2, 1});
  return {block, ring, dent, touching, brick({0, 0, 0}, {1, 2, 1}), octahedron, corner};
}

/// The set with random marks of its boundary: each item is kept with the chance kept / 4.
Nef3 with_random_boundary(const Nef3& set, Dice& dice, std::uint64_t kept) {
  const SpaceComplex& c = set.complex();
  SpaceMarks marks{std::vector<Mark>(c.vertex_count()), std::vector<Mark>(c.edge_count()),
                   std::vector<Mark>(c.facet_count()),
                   std::vector<Mark>(c.volume_mark.begin(), c.volume_mark.end())};
  for (std::vector<Mark>* each : {&marks.vertex, &marks.edge, &marks.facet}) {
    for (Mark& m : *each) m = dice.below(4U) < kept ? 1 : 0;
  }
  return set.with_marks(marks);
}

/// Some solid without parts of its boundary; its facets can have slits and marks on one side of a
/// line only, and segments can be missing in its interior.
Nef3 half_open(const Nef3& closed, Dice& dice) {
  const Nef3 set = with_random_boundary(closed, dice, 1 + dice.below(3U));
  const Nef3 half = Nef3::half_space({1, 2, 0, -1}, Boundary::Closed);
  switch (dice.below(4U)) {
    case 0:
      return set - Nef3::segment({0, 0, 0}, {1, 2, 1});
    case 1:
      return (closed * half) + (set - half);
    default:
      return set;
  }
}

/// One of the solids, and one of the convex ones.
std::array<Nef3, 2> operands(Dice& dice) {
  const std::vector<Nef3> all = solids();
  return {half_open(all[dice.below(all.size())], dice),
          half_open(all[all.size() - 1 - dice.below(3U)], dice)};
}

/// By the law of distribution, with operands that are open or have no interior points.
Nef3 sum_by_parts(const Nef3& a, const Nef3& b) {
  const Nef3 inner_a = a.interior(), inner_b = b.interior();
  const Nef3 outer_a = a - inner_a, outer_b = b - inner_b;
  const std::array<Nef3, 3> sums{minkowski_sum(inner_a, b), minkowski_sum(outer_a, inner_b),
                                 minkowski_sum(outer_a, outer_b)};
  return union_of(sums);
}

TEST(HalfOpenSum, IsTheUnionOfTheSumsOfInteriorsAndBoundaries) {
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    Dice dice(seed);
    const auto [a, b] = operands(dice);
    const Nef3 both = minkowski_sum(a, b);
    EXPECT_FALSE(audit(both.complex(), AuditForm::Minimal)) << "seed " << seed;
    EXPECT_EQ(both, sum_by_parts(a, b)) << "seed " << seed;
  }
}

TEST(HalfOpenSum, HoldsTheSumsOfItsPoints) {
  for (std::uint64_t seed = 100; seed < 106; ++seed) {
    Dice dice(seed);
    const auto [a, b] = operands(dice);
    EXPECT_EQ(wrong_place(minkowski_sum(a, b), a, b, dice, 40), "") << "seed " << seed;
  }
}

TEST(HalfOpenSum, WithAPointOrASegmentKeepsInnerMarks) {
  const Nef3 cube = brick({0, 0, 0}, {2, 2, 2}), slit = Nef3::segment({0, 0, 0}, {2, 2, 2});
  const Nef3 block = (cube - brick({1, 1, 1}, {3, 3, 3})) - slit;
  EXPECT_EQ(minkowski_sum(block, Nef3::point({0, 0, 0})), block);
  const Nef3 along = Nef3::segment({0, 0, 0}, {1, 0, 0});
  Dice dice(7);
  EXPECT_EQ(wrong_place(minkowski_sum(block, along), block, along, dice, 40), "");
}

// Facets of a piece that a caller numbered as walls are facets of the set nevertheless.
TEST(HalfOpenSum, OfAPieceOfASetHasTheMarksOfItsCuts) {
  const Nef3 block = brick({0, 0, 0}, {2, 2, 1}) - brick({1, 1, -1}, {3, 3, 2});
  const Nef3 ball = polyhedral_ball(1, 0);
  for (const Nef3& piece : decompose(block).pieces) {
    const Nef3 pair = piece + brick({5, 5, 5}, {6, 6, 6});
    EXPECT_EQ(minkowski_sum(pair, ball), sum_by_parts(pair, ball));
  }
}

// The number of sums of pairs is the product of the numbers of convex pieces, not of items. With
// every item as a part, the sum below takes minutes.
TEST(HalfOpenSum, OfRoundSolidsNeedsFewSums) {
  const Nef3 open = brick({-5, -5, -5}, {5, 5, 5}) - polyhedral_ball(5.5, 1);
  const Nef3 ball = polyhedral_ball(1, 1);
  Context context(Limits{.max_seconds = 600});
  const Nef3 sum = minkowski_sum(open, ball, context);
  EXPECT_EQ(sum.closure(), minkowski_sum(open.closure(), ball));
  EXPECT_FALSE(sum.is_closed());
  Dice dice(3);
  EXPECT_EQ(wrong_place(sum, open, ball, dice, 20), "");
}

}  // namespace
}  // namespace plumb::testing
