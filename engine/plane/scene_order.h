// Scenes renumbered along the sweep: what one event touches then lies side by side in memory. For
// 10^5 segments in random order this takes a sixth to a third off an arrangement.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/plane_builder.h"

namespace plumb {

struct OrderedScene {
  PlaneScene scene;
  std::vector<std::uint32_t> point;  ///< per point of `scene`: the number it had
  std::vector<SegmentId> curve;      ///< per curve of `scene`: likewise
};

/// Points in lexicographic order, equal ones by number; curves by their left end, those of equal
/// left ends by number. A sweep of either scene meets the same curves in the same order everywhere.
/// Requires input points only, all of them doubles. O(n log n).
OrderedScene in_sweep_order(const PlaneScene& scene);

}  // namespace plumb
