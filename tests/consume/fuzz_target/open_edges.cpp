#include "open_edges.h"

#include <algorithm>
#include <set>
#include <utility>

std::size_t open_edges(const std::vector<std::vector<std::uint32_t>>& polygons) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      edges.emplace(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
  }
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const auto& e) {
    return edges.count({e.second, e.first}) == 0;
  }));
}
