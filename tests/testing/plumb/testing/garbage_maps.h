// Maps that are wrong in every way at once, on small integers, where degeneracy is the rule.
#pragma once

#include <cstdint>

#include "plumb/testing/test_map.h"

namespace plumb::testing {

/// Random closed walks on random points of [0, range]^2: collinear, coincident and repeated points,
/// repeated edges. Never refused by check_map: cycles have 3 corners or more, no vertex twice in a
/// row.
TestMap garbage_map(std::uint32_t points, std::uint32_t cycles, std::int64_t range,
                    std::uint64_t seed);

/// Exchanges tails at vertices, `swaps` times: two visits of one vertex are chosen; two cycles
/// become one or one becomes two. The edges, and so the induced planar graph, stay as they are,
/// every directed edge stays used as often: what changes is only whose it is.
TestMap recombined(const TestMap& map, std::uint32_t swaps, std::uint64_t seed);

/// Reverses, removes or repeats whole cycles, `changes` times.
TestMap shuffled_cycles(const TestMap& map, std::uint32_t changes, std::uint64_t seed);

/// Moves `moves` vertices to random points of [0, range]^2.
TestMap moved_vertices(const TestMap& map, std::uint32_t moves, std::int64_t range,
                       std::uint64_t seed);

}  // namespace plumb::testing
