// Vertices with equal coordinates become one.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/map.h"

namespace plumb {

/// Replaces in every cycle each vertex by the least-numbered one with the same coordinates and
/// drops repetitions that arise. Vertices keep their numbers; returns the merged ones, ascending.
/// Throws Error{DegenerateFace} when a cycle keeps fewer than three corners.
std::vector<std::uint32_t> merge_equal_vertices(Map& map);

}  // namespace plumb
