#include "plumb/plane/map_merge.h"

#include <string>

#include "plumb/base/error.h"
#include "plumb/plane/point_ranks.h"

namespace plumb {
namespace {

std::vector<std::uint32_t> representatives(const Map& map) {
  const PointRanks ranks = rank_points(map.points, std::vector<char>(map.vertex_count(), 1));
  std::vector<std::uint32_t> representative(map.vertex_count());
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    representative[v] = ranks.order[ranks.rank[v]];
  }
  return representative;
}

}  // namespace

std::vector<std::uint32_t> merge_equal_vertices(Map& map) {
  const std::vector<std::uint32_t> representative = representatives(map);
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> begin = {0};
  corners.reserve(map.corners.size());
  for (std::size_t c = 0; c < map.cycle_count(); ++c) {
    for (const std::uint32_t v : map.cycle(c)) {
      const std::uint32_t r = representative[v];
      if (corners.size() == begin.back() || corners.back() != r) corners.push_back(r);
    }
    while (corners.size() > begin.back() + 1 && corners.back() == corners[begin.back()]) {
      corners.pop_back();
    }
    if (corners.size() - begin.back() < 3) {
      throw Error(ErrorCode::DegenerateFace,
                  "face " + std::to_string(c + 1) +
                      " collapses when vertices with equal coordinates are merged");
    }
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  map.corners = std::move(corners);
  map.cycle_begin = std::move(begin);
  std::vector<std::uint32_t> merged;
  for (std::uint32_t v = 0; v < representative.size(); ++v) {
    if (representative[v] != v) merged.push_back(v);
  }
  return merged;
}

}  // namespace plumb
