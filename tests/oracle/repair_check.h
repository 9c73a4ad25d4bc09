// Are mended meshes what the report says? By brute force over directed edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "plumb/space/mesh_arrays.h"

namespace plumb::testing {

inline constexpr std::size_t kRepairRecord = 8;

/// Whether each directed edge of a mesh, cut at all points that lie on it, is balanced by its
/// reverse. Points with equal coordinates are one. Requires coordinates whose products are exact.
bool is_balanced_by_places(const PolygonMesh& mesh);

/// Mends a mesh that is made from bytes, and returns the first thing that is wrong, or "". The
/// first record selects the options, each other record {corners, points ...} is a face between
/// points of a grid, some of them a quarter off the grid.
std::string repair_of_program_disagreement(std::span<const std::uint8_t> program);

}  // namespace plumb::testing
