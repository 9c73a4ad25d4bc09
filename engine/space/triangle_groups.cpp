#include "plumb/space/triangle_groups.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb {
namespace {

/// A unit vector and how far each coordinate may be off; infinite: nothing is known.
struct Direction {
  std::array<double, 3> unit{};
  double error = Box3::kInfinity;
};

Direction direction(const PointBox& from, const PointBox& to) {
  std::array<double, 3> d;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = to.mid[i] - from.mid[i];
    most = std::max(most, std::fabs(d[i]));
  }
  if (!(most > 0x1p-1000 && most < Box3::kInfinity)) return {};
  double square = 0;
  for (double& x : d) x /= most, square += x * x;
  // Of a vector of length 1 at least, off by r in each coordinate, the unit vector is off by 2 sqrt(3) r at most.
  const double error = 4 * ((from.radius + to.radius) / most) + 0x1p-40;
  if (!(error < 0x1p-3)) return {};
  const double length = std::sqrt(square);
  for (double& x : d) x /= length;
  return {d, error};
}

}  // namespace

TriangleGroups group_triangles(std::span<const FacetTriangle> triangles, std::size_t vertex_count) {
  constexpr std::uint32_t kMany = TriangleGroups::kMany, kNone = TriangleGroups::kNone;
  std::vector<std::uint32_t> degree(vertex_count, 0), group_at(vertex_count, kNone);
  for (const FacetTriangle& t : triangles) {
    for (const TriangleCorner& corner : t.corner) ++degree[corner.vertex.value()];
  }
  TriangleGroups groups;
  groups.of.assign(triangles.size(), kNone);
  const auto add_group = [&groups](VertexId hub) {
    groups.hub.push_back(hub);
    return static_cast<std::uint32_t>(groups.hub.size() - 1);
  };
  const auto busyness = [&degree](const TriangleCorner& corner) {
    return std::pair(degree[corner.vertex.value()], corner.vertex);
  };
  for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
    while (end < triangles.size() && triangles[end].facet == triangles[begin].facet) ++end;
    const bool is_large = end - begin > kMany;
    const std::uint32_t facet_group = is_large ? add_group({}) : kNone;
    for (std::size_t t = begin; t < end; ++t) {
      const VertexId hub = std::ranges::max(triangles[t].corner, {}, busyness).vertex;
      std::uint32_t& group = group_at[hub.value()];
      const bool is_around = !is_large && degree[hub.value()] > kMany;
      if (is_around && group == kNone) group = add_group(hub);
      groups.of[t] = is_around ? group : facet_group;
    }
  }
  std::vector<std::uint64_t> size(groups.hub.size(), 0);
  for (const std::uint32_t g : groups.of) {
    if (g != kNone) groups.pairs += size[g]++;
  }
  return groups;
}

// An arc of the sphere is within chord^2 / 4 of its chord: 1 - sqrt(1 - x^2) <= x^2.
Box3 box_of_directions(const PointBox& centre, const PointBox& a, const PointBox& b) {
  const Direction to_a = direction(centre, a), to_b = direction(centre, b);
  const double error = std::max(to_a.error, to_b.error);
  if (!(error < 1)) return {{-2, -2, -2}, {2, 2, 2}};
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double step = std::fabs(to_a.unit[i] - to_b.unit[i]) + 2 * error;
    square += step * step;
  }
  const double widened = square / 4 + 2 * error;
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(to_a.unit[i], to_b.unit[i]) - widened;
    box.high[i] = std::max(to_a.unit[i], to_b.unit[i]) + widened;
  }
  return box;
}

}  // namespace plumb
