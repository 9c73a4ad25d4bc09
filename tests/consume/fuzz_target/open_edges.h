// The project's own geometry, which is to be fuzzed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// Directed edges of polygons whose other side belongs to no polygon. Each counts once.
std::size_t open_edges(const std::vector<std::vector<std::uint32_t>>& polygons);
