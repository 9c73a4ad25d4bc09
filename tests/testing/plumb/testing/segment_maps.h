// Maps as the bounded and outer cycles of a set of segments: exact, by all pairs.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/testing/test_map.h"

namespace plumb::testing {

/// Coordinates must lie within +-kSegmentRange: all arithmetic then fits 64 bits.
inline constexpr std::int64_t kSegmentRange = 8192;

struct IntegerSegment {
  std::int64_t x1, y1, x2, y2;
};

/// The subdivision the segments induce: split wherever they meet, edges that lie in no boundary of
/// a face (bridges and dangling ones) removed, every orbit listed as a cycle. Always a valid map;
/// it has islands where the segments are disconnected and pinches where they touch in points.
/// Segments of length zero are ignored. Cost: O(s^2 + k log k) for s segments and k crossings.
TestMap subdivision_of(const std::vector<IntegerSegment>& segments);

}  // namespace plumb::testing
