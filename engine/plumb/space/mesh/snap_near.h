// Makes vertices, edges and triangles of a mesh that nearly touch meet in common vertices.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "plumb/space/mesh/changed_mesh.h"

namespace plumb {

/// Snaps vertices and edges of the damaged triangles of a closed mesh to each other if they are at
/// most `width` apart:
///
///  1. Two vertices become one: the ends of an edge of a damaged triangle, and vertices of the two
///     triangles of a pair.
///  2. A vertex becomes a corner in the middle of an edge, in all faces of this edge. The vertex is
///     the third vertex of a damaged triangle, or a vertex of a triangle whose partner in a pair
///     has the edge.
///  3. A vertex of a triangle becomes a vertex inside the other triangle of a pair.
///
/// Each directed edge still occurs as often as its reverse. Triangles that are left without area
/// are removed. Whether things are near each other is decided in doubles. This is allowed, because
/// each decision keeps the mesh closed, and largest_move includes its effect. `pairs` lists pairs
/// of faces that cross. Takes O(corners + k log k) time for k near parts.
ChangedMesh snap_near(const PolygonMesh& mesh, std::span<const std::uint8_t> is_damaged,
                      std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs, double width);

}  // namespace plumb
