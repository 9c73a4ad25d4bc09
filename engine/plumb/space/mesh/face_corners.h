// Finds the corners of faces at the corners of faces that were made of them, and carries the
// attributes over. Internal.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// A triangle of a face.
struct FaceTriangle {
  std::uint32_t face;                   ///< The face.
  std::array<std::uint32_t, 3> corner;  ///< Its corners, indices of PolygonMesh::corners.
};

/// A triangle of vertices.
using VertexTriangle = std::array<std::uint32_t, 3>;

/// Finds the corners of one face at the corners of its triangles.
class CornerFinder {
 public:
  /// `vertices` has the vertex of each corner of the face, whose first corner has the index `begin`
  /// in the mesh. Keeps a reference to the vertices. O(n log n) for n corners.
  CornerFinder(std::span<const std::uint32_t> vertices, std::uint32_t begin);

  /// Appends the triangles with their corners. O(n log n).
  void add(std::uint32_t face, std::span<const VertexTriangle> triangles,
           std::vector<FaceTriangle>& result);

 private:
  std::uint32_t first_at(std::uint32_t vertex) const;
  void choose_corners(std::span<const VertexTriangle> triangles, std::span<FaceTriangle> result);

  std::span<const std::uint32_t> vertices_;
  std::uint32_t begin_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> first_;  // Vertices with their corners.
  bool has_repeats_ = false;
};

/// Throws Error{BadArgument} unless each array of the attributes is empty or complete
/// (mesh_attributes.h) for a mesh with so many faces and corners. O(1) for each array.
void require_sizes(const MeshAttributes& attributes, std::size_t faces, std::size_t corners);

/// Where the faces of a mesh come from in a mesh before a change. Invalid indices are kNone.
struct FaceOrigins {
  std::vector<std::uint32_t> face;        ///< For each face, the face before, or kNone.
  std::vector<std::uint8_t> is_reversed;  ///< For each face, whether its direction was reversed.
  std::vector<std::uint32_t> corner;      ///< For each corner, the corner before, or kNone.
};

/// Finds the corners of the faces of `after`. Face f was made of face `face[f]` of `before` by
/// leaving out corners and reversing the direction, or it is new if face[f] is not a face of
/// `before`. Both meshes number their points in the same way. O(n) for n corners.
FaceOrigins origins_of(const PolygonMesh& before, const PolygonMesh& after,
                       std::span<const std::uint32_t> face);

/// Returns the attributes of the faces of `after` from those of the faces of which they were made.
/// `attributes` must be complete. Faces that were reversed have the negative of the channel
/// "normal" of width 3. New faces have no material, no group and no id; their numbers are 1 in the
/// channel "color" and 0 in other channels. O(n).
MeshAttributes carried(const MeshAttributes& attributes, const PolygonMesh& after,
                       const FaceOrigins& origins);

}  // namespace plumb
