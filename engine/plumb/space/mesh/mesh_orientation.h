// Which faces of a mesh are listed the wrong way round, and which holes are left if they are
// turned.
//
// Main flow of orient_faces():
//  1. list_edges    lists the faces that run along each edge, with their directions
//  2. cut_edges     cuts edges that an odd number of faces use at the vertices that lie on them, so
//                   that a long edge meets the short edges beside it
//  3. relate_pairs  relates the two faces at each edge that has two: they must run through it in
//                   opposite directions
//  4. relate_rest   relates the patches that are left over at an edge with more faces, if they are
//                   two
//  5. choose        turns the smaller part of each patch; of equal parts the one after which the
//                   patch has positive volume
//  6. holes         lists where the mesh is open even then
//
// Nothing is measured except in step 2 and between equal parts in step 5, exactly. If turning faces
// does not make the borders shorter, no face is turned. Cost: O(n log n) for n corners, besides the
// cost of vertices_inside().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// How the faces of a mesh would have to face. All lists of faces ascend. A patch is a set of faces
/// that determine each other's direction.
struct MeshOrientation {
  std::vector<std::uint32_t> flipped;  ///< Faces to be turned so that neighbours agree.
  /// For each patch that has only one side, such as a Moebius strip, the face with the least index.
  /// Some neighbours in such a patch disagree, whichever faces are flipped.
  std::vector<std::uint32_t> one_sided;
  /// Where the mesh is open after `flipped` have been turned: closed chains of vertices, each in
  /// the direction that a face would have that closes it.
  std::vector<std::vector<std::uint32_t>> holes;
};

/// Returns which faces to turn. `vertices` are the vertices of the mesh, whose points are in
/// `table`. If the borders of the mesh as it is are known, they need not be traced again where no
/// face is turned. Throws the errors of the Context.
MeshOrientation orient_faces(const MeshView& mesh, const MeshVertices& vertices,
                             const Point3Table& table, Context& context,
                             const std::vector<std::vector<std::uint32_t>>* borders = nullptr);

/// Reverses faces: each keeps its first corner.
void reverse_faces(PolygonMesh& mesh, std::span<const std::uint32_t> faces);

}  // namespace plumb
