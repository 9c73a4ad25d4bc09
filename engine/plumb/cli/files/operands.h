// Operands of commands: the kinds of files, numbers, and the reading of solids and scenes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/cli/session/session.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/solid_io.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"
#include "plumb/surface/surface.h"

namespace plumb {

/// The kind of thing that a file holds.
enum class FileKind : std::uint8_t {
  Map,       ///< A map (map_io.h).
  PlaneSet,  ///< A set of the plane (plane_io.h).
  Solid,     ///< A mesh or .nef (solid_io.h).
};

/// Returns the kind by the extension; if that names none, by how the file begins: a .nef, binary
/// STL (by its length), JSON of glTF, other JSON (GeoJSON), WKB or .nef2, a word of WKT or what its
/// dialects put before one; two numbers on the first line are a map. Everything else is taken for a
/// mesh.
FileKind kind_of_file(const std::string& path, std::string_view bytes);

}  // namespace plumb

namespace plumb::cli {

// Numbers on the command line, and exact numbers as text for people.

/// Returns a number given as an argument, by the rules for numbers in files. `name` appears in
/// Error{Usage}.
Rational read_number_argument(const std::string& text, const std::string& name, Session& session);

/// The options --raw and --grid of commands that write shapes of doubles.
class RoundingOptions {
 public:
  /// Declares --raw and, if the command has it, --grid.
  void declare(CLI::App& app, bool has_grid);
  /// Returns the options as a writer takes them. Throws Error{Usage} if the step of the grid is not
  /// a positive number, or if both options are given.
  PlaneWriteOptions read(Session& session) const;
  /// Whether an option is given.
  bool is_given() const { return is_raw_ || !grid_.empty(); }

 private:
  bool is_raw_ = false;
  std::string grid_;
};

/// Returns the exact number, unless that is longer than a person reads (areas of doubles can have
/// thousands of digits): then the nearest double, and how many digits the exact number has.
std::string readable(const Rational& value);

// How commands read sets of the plane, and solids.

/// Returns a set of the plane, whose file has been read, and prints its notes.
Nef2 read_plane(const std::string& file, const std::string& bytes, Session& session);

/// Throws Error{UnknownFormat} for maps and sets of the plane, which would be refused as meshes for
/// their first words.
void require_solid(const std::string& file, const std::string& bytes);

/// Help of an operand that may be either.
inline constexpr const char* kSolidOrPlaneHelp =
    "A solid: .off, .obj, .stl, .ply, .glb, .gltf, .3mf, .amf, .nef; or a set of the plane: .wkt, "
    ".geojson, .wkb, .nef2; - is standard input";

/// Prints the notes and the warnings of a file that was read: of a SolidRead or a MeshFile, or the
/// notes of a set of the plane.
template <class Read>
void print_notes(const std::string& file, const Read& read, Session& session) {
  const std::string name = input_name(file);
  for (const std::string& note : read.notes) session.note(name + ": " + note);
  if constexpr (requires { read.warnings; }) {
    for (const std::string& warning : read.warnings) session.warn(name, warning);
  }
}

/// The options that mend a mesh.
class RepairFlags {
 public:
  void declare(CLI::App& app);
  RepairOptions options() const;

 private:
  double weld_ = 0;
  bool one_side_ = false;
  bool reorients_ = false;
  std::uint32_t fill_holes_ = 0;
  double fill_holes_below_ = 0;
};

/// Returns the options that ask for a repair, such as "--weld 1e-06 --reorient".
std::string words_of(const RepairOptions& repair);

/// How meshes are read as sets: the same options for all operands of a command.
class SolidInput {
 public:
  void declare(CLI::App& app);
  /// Declares --keep, for commands that write solids. Without it, attributes are passed over. Where
  /// a command has another option of this name, it is called --attributes.
  void declare_keep(CLI::App& app);
  /// Declares --keep-faces, for commands that write solids.
  void declare_keep_faces(CLI::App& app);
  /// Returns which attributes are kept.
  KeptAttributes kept() const;
  /// Whether the faces of meshes stay apart in the result.
  bool keeps_faces() const { return keeps_faces_; }
  /// Returns a set of the plane, if a command accepts both. Throws Error{Usage} if an option says
  /// how meshes are read.
  Nef2 read_plane(const std::string& file, const std::string& bytes, Session& session) const;
  /// Whether no option says how meshes are read.
  bool is_plain() const {
    return rule_.empty() && !surface_ && !allows_empty_ && !repair_.options().asks();
  }
  /// Whether a mesh is read as the points that its faces wind around: closed and without repairs.
  bool reads_windings() const { return !surface_ && !allows_empty_ && !repair_.options().asks(); }
  /// Returns the rule that says which winding numbers are inside: "positive", "nonzero" or "odd".
  std::string winding_rule() const { return rule_.empty() ? "positive" : rule_; }
  /// Throws Error{Usage} if an option says how meshes are read, for a file that is no mesh.
  void require_plain() const;
  /// Returns a solid with its notes and warnings. May be called from several threads at once. A
  /// mesh that is refused is refused with a hint: options with which it is read, if there are any.
  SolidRead load(const std::string& file, const CommonOptions& options, Context& context) const;
  /// Returns a solid and prints its notes and warnings.
  Nef3 read(const std::string& file, Session& session) const;
  /// Does the same if the bytes of the file have been read.
  Nef3 read(const std::string& file, const std::string& bytes, Session& session) const;
  /// Does the same as load() for a file whose bytes have been read.
  SolidRead load(const std::string& file, const std::string& bytes, const CommonOptions& options,
                 Context& context) const;

 private:
  SolidReadOptions read_options(const CommonOptions& common) const;

  std::string rule_;
  bool surface_ = false;
  bool allows_empty_ = false;
  std::string keep_ = "none";
  bool keeps_faces_ = false;
  RepairFlags repair_;
};

// How commands on surfaces read scenes and expressions.

/// The loops that were added to a shape so that it separates the surface.
struct SurfaceRepair {
  std::uint32_t shape;
  std::vector<std::int64_t> homology;   ///< Its class before.
  std::vector<std::uint32_t> polygons;  ///< Loops that were added to it.
};

/// A scene that has been read and divided.
struct DividedScene {
  SurfaceDivision division;
  std::string model;  ///< Path of the model.
  std::vector<SurfaceRepair> repairs;
};

/// The options and operands of commands on surfaces.
class SurfaceInput {
 public:
  void declare(CLI::App& app);
  /// Declares the scene and --anywhere, but no option that concerns shapes.
  void declare_file(CLI::App& app);
  void declare_expression(CLI::App& app, bool is_required);

  bool has_expression() const { return !expression_.empty(); }
  const std::string& file() const { return file_; }

  /// Reads the scene, and prints its notes.
  SceneFile read_undivided(Session& session) const;
  /// Reads and divides the scene, and prints its notes.
  DividedScene read(Session& session) const;
  /// Returns the result of the expression. Throws Error{Usage} for bad expressions and for shapes
  /// without an inside.
  SurfaceResult evaluate(const SurfaceDivision& division, Context& context) const;

 private:
  std::string file_;
  std::string expression_;
  std::string rule_;
  bool repairs_ = false;
  bool reads_anywhere_ = false;
};

}  // namespace plumb::cli
