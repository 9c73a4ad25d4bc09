// Convex neighbours that become one: the union stays, pieces stay convex, and no two that are left
// have a convex union.
#include "plumb/convex/part/merge_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/part/cut_set.h"
#include "plumb/testing/dice.h"

namespace plumb::merge_parts_test {

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

/// Do two share more than an edge, and is their union convex?
bool may_merge(const Nef3& a, const Nef3& b) {
  const Nef3 both = (a + b).closure();
  return both.interior().is_convex() && *both.volume() == *a.volume() + *b.volume();
}

void expect_merged(const std::vector<Nef3>& pieces, const Nef3& set) {
  Nef3 sum = Nef3::empty();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_FALSE(pieces[i].audit());
    EXPECT_TRUE(pieces[i].interior().is_convex());
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(may_merge(pieces[i], pieces[j]));
    sum = sum + pieces[i];
  }
  EXPECT_TRUE(sum == set);
}

/// The last two blocks make one that fits the first; with it, one that fits the second.
TEST(MergeParts, TriesWhatAnEarlierSetHasBecome) {
  std::vector<Nef3> pieces = {box({0, 0, 0}, {2, 1, 1}), box({2, 0, 0}, {3, 2, 1}),
                              box({0, 1, 0}, {1, 2, 1}), box({1, 1, 0}, {2, 2, 1})};
  merge_sets(pieces, unlimited_context());
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0] == box({0, 0, 0}, {3, 2, 1}));
}

/// In any order, as few sets: a polygon refused once has not become a good one.
TEST(MergeParts, MergesAGridInAnyOrder) {
  const Nef3 all = box({0, 0, 0}, {2, 2, 1}) + box({0, 0, 1}, {1, 1, 2});
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    testing::Dice dice(seed);
    std::vector<Nef3> pieces;
    for (int i = 0; i < 4; ++i) {
      const double x = i % 2, y = i / 2;
      pieces.push_back(box({x, y, 0}, {x + 1, y + 1, 1}));
    }
    pieces.push_back(box({0, 0, 1}, {1, 1, 2}));  // an L with what is below
    for (std::size_t i = pieces.size(); i > 1; --i) std::swap(pieces[i - 1], pieces[dice.below(i)]);
    merge_sets(pieces, unlimited_context());
    EXPECT_LE(pieces.size(), 3U) << seed;
    expect_merged(pieces, all);
  }
}

/// Other polygons, an edge, or a corner in common; sets that are not bounded or have no volume.
TEST(MergeParts, LeavesWhatHasNoConvexUnion) {
  const std::vector<Nef3> apart = {
      box({0, 0, 0}, {2, 2, 2}),
      box({2, 0, 0}, {4, 2, 1}),  // a smaller square
      box({2, 2, 2}, {3, 3, 3}),  // a corner
      Nef3::half_space({0, 0, 1, 5}, Boundary::Closed),
      Nef3::facet(std::vector<Point3>{{9, 0, 2}, {10, 0, 2}, {10, 2, 2}}),
      Nef3::point({7, 7, 7})};
  std::vector<Nef3> pieces = apart;
  merge_sets(pieces, unlimited_context());
  ASSERT_EQ(pieces.size(), apart.size());
  for (std::size_t i = 0; i < apart.size(); ++i) EXPECT_TRUE(pieces[i] == apart[i]);
}

/// A common square between two wedges: reflex at one of its sides, or at none.
TEST(MergeParts, TheRimOfThePolygonDecides) {
  for (const auto& [tip, is_convex] : {std::pair(1.0, true), {2.0, true}, {3.0, false}}) {
    const Nef3 left = box({-2, 0, 0}, {0, 2, 2});
    const Nef3 right = testing::solid(testing::make_mesh(
        {{0, 0, 0},
         {0, 2, 0},
         {0, 2, 2},
         {0, 0, 2},
         {1, 0, 0},
         {1, 2, 0},
         {1, 2, tip},
         {1, 0, tip}},
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}}));
    std::vector<Nef3> pieces = {left, right};
    EXPECT_EQ(may_merge(left, right), is_convex);
    merge_sets(pieces, unlimited_context());
    EXPECT_EQ(pieces.size(), is_convex ? 1U : 2U);
    expect_merged(pieces, left + right);
  }
}

/// Pieces of one surface, cut by the plain rule.
TEST(MergeParts, PiecesOfASurfaceAreMergedAsFarAsTheyGo) {
  for (const Nef3& set :
       {testing::solid(testing::comb_block(2, 1)), testing::solid(testing::star_prism(5)),
        box({0, 0, 0}, {4, 4, 4}) - box({2, -1, 2}, {5, 5, 5}),
        (box({0, 0, 0}, {4, 4, 4}) - box({1, 1, 1}, {5, 5, 5})).interior()}) {
    std::optional<CutSurface> surface = cut_surface_of(set.complex());
    ASSERT_TRUE(surface);
    SolidPieces cut = cut_solid(*surface, CutRule::Fixed, unlimited_context());
    ASSERT_TRUE(cut.stuck.empty());
    const std::size_t before = cut.convex.size();
    merge_pieces(*surface, cut.convex, unlimited_context());
    EXPECT_LE(cut.convex.size(), before);
    std::vector<Nef3> pieces;
    for (const auto& faces : cut.convex) {
      pieces.push_back(set_of_piece(*surface, faces, false, unlimited_context()));
    }
    expect_merged(pieces, set);
  }
}

}  // namespace plumb::merge_parts_test
