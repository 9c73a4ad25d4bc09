// Divided surfaces against engine/plane, on flat meshes: random polygons in all degenerate positions.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "generate/dice.h"
#include "generate/surface_program.h"
#include "oracle/surface_oracle.h"

namespace plumb::testing {
namespace {

RationalPoint2 random_point(Dice& dice, const FlatScene& scene, std::int64_t unit) {
  const Rational x = Rational(dice.between(0, scene.columns * unit)) / unit;
  const Rational y = Rational(dice.between(0, scene.rows * unit)) / unit;
  return {x, y};
}

std::string to_text(const FlatScene& scene) {
  std::string text = std::to_string(scene.columns) + " x " + std::to_string(scene.rows);
  for (const auto& polygon : scene.polygons) {
    text += "\n ";
    for (const RationalPoint2& p : polygon) text += " " + p.x.str() + "," + p.y.str();
  }
  return text;
}

/// Corners on a grid of `unit` steps a square; with one step all lie on vertices.
FlatScene random_scene(Dice& dice, std::int64_t unit) {
  FlatScene scene;
  scene.columns = static_cast<std::uint32_t>(dice.between(1, 4));
  scene.rows = static_cast<std::uint32_t>(dice.between(1, 4));
  const std::int64_t polygons = dice.between(1, 4);
  for (std::int64_t p = 0; p < polygons; ++p) {
    auto& polygon = scene.polygons.emplace_back();
    const std::int64_t corners = dice.between(0, 7);
    for (std::int64_t i = 0; i < corners; ++i) {
      const bool repeats = !polygon.empty() && dice.between(0, 5) == 0;
      polygon.push_back(repeats ? polygon[dice.below(polygon.size())]
                                : random_point(dice, scene, unit));
    }
    if (p > 0 && dice.between(0, 7) == 0)
      polygon = scene.polygons[dice.below(scene.polygons.size())];
  }
  return scene;
}

class OnPlane : public ::testing::TestWithParam<std::int64_t> {};

TEST_P(OnPlane, CellsLabelsRegionsAndBorders) {
  const auto unit = static_cast<std::uint64_t>(GetParam());
  for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    Dice dice(1000 * unit + seed);
    const FlatScene scene = random_scene(dice, GetParam());
    EXPECT_EQ(disagreement_on_plane(scene, seed % 3 == 0 ? 0 : seed), "") << "seed " << seed << "\n"
                                                                          << to_text(scene);
  }
}

INSTANTIATE_TEST_SUITE_P(Units, OnPlane, ::testing::Values(1, 2, 3, 5, 7, 64, 1000));

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
}  // namespace plumb::testing
