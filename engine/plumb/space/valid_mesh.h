// Converts a set of space to a mesh that is valid after its coordinates have been rounded.
//
// Rounding moves the vertices of a mesh. Faces that are close together can then cross, coincide,
// flip or lose their area. Many programs cannot use a mesh with such defects. The functions of this
// header repair these defects.
//
// Main flow of valid_mesh():
//  1. mesh_of_complex()     makes a mesh whose coordinates are rounded to the nearest doubles
//  2. drop_flat_vertices()  removes a constructed vertex if all faces at the vertex lie in one
//                           plane, or in two planes that meet in a line through the vertex. The
//                           faces may deviate from the planes by some units of the last digit
//                           (mesh/drop_flat_vertices.h)
//  3. find_damage           finds the damaged faces: the faces that cross, coincide, are flipped or
//                           have no area after rounding. For most faces, a computation with doubles
//                           proves that they are not damaged (mesh/doubtful_faces.h). If no face is
//                           damaged, the mesh is finished
//  4. RoundingRepairer      repairs damaged faces. First it tries to snap vertices and edges of
//                           damaged faces to each other if they nearly touch (mesh/snap_near.h). If
//                           this is not enough, it takes the boundaries of all solids that have
//                           damaged faces. From these boundaries it makes a new set: the set of all
//                           points with a positive winding number. The boundary of this set
//                           replaces the boundaries of these solids. The flow continues with step 3
//
// Step 2 is needed if results are written to files, and read again for the next operation. After
// rounding, the triangles of one facet lie in slightly different planes. If the next operation cuts
// these triangles, a new vertex arises on each edge between two of them. If these vertices were
// kept, the number of triangles would grow with each operation.
//
// Properties of the result (proofs: docs/design/mesh-rounding.md):
// - Faces meet only in common vertices and common edges. No face is degenerate, no two faces
//   coincide, and the mesh is closed and oriented.
// - Each point of the mesh lies within RoundingRepair::largest_move of the exact boundary.
// - If rounding to the nearest numbers of the output type damages no face, these nearest numbers
//   are the coordinates of the result. Otherwise, consider a vertex whose exact coordinates are
//   numbers of the output type. It moves only if it is near a damaged face, or if its solid had to
//   be rounded more coarsely (RoundingRepair::coarse_rounds).
// - A vertex whose exact coordinates are doubles is not removed. So if a valid mesh with numbers of
//   the output type is converted to a set, the result for this set is the same mesh.
//
// The cost is a sum. Its terms are the cost of mesh_of_complex(), O(n log n) for the boxes of n
// faces with rounded vertices, and the cost of complex_of_mesh() for the faces that may be damaged.
// Each round of step 4 adds the cost of checking the faces near damaged faces, and O(n) for a mesh
// of n corners. If a round makes a new set from solids with damaged faces, the cost of making this
// set is added, too.
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
  /// The number of vertices of the set whose coordinates were rounded.
  std::uint64_t rounded_vertices = 0;
  /// The number of constructed vertices that step 2 (see above) removed.
  std::uint64_t dropped_vertices = 0;
  /// The number of rounds of repair. It is 0 if the mesh was valid without repair.
  std::uint32_t rounds = 0;
  /// The number of times that the repair was started again on a coarser grid. In such a repair, the
  /// solids with damaged faces are snapped to a grid that is coarser than the numbers of the output
  /// type.
  std::uint32_t coarse_rounds = 0;
  /// The number of faces that crossed, coincided, flipped or lost their area after rounding. A face
  /// can be counted in several rounds.
  std::uint64_t damaged_faces = 0;
  /// Whether a repair changed the number of solids (marked volumes) or the Euler characteristic of
  /// their boundaries. This happens if a part or a hole vanishes because it is thinner than
  /// largest_move, or if a gap closes.
  bool changes_topology = false;
  /// An upper bound for the distance of points of the result from the exact boundary.
  double largest_move = 0;
};

/// A valid mesh.
struct ValidMesh {
  /// The mesh. The lists mesh.exact and `rounded` are empty. `facet` lists for each face the facet
  /// of the set from which the face was made. If one face was made from several facets, `facet`
  /// lists the least of them. The report is the report of mesh_of_complex().
  MeshOfComplex made;
  RoundingRepair repair;  ///< A report on the repair.
};

/// Returns the boundary of regularization() as a valid mesh. If a marked volume is unbounded, the
/// mesh is empty and report.is_unbounded is set. If `type` is Float, the mesh consists of
/// triangles. Throws Error{NumberOutOfRange} if a coordinate is larger than the largest number of
/// the output type.
[[nodiscard]] ValidMesh valid_mesh(const Nef3& set, const ToMeshOptions& options = {},
                                   CoordinateType type = CoordinateType::Double,
                                   Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
