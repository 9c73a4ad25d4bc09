// Checks whether rounding the vertices of a mesh to doubles has broken the mesh.
//
// Main flow of check_rounding():
//  1. select_faces  finds the faces with a rounded vertex, and the faces whose boxes meet theirs:
//                   nothing can go wrong elsewhere
//  2. judge         lets complex_of_mesh() find what is wrong with these faces in their rounded
//                   coordinates
//  3. is_flipped    compares the normals of faces before and after rounding
//
// Cost: O(vertices) if the coordinates of all vertices are doubles. Otherwise a tree of O(n) boxes
// is built, and complex_of_mesh() works on the faces of step 1.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The effects of rounding on a mesh. Faces and vertices are indices in the mesh, and lists are
/// ascending. If beyond_doubles is not empty, only beyond_doubles and rounded_vertices are filled.
struct RoundingReport {
  using FacePair = std::pair<std::uint32_t, std::uint32_t>;  ///< Two faces of the mesh.

  /// Number of vertices whose exact coordinates are not doubles.
  std::uint64_t rounded_vertices = 0;
  /// Vertices with a coordinate that rounds to an infinity.
  std::vector<std::uint32_t> beyond_doubles;
  std::uint64_t vertices_merged = 0;  ///< Number of vertices that coincide with another vertex now.
  std::vector<std::uint32_t> degenerate;  ///< Faces without area now.
  std::vector<std::uint32_t> flipped;     ///< Faces whose normal is reversed now.
  std::vector<std::uint32_t> not_simple;  ///< Faces that cross themselves now.
  std::vector<FacePair> doubled;          ///< Pairs of faces that coincide now.
  std::uint64_t crossing_count = 0;  ///< Number of pairs of facets that cross only since rounding.
  std::vector<FacePair> crossings;   ///< The first such pairs, as faces of the mesh.
  /// Polygons that are not planar now. This does not harm their neighbours, but a program that
  /// reads the mesh must triangulate these polygons. Their crossings are computed for their
  /// constrained Delaunay triangles (complex_of_mesh()).
  std::vector<std::uint32_t> not_planar;

  /// Whether rounding broke nothing. Polygons that are not planar any more do not count.
  bool is_sound() const {
    return beyond_doubles.empty() && vertices_merged == 0 && degenerate.empty() &&
           flipped.empty() && not_simple.empty() && doubled.empty() && crossing_count == 0;
  }
};

/// Returns the effects of rounding on the mesh. At most `max_listed` crossings are listed, but
/// crossing_count counts all. Requires that faces with their exact coordinates neither cross nor
/// coincide. Throws what the context throws.
RoundingReport check_rounding(const PolygonMesh& mesh, std::uint64_t max_listed,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
