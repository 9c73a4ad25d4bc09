// Mends meshes on request: close points, doubled faces, faces listed the wrong way round, holes.
//
// Main flow of repair_mesh():
//  1. weld_points      makes points one that are equal, or at most RepairOptions::weld apart; trims
//                      faces that then repeat a corner, and drops those with fewer than three
//  2. drop_doubled     drops faces with the corners of an earlier face, in either direction
//  3. orient_faces     turns faces that disagree with their neighbours
//  4. fill_hole        adds faces along closed chains of edges that lack a face
//  5. turn_components  turns components of negative volume that no others enclose
//
// Every step is done only if it is asked for, and reports what it did. Nothing is guessed from
// distances except in step 1, where the caller gives the distance. What is mended is the mesh; the
// set that it describes is made by Nef3::from_mesh(), which needs none of these steps for a mesh
// that is closed.
//
// Cost: O(n log n) for n corners, besides O(k^2) for each edge of a hole of k <= 100 edges. Step 5
// costs as much as complex_of_mesh(), and as arrange() if the mesh crosses itself. Memory: about
// 200 bytes per corner. Source: docs/design/meshes.md, "Mending".
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What repair_mesh() does with faces that have the corners of an earlier face, in either
/// direction.
enum class DoubledFaces : std::uint8_t {
  Keep,  ///< They stay.
  /// They are dropped if that makes the borders of the mesh shorter, or if every face is there in
  /// both directions and one side alone is closed. Two solids with a common wall, which has a face
  /// of each, stay as they are.
  DropIfBetter,
  Drop,  ///< They are dropped. Of a double-sided mesh one side stays.
};

/// What repair_mesh() is asked to do.
struct RepairOptions {
  /// Points at most this far apart become one point. With 0 only points with equal coordinates do.
  double weld = 0;
  DoubledFaces doubled = DoubledFaces::Keep;  ///< What is done with doubled faces.
  /// Whether faces that disagree with their neighbours are turned, and then, if the mesh is closed,
  /// components of negative volume that no others enclose.
  bool reorient = false;
  /// Holes with at most so many edges are filled. If this is not 0, faces that disagree with their
  /// neighbours are turned, too, since the holes are known only then.
  std::uint32_t fill_holes = 0;
  /// Holes are also filled if the bounding box of their vertices has a diagonal of at most this
  /// length, however many edges they have. Faces are turned as for fill_holes.
  double fill_holes_below = 0;

  /// Whether anything is asked for.
  bool asks() const {
    return weld > 0 || doubled != DoubledFaces::Keep || reorient || fills_holes();
  }
  /// Whether holes of some size are filled.
  bool fills_holes() const { return fill_holes > 0 || fill_holes_below > 0; }
  friend bool operator==(const RepairOptions&, const RepairOptions&) = default;
};

/// What repair_mesh() found and did. Faces are 0-based indices of the mesh before; all lists of
/// faces are in ascending order.
struct RepairReport {
  std::uint64_t equal = 0;    ///< Points that had the coordinates of an earlier point.
  std::uint64_t welded = 0;   ///< Places that moved onto another place.
  double farthest = 0;        ///< How far they moved at most; never more than RepairOptions::weld.
  std::uint64_t unused = 0;   ///< Points dropped because no face uses them; merged points as well.
  std::uint64_t trimmed = 0;  ///< Faces that lost repeated corners or spikes (a b a).
  std::vector<std::uint32_t> degenerate;  ///< Dropped faces: fewer than three corners were left.
  /// Pairs of a dropped face and the earlier face that has the same corners.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> doubled;
  std::vector<std::uint32_t> flipped;  ///< Faces turned to agree with their neighbours.
  /// The least face of each component that was turned because it was inside out.
  std::vector<std::uint32_t> turned;
  std::vector<std::uint32_t> filled;  ///< For each hole that was filled, the number of its edges.
  std::uint64_t added = 0;            ///< Faces added in holes.
  /// Closed chains of vertices of the mended mesh along which faces are missing, or disagree.
  std::vector<std::vector<std::uint32_t>> holes;
  /// The least face of each connected set of faces that has only one side, as a Moebius strip.
  std::vector<std::uint32_t> one_sided;

  /// Whether the mended mesh is closed.
  bool is_closed() const { return holes.empty(); }
  /// Whether the mesh was changed, apart from points that no face uses.
  bool has_changed() const {
    return equal > 0 || welded > 0 || trimmed > 0 || !degenerate.empty() || !doubled.empty() ||
           !flipped.empty() || !turned.empty() || !filled.empty();
  }
};

/// Mends a mesh. Faces that stay keep their order, and faces added in holes follow them. Points
/// that stay keep their order and their coordinates. Throws, and then leaves the mesh as it was:
///   - Error{BadArgument} unless the tolerance of welding is finite and not negative
///   - Error{BadIndex} and Error{NotFinite} as complex_of_mesh() does
///   - what the context throws
RepairReport repair_mesh(PolygonMesh& mesh, const RepairOptions& options,
                         Context& context = unlimited_context());

/// Describes what was done, for a human: one sentence each, nothing if nothing was done. Points
/// that are merged because they are equal are not mentioned.
std::vector<std::string> sentences(const RepairReport& report);

/// Returns the mesh with every face of more than three corners cut into triangles between its
/// corners, which have the same boundary: constrained Delaunay triangles if the face is simple as
/// seen along an axis, else a fan. Throws Error{BadIndex}, Error{NotFinite}, and what the context
/// throws. O(n log n).
PolygonMesh triangulated(const PolygonMesh& mesh, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
