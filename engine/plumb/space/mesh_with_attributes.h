// Converts a set of space to a mesh that has the attributes of the meshes from which the set was
// made: materials, groups, ids, and numbers at corners such as colours and texture coordinates.
//
// Nothing is threaded through operations. A set keeps the list of its sources (source_mesh.h). The
// planes of a set are exact, and operations add no planes. So each part of the boundary that comes
// from a source lies in the plane of a face of this source, and the face is found again from the
// plane alone.
//
// Main flow of mesh_with_attributes():
//  1. SourceTriangles  finds the planes of the triangles of all sources in the tables of the set,
//                      most of them by one look-up. Equal planes have equal ids
//  2. cut_boundary     lays each facet over the source triangles of its plane. A facet inside the
//                      only triangle of its plane, or that is a face of a source, is one piece.
//                      Other facets are overlaid with the triangles by an exact sweep. Neighbouring
//                      pieces of one facet are joined as AttributeOptions::join says
//  3. round_mesh       rounds the mesh of the pieces and repairs it, as valid_mesh() does
//  4. fill_channels    copies the numbers at corners of source faces, and computes all others by
//                      barycentric weights
//
// Rules:
// - If several source triangles cover a piece, those with the same orientation as the boundary come
//   before those with the opposite one. Among these, the first source in Nef3::sources() wins: the
//   first operand. Within a source, the face of the least index wins.
// - A piece of the opposite orientation is flipped. So is the boundary of a subtracted set.
//   Channels named "normal" are negated there. They are also transformed by the inverse transpose
//   of the map of their source, and keep their length.
// - A piece that no source triangle covers, for instance in the plane of a half-space, has no
//   source. Its ids are MeshAttributes::kNone and its numbers are 0.
// - The weights are computed exactly from the exact point and then rounded to the nearest doubles.
//   For a point that a repair has moved, the weights are those of the moved point, seen along the
//   axis nearest to the normal of the triangle. Negative weights become 0.
// - A triangle that a repair makes belongs to one of the pieces from which it was made.
//
// Cost: the cost of valid_mesh(), O(n) for the triangles of the sources, and O(m log m) for m
// corners and crossings in planes in which a facet is cut. Errors: Error{BadArgument} if a marked
// volume is unbounded, what valid_mesh() throws, and what the context throws. Source:
// docs/attributes.md.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_attributes.h"
#include "plumb/space/nef3.h"
#include "plumb/space/source_mesh.h"
#include "plumb/space/to_mesh.h"
#include "plumb/space/valid_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How facets are divided into pieces. A facet that is exactly one face of a source, with no other
/// source in its plane, is one piece unless PieceJoin::None is given.
enum class PieceJoin : std::uint8_t {
  /// Neighbouring pieces of a facet are joined if they come from the same source and have the same
  /// material, group and id, and if each channel is the same affine function over both pieces.
  SameAttributes,
  None,  ///< Each piece lies in one triangle of a source.
  /// As SameAttributes, and only pieces of the same face of a source are joined. So the faces of
  /// the input stay apart from each other, even if they lie in one plane.
  SameFace,
};

/// Options of mesh_with_attributes().
struct AttributeOptions {
  PieceJoin join = PieceJoin::SameAttributes;    ///< How facets are divided into pieces.
  CoordinateType type = CoordinateType::Double;  ///< The numbers to which points are rounded.
  /// How pieces become faces. A piece stays a polygon under the conditions that MeshFaces states
  /// for facets; others are cut into triangles. Meshes of floats consist of triangles.
  MeshFaces faces = MeshFaces::Triangles;
};

/// The part of a source from which a face was made.
struct FaceSource {
  static constexpr std::uint32_t kNone = 0xffffffff;  ///< There is no source.

  std::uint32_t source = kNone;  ///< The index in Nef3::sources(), or kNone.
  /// The face of the source, an index of its mesh. If pieces were joined, the least of their faces.
  std::uint32_t face = kNone;
  bool is_flipped = false;  ///< Whether the face and the face of the source have opposite sides.
  friend bool operator==(const FaceSource&, const FaceSource&) = default;
};

/// A mesh with attributes.
struct MeshWithAttributes {
  PolygonMesh mesh;           ///< A valid mesh (valid_mesh.h), of triangles or of polygons.
  MeshAttributes attributes;  ///< What belongs to the faces and corners of the mesh.
  /// For each face, where it comes from. Faces are in ascending order of sources; faces without a
  /// source are last.
  std::vector<FaceSource> source;
  /// The faces run_begin[i], ..., run_begin[i + 1] - 1 come from source i. The last run, of the
  /// index of the number of sources, has the faces without a source. There is one more entry for
  /// the end.
  std::vector<std::uint32_t> run_begin;
  RoundingRepair repair;  ///< What was repaired after rounding.
  /// What the mesh does not say of the set. The counts of edges and vertices that are not manifold
  /// are 0.
  ToMeshReport report;
};

/// Returns the boundary of regularization() with the attributes of the sources of the set. In the
/// result, materials and groups of all sources follow each other in the order of the sources.
/// Channels of the same name become one channel with the greater width; numbers that a source does
/// not have are 0, and 1 in a channel named "color".
[[nodiscard]] MeshWithAttributes mesh_with_attributes(const Nef3& set,
                                                      const AttributeOptions& options = {},
                                                      Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
