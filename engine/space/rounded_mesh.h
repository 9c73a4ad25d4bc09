// Did rounding the vertices of a mesh to doubles break it?
//
// Main flow of check_rounding():
//  1. the faces with a rounded vertex, and those whose boxes they meet: only there can anything happen
//  2. complex_of_mesh() of these faces with rounded coordinates says what is wrong with them
//  3. faces that turned over: their normals before and after
//
// Cost: nothing when all vertices are doubles; else O(n) boxes, and the work of complex_of_mesh() on the faces
// of 1.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/polygon_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Numbers of faces and vertices are those of the mesh; lists ascend.
struct RoundingReport {
  using FacePair = std::pair<std::uint32_t, std::uint32_t>;  ///< two faces

  std::uint64_t rounded_vertices = 0;         ///< vertices whose coordinates are no doubles
  std::vector<std::uint32_t> beyond_doubles;  ///< vertices that round to an infinity
  std::uint64_t vertices_merged = 0;          ///< that fell onto another one
  std::vector<std::uint32_t> degenerate;      ///< faces without area now
  std::vector<std::uint32_t> flipped;         ///< faces that look the other way now
  std::vector<std::uint32_t> not_simple;      ///< faces that cross themselves now
  std::vector<FacePair> doubled;              ///< faces that fell onto each other
  std::uint64_t crossing_count = 0;           ///< pairs of faces that cross now and did not
  std::vector<FacePair> crossings;  ///< the first pairs of faces that cross now and did not
  /// Polygons that left their plane: no harm to their neighbours yet, but whoever reads them must cut
  /// them. Crossings are those of their constrained Delaunay triangles (complex_of_mesh()).
  std::vector<std::uint32_t> not_planar;

  /// Nothing but rounding happened.
  bool is_sound() const {
    return beyond_doubles.empty() && vertices_merged == 0 && degenerate.empty() &&
           flipped.empty() && not_simple.empty() && doubled.empty() && crossing_count == 0;
  }
};

/// Requires a mesh whose faces neither cross nor coincide with its exact coordinates; lists at most `max_listed`
/// crossings.
RoundingReport check_rounding(const PolygonMesh& mesh, std::uint64_t max_listed, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
