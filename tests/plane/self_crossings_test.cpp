// Crossings of rings in reports of layers: random rings against all pairs of edges, and small
// polygons whose rings touch, cross or lie on each other.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

#include "plumb/plane/layer.h"
#include "plumb/predicates/input_predicates.h"
#include "random_layers.h"

namespace plumb::layer_test {
namespace {

using Rings = std::vector<Polygon>;
using Place = std::tuple<std::uint32_t, double, double>;  // A feature, x, y.

/// A layer with one polygon of several rings.
Layer layer_of_rings(const Rings& rings) {
  Layer layer;
  for (const Polygon& ring : rings) {
    for (const Point2 p : ring) {
      layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
      layer.points.push_back(p);
    }
    layer.end_ring();
  }
  layer.end_polygon();
  layer.end_feature("", "");
  return layer;
}

std::vector<Place> crossings_of(const Layer& layer) {
  const LayerReport report = check_layer(layer);
  std::vector<Place> places;
  for (const LayerRegion& region : report.regions) {
    if (region.kind != LayerRegionKind::Crossing) continue;
    EXPECT_TRUE(region.at && report.features_of(region).size() == 1);
    EXPECT_EQ(region.area, 0);
    EXPECT_EQ(region.owner, LayerRegion::kNobody);
    places.emplace_back(report.features_of(region).front(), region.at->x, region.at->y);
  }
  EXPECT_TRUE(places.empty() || report.has_defects());
  const RepairedLayer repaired = repair_layer(layer);
  EXPECT_EQ(repaired.report.count(LayerRegionKind::Crossing), places.size());
  EXPECT_EQ(check_layer(repaired.layer).count(LayerRegionKind::Crossing), 0U);
  return places;
}

std::vector<Place> crossings_of(const Rings& rings) { return crossings_of(layer_of_rings(rings)); }

/// Whether two edges cross in their interiors.
bool is_crossing(Point2 a, Point2 b, Point2 c, Point2 d) {
  const auto differ = [](Sign s, Sign t) { return s != t && s != Sign::Zero && t != Sign::Zero; };
  return differ(orient2d(a, b, c), orient2d(a, b, d)) &&
         differ(orient2d(c, d, a), orient2d(c, d, b));
}

TEST(SelfCrossings, are_those_of_all_pairs_of_edges) {
  std::size_t found = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    std::vector<Polygon> rings(3);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t f = 0; f < rings.size(); ++f) {
      Polygon& ring = rings[f];
      const std::size_t corners = 3 + dice.below(6);
      while (ring.size() < corners) {
        // In general position with overwhelming probability.
        ring.push_back({static_cast<double>(dice.below(1U << 30U)),
                        static_cast<double>(dice.below(1U << 30U))});
      }
      for (std::size_t i = 0; i < corners; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (is_crossing(ring[i], ring[(i + 1) % corners], ring[j], ring[(j + 1) % corners])) {
            expected.push_back(f);
          }
        }
      }
    }
    std::vector<std::uint32_t> told;
    for (const Place& place : crossings_of(layer_of(rings))) told.push_back(std::get<0>(place));
    EXPECT_EQ(told, expected);
    found += told.size();
  }
  EXPECT_GT(found, 500U);
}

TEST(SelfCrossings, are_told_where_they_are) {
  // A bow tie, without and with a vertex at the crossing.
  EXPECT_EQ(crossings_of({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}), (std::vector<Place>{{0, 1, 1}}));
  EXPECT_EQ(crossings_of({{{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}}),
            (std::vector<Place>{{0, 1, 1}}));
  EXPECT_EQ(crossings_of({{{0, 0}, {1, 1}, {2, 2}, {2, 0}, {0, 2}}}),
            (std::vector<Place>{{0, 1, 1}}));
  // Three edges through one point are one place. The last one ends on an edge and goes on behind
  // it.
  EXPECT_EQ(crossings_of({{{0, 0}, {4, 4}, {4, 0}, {0, 4}, {0, 2}, {4, 2}, {6, 1}, {2, -2}}}),
            (std::vector<Place>{{0, 2, 2}, {0, 4, 2}}));
  // A hole that leaves its shell.
  EXPECT_EQ(crossings_of({box(0, 0, 4, 4), box(3, 1, 5, 2)}),
            (std::vector<Place>{{0, 4, 1}, {0, 4, 2}}));
}

TEST(SelfCrossings, are_edges_that_lie_on_each_other) {
  // A spike, a hole along its shell, and a ring that runs twice round.
  EXPECT_EQ(crossings_of({{{0, 0}, {4, 0}, {4, 4}, {6, 4}, {4, 4}, {0, 4}}}),
            (std::vector<Place>{{0, 4, 4}}));
  EXPECT_EQ(crossings_of({box(0, 0, 4, 4), box(3, 1, 4, 2)}).size(), 1U);
  EXPECT_EQ(crossings_of({{{0, 0}, {2, 0}, {0, 2}, {0, 0}, {2, 0}, {0, 2}}}).size(), 1U);
  // Two spikes at different places, of which one is cut by another feature.
  Layer layer = layer_of({{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {4, 4}, {0, 4}, {-2, 4}, {0, 4}},
                          {{6, 3}, {7, 3}, {7, 5}, {6, 5}}});
  EXPECT_EQ(crossings_of(layer).size(), 2U);
}

TEST(SelfCrossings, are_not_where_rings_touch) {
  // A hole touches its shell at a corner and on an edge; two holes touch each other.
  EXPECT_TRUE(crossings_of({box(0, 0, 4, 4), {{0, 0}, {2, 1}, {1, 2}}}).empty());
  EXPECT_TRUE(crossings_of({box(0, 0, 4, 4), {{0, 2}, {2, 1}, {2, 3}}}).empty());
  EXPECT_TRUE(
      crossings_of({box(0, 0, 8, 8), {{1, 1}, {4, 4}, {1, 4}}, {{4, 4}, {7, 4}, {7, 7}}}).empty());
  // The same polygon as one ring, which touches itself from inside and from outside.
  EXPECT_TRUE(crossings_of({{{0, 0}, {2, 1}, {1, 2}, {0, 0}, {0, 4}, {4, 4}, {4, 0}}}).empty());
  EXPECT_TRUE(crossings_of({{{0, 0}, {2, 2}, {4, 2}, {2, 2}, {2, 4}}}).size() == 1);  // A spike.
  EXPECT_TRUE(crossings_of({{{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 2}, {0, 2}}}).empty());
  // Neighbours whose borders pass the same vertex.
  EXPECT_TRUE(crossings_of(layer_of({box(0, 0, 1, 1), box(1, 1, 2, 2), box(1, 0, 2, 1)})).empty());
}

TEST(SelfCrossings, ignore_edges_of_length_zero) {
  EXPECT_EQ(crossings_of({{{0, 0}, {1, 1}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {1, 1}, {0, 2}}}),
            (std::vector<Place>{{0, 1, 1}}));
}

/// Returns the overlaps of a layer with one feature that has two polygons.
std::vector<double> own_overlaps(const Polygon& a, const Polygon& b) {
  Layer layer;
  add_polygon(layer, a);
  add_polygon(layer, b);
  layer.end_feature("", "");
  const RepairedLayer repaired = repair_layer(layer);
  EXPECT_FALSE(check_layer(repaired.layer).has_defects());
  std::vector<double> areas;
  for (const LayerRegion& region : repaired.report.regions) {
    EXPECT_EQ(region.kind, LayerRegionKind::Overlap);
    EXPECT_EQ(region.owner, 0U);
    EXPECT_EQ(repaired.report.features_of(region).size(), 1U);
    areas.push_back(region.area.convert_to<double>());
  }
  return areas;
}

TEST(SelfCrossings, polygons_of_one_feature_may_touch_and_do_not_overlap) {
  EXPECT_EQ(own_overlaps(box(0, 0, 4, 4), box(3, 3, 6, 6)), std::vector<double>{1});
  EXPECT_EQ(own_overlaps(box(0, 0, 4, 4), box(0, 0, 4, 4)), std::vector<double>{16});
  EXPECT_TRUE(own_overlaps(box(0, 0, 4, 4), box(4, 0, 6, 4)).empty());
  EXPECT_TRUE(own_overlaps(box(0, 0, 4, 4), box(4, 4, 6, 6)).empty());
}

}  // namespace
}  // namespace plumb::layer_test
