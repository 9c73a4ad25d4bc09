// Dissolving, overlaying and simplifying layers: against cells of a grid and brute force, and laws
// on random triangles and coverages.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "plumb/plane/layer.h"
#include "plumb/plane/layer/corner_tree.h"
#include "plumb/plane/layer_dissolve.h"
#include "plumb/plane/layer_overlay.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/predicates/error.h"
#include "random_layers.h"

namespace plumb::layer_test {
namespace {

constexpr std::uint32_t kNobody = LayerRegion::kNobody;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A repair without gaps finds no overlap, moves nothing, and returns the same polygons.
void expect_coverage(const Layer& layer) {
  EXPECT_TRUE(layer.points.all_double());
  const RepairedLayer repaired = repair_layer(layer, {OwnerRule::First, 0.0});
  EXPECT_EQ(repaired.report.count(LayerRegionKind::Overlap), 0U);
  EXPECT_EQ(repaired.report.rounding.largest_move, 0);
  EXPECT_TRUE(is_same_shape(layer, repaired.layer));
}

/// Calls visit(centre) for each cell of the grid.
template <class Visit>
void for_each_cell(const Visit& visit) {
  for (int y = 0; y < GridCells::kSide; ++y) {
    for (int x = 0; x < GridCells::kSide; ++x) visit(GridCells::centre(x, y));
  }
}

// ---------------------------------------------------------------- dissolve

TEST(LayerDissolve, is_what_the_cells_of_a_grid_say) {
  std::size_t overlaps = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer layer = random_rectangles(dice);
    std::vector<std::uint32_t> group;
    for (std::size_t f = 0; f < layer.feature_count(); ++f) {
      const auto g = static_cast<std::uint32_t>(dice.below(4));
      group.push_back(g == 3 ? kNobody : g);
    }
    const DissolvedLayer dissolved = dissolve_layer(layer, group, 3);
    expect_coverage(dissolved.layer);
    ASSERT_EQ(dissolved.layer.feature_count(), 3U);
    bool has_conflict = false;
    for_each_cell([&](Point2 at) {
      Features expected;
      for (const std::uint32_t f : features_at(layer, at)) {
        if (group[f] != kNobody && expected.empty()) expected = {group[f]};
        has_conflict = has_conflict || group[f] != group[features_at(layer, at).front()];
      }
      EXPECT_EQ(features_at(dissolved.layer, at), expected) << at.x << ' ' << at.y;
    });
    EXPECT_EQ(dissolved.overlaps > 0, has_conflict);
    overlaps += dissolved.overlaps;
  }
  EXPECT_GT(overlaps, 100U);
}

TEST(LayerDissolve, keeps_corners_of_borders_and_drops_inner_ones) {
  // Two squares with a common side, whose middle is a corner: the side vanishes.
  const Layer layer = layer_of(
      {{{0, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}, {{2, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 1}}});
  const std::vector<std::uint32_t> group{0, 0};
  const Layer one = dissolve_layer(layer, group, 1).layer;
  ASSERT_EQ(one.polygon_count(), 1U);
  EXPECT_EQ(one.ring(0).size(), 6U);
  EXPECT_EQ(area_of(one, 0), 8);
}

TEST(LayerDissolve, refuses_groups_that_do_not_fit) {
  const Layer layer = layer_of({box(0, 0, 1, 1)});
  const std::vector<std::uint32_t> none, wrong{1};
  EXPECT_THROW(dissolve_layer(layer, none, 1), Error);
  EXPECT_THROW(dissolve_layer(layer, wrong, 1), Error);
}

// ---------------------------------------------------------------- overlay

constexpr std::array kPairs{OverlayPairs::All, OverlayPairs::First, OverlayPairs::Both,
                            OverlayPairs::FirstOnly};

bool is_kept(OverlayPairs pairs, bool has_first, bool has_second) {
  switch (pairs) {
    case OverlayPairs::All:
      return has_first || has_second;
    case OverlayPairs::First:
      return has_first;
    case OverlayPairs::Both:
      return has_first && has_second;
    case OverlayPairs::FirstOnly:
      return has_first && !has_second;
  }
  return false;
}

TEST(LayerOverlay, is_what_the_cells_of_a_grid_say) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer first = random_rectangles(dice), second = random_rectangles(dice);
    const OverlayPairs pairs = kPairs[seed % kPairs.size()];
    const LayerOverlay overlay = overlay_layers(first, second, {pairs, true});
    expect_coverage(overlay.layer);
    ASSERT_EQ(overlay.layer.feature_count(), overlay.pairs.size());
    EXPECT_TRUE(overlay.vanished.empty());
    std::vector<int> area(overlay.pairs.size(), 0);
    bool has_overlap = false;
    for_each_cell([&](Point2 at) {
      const Features a = features_at(first, at), b = features_at(second, at);
      has_overlap = has_overlap || a.size() > 1;
      const Features found = features_at(overlay.layer, at);
      ASSERT_EQ(found.size(), is_kept(pairs, !a.empty(), !b.empty()) ? 1U : 0U);
      if (found.empty()) return;
      const LayerOverlay::Pair expected{a.empty() ? kNobody : a.front(),
                                        b.empty() ? kNobody : b.front()};
      EXPECT_EQ(overlay.pairs[found.front()], expected);
      ++area[found.front()];
    });
    for (std::size_t i = 0; i < area.size(); ++i) EXPECT_EQ(overlay.area[i], area[i]) << i;
    EXPECT_EQ(overlay.first_overlaps > 0, has_overlap);
  }
}

Rational total(const LayerOverlay& overlay) {
  Rational sum = 0;
  for (const Rational& area : overlay.area) sum += area;
  return sum;
}

/// Exact areas: what both cover and what only the first one covers is what the first one covers.
TEST(LayerOverlay, has_areas_that_add_up_exactly) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer first = random_triangles(dice), second = random_triangles(dice);
    const auto area = [&](OverlayPairs pairs) {
      const LayerOverlay overlay = overlay_layers(first, second, {pairs, true});
      expect_coverage(overlay.layer);
      return total(overlay);
    };
    const Rational both = area(OverlayPairs::Both), only = area(OverlayPairs::FirstOnly);
    EXPECT_EQ(both + only, area(OverlayPairs::First));
    EXPECT_GT(both, 0);
    const LayerOverlay reversed = overlay_layers(second, first, {OverlayPairs::FirstOnly, true});
    EXPECT_EQ(both + only + total(reversed), area(OverlayPairs::All));
  }
}

TEST(LayerOverlay, keeps_lakes_and_touching_rings) {
  // A frame whose hole touches the shell at a corner, over a square that covers the hole.
  Layer frame;
  for (const Point2 p : Polygon{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 4}, {7, 4}}) {
    frame.points.push_back(p);
  }
  frame.ring_corners = {0, 1, 2, 3, 4, 1, 5, 6};
  frame.ring_begin = {0, 5, 8};
  frame.end_polygon();
  frame.end_feature("", "");
  const LayerOverlay overlay =
      overlay_layers(frame, layer_of({box(0, 0, 10, 10)}), {.with_areas = true});
  expect_coverage(overlay.layer);
  ASSERT_EQ(overlay.pairs.size(), 2U);
  EXPECT_EQ(overlay.pairs[0], (LayerOverlay::Pair{0, 0}));
  EXPECT_EQ(overlay.pairs[1], (LayerOverlay::Pair{kNobody, 0}));
  EXPECT_EQ(overlay.area[0], 92);
  EXPECT_EQ(overlay.area[1], 8);
}

TEST(LayerOverlay, of_empty_layers_is_empty) {
  EXPECT_EQ(overlay_layers(Layer(), Layer()).layer.feature_count(), 0U);
  const Layer square = layer_of({box(0, 0, 1, 1)});
  EXPECT_EQ(overlay_layers(Layer(), square).layer.feature_count(), 1U);
  EXPECT_EQ(overlay_layers(square, Layer(), {OverlayPairs::Both, false}).pairs.size(), 0U);
}

// ---------------------------------------------------------------- simplify

/// A coverage of cells of a grid whose corners and borders were moved at random. Some cells are
/// left out, so there are lakes.
Layer random_coverage(Dice& dice) {
  constexpr int kCells = 5, kSteps = 6, kSide = kCells * kSteps;
  const auto moved = [&] { return (static_cast<double>(dice.below(1000)) / 1000 - 0.5) * 0.9; };
  std::vector<Point2> at;
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x) {
      const double dx = moved();
      at.push_back({x + dx, y + moved()});
    }
  }
  const auto corner = [&](int x, int y) {
    return at[static_cast<std::size_t>(y * (kSide + 1) + x)];
  };
  Layer layer;
  for (int cy = 0; cy < kCells; ++cy) {
    for (int cx = 0; cx < kCells; ++cx) {
      if (dice.below(6) == 0) continue;
      Polygon ring;
      const int x = cx * kSteps, y = cy * kSteps;
      for (int i = 0; i < kSteps; ++i) ring.push_back(corner(x + i, y));
      for (int i = 0; i < kSteps; ++i) ring.push_back(corner(x + kSteps, y + i));
      for (int i = 0; i < kSteps; ++i) ring.push_back(corner(x + kSteps - i, y + kSteps));
      for (int i = 0; i < kSteps; ++i) ring.push_back(corner(x, y + kSteps - i));
      add_polygon(layer, ring);
      layer.end_feature(std::to_string(cy * kCells + cx), "{}");
    }
  }
  return layer;
}

/// The numbers of polygons and rings of each feature.
std::vector<std::uint32_t> shape_counts(const Layer& layer) {
  std::vector<std::uint32_t> counts;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    const std::uint32_t begin = layer.feature_begin[f], end = layer.feature_begin[f + 1];
    counts.push_back(end - begin);
    counts.push_back(layer.polygon_begin[end] - layer.polygon_begin[begin]);
  }
  return counts;
}

TEST(LayerSimplify, keeps_a_coverage_and_all_features) {
  std::size_t removed = 0, blocked = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const bool is_messy = seed % 3 == 0;
    const Layer input = is_messy ? random_triangles(dice) : random_coverage(dice);
    const Layer layer = repair_layer(input, {OwnerRule::First, 0.0}).layer;
    const double tolerance = seed % 2 == 0 ? kInfinity : 0.4;
    const SimplifiedLayer simplified = simplify_layer(layer, {tolerance, 0});
    expect_coverage(simplified.layer);
    EXPECT_EQ(shape_counts(simplified.layer), shape_counts(layer));
    for (std::size_t f = 0; f < layer.feature_count(); ++f) {
      EXPECT_EQ(simplified.layer.id(f), layer.id(f));
    }
    const SimplifiedLayer again = simplify_layer(simplified.layer, {tolerance, 0});
    EXPECT_TRUE(is_same_shape(again.layer, simplified.layer)) << "nothing is left to remove";
    EXPECT_EQ(again.corners_before, simplified.corners_after);
    if (tolerance == kInfinity) {
      EXPECT_EQ(simplified.corners_after, simplified.fixed + simplified.blocked);
    }
    removed += simplified.corners_before - simplified.corners_after;
    blocked += simplified.blocked;
  }
  EXPECT_GT(removed, 1000U);
  EXPECT_GT(blocked, 100U);
}

/// Removes the corner with the least effective area again and again, in quadratic time.
Polygon simplified_by_brute_force(Polygon ring, std::size_t kept) {
  const auto area = [&](std::size_t i) {
    const Point2 a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i];
    const Point2 c = ring[(i + 1) % ring.size()];
    return std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  };
  std::vector<double> least(ring.size(), 0);
  while (ring.size() > kept) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
      if (std::max(area(i), least[i]) < std::max(area(best), least[best])) best = i;
    }
    const double removed = std::max(area(best), least[best]);
    least[(best + ring.size() - 1) % ring.size()] = removed;
    least[(best + 1) % ring.size()] = removed;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
    least.erase(least.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return ring;
}

TEST(LayerSimplify, removes_what_brute_force_removes) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    // Corners of a circle: no triangle contains another corner.
    Polygon ring;
    double angle = 0;
    while (angle < 6) {
      ring.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
      angle += 0.05 + static_cast<double>(dice.below(1000)) / 5000;
    }
    const SimplifiedLayer simplified = simplify_layer(layer_of({ring}), {kInfinity, 0.5});
    const std::size_t kept = (ring.size() + 1) / 2;
    EXPECT_EQ(simplified.corners_after, kept);
    Polygon expected = simplified_by_brute_force(ring, kept);
    Polygon found;
    for (const std::uint32_t c : simplified.layer.ring(0)) {
      found.push_back(simplified.layer.points.approx(c));
    }
    const auto is_less = [](Point2 p, Point2 q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    std::sort(expected.begin(), expected.end(), is_less);
    std::sort(found.begin(), found.end(), is_less);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].x, expected[i].x);
      EXPECT_EQ(found[i].y, expected[i].y);
    }
  }
}

TEST(LayerSimplify, moves_borders_no_farther_than_it_may) {
  std::size_t removed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer layer = random_coverage(dice);
    std::size_t before = 0;
    for (const double within : {0.0, 0.1, 0.5, 2.0}) {
      const SimplifiedLayer simplified = simplify_layer(layer, {kInfinity, 0, within});
      expect_coverage(simplified.layer);
      EXPECT_EQ(shape_counts(simplified.layer), shape_counts(layer));
      EXPECT_LE(simplified.borders_moved, within);
      const std::size_t gone = simplified.corners_before - simplified.corners_after;
      EXPECT_GE(gone, before) << "a wider bound lets at least as many corners go here";
      before = gone;
      removed += gone;
    }
  }
  EXPECT_GT(removed, 500U);
}

TEST(LayerSimplify, does_not_cut_off_what_lies_beside_a_border) {
  // The spike of the first feature goes around an island, which has to stay outside.
  const Layer layer = layer_of({{{0, 0}, {10, 0}, {5, 8}}, box(4.5, 5, 5.5, 6)});
  const Layer nested = repair_layer(layer).layer;
  const SimplifiedLayer simplified = simplify_layer(nested, {kInfinity, 0});
  EXPECT_EQ(shape_counts(simplified.layer), shape_counts(nested));
  EXPECT_EQ(simplified.layer.ring(0).size(), 3U);
  EXPECT_EQ(simplified.corners_after, 6U) << "each ring is a triangle";
}

TEST(LayerSimplify, refuses_options_out_of_range) {
  const Layer layer = layer_of({box(0, 0, 1, 1)});
  EXPECT_THROW(simplify_layer(layer, {-1, 0}), Error);
  EXPECT_THROW(simplify_layer(layer, {std::nan(""), 0}), Error);
  EXPECT_THROW(simplify_layer(layer, {1, 1.5}), Error);
  EXPECT_THROW(simplify_layer(layer, {1, 0, -1}), Error);
}

TEST(CornerTree, finds_what_brute_force_finds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    std::vector<Point2> points;
    for (std::uint64_t i = dice.below(200); i > 0; --i) {
      const auto x = static_cast<double>(dice.below(20));
      points.push_back({x, static_cast<double>(dice.below(20))});
    }
    CornerTree tree(points);
    std::vector<std::uint8_t> is_left(points.size(), 1);
    for (int round = 0; round < 100; ++round) {
      const auto x = static_cast<double>(dice.below(20)), y = static_cast<double>(dice.below(20));
      const Point2 a{x, y}, b{x + 7, y + 1}, c{x + 2, y + 5};
      const auto is_inside = [&](Point2 p) {
        const auto turn = [&](Point2 q, Point2 r) {
          return (r.x - q.x) * (p.y - q.y) - (r.y - q.y) * (p.x - q.x);
        };
        return turn(a, b) >= 0 && turn(b, c) >= 0 && turn(c, a) >= 0;
      };
      std::vector<std::uint8_t> found(points.size(), 0), expected(points.size(), 0);
      tree.find_in_triangle(a, b, c, [&](std::uint32_t i) {
        found[i] = is_inside(points[i]) ? 1 : 0;
        return false;
      });
      for (std::size_t i = 0; i < points.size(); ++i) {
        expected[i] = is_left[i] != 0 && is_inside(points[i]);
      }
      ASSERT_EQ(found, expected) << seed << ' ' << round;
      const auto next = static_cast<std::uint32_t>(round);
      if (next >= points.size()) break;
      tree.remove(next);
      is_left[next] = 0;
    }
  }
}

}  // namespace
}  // namespace plumb::layer_test
