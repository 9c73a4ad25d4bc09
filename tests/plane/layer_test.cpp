// Repair of layers: random rectangles against cells of a grid, laws on random triangles, and what
// the rules select on small layers.

#include "plumb/plane/layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "plumb/predicates/rounding.h"
#include "random_layers.h"

namespace plumb::layer_test {
namespace {

// ---------------------------------------------------------------- cells of a grid

void expect_regions(const GridCells& cells, const LayerReport& report) {
  std::vector<std::tuple<Features, int>> found;
  for (const LayerRegion& region : report.regions) {
    const auto features = report.features_of(region);
    const bool is_overlap = region.kind == LayerRegionKind::Overlap;
    found.push_back({is_overlap ? Features(features.begin(), features.end()) : Features(),
                     static_cast<int>(nearest_double(region.area))});
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, cells.regions());
}

/// Cells that one feature covers stay, others go to a feature of theirs, gaps are filled.
void expect_owners(const GridCells& cells, const Layer& repaired, bool fills_gaps) {
  for (int y = 0; y < GridCells::kSide; ++y) {
    for (int x = 0; x < GridCells::kSide; ++x) {
      const Features owners = features_at(repaired, GridCells::centre(x, y));
      const Features& before = cells.cover(x, y);
      const bool is_owned = !before.empty() || (fills_gaps && !cells.is_outside(x, y));
      ASSERT_EQ(owners.size(), is_owned ? 1U : 0U) << x << ' ' << y;
      if (before.empty()) continue;
      EXPECT_TRUE(std::find(before.begin(), before.end(), owners.front()) != before.end());
    }
  }
}

TEST(Layer, is_repaired_as_the_cells_of_a_grid_say) {
  constexpr std::array kRules{OwnerRule::LongestBorder, OwnerRule::Largest, OwnerRule::Smallest,
                              OwnerRule::First};
  std::size_t overlaps = 0, gaps = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer layer = random_rectangles(dice);
    const GridCells cells(layer);
    const bool fills_gaps = seed % 3 != 0;
    const LayerRepairOptions options{kRules[seed % kRules.size()], fills_gaps ? 100.0 : 0.0, false};
    const RepairedLayer repaired = repair_layer(layer, options);
    expect_regions(cells, repaired.report);
    expect_owners(cells, repaired.layer, fills_gaps);
    overlaps += repaired.report.count(LayerRegionKind::Overlap);
    gaps += repaired.report.count(LayerRegionKind::Gap);
  }
  EXPECT_GT(overlaps, 300U);
  EXPECT_GT(gaps, 20U);
}

// ---------------------------------------------------------------- laws

TEST(Layer, is_a_coverage_after_one_repair) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const LayerRepairOptions options{seed % 2 == 0 ? OwnerRule::LongestBorder : OwnerRule::Largest,
                                     0.5};
    const RepairedLayer once = repair_layer(random_triangles(dice), options);
    EXPECT_TRUE(once.layer.points.all_double());
    const RepairedLayer twice = repair_layer(once.layer, options);
    EXPECT_EQ(twice.report.count(LayerRegionKind::Overlap), 0U);
    EXPECT_EQ(twice.report.rounding.largest_move, 0);
    if (twice.report.count(LayerRegionKind::Gap) == 0) {
      EXPECT_TRUE(is_same_shape(once.layer, twice.layer));
    }
  }
}

/// The areas of features change by the regions that they get or lose, and by nothing else.
TEST(Layer, keeps_all_area_outside_of_the_reported_regions) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer layer = random_triangles(dice);
    const RepairedLayer repaired = repair_layer(layer, {OwnerRule::Smallest, 2.0});
    std::vector<double> expected;
    for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
      expected.push_back(std::fabs(area_of(layer, f)));
    }
    for (const LayerRegion& region : repaired.report.regions) {
      const double area = nearest_double(region.area);
      if (region.kind == LayerRegionKind::Overlap) {
        for (const std::uint32_t f : repaired.report.features_of(region)) expected[f] -= area;
      }
      if (region.owner != LayerRegion::kNobody) expected[region.owner] += area;
    }
    for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
      EXPECT_NEAR(area_of(repaired.layer, f), expected[f], 1e-8) << f;
    }
  }
}

// ---------------------------------------------------------------- rules

std::uint32_t owner_of(const Layer& layer, OwnerRule rule) {
  const LayerReport report = repair_layer(layer, {rule, 1.5}).report;
  EXPECT_EQ(report.regions.size(), 1U);
  return report.regions.empty() ? LayerRegion::kNobody : report.regions.front().owner;
}

TEST(Layer, overlap_goes_to_the_feature_of_the_rule) {
  // Feature 0 is flat and wide, feature 1 is high: they overlap in [8,10] x [0,2].
  const Layer layer = layer_of({box(0, 0, 10, 2), box(8, 0, 12, 9)});
  EXPECT_EQ(owner_of(layer, OwnerRule::First), 0U);
  EXPECT_EQ(owner_of(layer, OwnerRule::Largest), 1U);
  EXPECT_EQ(owner_of(layer, OwnerRule::Smallest), 0U);
  EXPECT_EQ(owner_of(layer, OwnerRule::LongestBorder), 1U) << "4 against 2";
}

TEST(Layer, gap_goes_to_a_neighbour_and_a_hole_stays) {
  // The gap [4,5] x [1,9] lies between two halves of a frame.
  const Polygon left{{0, 0}, {5, 0}, {5, 1}, {4, 1}, {4, 9}, {5, 9}, {5, 10}, {0, 10}};
  const Polygon right = box(5, 0, 10, 10);
  const Layer layer = layer_of({right, left});
  EXPECT_EQ(owner_of(layer, OwnerRule::LongestBorder), 1U) << "10 against 8";
  EXPECT_EQ(owner_of(layer, OwnerRule::Largest), 0U);
  const RepairedLayer kept = repair_layer(layer, {OwnerRule::First, 0.5});
  ASSERT_EQ(kept.report.regions.size(), 1U);
  const LayerRegion& hole = kept.report.regions.front();
  EXPECT_EQ(hole.kind, LayerRegionKind::Hole);
  EXPECT_EQ(hole.owner, LayerRegion::kNobody);
  EXPECT_EQ(hole.area, 8);
  EXPECT_DOUBLE_EQ(hole.width, 16.0 / 18);
  EXPECT_FALSE(kept.report.has_defects());
  EXPECT_EQ(features_at(kept.layer, {4.5, 5}), Features());
}

/// The kind of the only region of a layer of 70000 x 70000 in which it is uncovered, by default.
LayerRegionKind kind_by_default(const std::vector<Polygon>& polygons) {
  const LayerReport report = check_layer(layer_of(polygons));
  EXPECT_GT(report.gaps_below, 9);
  EXPECT_EQ(report.regions.size(), 1U);
  return report.regions.empty() ? LayerRegionKind::Overlap : report.regions.front().kind;
}

/// Two halves of a square around a box, whose sides the border between them meets at x = 30000.
std::vector<Polygon> halves_around(double left, double low, double right, double high) {
  const double x = 30000, end = 70000;
  return {
      {{0, 0}, {x, 0}, {x, low}, {left, low}, {left, high}, {x, high}, {x, end}, {0, end}},
      {{x, 0}, {end, 0}, {end, end}, {x, end}, {x, high}, {right, high}, {right, low}, {x, low}}};
}

TEST(Layer, small_lakes_are_no_gaps_unless_a_width_is_given) {
  const std::vector<Polygon> lake = halves_around(29998, 10000, 30002, 10004);
  EXPECT_EQ(kind_by_default(lake), LayerRegionKind::Hole);
  EXPECT_EQ(check_layer(layer_of(lake), {OwnerRule::First, 9.0}).count(LayerRegionKind::Gap), 1U);
  // A gap is long, or a trace of rounding, or lies between three features.
  EXPECT_EQ(kind_by_default(halves_around(29998, 10000, 30002, 20000)), LayerRegionKind::Gap);
  EXPECT_EQ(kind_by_default(halves_around(29999.99999, 10000, 30000.00001, 10000.00001)),
            LayerRegionKind::Gap);
  const double end = 70000, low = 39998, high = 40002;
  EXPECT_EQ(kind_by_default({{{0, 0}, {end, 0}, {high, low}, {low, low}},
                             {{end, 0}, {end, end}, {40000, high}, {high, low}},
                             {{end, end}, {0, end}, {0, 0}, {low, low}, {40000, high}}}),
            LayerRegionKind::Gap);
  // Wide regions are holes, however long they are.
  EXPECT_EQ(kind_by_default(halves_around(29900, 10, 30100, 69990)), LayerRegionKind::Hole);
}

TEST(Layer, feature_inside_another_one_keeps_its_area) {
  const RepairedLayer inside = repair_layer(layer_of({box(0, 0, 9, 9), box(3, 3, 4, 4)}));
  EXPECT_EQ(features_at(inside.layer, {3.5, 3.5}), Features{1});
  EXPECT_TRUE(inside.report.emptied.empty());
  const RepairedLayer equal = repair_layer(layer_of({box(0, 0, 9, 9), box(0, 0, 9, 9)}));
  EXPECT_EQ(equal.report.emptied, Features{1});
}

TEST(Layer, hole_that_touches_its_shell_is_no_defect) {
  Layer layer;
  for (const Point2 p : Polygon{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 4}, {7, 4}}) {
    layer.points.push_back(p);
  }
  layer.ring_corners = {0, 1, 2, 3, 4, 1, 5, 6};
  layer.ring_begin = {0, 5, 8};
  layer.end_polygon();
  layer.end_feature("1", "");
  layer.ring_corners.insert(layer.ring_corners.end(), {1, 6, 5});
  layer.end_ring();
  layer.end_polygon();
  layer.end_feature("2", "{}");
  const RepairedLayer repaired = repair_layer(layer);
  EXPECT_TRUE(repaired.report.regions.empty());
  EXPECT_EQ(area_of(repaired.layer, 0), 92);
  EXPECT_EQ(area_of(repaired.layer, 1), 8);
  EXPECT_EQ(repaired.layer.ring_count(), 3U);
  EXPECT_EQ(repaired.layer.id(1), "2");
  EXPECT_EQ(repaired.layer.properties(1), "{}");
}

TEST(Layer, default_width_of_gaps_is_a_part_of_the_diagonal) {
  EXPECT_DOUBLE_EQ(repair_layer(layer_of({box(0, 0, 3, 4)})).report.gaps_below, 5e-4);
  EXPECT_EQ(repair_layer(Layer()).report.gaps_below, 0);
}

/// The layer with all coordinates multiplied by 2^exponent, which is exact here.
Layer scaled(const Layer& layer, int exponent) {
  Layer result = layer;
  result.points = {};
  for (std::uint32_t i = 0; i < layer.points.size(); ++i) {
    const Point2 p = layer.points.approx(i);
    result.points.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)});
  }
  return result;
}

// Four blocks around a gap between four features, and an overlap.
TEST(Layer, is_judged_alike_at_every_scale) {
  const Layer layer = layer_of({box(0, 0, 4, 2), box(4, 0, 6, 4), box(2, 4, 6, 6), box(0, 2, 2, 6),
                                box(5, 5, 7, 7), box(2, 2 + 0x1p-12, 4, 4)});
  const RepairedLayer plain = repair_layer(layer, {OwnerRule::Largest, {}, false});
  ASSERT_EQ(plain.report.count(LayerRegionKind::Gap), 1U);
  ASSERT_EQ(plain.report.count(LayerRegionKind::Overlap), 1U);
  for (const int exponent : {-300, 400, 900, 1020}) {
    SCOPED_TRACE(exponent);
    for (const bool finds_open : {false, true}) {
      const RepairedLayer large =
          repair_layer(scaled(layer, exponent), {OwnerRule::Largest, {}, finds_open});
      EXPECT_TRUE(std::isfinite(large.report.gaps_below));
      EXPECT_DOUBLE_EQ(large.report.gaps_below, std::ldexp(plain.report.gaps_below, exponent));
      ASSERT_EQ(large.report.regions.size(), plain.report.regions.size());
      for (std::size_t i = 0; i < plain.report.regions.size(); ++i) {
        EXPECT_EQ(large.report.regions[i].kind, plain.report.regions[i].kind);
        EXPECT_EQ(large.report.regions[i].owner, plain.report.regions[i].owner);
        EXPECT_DOUBLE_EQ(large.report.regions[i].width,
                         std::ldexp(plain.report.regions[i].width, exponent));
      }
    }
  }
}

}  // namespace
}  // namespace plumb::layer_test
