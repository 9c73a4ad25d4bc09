// Layers for tests, what covers a point of a layer, and the cells of layers on a grid.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "plumb/plane/layer.h"
#include "plumb/testing/dice.h"

namespace plumb::layer_test {

using testing::Dice;
using Polygon = std::vector<Point2>;
using Features = std::vector<std::uint32_t>;

inline void add_polygon(Layer& layer, const Polygon& corners) {
  for (const Point2 p : corners) {
    layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.points.push_back(p);
  }
  layer.end_ring();
  layer.end_polygon();
}

inline Polygon box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// A layer with one polygon for each feature.
inline Layer layer_of(const std::vector<Polygon>& polygons) {
  Layer layer;
  for (const Polygon& p : polygons) {
    add_polygon(layer, p);
    layer.end_feature("", "");
  }
  return layer;
}

inline bool polygon_covers(const Layer& layer, std::uint32_t polygon, Point2 at) {
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
inline Features features_at(const Layer& layer, Point2 at) {
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

/// Returns how many polygons of a feature cover a point off all edges.
inline int polygons_at(const Layer& layer, std::uint32_t feature, Point2 at) {
  int count = 0;
  for (std::uint32_t p = layer.feature_begin[feature]; p < layer.feature_begin[feature + 1]; ++p) {
    count += polygon_covers(layer, p, at) ? 1 : 0;
  }
  return count;
}

/// Returns the area of a feature whose holes run clockwise.
inline double area_of(const Layer& layer, std::uint32_t feature) {
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

constexpr int kGrid = 10;

/// The unit squares of a grid with a margin of one, with the features that cover each of them.
class GridCells {
 public:
  explicit GridCells(const Layer& layer) {
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        cover_.push_back(features_at(layer, centre(x, y)));
        is_doubled_.push_back(cover_.back().size() == 1 &&
                              polygons_at(layer, cover_.back().front(), centre(x, y)) > 1);
      }
    }
    region_.assign(cover_.size(), -1);
    for (int c = 0; c < kSide * kSide; ++c) {
      if (region_[index(c)] < 0) flood(c, count_++);
    }
  }

  static Point2 centre(int x, int y) { return {x - 0.5, y - 0.5}; }
  static constexpr int kSide = kGrid + 2;

  const Features& cover(int x, int y) const { return cover_[index(y * kSide + x)]; }
  /// Returns the number of the region of a square.
  int region(int x, int y) const { return region_[index(y * kSide + x)]; }
  bool is_outside(int x, int y) const { return region_[index(y * kSide + x)] == region_[0]; }

  /// Returns for each region with overlaps of polygons, or without features, its features and its
  /// area.
  std::vector<std::tuple<Features, int>> regions() const {
    std::map<int, std::tuple<Features, int>> found;
    for (std::size_t c = 0; c < cover_.size(); ++c) {
      const bool is_sound = cover_[c].size() == 1 && !is_doubled_[c];
      if (is_sound || region_[c] == region_[0]) continue;
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
        const int other = j * kSide + i;
        if (is_doubled_[index(other)] != is_doubled_[index(c)]) continue;
        if (cover(i, j) == cover(x, y)) open.push_back(other);
      }
    }
  }

  std::vector<Features> cover_;
  std::vector<bool> is_doubled_;  // Whether several polygons of the only feature cover a square.
  std::vector<int> region_;
  int count_ = 0;
};

/// Adds a rectangle, with a hole if there is room for a border of width 1.
inline void add_frame(Layer& layer, double left, double low, double right, double high) {
  add_polygon(layer, box(left, low, right, high));
  if (right - left < 3 || high - low < 3) return;
  for (const Point2 p : box(left + 1, low + 1, right - 1, high - 1)) {
    layer.ring_corners.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.points.push_back(p);
  }
  layer.end_ring();
  ++layer.polygon_begin.back();
}

inline Layer random_rectangles(Dice& dice) {
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

inline Layer random_triangles(Dice& dice) {
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

inline bool is_same_shape(const Layer& a, const Layer& b) {
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

}  // namespace plumb::layer_test
