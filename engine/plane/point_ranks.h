// Lexicographic ranks of points.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/predicates/plane_points.h"

namespace plumb {

/// The used points in lexicographic order. Points of equal coordinates share the rank of the first.
struct PointRanks {
  static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> order;  ///< used points, sorted; equal points by index
  std::vector<std::uint32_t> rank;   ///< per point: position in `order` of the first equal one
};

/// Ranks the points whose `used` entry is set. O(n log n).
PointRanks rank_points(const PlanePointsView& points, const std::vector<char>& used);

}  // namespace plumb
