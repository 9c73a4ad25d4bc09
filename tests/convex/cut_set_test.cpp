// Parts of any kind cut into convex pieces: disjoint, convex, together the part, and within the
// bound of the classical rule.
#include "plumb/convex/part/cut_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/convexity.h"
#include "plumb/testing/dice.h"

namespace plumb::cut_set_test {

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

/// Solids with one connected surface.
std::vector<Nef3> solids() {
  const Nef3 step = box({0, 0, 0}, {4, 4, 4}) - box({2, -1, 2}, {5, 5, 5});
  std::vector<Nef3> all = {step,
                           step.interior(),
                           step.closure(),
                           box({0, 0, 0}, {4, 4, 4}) - box({1, 1, 1}, {5, 5, 5}),
                           box({0, 0, 0}, {9, 9, 3}) - box({3, 3, -1}, {6, 6, 4}),
                           testing::solid(testing::comb_block(1, 2)),
                           testing::solid(testing::star_prism(5))};
  testing::Dice dice(1);
  for (int i = 0; i < 3; ++i) {
    all.push_back(testing::solid(testing::voxel_mesh(testing::random_terrain(dice, 2, 2, 3))));
  }
  return all;
}

/// Disjoint pieces with convex interiors that make up the set; closed ones overlap in boundaries.
void expect_pieces(const Nef3& set, const std::vector<Nef3>& pieces, bool closed) {
  Nef3 sum = Nef3::empty();
  for (const Nef3& piece : pieces) {
    EXPECT_FALSE(piece.audit());
    EXPECT_FALSE(piece.is_empty());
    EXPECT_TRUE(piece.interior().is_convex());
    EXPECT_TRUE(reflex_edges(piece.complex()).empty());
    const Nef3 common = sum * piece;
    EXPECT_TRUE(closed ? common.interior().is_empty() : common.is_empty());
    if (closed) {
      EXPECT_TRUE(piece.is_closed());
    }
    sum = sum + piece;
  }
  EXPECT_TRUE(sum == (closed ? set.closure() : set));
}

TEST(CutSet, TheBoundGrowsWithTheSquareAndDoesNotOverflow) {
  EXPECT_EQ(most_pieces(0), 1U);
  std::size_t sum = 1;
  for (std::size_t r = 1; r < 100; ++r) EXPECT_EQ(most_pieces(r), sum += r);
  EXPECT_EQ(most_pieces(std::numeric_limits<std::size_t>::max()),
            std::numeric_limits<std::size_t>::max());
  EXPECT_GT(most_pieces((std::size_t{1} << 31U) - 1), std::size_t{1} << 60U);
}

TEST(CutSet, BothRulesCutSolidsWithinTheBound) {
  for (const Nef3& set : solids()) {
    for (const CutRule rule : {CutRule::Greedy, CutRule::Fixed}) {
      std::optional<CutSurface> surface = cut_surface_of(set.complex());
      ASSERT_TRUE(surface);
      const SolidPieces cut = cut_solid(*surface, rule, unlimited_context());
      EXPECT_EQ(cut.reflex_edges, reflex_edges(set.complex()).size());
      EXPECT_TRUE(cut.stuck.empty());
      EXPECT_GT(cut.convex.size(), 1U);
      if (rule == CutRule::Fixed) {
        EXPECT_LE(cut.convex.size(), most_pieces(cut.reflex_edges));
      }
      std::vector<Nef3> pieces;
      for (const auto& faces : cut.convex) {
        pieces.push_back(set_of_piece(*surface, faces, false, unlimited_context()));
      }
      expect_pieces(set, pieces, false);
    }
  }
}

TEST(CutSet, PiecesOfSolidsOpenAndClosed) {
  for (const Nef3& set : solids()) {
    for (const bool closed : {false, true}) {
      const DecomposeOptions plain{DecomposeMethod::Cuts, closed};
      const DecomposeOptions merged{DecomposeMethod::Best, closed};
      const auto pieces = cut_set({set, 3}, plain, unlimited_context());
      const auto fewer = cut_set({set, 3}, merged, unlimited_context());
      const auto fallen_back = cut_set({set, 3}, plain, unlimited_context(), 0);
      expect_pieces(set, pieces, closed);
      expect_pieces(set, fewer, closed);
      expect_pieces(set, fallen_back, closed);
      EXPECT_LE(fewer.size(), pieces.size());
      EXPECT_LE(fallen_back.size(), pieces.size());
    }
  }
}

/// Of two shells, with slits, lines and points taken out, and without end: by Booleans.
TEST(CutSet, OtherVolumesAreDivided) {
  const Nef3 cube = box({0, 0, 0}, {6, 6, 6});
  for (const Nef3& set :
       {cube - box({2, 2, 2}, {4, 4, 4}), cube - Nef3::point({1, 2, 3}),
        cube - Nef3::segment({1, 1, 1}, {3, 2, 2}),
        cube - Nef3::facet(std::vector<Point3>{{1, 1, 1}, {3, 1, 1}, {3, 3, 2}, {1, 3, 2}}),
        Nef3::whole() - cube, Nef3::whole() - Nef3::point({1, 2, 3}),
        Nef3::half_space({0, 0, 1, 0}, Boundary::Open) - box({0, 0, -9}, {1, 1, -5})}) {
    const DecomposeOptions options{DecomposeMethod::Cuts, false};
    const auto pieces = cut_set({set, 3}, options, unlimited_context());
    EXPECT_GT(pieces.size(), 1U);
    expect_pieces(set, pieces, false);
  }
}

/// Facets are cut in their plane; edges and points are pieces as they are.
TEST(CutSet, FlatPartsAreCutToo) {
  const DecomposeOptions options{DecomposeMethod::Cuts, false};
  const std::vector<Point3> corners = {{0, 0, 1}, {4, 0, 1}, {4, 2, 1},
                                       {2, 2, 1}, {2, 4, 1}, {0, 4, 1}};
  const Nef3 sheet = Nef3::facet(corners);
  for (const Nef3& set :
       {sheet, sheet - Nef3::point({1, 1, 1}), sheet - Nef3::segment({1, 1, 1}, {1, 3, 1})}) {
    const auto pieces = cut_set({set, 2}, options, unlimited_context());
    EXPECT_GT(pieces.size(), 1U);
    Nef3 sum = Nef3::empty();
    for (const Nef3& piece : pieces) {
      EXPECT_TRUE((sum * piece).is_empty());
      EXPECT_TRUE(piece.closure().is_convex());
      sum = sum + piece;
    }
    EXPECT_TRUE(sum == set);
  }
  for (const auto& [set, dimension] :
       {std::pair(Nef3::segment({0, 0, 0}, {1, 2, 3}), 1), {Nef3::point({1, 2, 3}), 0}}) {
    const auto pieces = cut_set({set, dimension}, options, unlimited_context());
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_TRUE(pieces[0] == set);
  }
}

}  // namespace plumb::cut_set_test
