// Finds the faces of a mesh that rounding may have damaged, with doubles only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// Faces that rounding may have damaged. Both lists are ascending.
struct DoubtfulFaces {
  /// A list that contains each face that
  ///
  /// - meets another face outside common vertices and edges, if one of the two is to be checked,
  /// - is to be checked, and has no area, crosses itself or is not planar.
  std::vector<std::uint32_t> faces;
  /// A list that contains each face that is to be checked and whose normal has been reversed by
  /// rounding its vertices to doubles or, if all of them are floats, to floats. They are in
  /// `faces`, too.
  std::vector<std::uint32_t> flipped;
};

/// Returns 1 for each face with a point for which is_chosen is not 0. O(corners).
std::vector<std::uint8_t> faces_at(const PolygonMesh& mesh,
                                   std::span<const std::uint8_t> is_chosen);

/// Of the faces with is_checked = 1, returns the faces that rounding may have damaged. Also returns
/// the faces that these faces may meet. All tests refer to mesh.points, the rounded coordinates. A
/// mesh that is far from any damage gives empty lists. Requires finite coordinates. O(n log n + c)
/// for c pairs of a face that is checked and a face whose box meets its box. If c exceeds 64 n +
/// 4096, all faces of such pairs are returned.
DoubtfulFaces doubtful_faces(const PolygonMesh& mesh, std::span<const std::uint8_t> is_checked,
                             Context& context);

}  // namespace plumb
