// Converts a set of space to a mesh with attributes. The attributes come from the meshes from which
// the set was made. They are materials, groups, ids, and numbers at corners, such as colours and
// texture coordinates.
//
// Operations on sets do not keep track of attributes. Instead, a set keeps the list of its sources,
// the meshes from which it was made (source_mesh.h). The planes of a set are exact, and operations
// add no planes. So each part of the boundary that comes from a source lies exactly in the plane of
// a face of this source. Therefore the face can be found again from this plane.
//
// Main flow of mesh_with_attributes():
//  1. SourceTriangles  finds the plane of each triangle of all sources in the table of planes of
//                      the set. For most triangles, one look-up is enough. Equal planes have equal
//                      ids
//  2. cut_boundary     cuts each facet into pieces along the source triangles in the same plane. A
//                      facet is one piece if it lies inside the only source triangle of its plane,
//                      or if it is a face of a source. For other facets, an exact sweep computes
//                      the overlay of the facet and the triangles. Then neighbouring pieces of one
//                      facet are joined as AttributeOptions::join states
//  3. round_mesh       rounds the mesh of the pieces and repairs it, as valid_mesh() does
//  4. fill_channels    computes the numbers at the corners of the new faces. At a corner of a
//                      source face, the numbers are copied. At all other points they are
//                      interpolated with barycentric weights
//
// Rules:
// - A piece gets its attributes from one source triangle. If several source triangles cover the
//   piece, one of them is chosen as follows. Triangles with the same orientation as the piece are
//   preferred to triangles with the opposite orientation. Among these, a triangle of the first
//   source in Nef3::sources() is chosen, which belongs to the first operand. Among several faces of
//   this source, the face with the least index is chosen.
// - A piece is flipped if it and its source triangle have opposite orientations. An example is a
//   piece of the boundary of a subtracted set. The values of channels named "normal" are negated on
//   flipped pieces. If the source has a map, these values are also transformed by the inverse
//   transpose of the map, and keep their length.
// - A piece that no source triangle covers has no source. An example is a piece in the plane of a
//   half-space. Its ids are MeshAttributes::kNone, and its numbers are 0.
// - The weights are computed exactly from the exact point and then rounded to the nearest doubles.
//   A repair may have moved a point out of the plane of its triangle. Then the point and the
//   triangle are first projected along the coordinate axis that is nearest to the normal of the
//   triangle. Negative weights are replaced by 0.
// - A triangle that a repair makes gets the attributes of one of the pieces from which it was made.
//
// Cost: the cost of valid_mesh(), O(n) for n triangles of the sources, and O(m log m) for m corners
// and crossings in planes in which a facet is cut. Errors: Error{BadArgument} if a marked volume is
// unbounded, the errors of valid_mesh(), and the errors of the Context. Source: docs/attributes.md.
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

/// Determines which pieces of a facet are joined. One rule holds for all values except None: if a
/// facet is exactly one face of a source, and no other source has a face in its plane, the facet is
/// one piece.
enum class PieceJoin : std::uint8_t {
  /// Neighbouring pieces of a facet are joined under two conditions. They come from the same
  /// source, with the same material, group and id. For each channel, a single affine function
  /// describes the values on both pieces.
  SameAttributes,
  None,  ///< No pieces are joined, so each piece lies in one triangle of a source.
  /// Pieces are joined under the conditions of SameAttributes, and only if they also come from the
  /// same face of a source. So two faces of the input remain separate faces, even if they lie in
  /// one plane.
  SameFace,
};

/// Options of mesh_with_attributes().
struct AttributeOptions {
  PieceJoin join = PieceJoin::SameAttributes;  ///< The pieces of a facet that are joined.
  /// The type of number to which points are rounded.
  CoordinateType type = CoordinateType::Double;
  /// The faces that are made from pieces. A piece becomes one polygon under the conditions that
  /// MeshFaces states for facets. All other pieces are cut into triangles. If points are rounded to
  /// floats, all pieces are cut into triangles.
  MeshFaces faces = MeshFaces::Triangles;
};

/// The part of a source from which a face was made.
struct FaceSource {
  static constexpr std::uint32_t kNone = 0xffffffff;  ///< The value for "no source".

  std::uint32_t source = kNone;  ///< The index in Nef3::sources(), or kNone.
  /// The index of the face in the mesh of the source. If pieces were joined, this is the least of
  /// the indices of their faces.
  std::uint32_t face = kNone;
  bool is_flipped = false;  ///< Whether the face and its source face have opposite orientations.
  friend bool operator==(const FaceSource&, const FaceSource&) = default;
};

/// A mesh with attributes.
struct MeshWithAttributes {
  PolygonMesh mesh;           ///< A valid mesh (valid_mesh.h), of triangles or of polygons.
  MeshAttributes attributes;  ///< The attributes of the faces and corners of the mesh.
  /// The source of each face. Faces are in ascending order of sources, and faces without a source
  /// come last.
  std::vector<FaceSource> source;
  /// Faces run_begin[i], ..., run_begin[i + 1] - 1 come from source i. If there are n sources,
  /// faces run_begin[n], ..., run_begin[n + 1] - 1 have no source. So the array has n + 2 entries.
  std::vector<std::uint32_t> run_begin;
  RoundingRepair repair;  ///< A report about the repair after rounding.
  /// A report about the properties of the set that the mesh does not represent. The counts of edges
  /// and vertices that are not manifold are 0.
  ToMeshReport report;
};

/// Returns the boundary of regularization() with the attributes of the sources of the set. The list
/// of materials of the result consists of the materials of the first source, then the materials of
/// the second source, and so on. The list of groups is made in the same way. Channels of different
/// sources that have the same name become one channel. The width of this channel is the greatest of
/// the widths of the joined channels. Values that a source lacks are set to 1 in a channel named
/// "color", and to 0 in all other channels.
[[nodiscard]] MeshWithAttributes mesh_with_attributes(const Nef3& set,
                                                      const AttributeOptions& options = {},
                                                      Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
