// Voronoi cells: together they are the box, and every corner of a cell is as near to its site as to
// any other.
#include "plumb/convex/voronoi.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "generate/test_share.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane/plane_points.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::voronoi_test {
namespace {

Rational squared_distance(const RationalPoint2& a, const RationalPoint2& b) {
  const RationalPoint2 d = a - b;
  return d.x * d.x + d.y * d.y;
}

PointTable2 random_sites(Dice& dice) {
  PointTable2 sites;
  const std::uint64_t count = 1 + dice.below(12);
  const std::uint64_t kind = dice.below(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(dice.below(kind == 0 ? 3 : 8));
    const auto y = static_cast<double>(dice.below(8));
    if (kind == 1) sites.push_back({x, 2 * x - 3});  // On a line.
    if (kind == 2) sites.push_back(Rational(x) / 3, Rational(y) / 7);
    if (kind != 1 && kind != 2) sites.push_back({x, y});
  }
  return sites;
}

TEST(Voronoi, CellsFillTheBoxAndAreNearest) {
  for (std::uint64_t seed = 0; seed < case_count(300); ++seed) {
    Dice dice(seed);
    const PointTable2 sites = random_sites(dice);
    const RationalPoint2 low{-1, Rational(1) / 3};
    const RationalPoint2 high{6, 5};
    const Layer cells = voronoi_cells(sites, low, high);
    ASSERT_EQ(cells.feature_count(), sites.size());
    Rational twice_area = 0;
    for (std::uint32_t site = 0; site < sites.size(); ++site) {
      for (std::uint32_t p = cells.feature_begin[site]; p < cells.feature_begin[site + 1]; ++p) {
        const auto ring = cells.ring(cells.polygon_begin[p]);
        const Rational area = twice_polygon_area(cells.points, ring);
        EXPECT_GT(area, 0) << "seed " << seed;
        twice_area += area;
        for (const std::uint32_t corner : ring) {
          const RationalPoint2 at = cells.points.exact(corner);
          for (std::uint32_t other = 0; other < sites.size(); ++other) {
            EXPECT_LE(squared_distance(at, sites.exact(site)),
                      squared_distance(at, sites.exact(other)))
                << "seed " << seed;
          }
          EXPECT_TRUE(low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y);
        }
        // A corner where the boundary goes straight on would be no corner of the cell.
        for (std::size_t i = 0; i < ring.size(); ++i) {
          EXPECT_EQ(orient2d(cells.points, ring[i], ring[(i + 1) % ring.size()],
                             ring[(i + 2) % ring.size()]),
                    Sign::Positive)
              << "seed " << seed;
        }
      }
    }
    EXPECT_EQ(twice_area, 2 * (high.x - low.x) * (high.y - low.y)) << "seed " << seed;
  }
}

TEST(Voronoi, NoSitesHaveNoCells) {
  EXPECT_EQ(voronoi_cells(PointTable2(), {0, 0}, {1, 1}).feature_count(), 0U);
  EXPECT_THROW(static_cast<void>(voronoi_cells(PointTable2(), {0, 0}, {0, 1})), Error);
}

}  // namespace
}  // namespace plumb::testing::voronoi_test
