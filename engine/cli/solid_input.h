// How commands read solids.
#pragma once

#include <string>

#include "plumb/io/solid_sets.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"
#include "session.h"

namespace plumb::cli {

/// Throws Error{UnknownFormat} for maps and sets of the plane: as meshes they would be refused for their first words.
void require_solid(const std::string& file, const std::string& bytes);

/// Help of an operand that may be either.
inline constexpr const char* kSolidOrPlaneHelp =
    "A solid: .off, .obj, .stl, .ply, .glb, .gltf, .nef; or a set of the plane: .wkt, .geojson, "
    ".nef2; - is standard input";

/// How meshes are read as sets: the same options for all operands of a command.
class SolidInput {
 public:
  void declare(CLI::App& app);
  /// A set of the plane, where a command takes either: Usage if something was said of how meshes are read.
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

}  // namespace plumb::cli
