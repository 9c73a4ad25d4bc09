// The grid held against the exact locator, in every rounding mode, and against the sheets that were
// put into it.
#include "plumb/space/query/volume_grid.h"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <vector>

#include "generate/meshes.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/query/volumes.h"
#include "plumb/space/space_locator.h"
#include "plumb/testing/dice.h"

namespace plumb::volume_grid_test {

using testing::Dice;
using testing::icosphere_mesh;
using testing::joined;

// Known is the volume nearly everywhere, and rightly so.
TEST(VolumeGrid, KnowsWhatIsAwayFromFacets) {
  Context context;
  SpaceComplex complex =
      complex_of_mesh(joined(icosphere_mesh(3, 1, {}), icosphere_mesh(2, 0.5, {})), {}, context)
          .complex;
  label_volumes(complex, context);
  const SpaceLocator locator(complex);
  std::vector<Box3> boxes;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    boxes.push_back(box_of(complex, FacetId(f)));
  }
  const auto volume_of = [&](const Point3& p) {
    return locator.volume_of(RationalPoint3{p.x, p.y, p.z});
  };
  const VolumeGrid grid(boxes, volume_of);
  Dice dice(11);
  const auto coordinate = [&] { return static_cast<double>(dice.between(-64, 64)) / 48; };
  std::array<int, 3> known{};
  for (int i = 0; i < 2000; ++i) {
    const double x = coordinate();
    const double y = coordinate();
    const double z = coordinate();
    const Point3 p{x, y, z};
    const VolumeId volume = grid.volume_at(p);
    if (volume.is_valid()) {
      ASSERT_EQ(locator.locate(RationalPoint3{x, y, z}), SpaceItem(volume));
      ++known[volume.value()];
    }
    const VolumeGrid::Left left = grid.left_of(p);
    if (left.volume.is_valid()) {
      ASSERT_LT(left.x, x);
      ASSERT_EQ(volume_of({left.x, y, z}), left.volume);
    }
  }
  EXPECT_GT(known[0] + known[1] + known[2], 1000);
  EXPECT_GT(known[1], 50);
  EXPECT_GT(known[2], 5);
  // Boxes without bounds, on a line but for next to nothing, none.
  boxes.push_back({{0, 0, 0}, {Box3::kInfinity, 0, 0}});
  EXPECT_FALSE(VolumeGrid(boxes, volume_of).volume_at({}).is_valid());
  boxes.back() = {{0, 0, 0}, {1e300, 1e-300, 1e-200}};
  EXPECT_TRUE(VolumeGrid(std::span(boxes).last(1), [](const Point3&) { return VolumeId(3); })
                  .volume_at({-1, 0, 0})
                  .is_valid());
  EXPECT_FALSE(VolumeGrid({}, volume_of).volume_at({}).is_valid());
}

// A grid that was laid out in one rounding mode, asked in another: never sure of a point that an
// item holds.
TEST(VolumeGrid, IsSureInNoModeOfWhatAnItemHolds) {
  std::vector<Box3> boxes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double at : {0.0, 1.0}) {
      Box3 face{{0, 0, 0}, {1, 1, 1}};
      face.low[axis] = face.high[axis] = at;
      boxes.push_back(face);
    }
  }
  int sure = 0;
  for (int parts = 3; parts < 30; ++parts) {
    for (int i = 1; i < parts; ++i) {
      const double x = static_cast<double>(i) / parts;
      std::vector<Box3> with_sheet = boxes;
      with_sheet.push_back({{x, 0, 0}, {x, 1, 1}});
      const VolumeGrid grid(with_sheet, [](const Point3&) { return VolumeId(1); });
      for (const int mode : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const bool is_sure = grid.volume_at({x, 0.5, 0.5}).is_valid();
        const bool is_sure_elsewhere = grid.volume_at({x < 0.5 ? 0.8 : 0.2, 0.5, 0.5}).is_valid();
        std::fesetround(FE_TONEAREST);
        EXPECT_FALSE(is_sure) << i << '/' << parts << " in mode " << mode;
        if (is_sure_elsewhere) ++sure;
      }
    }
  }
  EXPECT_GT(sure, 1000);
}

// One question for each part that the items leave connected: inside and outside of a closed box,
// only one where a side is open.
TEST(VolumeGrid, AsksOnceForEachConnectedPart) {
  for (const std::size_t sides : {5U, 6U}) {
    std::vector<Box3> boxes;
    for (std::size_t side = 0; side < sides; ++side) {
      Box3 face{{0, 0, 0}, {1, 1, 1}};
      face.low[side / 2] = face.high[side / 2] = side % 2 == 0 ? 0.0 : 1.0;
      boxes.push_back(face);
    }
    std::vector<Point3> asked;
    const VolumeGrid grid(boxes, [&](const Point3& p) {
      asked.push_back(p);
      return VolumeId(asked.size());
    });
    ASSERT_EQ(asked.size(), sides == 6 ? 2U : 1U);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      EXPECT_EQ(grid.volume_at(asked[i]), VolumeId(i + 1));
    }
    const VolumeId inside = grid.volume_at({0.5, 0.5, 0.5});
    const VolumeId outside = grid.volume_at({-9, 0.5, 0.5});
    ASSERT_TRUE(inside.is_valid() && outside.is_valid());
    EXPECT_EQ(inside == outside, sides == 5);
  }
}

}  // namespace plumb::volume_grid_test
