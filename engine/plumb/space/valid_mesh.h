// Converts a set of space to a mesh that is valid after its coordinates have been rounded.
//
// Rounding moves the vertices of a mesh. Faces that are close together can then cross, coincide,
// flip or lose their area. A program that reads such a mesh finds a mesh that crosses itself. The
// functions of this header repair the mesh before it leaves plumb.
//
// Main flow of valid_mesh():
//  1. mesh_of_complex()  makes a mesh with exact coordinates
//  2. round_points()     rounds each vertex to the nearest numbers of the output
//  3. check_rounding()   finds the faces that rounding has damaged. If there are none, the mesh is
//                        finished
//  4. mended             reads the boundaries of all damaged solids as a mesh: the new solids
//                        consist of the points of positive winding number. Their exact meshes
//                        replace the damaged ones, and the flow continues with step 2
//
// Properties of the result (proofs: docs/design/mesh-rounding.md):
// - Faces meet only in common vertices and common edges. No face is degenerate, no two faces
//   coincide, and the mesh is closed and oriented.
// - Each vertex lies within RoundingRepair::largest_move of the exact boundary.
// - A vertex moves only if its coordinates are not numbers of the output, or if it belongs to a
//   damaged solid that had to be rounded more coarsely (RoundingRepair::coarse_rounds).
// - A mesh of a set whose mesh is valid after rounding consists of the nearest numbers.
//
// Cost: the cost of mesh_of_complex() and of check_rounding(). If there is damage, each round adds
// the cost of reading the boundaries of the damaged solids.
#pragma once

#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/space/to_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What valid_mesh() has changed in a mesh of nearest numbers.
struct RoundingRepair {
  std::uint64_t rounded_vertices = 0;  ///< Vertices of the set whose coordinates were rounded.
  std::uint32_t rounds = 0;            ///< Number of repairs. 0: the nearest numbers are valid.
  /// Number of repairs that rounded to a grid that is coarser than the numbers of the output.
  std::uint32_t coarse_rounds = 0;
  /// Faces of the nearest numbers that crossed, coincided, flipped or lost their area. A face may
  /// be counted in several rounds.
  std::uint64_t damaged_faces = 0;
  /// Whether a repair changed the number of solids (marked volumes) or the Euler characteristic of
  /// their boundaries. This happens if parts or holes that are thinner than largest_move vanish, and
  /// if gaps close.
  bool changes_topology = false;
  double largest_move = 0;  ///< No point of the result is farther from the exact boundary.
};

/// A valid mesh.
struct ValidMesh {
  /// The mesh, whose list mesh.exact is empty. `facet` lists for each face the facet of the set
  /// from which the face was made. If a repair made one face from several facets, `facet` lists the
  /// least of them. The report is that of mesh_of_complex().
  MeshOfComplex made;
  RoundingRepair repair;  ///< What was repaired.
};

/// Returns the boundary of regularization() as a valid mesh. If a marked volume is unbounded, the
/// mesh is empty and report.is_unbounded is set. Throws Error{NumberOutOfRange} if a coordinate is
/// larger than the largest number of the output.
[[nodiscard]] ValidMesh valid_mesh(const Nef3& set, const ToMeshOptions& options = {},
                                   CoordinateType type = CoordinateType::Double,
                                   Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
