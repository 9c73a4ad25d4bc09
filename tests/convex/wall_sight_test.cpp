// Walls straight up and down from reflex edges: known polygons in a step, and in any solid what
// they must do, by exact points and the edges that stay reflex.
#include "plumb/convex/wall/wall_sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/wall/wall_complex.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb::wall_sight_test {

using Direction = std::array<Integer, 3>;

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

/// A complex whose tables may grow, and what is seen in it.
struct Scene {
  SpaceComplex complex;
  std::shared_ptr<SpaceTables> tables;
  Vertical vertical;
  std::vector<WallPolygon> walls;

  Scene(const Nef3& set, const Direction& up)
      : complex(set.complex()), tables(copy(*complex.tables)), vertical(up, *tables) {
    complex.tables = tables;
    walls = sight_walls(complex, *tables, vertical, unlimited_context());
  }
  RationalPoint3 at(SpacePoint x) const { return exact(tables->points, x); }
};

bool is_less(const RationalPoint3& p, const RationalPoint3& q) {
  if (p.x != q.x) return p.x < q.x;
  return p.y != q.y ? p.y < q.y : p.z < q.z;
}
std::vector<RationalPoint3> corners_of(const Scene& s, const WallPolygon& wall) {
  std::vector<RationalPoint3> corners;
  for (const SpacePoint x : wall.corners) corners.push_back(s.at(x));
  std::sort(corners.begin(), corners.end(), is_less);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

TEST(WallSight, NothingIsSeenFromAConvexSetOrAVerticalEdge) {
  EXPECT_TRUE(Scene(box({0, 0, 0}, {1, 2, 3}), {1, 2, 3}).walls.empty());
  const Nef3 step = box({0, 0, 0}, {4, 4, 4}) - box({2, -1, 2}, {5, 5, 5});
  EXPECT_TRUE(Scene(step, {0, 1, 0}).walls.empty());
}

/// The reflex edge runs along y at x = 2, z = 2; the wall goes back from it to the boundary.
TEST(WallSight, AStepHasOneWallBelowItsEdge) {
  const Nef3 step = box({0, 0, 0}, {4, 4, 4}) - box({2, -1, 2}, {5, 5, 5});
  for (const Direction& up :
       {Direction{0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {2, 0, 1}, {1, 0, 3}, {0, 0, -1}, {-2, 0, -5}}) {
    const Scene s(step, up);
    ASSERT_EQ(s.walls.size(), 1U);
    const Rational x = up[0] < 0 ? -up[0] : up[0], z = up[2] < 0 ? -up[2] : up[2];
    // As far as x = 0 or z = 0.
    const Rational far = x > z ? Rational(2 / x) : Rational(2 / z);
    std::vector<RationalPoint3> expected;
    for (const int y : {0, 4}) {
      expected.push_back({2, y, 2});
      expected.push_back({2 - far * x, y, 2 - far * z});
    }
    std::sort(expected.begin(), expected.end(), is_less);
    EXPECT_EQ(corners_of(s, s.walls[0]), expected);
    for (const SpacePoint p : s.walls[0].corners) {
      EXPECT_EQ(side(s.tables->points, p, s.walls[0].plane), Sign::Zero);
    }
  }
}

/// A groove along x above one along y: its wall ends at the edge of the other, and at the bottom.
TEST(WallSight, WhatIsNearerIsSeen) {
  const Nef3 set =
      box({0, 0, 0}, {6, 6, 6}) - box({-1, 2, 4}, {7, 4, 7}) - box({2, -1, -1}, {4, 7, 2});
  const Scene s(set, {0, 0, 1});
  std::vector<std::vector<RationalPoint3>> above;
  for (const WallPolygon& wall : s.walls) {
    const auto corners = corners_of(s, wall);
    const bool is_at_2 = std::ranges::all_of(corners, [](const auto& p) { return p.y == 2; });
    if (is_at_2) above.push_back(corners);
  }
  const std::vector<RationalPoint3> expected = {{0, 2, 0}, {0, 2, 4}, {2, 2, 0}, {2, 2, 2},
                                                {4, 2, 0}, {4, 2, 2}, {6, 2, 0}, {6, 2, 4}};
  EXPECT_EQ(above, (std::vector<std::vector<RationalPoint3>>{expected}));
  EXPECT_EQ(s.walls.size(), 4U);
}

/// Corners in their plane, which holds the vertical, and in the closure of the set; a polygon that
/// runs counter-clockwise seen from the positive side.
TEST(WallSight, WallsAreUprightPolygonsInsideTheSet) {
  for (const Nef3& set :
       {testing::solid(testing::comb_block(2, 2)), testing::solid(testing::star_prism(4)),
        testing::solid(testing::saddle_block(1))}) {
    for (const Direction& up : {Direction{0, 0, 1}, {1, 2, 0}, {1, 2, 3}}) {
      const Scene s(set, up);
      for (const WallPolygon& wall : s.walls) {
        const IntegerRow row = s.tables->planes.coefficients(wall.plane);
        EXPECT_EQ(row[0] * up[0] + row[1] * up[1] + row[2] * up[2], 0);
        std::array<Rational, 3> area{};
        const std::size_t n = wall.corners.size();
        for (std::size_t i = 0; i < n; ++i) {
          const RationalPoint3 p = s.at(wall.corners[i]), q = s.at(wall.corners[(i + 1) % n]);
          EXPECT_EQ(row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3], 0);
          EXPECT_TRUE(set.closure().contains(p));
          area[0] += p.y * q.z - p.z * q.y;
          area[1] += p.z * q.x - p.x * q.z;
          area[2] += p.x * q.y - p.y * q.x;
        }
        EXPECT_GT(row[0] * area[0] + row[1] * area[1] + row[2] * area[2], 0);
      }
    }
  }
}

TEST(WallSight, OnlyVerticalEdgesStayReflex) {
  std::size_t walls = 0;
  for (const Nef3& set :
       {testing::solid(testing::comb_block(2, 2)), testing::solid(testing::star_prism(5)),
        box({0, 0, 0}, {6, 6, 6}) - box({2, 2, 2}, {4, 4, 4})}) {
    for (const Direction& up : {Direction{0, 0, 1}, {0, 1, 0}, {1, 2, 3}}) {
      Scene s(set, up);
      walls += s.walls.size();
      const SpaceComplex cut = with_walls(s.complex, s.tables, s.walls, unlimited_context());
      const SectorTest test(cut);
      const auto after = copy(*cut.tables);
      Vertical vertical(up, *after);
      std::vector<Sector> sectors;
      for (std::uint32_t e = 0; e < cut.edge_count(); ++e) {
        sectors_of(cut, EdgeId(e), sectors);
        for (const Sector& sector : sectors) {
          if (test.is_reflex(sector)) {
            EXPECT_TRUE(vertical.is_vertical(cut.edge_planes[e]));
          }
        }
      }
    }
  }
  EXPECT_GT(walls, 20U);
}

}  // namespace plumb::wall_sight_test
