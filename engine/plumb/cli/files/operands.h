// What kind of thing a file holds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/cli/session/session.h"
#include "plumb/io/solid_io.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"
#include "plumb/surface/surface.h"

namespace plumb {

enum class FileKind : std::uint8_t {
  Map,       ///< map_io.h
  PlaneSet,  ///< plane_io.h
  Solid,     ///< solid_io.h: meshes and .nef
};

/// By the extension; where that names none, by how the file begins: a .nef, binary STL (by its
/// length), JSON of glTF, other JSON (GeoJSON) or .nef2, a word of WKT; two numbers on the first
/// line are a map. All else is taken for a mesh.
FileKind kind_of_file(const std::string& path, std::string_view bytes);

}  // namespace plumb

namespace plumb::cli {

// Numbers on the command line, and exact ones for people to read.

/// A number given as an argument, by the rules for numbers in files. `name` is said in
/// Error{Usage}.
Rational read_number_argument(const std::string& text, const std::string& name, Session& session);

/// Exactly, unless that is longer than a person reads (areas of doubles can have thousands of
/// digits): then the nearest double, and how many digits the exact number has.
std::string readable(const Rational& value);

// How commands read solids.

/// Throws Error{UnknownFormat} for maps and sets of the plane: as meshes they would be refused for
/// their first words.
void require_solid(const std::string& file, const std::string& bytes);

/// Help of an operand that may be either.
inline constexpr const char* kSolidOrPlaneHelp =
    "A solid: .off, .obj, .stl, .ply, .glb, .gltf, .nef; or a set of the plane: .wkt, .geojson, "
    ".nef2; - is standard input";

/// How meshes are read as sets: the same options for all operands of a command.
class SolidInput {
 public:
  void declare(CLI::App& app);
  /// A set of the plane, where a command takes either: Usage if something was said of how meshes
  /// are read.
  Nef2 read_plane(const std::string& file, const std::string& bytes, Session& session) const;
  /// Was nothing said of how meshes are read?
  bool is_plain() const { return rule_.empty() && !surface_; }
  /// With what is remarkable about it. May be called from several threads at once.
  SolidRead load(const std::string& file, const CommonOptions& options, Context& context) const;
  /// What is remarkable is noted.
  Nef3 read(const std::string& file, Session& session) const;
  /// The same, when the bytes of the file have been read.
  Nef3 read(const std::string& file, const std::string& bytes, Session& session) const;

 private:
  SolidReadOptions read_options(const CommonOptions& common) const;

  std::string rule_;
  bool surface_ = false;
};

// How commands on surfaces read scenes and expressions.

/// What made a shape separate that did not.
struct SurfaceRepair {
  std::uint32_t shape;
  std::vector<std::int64_t> homology;   ///< its class before
  std::vector<std::uint32_t> polygons;  ///< loops that were added to it
};

struct DividedScene {
  SurfaceDivision division;
  std::string model;  ///< its path
  std::vector<SurfaceRepair> repairs;
};

class SurfaceInput {
 public:
  void declare(CLI::App& app);
  void declare_expression(CLI::App& app, bool is_required);

  bool has_expression() const { return !expression_.empty(); }
  const std::string& file() const { return file_; }

  /// What is remarkable is noted.
  DividedScene read(Session& session) const;
  /// Errors: Usage, for expressions and for shapes without an inside.
  SurfaceResult evaluate(const SurfaceDivision& division, Context& context) const;

 private:
  std::string file_;
  std::string expression_;
  std::string rule_;
  bool repairs_ = false;
};

}  // namespace plumb::cli
