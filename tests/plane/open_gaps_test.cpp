// Gaps that open to the outside or into a hole: two blocks of squares with a channel of known width
// between them, notches and dents, channels into lakes, and laws on random layers.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/plane/layer.h"
#include "plumb/predicates/rounding.h"
#include "random_layers.h"

namespace plumb::layer_test {
namespace {

LayerRepairOptions below(double width) { return {OwnerRule::LongestBorder, width}; }

/// The open gaps of a report.
std::vector<LayerRegion> open_gaps(const LayerReport& report) {
  std::vector<LayerRegion> found;
  for (const LayerRegion& region : report.regions) {
    if (region.is_open) found.push_back(region);
  }
  return found;
}

// ---------------------------------------------------------------- a channel of known width

void add_box(Layer& layer, const Rational& left, const Rational& low) {
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
    layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.points.push_back(left + x, low + y);
  }
  layer.end_ring();
  layer.end_polygon();
  layer.end_feature("", "");
}

/// A block of side x side unit squares with a corner at 0 0, and one shifted by `across` to the
/// right and by `up`. The features of the first block come first.
Layer two_blocks(int side, const Rational& across, const Rational& up) {
  Layer layer;
  for (const bool is_shifted : {false, true}) {
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        if (is_shifted) {
          add_box(layer, side + across + x, up + y);
        } else {
          add_box(layer, x, y);
        }
      }
    }
  }
  return layer;
}

TEST(OpenGaps, channel_between_shifted_squares_has_its_exact_area) {
  int wide_mouths = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const int side = 1 + static_cast<int>(dice.below(5));
    const Rational across = Rational(1 + static_cast<int>(dice.below(17)), 256);
    const Rational up = Rational(static_cast<int>(dice.below(40)), 128);
    const double w = nearest_double(across), s = nearest_double(up);
    const double bound = 0.07;
    const Layer layer = two_blocks(side, across, up);
    const LayerReport report = check_layer(layer, below(bound));
    const std::vector<LayerRegion> gaps = open_gaps(report);
    ASSERT_EQ(report.regions.size(), 1U);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_EQ(gaps[0].kind, LayerRegionKind::Gap);
    // A mouth joins the corner of one block to the other block, straight or aslant.
    const bool is_aslant = std::hypot(w, s) < bound;
    wide_mouths += is_aslant && s > 0 ? 1 : 0;
    const Rational area = across * (side - up) + (is_aslant ? Rational(across * up) : Rational(0));
    EXPECT_EQ(gaps[0].area, area);
    // The squares at the channel, on both sides.
    EXPECT_EQ(report.features_of(gaps[0]).size(), static_cast<std::size_t>(2 * side));
    // A narrower bound leaves the channel alone.
    EXPECT_FALSE(check_layer(layer, below(w * 0.999)).has_defects());
    EXPECT_FALSE(check_layer(layer, {OwnerRule::First, bound, false}).has_defects());
  }
  EXPECT_GT(wide_mouths, 10);
}

TEST(OpenGaps, channel_is_filled_and_nothing_else_changes) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const int side = 1 + static_cast<int>(dice.below(4));
    const Rational across = Rational(1 + static_cast<int>(dice.below(17)), 256);
    const Rational up = Rational(static_cast<int>(dice.below(40)), 128);
    const RepairedLayer repaired = repair_layer(two_blocks(side, across, up), below(0.07));
    const std::vector<LayerRegion> gaps = open_gaps(repaired.report);
    ASSERT_EQ(gaps.size(), 1U);
    for (std::uint32_t f = 0; f < repaired.layer.feature_count(); ++f) {
      const double more = f == gaps[0].owner ? nearest_double(gaps[0].area) : 0;
      EXPECT_NEAR(area_of(repaired.layer, f), 1 + more, 1e-12) << f;
    }
    const RepairedLayer again = repair_layer(repaired.layer, below(0.07));
    EXPECT_TRUE(again.report.regions.empty());
    EXPECT_TRUE(is_same_shape(repaired.layer, again.layer));
  }
}

// ---------------------------------------------------------------- shapes

/// Two features left and right of x = 0 over a third one below, with a notch of a width and a
/// depth.
Layer notch(double width, double depth) {
  return layer_of({{{-9, 0}, {0, 0}, {0, depth}, {-9, depth}},
                   {{width, 0}, {9, 0}, {9, depth}, {width, depth}},
                   {{-9, -9}, {9, -9}, {9, 0}, {width, 0}, {0, 0}, {-9, 0}}});
}

TEST(OpenGaps, notch_is_a_gap_if_it_is_narrow_and_deep) {
  const LayerReport deep = check_layer(notch(0.5, 4), below(1));
  ASSERT_EQ(deep.regions.size(), 1U);
  EXPECT_TRUE(deep.regions[0].is_open);
  EXPECT_EQ(deep.regions[0].area, 2);
  EXPECT_DOUBLE_EQ(deep.regions[0].width, 4.0 / 9);
  const auto features = deep.features_of(deep.regions[0]);
  EXPECT_EQ(Features(features.begin(), features.end()), (Features{0, 1, 2}));
  EXPECT_FALSE(check_layer(notch(2, 4), below(1)).has_defects()) << "wider than the bound";
  EXPECT_FALSE(check_layer(notch(0.5, 0.2), below(1)).has_defects()) << "a short dent";
  EXPECT_TRUE(check_layer(notch(0.5, 0.3), below(1)).has_defects()) << "border 1.1, mouth 0.5";
}

TEST(OpenGaps, dents_of_one_feature_are_its_shape) {
  const Polygon comb{{0, 0}, {9, 0}, {9, 5}, {5, 5}, {5, 1}, {4.9, 1}, {4.9, 5}, {0, 5}};
  EXPECT_FALSE(check_layer(layer_of({comb}), below(1)).has_defects());
}

TEST(OpenGaps, default_needs_a_long_channel) {
  EXPECT_FALSE(check_layer(notch(1e-4, 5e-3)).has_defects()) << "50 times as long as wide";
  EXPECT_TRUE(check_layer(notch(1e-4, 5e-2)).has_defects()) << "500 times";
  EXPECT_TRUE(check_layer(notch(1e-12, 1e-11)).has_defects()) << "a trace of rounding";
}

TEST(OpenGaps, wedge_is_cut_off_where_it_is_as_wide_as_the_bound) {
  // Two features with a wedge between them, 1 wide at x = 10.
  const Layer layer = layer_of({{{0, 0}, {10, 0}, {10, -5}, {0, -5}},
                                {{0, 0}, {10, 1}, {10, 5}, {0, 5}},
                                box(-5, -5, 0, 5)});
  const LayerReport report = check_layer(layer, below(0.5));
  ASSERT_EQ(report.regions.size(), 1U);
  // Cut off at a right angle to one of the sides.
  EXPECT_NEAR(nearest_double(report.regions[0].area), 5 * 0.5 / 2, 0.05);
  EXPECT_NEAR(nearest_double(check_layer(layer, below(0.25)).regions[0].area), 2.5 * 0.25 / 2,
              0.02);
}

TEST(OpenGaps, channel_into_a_lake_is_cut_off_the_lake) {
  // Two halves around the lake [3,6] x [3,6], with a channel from it downwards to y = 1.
  const Polygon left{{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 6}, {4.5, 6}, {4.5, 9}, {0, 9}};
  const Polygon right{{4, 0}, {9, 0}, {9, 9},   {4.5, 9}, {4.5, 6},
                      {6, 6}, {6, 3}, {4.1, 3}, {4.1, 1}, {4, 1}};
  const LayerReport report = check_layer(layer_of({left, right}), below(0.5));
  ASSERT_EQ(report.regions.size(), 2U);
  const std::vector<LayerRegion> gaps = open_gaps(report);
  ASSERT_EQ(gaps.size(), 1U);
  EXPECT_NEAR(nearest_double(gaps[0].area), 0.2, 1e-12);
  for (const LayerRegion& region : report.regions) {
    EXPECT_TRUE(region.is_open || region.area == 9);
  }
}

TEST(OpenGaps, lake_behind_a_filled_channel_becomes_a_hole) {
  // The lake [3,6] x [3,6] and a channel from it to the outside.
  const Polygon left{{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 6}, {4.5, 6}, {4.5, 9}, {0, 9}};
  const Polygon right{{4.1, 0}, {9, 0}, {9, 9}, {4.5, 9}, {4.5, 6}, {6, 6}, {6, 3}, {4.1, 3}};
  const Layer layer = layer_of({left, right});
  EXPECT_TRUE(check_layer(layer, below(0.01)).regions.empty());
  const RepairedLayer repaired = repair_layer(layer, below(0.5));
  EXPECT_EQ(repaired.report.count(LayerRegionKind::Gap), 1U);
  EXPECT_EQ(repaired.report.count(LayerRegionKind::Hole), 1U);
  EXPECT_EQ(features_at(repaired.layer, {4.05, 1}).size(), 1U);
  EXPECT_TRUE(features_at(repaired.layer, {4.5, 4.5}).empty());
}

// ---------------------------------------------------------------- laws

/// Of what is uncovered, repair covers the gaps of the report; a second repair changes nothing.
TEST(OpenGaps, repair_says_that_it_ended_after_the_given_rounds) {
  const Layer layer = two_blocks(3, Rational(1, 8), Rational(1, 3));
  LayerRepairOptions options = below(0.5);
  const RepairedLayer whole = repair_layer(layer, options);
  ASSERT_EQ(open_gaps(whole.report).size(), 1U);
  EXPECT_FALSE(whole.report.is_stopped);
  options.most_rounds = 1;
  const RepairedLayer stopped = repair_layer(layer, options);
  EXPECT_TRUE(stopped.report.is_stopped);
  options.open_gaps = false;
  EXPECT_FALSE(repair_layer(layer, options).report.is_stopped) << "without open gaps, one round";
  EXPECT_FALSE(check_layer(stopped.layer, options).has_defects());
}

TEST(OpenGaps, repair_fills_what_the_report_says_and_ends) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer layer = seed % 2 == 0 ? random_triangles(dice) : random_rectangles(dice);
    const LayerRepairOptions options = below(seed % 3 == 0 ? 1.5 : 12);
    const RepairedLayer repaired = repair_layer(layer, options);
    double before = 0, filled = 0, after = 0;
    for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
      after += area_of(repaired.layer, f);
    }
    const RepairedLayer kept = repair_layer(layer, {OwnerRule::LongestBorder, 0.0, false});
    for (std::uint32_t f = 0; f < layer.feature_count(); ++f) before += area_of(kept.layer, f);
    for (const LayerRegion& region : repaired.report.regions) {
      if (region.kind == LayerRegionKind::Gap) filled += nearest_double(region.area);
    }
    EXPECT_NEAR(after, before + filled, 1e-7);
    found += open_gaps(repaired.report).size();
    const RepairedLayer again = repair_layer(repaired.layer, options);
    if (open_gaps(repaired.report).empty()) continue;
    EXPECT_FALSE(again.report.has_defects());
    EXPECT_TRUE(is_same_shape(repaired.layer, again.layer));
  }
  EXPECT_GT(found, 50U);
}

}  // namespace
}  // namespace plumb::layer_test
