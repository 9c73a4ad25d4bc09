// Checks whether rounding the vertices of a mesh to doubles has broken it.
//
// Main flow of check_rounding():
//  1. select_faces  finds the faces with a rounded vertex and those whose boxes meet them: nothing
//                   can go wrong elsewhere
//  2. judge         lets complex_of_mesh() find what is wrong with these faces in their rounded
//                   coordinates
//  3. is_flipped    compares the normals of faces before and after rounding
//
// Cost: O(vertices) if all vertices are doubles; otherwise a tree of O(n) boxes, and the work of
// complex_of_mesh() on the faces of step 1.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What rounding has done to a mesh. Faces and vertices are indices in the mesh; lists are
/// ascending. If beyond_doubles is not empty, only it and rounded_vertices are filled.
struct RoundingReport {
  using FacePair = std::pair<std::uint32_t, std::uint32_t>;  ///< Two faces of the mesh.

  std::uint64_t rounded_vertices = 0;         ///< Vertices that are not doubles.
  std::vector<std::uint32_t> beyond_doubles;  ///< Vertices that round to an infinity.
  std::uint64_t vertices_merged = 0;          ///< Vertices that coincide with another one now.
  std::vector<std::uint32_t> degenerate;      ///< Faces without area now.
  std::vector<std::uint32_t> flipped;         ///< Faces whose normal is reversed now.
  std::vector<std::uint32_t> not_simple;      ///< Faces that cross themselves now.
  std::vector<FacePair> doubled;              ///< Pairs of faces that coincide now.
  std::uint64_t crossing_count = 0;  ///< Pairs of facets that cross now and did not before.
  std::vector<FacePair> crossings;   ///< The first such pairs, as faces of the mesh.
  /// Polygons that are not planar now. This does not harm their neighbours, but readers of the mesh
  /// must triangulate them. Crossings are those of their constrained Delaunay triangles
  /// (complex_of_mesh()).
  std::vector<std::uint32_t> not_planar;

  /// Whether rounding broke nothing. Polygons that are not planar any more do not count.
  bool is_sound() const {
    return beyond_doubles.empty() && vertices_merged == 0 && degenerate.empty() &&
           flipped.empty() && not_simple.empty() && doubled.empty() && crossing_count == 0;
  }
};

/// Returns what rounding has done to the mesh, with at most `max_listed` crossings; their number is
/// complete. Requires that, with the exact coordinates, faces neither cross nor coincide. Throws
/// what the context throws.
RoundingReport check_rounding(const PolygonMesh& mesh, std::uint64_t max_listed,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
