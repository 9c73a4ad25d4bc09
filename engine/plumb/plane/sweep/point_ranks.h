// Sorts points lexicographically, and finds equal points.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/plane/plane_points.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The used points in lexicographic order. Points with equal coordinates have the same rank, which
/// is the position of the first of them.
struct PointRanks {
  static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> order;  ///< The used points, sorted; equal points are sorted by index.
  /// For each point, the position in `order` of the first point that is equal to it.
  std::vector<std::uint32_t> rank;
};

/// Returns the ranks of the used points. Point i is used if used[i] is not 0. The limits of
/// `context`, which may be null, are checked meanwhile. O(n log n) for n points.
PointRanks rank_points(const PlanePointsView& points, const std::vector<char>& used,
                       const Context* context = nullptr);

}  // namespace plumb
#pragma GCC visibility pop
