// Repair of layers: random rectangles against cells of a grid, laws on random triangles, and what
// the rules select on small layers.

#include "plumb/plane/layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::layer_test {
namespace {

using testing::Dice;
using Polygon = std::vector<Point2>;
using Features = std::vector<std::uint32_t>;

void add_polygon(Layer& layer, const Polygon& corners) {
  for (const Point2 p : corners) {
    layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.points.push_back(p);
  }
  layer.end_ring();
  layer.end_polygon();
}

Polygon box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// A layer with one polygon for each feature.
Layer layer_of(const std::vector<Polygon>& polygons) {
  Layer layer;
  for (const Polygon& p : polygons) {
    add_polygon(layer, p);
    layer.end_feature("", "");
  }
  return layer;
}

bool polygon_covers(const Layer& layer, std::uint32_t polygon, Point2 at) {
  bool is_inside = false;
  for (std::uint32_t r = layer.polygon_begin[polygon]; r < layer.polygon_begin[polygon + 1]; ++r) {
    const auto ring = layer.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 p = layer.points.approx(ring[i]);
      const Point2 q = layer.points.approx(ring[(i + 1) % ring.size()]);
      if ((p.y > at.y) == (q.y > at.y)) continue;
      const double x = p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x);
      if (x > at.x) is_inside = !is_inside;
    }
  }
  return is_inside;
}

/// Returns the features that cover a point off all edges.
Features features_at(const Layer& layer, Point2 at) {
  Features found;
  for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
    bool is_inside = false;
    for (std::uint32_t p = layer.feature_begin[f]; p < layer.feature_begin[f + 1]; ++p) {
      is_inside = is_inside || polygon_covers(layer, p, at);
    }
    if (is_inside) found.push_back(f);
  }
  return found;
}

/// Returns the area of a feature whose holes run clockwise.
double area_of(const Layer& layer, std::uint32_t feature) {
  double twice = 0;
  for (std::uint32_t p = layer.feature_begin[feature]; p < layer.feature_begin[feature + 1]; ++p) {
    for (std::uint32_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
      const auto ring = layer.ring(r);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point2 a = layer.points.approx(ring[i]);
        const Point2 b = layer.points.approx(ring[(i + 1) % ring.size()]);
        twice += a.x * b.y - a.y * b.x;
      }
    }
  }
  return twice / 2;
}

// ---------------------------------------------------------------- cells of a grid

constexpr int kGrid = 10;

/// The unit squares of a grid with a margin of one, with the features that cover each of them.
class GridCells {
 public:
  explicit GridCells(const Layer& layer) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) cover_.push_back(features_at(layer, centre(x, y)));
    }
    region_.assign(cover_.size(), -1);
    for (int c = 0; c < kSide * kSide; ++c) {
      if (region_[index(c)] < 0) flood(c, count_++);
    }
  }

  static Point2 centre(int x, int y) { return {x - 0.5, y - 0.5}; }
  static constexpr int kSide = kGrid + 2;

  const Features& cover(int x, int y) const { return cover_[index(y * kSide + x)]; }
  bool is_outside(int x, int y) const { return region_[index(y * kSide + x)] == region_[0]; }

  /// Returns for each region with overlaps, or without features, its features and its area.
  std::vector<std::tuple<Features, int>> regions() const {
    std::map<int, std::tuple<Features, int>> found;
    for (std::size_t c = 0; c < cover_.size(); ++c) {
      if (cover_[c].size() == 1 || region_[c] == region_[0]) continue;
      std::get<0>(found[region_[c]]) = cover_[c];
      ++std::get<1>(found[region_[c]]);
    }
    std::vector<std::tuple<Features, int>> sorted;
    for (const auto& [region, entry] : found) sorted.push_back(entry);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

 private:
  static std::size_t index(int c) { return static_cast<std::size_t>(c); }
  void flood(int from, int region) {
    std::vector<int> open{from};
    while (!open.empty()) {
      const int c = open.back();
      open.pop_back();
      if (region_[index(c)] >= 0) continue;
      region_[index(c)] = region;
      const int x = c % kSide, y = c / kSide;
      const std::array<std::array<int, 2>, 4> beside{
          {{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}};
      for (const auto& [i, j] : beside) {
        if (i < 0 || j < 0 || i >= kSide || j >= kSide) continue;
        if (cover(i, j) == cover(x, y)) open.push_back(j * kSide + i);
      }
    }
  }

  std::vector<Features> cover_;
  std::vector<int> region_;
  int count_ = 0;
};

/// Adds a rectangle, with a hole if there is room for a border of width 1.
void add_frame(Layer& layer, double left, double low, double right, double high) {
  add_polygon(layer, box(left, low, right, high));
  if (right - left < 3 || high - low < 3) return;
  for (const Point2 p : box(left + 1, low + 1, right - 1, high - 1)) {
    layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.points.push_back(p);
  }
  layer.end_ring();
  ++layer.polygon_begin.back();
}

Layer random_rectangles(Dice& dice) {
  Layer layer;
  const std::uint64_t features = 1 + dice.below(6);
  for (std::uint64_t f = 0; f < features; ++f) {
    const std::uint64_t polygons = dice.below(3);
    for (std::uint64_t p = 0; p < polygons; ++p) {
      const auto left = static_cast<double>(dice.below(kGrid));
      const auto low = static_cast<double>(dice.below(kGrid));
      const double right =
          left + 1 + static_cast<double>(dice.below(kGrid)) * (kGrid - left) / kGrid;
      const double high = low + 1 + static_cast<double>(dice.below(kGrid)) * (kGrid - low) / kGrid;
      add_frame(layer, left, low, std::min(std::floor(right), double{kGrid}),
                std::min(std::floor(high), double{kGrid}));
    }
    layer.end_feature("", "");
  }
  return layer;
}

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
    const LayerRepairOptions options{kRules[seed % kRules.size()], fills_gaps ? 100.0 : 0.0};
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

Layer random_triangles(Dice& dice) {
  std::vector<Polygon> polygons(2 + dice.below(12));
  const auto coordinate = [&dice] { return static_cast<double>(dice.below(1000)) / 7; };
  for (Polygon& p : polygons) {
    for (int i = 0; i < 3; ++i) {
      const double x = coordinate();
      p.push_back({x, coordinate()});
    }
  }
  return layer_of(polygons);
}

bool is_same_shape(const Layer& a, const Layer& b) {
  if (a.ring_begin != b.ring_begin || a.polygon_begin != b.polygon_begin ||
      a.feature_begin != b.feature_begin) {
    return false;
  }
  for (std::size_t i = 0; i < a.ring_corners.size(); ++i) {
    const Point2 p = a.points.approx(a.ring_corners[i]), q = b.points.approx(b.ring_corners[i]);
    if (p.x != q.x || p.y != q.y) return false;
  }
  return true;
}

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

}  // namespace
}  // namespace plumb::layer_test
