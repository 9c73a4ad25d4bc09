// The lexicographic order of points, with equal points found.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/plane/plane_points.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The used points in lexicographic order. Points of equal coordinates share the rank of the first.
struct PointRanks {
  static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> order;  ///< The used points, sorted; equal points by index.
  std::vector<std::uint32_t> rank;   ///< The position in `order` of the first equal point.
};

/// Returns the ranks of the points whose `used` entry is set. The limits of `context`, which may be
/// null, are checked meanwhile. O(n log n).
PointRanks rank_points(const PlanePointsView& points, const std::vector<char>& used,
                       const Context* context = nullptr);

}  // namespace plumb
#pragma GCC visibility pop
