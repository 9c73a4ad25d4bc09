// Walls that prolong facets across vertical reflex edges: known polygons in prisms, and in any
// prism no reflex edge left and one piece more for each edge at most.
#include "plumb/convex/wall/wall_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/wall/wall_complex.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/testing/dice.h"

namespace plumb::wall_spread_test {

using Direction = std::array<Integer, 3>;

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }
Nef3 prism(const std::vector<Point2>& outline) {
  return testing::solid(testing::prism_mesh(outline, 0, 2));
}

struct Scene {
  SpaceComplex complex;
  std::shared_ptr<SpaceTables> tables;
  std::vector<WallPolygon> walls;

  explicit Scene(const Nef3& set, const Direction& up = {0, 0, 1})
      : complex(set.complex()), tables(copy(*complex.tables)) {
    complex.tables = tables;
    Vertical vertical(up, *tables);
    walls = spread_walls(complex, *tables, vertical, unlimited_context());
  }
  SpaceComplex cut() const { return with_walls(complex, tables, walls, unlimited_context()); }
};

std::size_t reflex_sectors(const SpaceComplex& c) {
  const SectorTest test(c);
  std::vector<Sector> sectors;
  std::size_t count = 0;
  for (std::uint32_t e = 0; e < c.edge_count(); ++e) {
    sectors_of(c, EdgeId(e), sectors);
    count += static_cast<std::size_t>(
        std::ranges::count_if(sectors, [&](const Sector& s) { return test.is_reflex(s); }));
  }
  return count;
}

/// Where the wall stands, from above: x and y of its corners, each once.
std::vector<std::array<Rational, 2>> shadow(const Scene& s, const WallPolygon& wall) {
  std::vector<std::array<Rational, 2>> places;
  for (const SpacePoint x : wall.corners) {
    const RationalPoint3 at = exact(s.tables->points, x);
    EXPECT_TRUE(at.z == 0 || at.z == 2);
    EXPECT_EQ(side(s.tables->points, x, wall.plane), Sign::Zero);
    places.push_back({at.x, at.y});
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

TEST(WallSpread, ConvexSetsNeedNone) {
  EXPECT_TRUE(Scene(box({0, 0, 0}, {1, 2, 3})).walls.empty());
  EXPECT_TRUE(Scene(prism({{0, 0}, {3, 0}, {4, 2}, {1, 3}})).walls.empty());
}

/// Ahead from the corner in the plane of either facet, to what is opposite.
TEST(WallSpread, AnLHasOneWallThatProlongsAFacet) {
  const Scene s(prism({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}));
  ASSERT_EQ(s.walls.size(), 1U);
  using Places = std::vector<std::array<Rational, 2>>;
  const Places places = shadow(s, s.walls[0]);
  EXPECT_TRUE(places == (Places{{0, 2}, {2, 2}}) || places == (Places{{2, 0}, {2, 2}}));
  EXPECT_EQ(s.walls[0].corners.size(), 4U);
}

/// In a Z the two walls are apart; in a plus each of four ends at the next corner or wall.
TEST(WallSpread, WallsEndAtWallsBeforeThem) {
  const std::vector<Point2> plus = {{2, 0}, {4, 0}, {4, 2}, {6, 2}, {6, 4}, {4, 4},
                                    {4, 6}, {2, 6}, {2, 4}, {0, 4}, {0, 2}, {2, 2}};
  const Scene s(prism(plus));
  EXPECT_LE(s.walls.size(), 4U);
  for (const WallPolygon& wall : s.walls) EXPECT_EQ(shadow(s, wall).size(), 2U);
  const SpaceComplex cut = s.cut();
  EXPECT_EQ(reflex_sectors(cut), 0U);
  EXPECT_LE(std::ranges::count(cut.volume_mark, Mark{1}), 5);
}

/// Two chains over a common base: every corner may be reflex.
std::vector<Point2> random_outline(testing::Dice& dice) {
  std::vector<Point2> outline;
  for (int x = 0; x <= 4; ++x) {
    outline.push_back({static_cast<double>(x), static_cast<double>(dice.between(0, 2))});
  }
  for (int x = 4; x >= 0; --x) {
    outline.push_back({static_cast<double>(x), static_cast<double>(dice.between(3, 5))});
  }
  return outline;
}

TEST(WallSpread, PrismsHaveNoReflexEdgeLeftAndFewPieces) {
  testing::Dice dice(1);
  std::vector<Nef3> sets = {testing::solid(testing::star_prism(5)),
                            box({0, 0, 0}, {9, 9, 2}) - box({2, 2, -1}, {4, 4, 3}),
                            box({0, 0, 0}, {9, 9, 2}).interior() - box({2, 2, -1}, {4, 4, 3})};
  for (int i = 0; i < 12; ++i) sets.push_back(prism(random_outline(dice)));
  std::size_t walls = 0;
  for (const Nef3& set : sets) {
    const std::size_t reflex = reflex_edges(set.complex()).size();
    const Scene s(set);
    walls += s.walls.size();
    const SpaceComplex cut = s.cut();
    EXPECT_EQ(reflex_sectors(cut), 0U);
    EXPECT_LE(static_cast<std::size_t>(std::ranges::count(cut.volume_mark, Mark{1})), reflex + 1);
  }
  EXPECT_GT(walls, 20U);
}

/// One wall to both sides of a line, and none where the vertical is another one.
TEST(WallSpread, ALineTakenOutIsPassedByAWall) {
  const Nef3 cube = box({0, 0, 0}, {4, 4, 2});
  const Nef3 set = cube - Nef3::segment({1, 2, 0}, {1, 2, 2});
  const Scene s(set);
  ASSERT_EQ(s.walls.size(), 2U);
  const SpaceComplex cut = s.cut();
  EXPECT_EQ(reflex_sectors(cut), 0U);
  EXPECT_EQ(std::ranges::count(cut.volume_mark, Mark{1}), 2);
  const Nef3 step = prism({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
  EXPECT_TRUE(Scene(step, {1, 0, 0}).walls.empty());
}

}  // namespace plumb::wall_spread_test
