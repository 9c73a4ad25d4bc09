// Reads sets of space from files. A file is a mesh (mesh_io.h), a .nef file (nef3_reader.h) or a
// list of half-spaces.
//
// A mesh becomes a closed set: the facets of the mesh bound volumes, and the winding number of a
// volume decides whether the volume belongs to the set. A .nef file represents any set exactly. If
// the reader changes or leaves out something of the file, a note reports this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/predicates/error.h"
#include "plumb/space/half_space_list.h"
#include "plumb/space/mesh_attributes.h"
#include "plumb/space/nef3.h"
#include "plumb/space/repair_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The attributes of a mesh (mesh_attributes.h) that are kept with its set.
enum class KeptAttributes : std::uint8_t {
  None,     ///< No attributes. Then attributes cost no time and no memory.
  Colours,  ///< Materials, and the channel "color".
  Ids,      ///< Ids of faces, and groups.
  All,      ///< All attributes.
};

/// Removes from `attributes` the attributes that `kept` does not select.
void keep_only(KeptAttributes kept, MeshAttributes& attributes);

/// Options of the conversion of a file to a set.
struct SolidReadOptions {
  /// The rule for winding numbers. A volume belongs to the set if the rule accepts its winding
  /// number. If no rule is given, the rule is Positive. In this case, the reader first flips each
  /// component of the mesh that has a negative volume and lies in no other component.
  std::optional<WindingRule> rule;
  /// Whether the set is the union of the facets of the mesh, instead of the volumes that they
  /// bound. The mesh may then be open.
  bool surface = false;
  /// Whether a number with a decimal point or an exponent is read exactly. Otherwise such a number
  /// is rounded to the nearest double.
  bool exact_decimals = false;
  /// How a mesh is repaired before it becomes a set. By default, it is not repaired.
  RepairOptions repair = {};
  /// Whether the set may be empty although the mesh has faces. If this is false, the reader throws
  /// EnclosesNothing for such a mesh.
  bool may_be_empty = false;
  /// Which attributes of a mesh are kept. If the mesh has such attributes, the mesh becomes the
  /// source of the set (Nef3::sources()). The source is the mesh as it was before any repair.
  KeptAttributes attributes = KeptAttributes::None;
  /// Whether the mesh becomes the source of the set even if it has no attributes. The source is
  /// needed if coplanar faces of the mesh must remain separate faces in a result
  /// (PieceJoin::SameFace).
  bool keeps_faces = false;
};

/// The error that is thrown if a mesh has faces, but no volume belongs to its set. An example is a
/// double-sided mesh, in which every face occurs once in each direction.
class EnclosesNothing : public Error {
 public:
  /// Constructs the error from the reason, and the file of the mesh.
  EnclosesNothing(const std::string& reason, std::string file)
      : Error(ErrorCode::BadShape, "the mesh encloses nothing: " + reason,
              TextPlace{std::move(file)}) {}
};

/// A set read from a file.
struct SolidRead {
  Nef3 set;                        ///< The set that the file describes.
  std::vector<std::string> notes;  ///< Notes for a human reader. Each note is one sentence.
  /// Warnings for a human reader about geometry of the file that is not in the set. Each warning is
  /// one sentence. A program should show warnings even if it does not show notes.
  std::vector<std::string> warnings;
};

/// Whether a file is a .nef file. The extension of `path` decides. If the extension names no
/// format, the first bytes of the file decide.
bool is_nef_file(const std::string& path, std::string_view bytes);

/// Reads the file `path`, or standard input if `path` is "-", and returns its set. Throws:
///   - the errors of mesh_io.h and nef3_reader.h
///   - Error{BadShape} if the audit (space_audit.h) finds a flaw in a .nef file
///   - Error{BadShape} if the mesh has no faces although the file is not empty, and
///     neither `options.surface` nor `options.may_be_empty` is true
///   - OpenMesh, an Error{BadShape}, if the mesh is open and `options.surface` is false. The error
///     lists the borders and the flipped faces of the mesh
///   - EnclosesNothing, an Error{BadShape}, if the set of a mesh with faces is empty, unless
///     `options.surface` or `options.may_be_empty` is true
SolidRead read_solid_file(const std::string& path, const SolidReadOptions& options = {},
                          Context& context = unlimited_context());
/// Returns the set of the file `path`. The caller has already read the bytes of the file. Throws as
/// read_solid_file() does.
SolidRead read_solid(const std::string& path, const std::string& bytes,
                     const SolidReadOptions& options = {}, Context& context = unlimited_context());

/// Reads half-spaces from the file `path`, or from standard input if `path` is "-". A line
/// `a b c d closed` stands for the half-space `a x + b y + c z + d <= 0`. A line `a b c d open`
/// stands for the half-space `a x + b y + c z + d < 0`. Errors are Error{Syntax} and
/// Error{NumberOutOfRange}, each with its position in the file.
HalfSpaceList read_half_spaces_file(const std::string& path, ReadOptions options = {},
                                    Context& context = unlimited_context());

// Repair options for meshes that the reader refuses.

/// Returns repair options for a mesh for which read_solid() with `options` throws OpenMesh or
/// EnclosesNothing. With the returned options, read_solid() accepts the mesh. The function tries
/// the following repairs in this order, and returns the first one that suffices. Each repair is
/// combined with `options.repair`:
///   - flipping faces
///   - dropping doubled faces, and flipping faces
///   - welding points whose distance is at most 1e-9, ..., 1e-5 times the size of the mesh, and
///     flipping faces
///   - flipping faces and filling holes; for a double-sided mesh also dropping doubled faces
///
/// Returns nullopt if none of these repairs suffices. The function tests each repair by repairing a
/// copy of the mesh and making a set from it. The cost is at most about ten times the cost of
/// reading the mesh. Throws the errors of the Context.
std::optional<RepairOptions> remedy_for(const PolygonMesh& mesh, const SolidReadOptions& options,
                                        Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
