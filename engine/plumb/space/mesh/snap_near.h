// Makes vertices, edges and triangles of a mesh that nearly touch meet in common vertices.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// A mesh whose parts meet in common vertices where they were near each other.
struct SnappedMesh {
  PolygonMesh mesh;                   ///< The points are those of the input; some have no face.
  std::vector<std::uint32_t> origin;  ///< The face of the input from which each face was made.
  /// For each face of the input, 1 if it was removed or has other corners now. Empty if nothing was
  /// near.
  std::vector<std::uint8_t> changed;
  double largest_move = 0;  ///< A bound of the distances by which points of faces moved.
};

/// Snaps what is at most `width` apart in the damaged triangles of a closed mesh:
///
///  1. Two vertices become one: the ends of an edge of a damaged triangle, and vertices of the two
///     triangles of a pair.
///  2. A vertex becomes a corner in the middle of an edge, in all faces of this edge. The vertex is
///     the third vertex of a damaged triangle, or a vertex of a triangle whose partner in a pair
///     has the edge.
///  3. A vertex of a triangle becomes a vertex inside the other triangle of a pair.
///
/// Each directed edge still occurs as often as its reverse. Triangles that are left without area
/// are removed. Doubles decide what is near, because each decision keeps the mesh closed and is
/// accounted for in largest_move. `pairs` lists pairs of faces that cross. Takes O(corners +
/// k log k) time for k near parts.
SnappedMesh snap_near(const PolygonMesh& mesh, std::span<const std::uint8_t> is_damaged,
                      std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs, double width);

}  // namespace plumb
