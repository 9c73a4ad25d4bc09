// Nestings in reports of layers: random boxes as rings against counts of the boxes that contain
// them, and small polygons whose rings touch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "plumb/plane/layer.h"
#include "random_layers.h"

namespace plumb::layer_test {
namespace {

using Rings = std::vector<Polygon>;
using Place = std::tuple<std::uint32_t, double, double>;  // A feature, x, y.

/// Appends a polygon of several rings to the feature that end_feature() will end.
void add_rings(Layer& layer, const Rings& rings) {
  for (const Polygon& ring : rings) {
    for (const Point2 p : ring) {
      layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
      layer.points.push_back(p);
    }
    layer.end_ring();
  }
  layer.end_polygon();
}

std::vector<Place> nestings_of(const Layer& layer) {
  const LayerReport report = check_layer(layer);
  std::vector<Place> places;
  for (const LayerRegion& region : report.regions) {
    if (region.kind != LayerRegionKind::Nesting) continue;
    EXPECT_TRUE(region.at && report.features_of(region).size() == 1);
    EXPECT_EQ(region.area, 0);
    EXPECT_EQ(region.owner, LayerRegion::kNobody);
    places.emplace_back(report.features_of(region).front(), region.at->x, region.at->y);
  }
  EXPECT_TRUE(places.empty() || report.has_defects());
  const RepairedLayer repaired = repair_layer(layer);
  EXPECT_EQ(repaired.report.count(LayerRegionKind::Nesting), places.size());
  EXPECT_EQ(check_layer(repaired.layer).count(LayerRegionKind::Nesting), 0U);
  return places;
}

std::vector<Place> nestings_of(const Rings& rings) {
  Layer layer;
  add_rings(layer, rings);
  layer.end_feature("", "");
  return nestings_of(layer);
}

Polygon reversed(Polygon ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

struct Box {
  double left, low, right, high;
};

bool contains(const Box& a, const Box& b) {
  return a.left < b.left && b.right < a.right && a.low < b.low && b.high < a.high;
}

bool is_apart(const Box& a, const Box& b) {
  return a.right < b.left || b.right < a.left || a.high < b.low || b.high < a.low;
}

/// Returns boxes of which any two are apart or one contains the other.
std::vector<Box> random_boxes(Dice& dice) {
  constexpr std::size_t kSize = 64;
  std::vector<Box> boxes;
  for (int i = 0; i < 60; ++i) {
    const auto left = static_cast<double>(dice.below(kSize));
    const auto low = static_cast<double>(dice.below(kSize));
    const Box box{left, low, left + 1 + static_cast<double>(dice.below(kSize)),
                  low + 1 + static_cast<double>(dice.below(kSize))};
    const bool fits = std::all_of(boxes.begin(), boxes.end(), [&](const Box& other) {
      return contains(box, other) || contains(other, box) || is_apart(box, other);
    });
    if (fits) boxes.push_back(box);
  }
  return boxes;
}

TEST(MisplacedHoles, are_the_holes_in_an_even_number_of_other_rings) {
  std::size_t found = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Layer layer;
    std::vector<Place> expected;
    for (std::uint32_t f = 0; f < 4; ++f) {
      for (std::size_t p = 0; p <= dice.below(2); ++p) {
        const std::vector<Box> boxes = random_boxes(dice);
        Rings rings;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          const Polygon ring = box(boxes[i].left, boxes[i].low, boxes[i].right, boxes[i].high);
          rings.push_back(dice.below(2) == 0 ? ring : reversed(ring));
          const auto around = std::count_if(boxes.begin(), boxes.end(), [&](const Box& other) {
            return contains(other, boxes[i]);
          });
          if (i == 0) continue;
          ++others;
          if (around % 2 != 0) continue;
          expected.emplace_back(f, rings.back().front().x, rings.back().front().y);
        }
        add_rings(layer, rings);
      }
      layer.end_feature("", "");
    }
    EXPECT_EQ(nestings_of(layer), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 500U);
  EXPECT_GT(others, found + 500U);
}

TEST(MisplacedHoles, are_told_where_they_are) {
  EXPECT_EQ(nestings_of({box(0, 0, 4, 4), box(6, 1, 8, 2)}), (std::vector<Place>{{0, 6, 1}}));
  // A hole in a hole, and the rings of a polygon in the wrong order.
  EXPECT_EQ(nestings_of({box(0, 0, 9, 9), box(1, 1, 8, 8), box(3, 3, 4, 4)}),
            (std::vector<Place>{{0, 3, 3}}));
  EXPECT_EQ(nestings_of({box(3, 3, 4, 4), box(1, 1, 8, 8)}), (std::vector<Place>{{0, 1, 1}}));
  // Holes that touch their outer ring from outside, at a corner and along a part of an edge.
  EXPECT_EQ(nestings_of({box(0, 0, 4, 4), box(4, 4, 6, 6)}), (std::vector<Place>{{0, 4, 4}}));
  EXPECT_EQ(nestings_of({box(0, 0, 4, 4), box(4, 1, 6, 2)}), (std::vector<Place>{{0, 4, 1}}));
}

TEST(MisplacedHoles, are_not_holes_that_touch_or_cross) {
  EXPECT_TRUE(nestings_of({box(0, 0, 4, 4), box(1, 1, 2, 2)}).empty());
  EXPECT_TRUE(nestings_of({box(0, 0, 4, 4), {{0, 0}, {2, 1}, {1, 2}}}).empty());
  EXPECT_TRUE(nestings_of({box(0, 0, 4, 4), box(3, 1, 4, 2)}).empty());
  EXPECT_TRUE(nestings_of({box(0, 0, 4, 4), box(0, 0, 4, 4)}).empty());
  // These cross, which the report says instead.
  EXPECT_TRUE(nestings_of({box(0, 0, 4, 4), box(3, 1, 5, 2)}).empty());
  // An island in a lake, and another polygon of the feature that fills a lake.
  Layer layer;
  add_rings(layer, {box(0, 0, 9, 9), box(1, 1, 8, 8)});
  add_rings(layer, {box(2, 2, 7, 7), box(3, 3, 4, 4)});
  add_rings(layer, {box(3, 3, 4, 4)});
  layer.end_feature("", "");
  EXPECT_TRUE(nestings_of(layer).empty());
}

}  // namespace
}  // namespace plumb::layer_test
