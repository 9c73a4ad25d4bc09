// Cells that boxes occupy, held against the boxes themselves.
#include "plumb/space/bounds/occupied_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::occupied_cells_test {
namespace {

using testing::Dice;

constexpr Box3 kAround{{-1, -2, 0}, {3, 2, 1}};

/// A box that meets kAround and may reach beyond it. Some have no extent along an axis.
Box3 random_box(Dice& dice, std::int64_t most) {
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    const double unit = (kAround.high[i] - kAround.low[i]) / 4096;
    box.low[i] = kAround.low[i] + unit * static_cast<double>(dice.between(-40, 4096));
    box.high[i] = box.low[i] + unit * static_cast<double>(dice.between(0, most));
    box.high[i] = std::max(box.high[i], kAround.low[i]);
  }
  return box;
}

// Boxes that meet are never told apart; boxes that are a cell and more apart always are.
TEST(OccupiedCells, AgreeWithBoxes) {
  Dice dice(311);
  std::size_t met = 0, apart = 0;
  for (int round = 0; round < 400; ++round) {
    const std::int64_t most = dice.below(2) == 0 ? 60 : 400;
    std::vector<Box3> boxes;
    for (int i = 0; i < 20; ++i) boxes.push_back(random_box(dice, most));
    const OccupiedCells cells(kAround, boxes);
    for (int i = 0; i < 60; ++i) {
      const Box3 query = random_box(dice, most);
      Box3 wide = query;
      for (std::size_t k = 0; k < 3; ++k) {
        const double cell = (kAround.high[k] - kAround.low[k]) / 63;
        wide.low[k] -= cell;
        wide.high[k] += cell;
      }
      const auto meets = [&](const Box3& box) {
        return std::ranges::any_of(boxes, [&](const Box3& other) { return box.meets(other); });
      };
      if (meets(query)) {
        ++met;
        EXPECT_TRUE(cells.may_meet(query));
      } else if (!meets(wide)) {
        ++apart;
        EXPECT_FALSE(cells.may_meet(query));
      }
    }
  }
  EXPECT_GT(met, 100U);
  EXPECT_GT(apart, 1000U);
}

// Large boxes, and grids without bounds, tell nothing apart.
TEST(OccupiedCells, GiveUpOnLargeBoxes) {
  const Box3 corner{{-1, -2, 0}, {-1, -2, 0}};
  const std::vector<Box3> large(5, Box3{{0, -2, 0}, {3, 2, 1}});
  EXPECT_TRUE(OccupiedCells(kAround, large).may_meet(corner));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Box3 everywhere{{-kInfinity, -2, 0}, {kInfinity, 2, 1}};
  const std::vector<Box3> small(5, Box3{{1, 1, 1}, {1, 1, 1}});
  EXPECT_TRUE(OccupiedCells(everywhere, small).may_meet(corner));
  EXPECT_FALSE(OccupiedCells(kAround, small).may_meet(corner));
}

}  // namespace
}  // namespace plumb::occupied_cells_test
