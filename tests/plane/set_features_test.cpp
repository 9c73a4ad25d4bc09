// The features of sets: against cells of a grid, where the first feature that covers a cell of the
// set has it, and laws on random triangles.
#include "plumb/plane/set_features.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "random_layers.h"

namespace plumb::layer_test {
namespace {

constexpr std::uint32_t kNobody = LayerRegion::kNobody;

/// Returns the set of all points that a layer covers.
Nef2 set_of(const Layer& layer) {
  std::vector<Nef2> sets;
  for (std::uint32_t p = 0; p < layer.polygon_count(); ++p) {
    const std::uint32_t begin = layer.ring_begin[layer.polygon_begin[p]];
    std::vector<std::uint32_t> chains;
    for (std::uint32_t r = layer.polygon_begin[p]; r <= layer.polygon_begin[p + 1]; ++r) {
      chains.push_back(layer.ring_begin[r] - begin);
    }
    const std::span corners = std::span(layer.ring_corners).subspan(begin, chains.back());
    sets.push_back(
        Nef2::polygons(layer.points, corners, chains, WindingRule::EvenOdd, Boundary::Closed));
  }
  return union_of(sets);
}

/// Returns a box as a set.
Nef2 box_set(double left, double low, double right, double high) {
  return Nef2::polygon(box(left, low, right, high));
}

/// A layer whose feature f has the id f and the property "n" with the value f.
Layer numbered(const Layer& layer) {
  Layer result = layer;
  result.json.clear();
  result.json_begin = {0};
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    result.json += std::to_string(f);
    result.json_begin.push_back(result.json.size());
    result.json += "{\"n\": " + std::to_string(f) + "}";
    result.json_begin.push_back(result.json.size());
  }
  return result;
}

void expect_names(const SetFeatures& parts, const Layer& sources) {
  ASSERT_EQ(parts.source.size(), parts.layer.feature_count());
  for (std::uint32_t k = 0; k < parts.source.size(); ++k) {
    const std::uint32_t f = parts.source[k];
    EXPECT_EQ(parts.layer.id(k), f == kNobody ? "" : sources.id(f));
    EXPECT_EQ(parts.layer.properties(k), f == kNobody ? "" : sources.properties(f));
    EXPECT_TRUE(k == 0 || parts.source[k - 1] < f);
    EXPECT_LT(parts.layer.feature_begin[k], parts.layer.feature_begin[k + 1]);
  }
}

TEST(SetFeatures, AreWhatTheCellsOfAGridSay) {
  std::size_t nobodys = 0, firsts_of_many = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer a = random_rectangles(dice), b = random_rectangles(dice);
    Layer sources;
    append_layer(sources, numbered(a));
    append_layer(sources, numbered(b));
    const auto some = [&] { return static_cast<double>(dice.below(kGrid)); };
    const Nef2 cut = box_set(some(), some(), kGrid, kGrid), left = set_of(a), right = set_of(b);
    const Nef2 sets[] = {left + right, left * right, left - right, left ^ right,
                         (left - right) + cut};
    for (const Nef2& set : sets) {
      const SetFeatures parts = set_features(set, sources);
      expect_names(parts, sources);
      EXPECT_FALSE(parts.is_unbounded);
      EXPECT_LT(parts.rounding.largest_move, 1e-14);
      for (int y = 0; y < GridCells::kSide; ++y) {
        for (int x = 0; x < GridCells::kSide; ++x) {
          const Point2 at = GridCells::centre(x, y);
          const Features covering = features_at(sources, at), found = features_at(parts.layer, at);
          if (!set.contains(RationalPoint2{exact_rational(at.x), exact_rational(at.y)})) {
            EXPECT_TRUE(found.empty());
            continue;
          }
          ASSERT_EQ(found.size(), 1U);
          EXPECT_EQ(parts.source[found[0]], covering.empty() ? kNobody : covering[0]);
          nobodys += covering.empty() ? 1 : 0;
          firsts_of_many += covering.size() > 1 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(nobodys, 1000U);
  EXPECT_GT(firsts_of_many, 1000U);
}

// Triangles in general position: the parts are a coverage, and their areas add up to that of the
// set up to rounding.
TEST(SetFeatures, AreACoverageOfTheSet) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Layer a = random_triangles(dice), b = random_triangles(dice);
    Layer sources = a;
    append_layer(sources, b);
    const Nef2 set = set_of(a) ^ set_of(b);
    const SetFeatures parts = set_features(set, sources);
    const RepairedLayer repaired = repair_layer(parts.layer, {OwnerRule::First, 0.0});
    EXPECT_EQ(repaired.report.count(LayerRegionKind::Overlap), 0U);
    EXPECT_EQ(repaired.report.rounding.largest_move, 0);
    double sum = 0;
    for (std::uint32_t f = 0; f < parts.layer.feature_count(); ++f) sum += area_of(parts.layer, f);
    EXPECT_NEAR(sum, nearest_double(marked_area(set.complex()).value()), 1e-9);
  }
}

TEST(SetFeatures, NameWhatIsLeftOut) {
  const Layer sources = layer_of({box(0, 0, 2, 2)});
  const Nef2 square = box_set(0, 0, 2, 2);
  EXPECT_FALSE(set_features(square, sources).has_thin_parts);
  const Nef2 point = Nef2::point({5, 5});
  EXPECT_TRUE(set_features(square + point, sources).has_thin_parts);
  EXPECT_TRUE(set_features(square.boundary(), sources).has_thin_parts);
  EXPECT_FALSE(set_features(square - point, sources).has_thin_parts);
  EXPECT_FALSE(set_features(square - Nef2::point({1, 1}), sources).has_thin_parts);
  const SetFeatures outside = set_features(square.complement(), sources);
  EXPECT_TRUE(outside.is_unbounded);
  EXPECT_EQ(outside.layer.feature_count(), 0U);
  EXPECT_EQ(set_features(Nef2::empty(), sources).layer.feature_count(), 0U);
  const SetFeatures grown = set_features(box_set(-1, -1, 3, 3), sources);
  EXPECT_EQ(grown.source, (std::vector<std::uint32_t>{0, kNobody}));
  EXPECT_EQ(area_of(grown.layer, 0), 4);
  EXPECT_EQ(area_of(grown.layer, 1), 12);
}

// A part that is less wide than the spacing of doubles vanishes, and is named.
TEST(SetFeatures, NameSourcesThatVanish) {
  const Layer sources = layer_of({box(0, 0, 1, 1), box(1, 0, 2, 1)});
  PointTable2 points;
  const Rational right = 1 + Rational(1) / (Integer(1) << 80U);
  for (const auto& [x, y] : {std::pair{Rational(0), 0}, {right, 0}, {right, 1}, {Rational(0), 1}}) {
    points.push_back(x, Rational(y));
  }
  const std::vector<std::uint32_t> corners{0, 1, 2, 3}, chain{0, 4};
  const SetFeatures parts = set_features(
      Nef2::polygons(points, corners, chain, WindingRule::EvenOdd, Boundary::Closed), sources);
  EXPECT_EQ(parts.source, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(parts.vanished, (std::vector<std::uint32_t>{1}));
}

}  // namespace
}  // namespace plumb::layer_test
