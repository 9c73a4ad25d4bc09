// Repairs a mesh. The caller chooses which defects are repaired: points that are close together but
// not equal, doubled faces, faces with the wrong orientation, and holes.
//
// Main flow of repair_mesh():
//  1. weld_points      merges points that are equal, or whose distance is at most
//                      RepairOptions::weld. If a face then has the same corner twice in a row, the
//                      repetition is removed. A face with fewer than three corners is dropped
//  2. drop_doubled     drops faces that have the same corners as an earlier face, in the same or in
//                      the opposite direction
//  3. orient_faces     flips faces that are not oriented like their neighbours
//  4. fill_hole        adds faces along closed chains of edges at which a face is missing
//  5. turn_components  flips components that have a negative volume and lie inside no other
//                      component
//
// A step is taken only if the options ask for it. All changes are reported. Only step 1 compares
// distances, and the caller gives the largest distance of two points that are merged. The functions
// of this header change a mesh and make no set. Nef3::from_mesh() makes a set from a mesh. A closed
// mesh can be passed to Nef3::from_mesh() without any of these steps.
//
// Cost: O(n log n) for n corners. In addition, a hole of k <= 100 edges takes O(k^3). Step 5 has
// the cost of complex_of_mesh(), plus the cost of arrange() if the mesh crosses itself. Memory:
// about 200 bytes per corner. Source: docs/design/meshes.md, "Mending".
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

#pragma GCC visibility push(default)
namespace plumb {

/// States when repair_mesh() drops doubled faces. A doubled face has the same corners as an earlier
/// face, in the same or in the opposite direction.
enum class DoubledFaces : std::uint8_t {
  Keep,  ///< Doubled faces are kept.
  /// Doubled faces are dropped in three cases. First case: without them, the borders of the mesh
  /// are shorter. Second case: every face of the mesh occurs in both directions, and the faces of
  /// one direction alone form a closed mesh. Third case: no face occurs in both directions, and the
  /// mesh is closed with the doubled faces and also without them. In this case, whole closed
  /// surfaces occur several times. If two solids have a common wall, the wall consists of a face of
  /// each solid. Such doubled faces are kept.
  DropIfBetter,
  Drop,  ///< Doubled faces are dropped. If the mesh is double-sided, one of its sides remains.
};

/// Options of repair_mesh(), which select the repairs.
struct RepairOptions {
  /// Points whose distance is at most this value are merged. If it is 0, only points with equal
  /// coordinates are merged.
  double weld = 0;
  DoubledFaces doubled = DoubledFaces::Keep;  ///< States when doubled faces are dropped.
  /// Whether faces that are not oriented like their neighbours are flipped. If the mesh is closed
  /// afterwards, components that have a negative volume and lie inside no other component are
  /// flipped, too.
  bool reorient = false;
  /// Holes with at most this number of edges are filled. If it is not 0, faces that are not
  /// oriented like their neighbours are flipped first, because the holes are known only afterwards.
  std::uint32_t fill_holes = 0;
  /// A hole is also filled if the diagonal of the bounding box of its vertices is at most this
  /// length. The number of its edges does not matter in this case. If the length is not 0, faces
  /// are flipped first (see fill_holes).
  double fill_holes_below = 0;

  /// Whether the options ask for any repair.
  bool asks() const {
    return weld > 0 || doubled != DoubledFaces::Keep || reorient || fills_holes();
  }
  /// Whether the options ask for holes to be filled.
  bool fills_holes() const { return fill_holes > 0 || fill_holes_below > 0; }
  friend bool operator==(const RepairOptions&, const RepairOptions&) = default;
};

/// A report on the defects that repair_mesh() found and the repairs that it made. Faces are 0-based
/// indices of the mesh before the repair. All lists of faces are in ascending order.
struct RepairReport {
  /// The number of points that had the same coordinates as an earlier point.
  std::uint64_t equal = 0;
  std::uint64_t welded = 0;  ///< The number of positions that were moved to another position.
  /// The largest distance by which a point moved; at most RepairOptions::weld.
  double farthest = 0;
  /// The number of points that were dropped because no face uses them, including merged points.
  std::uint64_t unused = 0;
  std::uint64_t trimmed = 0;  ///< The number of faces that lost repeated corners or spikes (a b a).
  /// Faces that were dropped because they had fewer than three corners left.
  std::vector<std::uint32_t> degenerate;
  /// The doubled faces that were dropped, each with the earlier face that has the same corners.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> doubled;
  std::vector<std::uint32_t> flipped;  ///< Faces that were flipped because of their neighbours.
  /// For each component that was flipped because it was inside out, the face with the least index.
  std::vector<std::uint32_t> turned;
  std::vector<std::uint32_t> filled;  ///< The number of edges of each hole that was filled.
  std::uint64_t added = 0;            ///< The number of faces that were added in holes.
  /// Closed chains of vertices of the repaired mesh along which faces are missing, or along which
  /// the orientations of faces disagree.
  std::vector<std::vector<std::uint32_t>> holes;
  /// For each connected set of faces that has only one side (such as a Moebius strip), the face
  /// with the least index.
  std::vector<std::uint32_t> one_sided;

  /// Whether the repaired mesh is closed.
  bool is_closed() const { return holes.empty(); }
  /// Whether the mesh was changed. The removal of points that no face uses does not count as a
  /// change.
  bool has_changed() const {
    return equal > 0 || welded > 0 || trimmed > 0 || !degenerate.empty() || !doubled.empty() ||
           !flipped.empty() || !turned.empty() || !filled.empty();
  }
};

/// Repairs a mesh. Faces that are not dropped keep their order, and the faces that were added in
/// holes follow after them. Points that are not dropped keep their order and their coordinates. If
/// the function throws, the mesh is unchanged. It throws:
///   - Error{BadArgument} if RepairOptions::weld is negative or not finite
///   - Error{BadIndex} and Error{NotFinite} as complex_of_mesh() does
///   - the errors of the Context
RepairReport repair_mesh(PolygonMesh& mesh, const RepairOptions& options,
                         Context& context = unlimited_context());

/// Does the same with the attributes of the mesh, which become those of the repaired mesh. A face
/// keeps its material, its group, its id and the numbers at its corners. If a face is flipped, its
/// normals (the channel "normal" of width 3) are negated. Faces added in holes have no material, no
/// group and no id; their numbers are 1 in the channel "color" and 0 in all other channels. If the
/// function throws, the mesh and the attributes are unchanged. In addition, it throws
/// Error{BadArgument} if an array of the attributes is neither empty nor complete
/// (mesh_attributes.h). Additional cost: O(n) for n corners.
RepairReport repair_mesh(PolygonMesh& mesh, MeshAttributes& attributes,
                         const RepairOptions& options, Context& context = unlimited_context());

/// Describes the repairs for a human reader, with one sentence for each kind of repair. Returns an
/// empty list if nothing was repaired. The merging of equal points is not mentioned.
std::vector<std::string> sentences(const RepairReport& report);

/// Returns the mesh after every face with more than three corners was cut into triangles. The
/// corners of these triangles are corners of the face, and the triangles together have the boundary
/// of the face. If the projection of the face along some coordinate axis is a simple polygon, the
/// triangles form a constrained Delaunay triangulation. Otherwise they form a fan. Throws
/// Error{BadIndex}, Error{NotFinite}, and the errors of the Context. Cost: O(n log n) for n
/// corners.
PolygonMesh triangulated(const PolygonMesh& mesh, Context& context = unlimited_context());
/// Does the same with the attributes of the mesh, which become those of the triangles: a triangle
/// has the attributes of its face, and the numbers at the corners of this face. If two corners of a
/// face are at one point, each of them belongs to the triangles between its own two edges. In
/// addition, throws Error{BadArgument} if an array of the attributes is neither empty nor complete
/// (mesh_attributes.h).
PolygonMesh triangulated(const PolygonMesh& mesh, MeshAttributes& attributes,
                         Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
