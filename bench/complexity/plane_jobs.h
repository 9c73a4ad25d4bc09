// What the plane's benchmarks run, on plumb: the same jobs for growth and for comparison.
#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "generate/plane_families.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/nef2.h"

namespace plumb::bench {

struct SegmentScene {
  PointTable2 points;
  std::vector<SweepSegment> segments;
};

inline SegmentScene scene_of(const std::vector<testing::PlaneSegment>& segments) {
  SegmentScene scene;
  for (const auto& [p, q] : segments) {
    const auto i = static_cast<std::uint32_t>(scene.points.size());
    scene.points.push_back(p);
    scene.points.push_back(q);
    scene.segments.push_back({i, i + 1});
  }
  return scene;
}

inline Arrangement arranged(const SegmentScene& scene) {
  Context context;
  return arrange(scene.points, scene.segments, context);
}

/// The union of all polygons, from their points.
inline Nef2 union_of_polygons(std::span<const testing::PlanePolygon> polygons) {
  PointTable2 points;
  std::vector<std::uint32_t> begin = {0};
  for (const testing::PlanePolygon& polygon : polygons) {
    for (const Point2& p : polygon) points.push_back(p);
    begin.push_back(static_cast<std::uint32_t>(points.size()));
  }
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), std::uint32_t{0});
  Context context;
  return Nef2::polygons(points, corners, begin, WindingRule::Positive, Boundary::Closed, context);
}

/// Left of each of n lines around the unit circle: an intersection of half-planes.
inline std::vector<Nef2> half_planes(std::size_t n) {
  std::vector<Nef2> sets;
  const testing::PlanePolygon star = testing::star_polygon(n, 7);
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 p = star[i];
    const RationalPoint2 on{Rational(p.x), Rational(p.y)};
    sets.push_back(Nef2::half_plane(Line2{on, {on.x - on.y, on.y + on.x}}, Boundary::Closed));
  }
  return sets;
}

}  // namespace plumb::bench
