// Divided surfaces against engine/plane, on flat meshes: random polygons in all degenerate
// positions.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "generate/surface_program.h"
#include "oracle/surface_oracle.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::surface_plane_test {
namespace {

std::string to_text(const FlatScene& scene) {
  std::string text = std::to_string(scene.columns) + " x " + std::to_string(scene.rows);
  for (const auto& polygon : scene.polygons) {
    text += "\n ";
    for (const RationalPoint2& p : polygon) text += " " + p.x.str() + "," + p.y.str();
  }
  return text;
}

/// What RapidCheck makes and shrinks: corners of polygons, in steps of the grid; small ones, when
/// it is done.
using Corner = std::pair<std::uint16_t, std::uint16_t>;
using Outlines = std::vector<std::vector<Corner>>;
constexpr std::size_t kMostPolygons = 4;
constexpr std::size_t kMostCorners = 7;

/// Corners on a grid of `unit` steps a square; with one step all lie on vertices. Any outlines are
/// a scene.
FlatScene scene_of(std::uint32_t columns, std::uint32_t rows, std::uint32_t unit,
                   const Outlines& outlines) {
  FlatScene scene{columns, rows, {}};
  for (std::size_t p = 0; p < std::min(outlines.size(), kMostPolygons); ++p) {
    auto& polygon = scene.polygons.emplace_back();
    for (std::size_t i = 0; i < std::min(outlines[p].size(), kMostCorners); ++i) {
      const auto& [x, y] = outlines[p][i];
      polygon.push_back(
          {Rational(x % (columns * unit + 1)) / unit, Rational(y % (rows * unit + 1)) / unit});
    }
  }
  return scene;
}

/// Appends a polygon of corners of the first, and the first itself, either way round.
void repeat(const std::vector<std::uint8_t>& again, Outlines& outlines) {
  if (again.empty() || outlines.empty() || outlines[0].empty()) return;
  const std::vector<Corner> first(
      outlines[0].begin(),
      outlines[0].begin() + static_cast<long>(std::min(outlines[0].size(), kMostCorners)));
  outlines.resize(std::min(outlines.size(), kMostPolygons - 2));
  outlines.push_back(first);
  if (again[0] % 2 == 1) std::reverse(outlines.back().begin(), outlines.back().end());
  outlines.emplace_back();
  for (const std::uint8_t i : again) outlines.back().push_back(first[i % first.size()]);
}

class OnPlane : public ::testing::TestWithParam<std::uint32_t> {};

TEST_P(OnPlane, CellsLabelsRegionsAndBorders) {
  const bool holds =
      rc::check("scenes agree", [](std::uint8_t size, std::uint8_t shuffle, Outlines outlines,
                                   const std::vector<std::uint8_t>& again) {
        if (shuffle % 4 == 0) repeat(again, outlines);
        const FlatScene scene = scene_of(1 + size % 4U, 1 + size / 4 % 4U, GetParam(), outlines);
        RC_LOG() << to_text(scene);
        RC_ASSERT(disagreement_on_plane(scene, shuffle % 8U) == "");
      });
  EXPECT_TRUE(holds);
}

INSTANTIATE_TEST_SUITE_P(Units, OnPlane, ::testing::Values(1, 2, 3, 5, 64, 1000));

// Many segments in few faces: boxes in a tree, islands within islands.
TEST(OnPlaneCrowded, ManySegmentsInOneFace) {
  for (std::uint64_t seed = 0; seed < 6 && !HasFailure(); ++seed) {
    Dice dice(seed);
    FlatScene scene;
    for (int p = 0; p < 12; ++p) {
      const RationalPoint2 low = {Rational(dice.between(1, 60)) / 200,
                                  Rational(dice.between(1, 60)) / 400};
      const Rational width = Rational(dice.between(1, 40)) / 100;
      const Rational height = Rational(dice.between(1, 40)) / 400;
      // Below the diagonal.
      const Rational shift = Rational(1) / 2;
      scene.polygons.push_back({{low.x + shift, low.y},
                                {low.x + shift + width / 2, low.y},
                                {low.x + shift + width / 2, low.y + height},
                                {low.x + shift, low.y + height}});
    }
    EXPECT_EQ(disagreement_on_plane(scene, seed), "") << to_text(scene);
  }
}

// ---------------------------------------------------------------- any bytes, shrunk when they fail

TEST(OnPlaneAnything, AnyProgramAgrees) {
  const bool holds = rc::check("programs agree", [](const std::vector<std::uint8_t>& bytes) {
    RC_ASSERT(disagreement_on_surface(bytes) == "");
  });
  EXPECT_TRUE(holds);
}

// Meshes and paths that nobody has checked: refused, or sound.
TEST(OnPlaneAnything, RawScenes) {
  for (std::uint64_t seed = 0; seed < 1000 && !HasFailure(); ++seed) {
    Dice dice(seed);
    std::vector<std::uint8_t> bytes = {7, static_cast<std::uint8_t>(seed), 0};
    const std::size_t records = 2 + seed % 14;
    for (std::size_t i = 0; i < 3 * records; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(dice.below(256)));
    }
    EXPECT_EQ(disagreement_on_surface(bytes), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace plumb::testing::surface_plane_test
