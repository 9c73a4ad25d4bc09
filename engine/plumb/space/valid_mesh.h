// Converts a set of space to a mesh that is valid after its coordinates have been rounded.
//
// Rounding moves the vertices of a mesh. Faces that are close together can then cross, coincide,
// flip or lose their area. A program that reads such a mesh finds a mesh that crosses itself. The
// functions of this header repair the mesh before it leaves plumb.
//
// Main flow of valid_mesh():
//  1. mesh_of_complex()     makes a mesh of the nearest doubles
//  2. drop_flat_vertices()  leaves out constructed vertices at which the boundary is flat, or
//                           folded along a straight line, up to some units of the last digit
//                           (mesh/drop_flat_vertices.h)
//  3. find_damage           finds the faces that rounding has damaged. Doubles prove of most faces
//                           that they are sound (mesh/doubtful_faces.h). If no face is damaged, the
//                           mesh is finished
//  4. RoundingRepairer      makes damaged parts that nearly touch meet in common vertices
//                           (mesh/snap_near.h). Where this does not help, it reads the boundaries
//                           of the damaged solids as one mesh; the points of positive winding
//                           number form the new solids. The flow continues with step 3
//
// Step 2 is for files that are read and written again and again. After rounding, the triangles of
// one facet lie in planes that are a hair apart. Where the next operation cuts them, each edge
// between two of them gives a vertex. If these vertices were kept, the number of triangles would
// grow with each operation.
//
// Properties of the result (proofs: docs/design/mesh-rounding.md):
// - Faces meet only in common vertices and common edges. No face is degenerate, no two faces
//   coincide, and the mesh is closed and oriented.
// - Each point of the mesh lies within RoundingRepair::largest_move of the exact boundary.
// - If rounding to the nearest numbers causes no damage, each vertex has the nearest numbers.
//   Otherwise, a vertex whose coordinates are numbers of the output moves only if it is near a
//   damaged face, or if its solid had to be rounded more coarsely (RoundingRepair::coarse_rounds).
// - A vertex whose exact coordinates are doubles is not left out. So the result for a mesh of
//   numbers of the output is this mesh.
//
// Cost: the cost of mesh_of_complex(), O(n log n) for the boxes of n faces with rounded vertices,
// and the cost of reading the faces that may be damaged. Each round of a repair adds the cost of
// checking the faces near the damage, and O(n) for a mesh of n corners. A round that reads the
// damaged solids adds the cost of reading them.
#pragma once

#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/space/to_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The changes that valid_mesh() makes to a mesh after its coordinates have been rounded to the
/// nearest numbers.
struct RoundingRepair {
  std::uint64_t rounded_vertices = 0;  ///< Vertices of the set whose coordinates were rounded.
  /// Constructed vertices that were left out because the boundary is flat there, or folded along a
  /// straight line, up to some units of the last digit (mesh/drop_flat_vertices.h).
  std::uint64_t dropped_vertices = 0;
  std::uint32_t rounds = 0;  ///< Number of rounds of repair. 0: the nearest numbers are valid.
  /// Number of times that the repair started again with damaged solids snapped to a grid that is
  /// coarser than the numbers of the output.
  std::uint32_t coarse_rounds = 0;
  /// Faces of the nearest numbers that crossed, coincided, flipped or lost their area. A face may
  /// be counted in several rounds.
  std::uint64_t damaged_faces = 0;
  /// Whether a repair changed the number of solids (marked volumes) or the Euler characteristic of
  /// their boundaries. This happens if parts or holes that are thinner than largest_move vanish,
  /// and if gaps close.
  bool changes_topology = false;
  double largest_move = 0;  ///< No point of the result is farther from the exact boundary.
};

/// A valid mesh.
struct ValidMesh {
  /// The mesh. The lists mesh.exact and `rounded` are empty. `facet` lists for each face the facet
  /// of the set from which the face was made. If one face was made from several facets, `facet`
  /// lists the least of them. The report is that of mesh_of_complex().
  MeshOfComplex made;
  RoundingRepair repair;  ///< What was repaired.
};

/// Returns the boundary of regularization() as a valid mesh. If a marked volume is unbounded, the
/// mesh is empty and report.is_unbounded is set. Throws Error{NumberOutOfRange} if a coordinate is
/// larger than the largest number of the output. Meshes of floats consist of triangles.
[[nodiscard]] ValidMesh valid_mesh(const Nef3& set, const ToMeshOptions& options = {},
                                   CoordinateType type = CoordinateType::Double,
                                   Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
