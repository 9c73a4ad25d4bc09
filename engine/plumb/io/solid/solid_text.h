// A set of space prepared for a file, and the check of links that a reader of `.nef` needs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The names of the planes of the frame in `.nef`, in the order of the tables.
inline constexpr std::array<std::string_view, 6> kFrameSides{"-x", "+x", "-y", "+y", "-z", "+z"};

/// A format of files of sets. `.nef` holds every set exactly; meshes hold the closure of the
/// interior, with rounded coordinates.
struct SolidFormat {
  std::string_view name;
  std::string_view extension;
  std::optional<MeshFormat> mesh;  ///< Empty for .nef.
};
/// Returns the formats in the order of preference.
std::span<const SolidFormat> solid_formats();

/// Returns the name of the material library beside the file `path`. It is empty if the path is "-",
/// a device or a pipe, which have no file beside them, or if the file itself is called .mtl.
std::string material_library_of(const std::string& path);

/// The options by which the boundary of a set becomes the faces of a mesh.
struct SolidFaces {
  /// Which pieces of facets become one face. If this is not SameAttributes, the mesh is divided as
  /// the sources are, even if they have no attributes.
  PieceJoin join = PieceJoin::SameAttributes;
  bool are_triangles = false;  ///< Whether all faces are triangles, in formats of polygons, too.
};

/// A set prepared for a format: all work and all checks are done before the first byte is written.
class SolidText {
 public:
  /// Throws Error{CannotWrite} if a mesh is to hold a marked volume that reaches infinity, and
  /// Error{NumberOutOfRange} if a coordinate lies beyond the largest double. If the set has sources
  /// with attributes that the format holds, the mesh has them. `library` is the name of the
  /// material library of OBJ; if it is empty, there is none.
  SolidText(const Nef3& set, const SolidFormat& format, OutputRounding rounding, Context& context,
            std::string library = {}, SolidFaces faces = {});

  /// Returns sentences about properties of the set that the file does not represent, or that
  /// rounding has changed.
  const std::vector<std::string>& losses() const { return losses_; }
  /// Returns sentences about changes that are no loss for users of meshes: that the closure of the
  /// set is written, and that rounding needed a repair.
  const std::vector<std::string>& changes() const { return changes_; }
  /// Returns a sentence on the attributes of the sources that the file does not have, or an empty
  /// text.
  const std::string& dropped() const { return dropped_; }
  /// Whether the file has attributes of the sources.
  bool has_attributes() const { return !attributes_.empty(); }
  /// Whether the file names a material library, which write_library() writes.
  bool has_library() const;
  void write_library(std::ostream& out) const { write_material_library(out, attributes_); }
  /// Writes the set; `.nef` with checkpoints.
  void write(std::ostream& out, Context& context) const;
  /// Writes a file and, if it has one, the material library beside it: both or none.
  void write_file(const std::string& path, Context& context) const;

 private:
  void make_mesh(MeshFormat format, OutputRounding rounding, Context& context);
  bool writes_attributes(OutputRounding rounding);
  void add_attributes(Context& context);
  MeshFaces mesh_faces() const;
  void require_faces(const PolygonMesh& mesh) const;

  Nef3 set_;
  SolidFormat format_;
  SolidFaces faces_;
  PolygonMesh mesh_;
  MeshAttributes attributes_;
  std::string library_;
  std::string dropped_;
  std::vector<std::string> losses_;
  std::vector<std::string> changes_;
};

// The check that the links of a complex can be followed, which a reader makes before anything else
// uses it.

/// Returns a text that states what is wrong with the links, or an empty string if nothing is wrong.
/// Requires arrays whose sizes agree and ids in range, as the reader's records have them. The
/// rules:
///
///   edges     An edge joins two vertices, lies on two planes, and is free in a volume or on a
///             facet
///   vertices  A vertex without edges is in a volume or in a facet, not both; any other has no
///             volume
///   uses      `next` goes on from where an edge use ends, in the same facet; `radial` stays at the
///             edge; both are permutations, and one radial cycle holds all uses of an edge
///   facets    Each cycle of uses is listed once, by the facet that its uses name
///
/// Cost: O(n).
std::string flaw_of_links(const SpaceComplex& complex);

}  // namespace plumb
