// Random models of OpenSCAD, read and evaluated, against the oracle of cells of half-spaces
// (oracle/model_check.h). The environment variable PLUMB_CASES sets the number of random models:
//
//     PLUMB_CASES=10000 build/release/tests/io/csg_models_test
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "generate/model_program.h"
#include "generate/test_share.h"
#include "oracle/model_check.h"
#include "oracle/program_property.h"

namespace plumb::testing::csg_models_test {
namespace {

TEST(CsgModels, RandomModelsAreWhatTheCellsOfTheirPlanesSay) {
  for (std::uint64_t seed = 0; seed < case_count(300); ++seed) {
    Dice dice(seed);
    const std::vector<std::uint8_t> program = random_model_program(dice, 3 + dice.below(14));
    ASSERT_EQ(flaw_of_model(program), "")
        << "seed " << seed << "\n"
        << text_of_model(model_of_program(program, kMostModelPlanes));
  }
}

TEST(CsgModels, ProgramsOfRapidCheckToo) {
  expect_no_flaw_of_programs(
      "models are what the cells of their planes say", 16,
      [](std::span<const std::uint8_t> program) { return flaw_of_model(program); });
}

TEST(CsgModels, HullsHaveThePlanesOfTheirFacets) {
  std::vector<IntegerPoint> points;
  for (std::int64_t corner = 0; corner < 8; ++corner) {
    points.push_back({corner & 1, corner >> 1 & 1, corner >> 2 & 1});
  }
  EXPECT_EQ(ModelPlanes().hull_of(points).planes.count(), 6U);
  points.resize(16);
  for (std::size_t i = 0; i < 8; ++i) {
    points[8 + i] = {points[i][0] + 1, points[i][1] - 1, points[i][2] + 1};
  }
  ModelPlanes planes;  // A zonotope of four generators.
  EXPECT_EQ(planes.hull_of(points).planes.count(), 12U);
  EXPECT_EQ(planes.planes().size(), 12U);
}

TEST(CsgModels, ThreePlanesHaveEightCellsAroundOneCorner) {
  const std::array<IntegerPlane, 3> planes{
      IntegerPlane{{1, 0, 0}, -1}, {{0, 1, 0}, 2}, {{1, 1, 1}, 0}};
  const ModelCells all = cells_of(planes);
  EXPECT_EQ(all.cells.size(), 8U);
  ASSERT_EQ(all.corners.size(), 1U);
  EXPECT_EQ(all.corners[0].cells.size(), 8U);
  EXPECT_EQ(all.corners[0].at, (ExactPoint3{1, -2, 1}));
}

TEST(CsgModels, NinePlanesOfAGridHave64Cells) {
  std::vector<IntegerPlane> planes;
  for (std::int64_t k = 0; k < 9; ++k) {
    IntegerPlane plane;
    plane.normal[static_cast<std::size_t>(k / 3)] = 1;
    plane.offset = -(k % 3);
    planes.push_back(plane);
  }
  const ModelCells all = cells_of(planes);
  EXPECT_EQ(all.cells.size(), 64U);
  EXPECT_EQ(all.corners.size(), 27U);
}

TEST(CsgModels, NPlanesInGeneralPositionHaveAsManyCellsAsTheFormulaSays) {
  // Normals (1, k, k^2) of different k are independent, and offsets k^4 let no four planes meet.
  std::vector<IntegerPlane> planes;
  constexpr std::int64_t kCount = 9;
  for (std::int64_t k = 1; k <= kCount; ++k) planes.push_back({{1, k, k * k}, -k * k * k * k});
  const ModelCells all = cells_of(planes);
  EXPECT_EQ(all.corners.size(), 84U);                // 9 choose 3
  EXPECT_EQ(all.cells.size(), 1U + 9U + 36U + 84U);  // the sum of n choose i, i up to 3
}

}  // namespace
}  // namespace plumb::testing::csg_models_test
