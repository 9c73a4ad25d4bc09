// The filter of the orientation of boxes against orient3d() of points in the boxes.
#include "plumb/predicates/space/box_orientation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

#include "plumb/predicates/input_predicates.h"

namespace plumb {
namespace {

using Boxes = std::array<PointBox, 4>;

FilteredSign filter(const Boxes& boxes) {
  return rung::orient3d_filter(boxes[0], boxes[1], boxes[2], boxes[3]);
}

/// Random boxes around small multiples of 1/16 whose radii are powers of two, so that the corners
/// of the boxes are doubles. The middles are in one plane up to a few radii.
class RandomBoxes {
 public:
  Boxes next() {
    Boxes boxes;
    const double radius = std::ldexp(1, -between(1, 40));
    for (PointBox& box : boxes) {
      box.radius = std::ldexp(radius, -between(0, 2));
      for (double& x : box.mid) x = between(-64, 64) / 16.0;
    }
    const double x = between(0, 3), y = between(0, 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = boxes[0].mid[k], b = boxes[1].mid[k], c = boxes[2].mid[k];
      boxes[3].mid[k] = a + x * (b - a) + y * (c - a) + radius * between(-40, 40);
    }
    return boxes;
  }
  Point3 corner(const PointBox& box) {
    std::array<double, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = box.mid[k] + between(-1, 1) * box.radius;
    return {at[0], at[1], at[2]};
  }

 private:
  int between(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low + 1);
    return low + static_cast<int>(random_() % count);
  }
  std::mt19937_64 random_{1};
};

TEST(BoxOrientation, IsThatOfAllPointsInTheBoxes) {
  RandomBoxes random;
  int decided_count = 0, unsure_count = 0;
  for (int i = 0; i < 20000; ++i) {
    const Boxes boxes = random.next();
    const FilteredSign sign = filter(boxes);
    ++(is_decided(sign) ? decided_count : unsure_count);
    if (!is_decided(sign)) continue;
    for (int j = 0; j < 16; ++j) {
      const Sign of_corners = orient3d(random.corner(boxes[0]), random.corner(boxes[1]),
                                       random.corner(boxes[2]), random.corner(boxes[3]));
      ASSERT_EQ(decided(sign), of_corners) << "boxes " << i;
    }
  }
  EXPECT_GT(decided_count, 2000);
  EXPECT_GT(unsure_count, 2000);
}

TEST(BoxOrientation, NeedsFiniteRadii) {
  Boxes boxes{{{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}, {{0, 0, 0}, 0}}};
  EXPECT_EQ(filter(boxes), FilteredSign::Positive);
  std::swap(boxes[0], boxes[1]);
  EXPECT_EQ(filter(boxes), FilteredSign::Negative);
  for (PointBox& box : boxes) {
    box.radius = std::numeric_limits<double>::infinity();
    EXPECT_EQ(filter(boxes), FilteredSign::Unsure);
    box.radius = 0;
  }
  boxes[3] = boxes[0];
  EXPECT_EQ(filter(boxes), FilteredSign::Unsure);
}

}  // namespace
}  // namespace plumb
