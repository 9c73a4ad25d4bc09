#include "solid_input.h"

#include <utility>

#include "command_app.h"
#include "plumb/base/error.h"
#include "plumb/io/file_kind.h"
#include "plumb/io/input.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid_sets.h"

namespace plumb::cli {

void SolidInput::declare(CLI::App& app) {
  add_choice(app, "--rule", rule_, {"positive", "nonzero", "odd"},
             "Winding numbers inside (default: positive, and components inside out are turned)");
  app.add_flag("--surface", surface_, "Read a mesh, open or not, as the set of its facets");
}

SolidReadOptions SolidInput::read_options(const CommonOptions& common) const {
  SolidReadOptions options;
  options.exact_decimals = common.exact_decimals;
  options.surface = surface_;
  if (!rule_.empty()) {
    options.rule = rule_ == "odd"       ? WindingRule::EvenOdd
                   : rule_ == "nonzero" ? WindingRule::NonZero
                                        : WindingRule::Positive;
  }
  return options;
}

void require_solid(const std::string& file, const std::string& bytes) {
  const FileKind kind = kind_of_file(file, bytes);
  if (kind == FileKind::Solid) return;
  const std::string what = kind == FileKind::Map ? "a map" : "a set of the plane";
  throw Error(ErrorCode::UnknownFormat,
              what + ", where a solid is needed: .off, .obj, .stl, .ply, .glb, .gltf, .nef",
              {.file = input_name(file)});
}

SolidRead SolidInput::load(const std::string& file, const CommonOptions& options,
                           Context& context) const {
  const std::string bytes = read_input(file, context);
  require_solid(file, bytes);
  SolidRead solid = read_solid(file, bytes, read_options(options), context);
  context.release_memory(bytes.size());
  return solid;
}

Nef3 SolidInput::read(const std::string& file, Session& session) const {
  const std::string bytes = read_input(file, session.context());
  Nef3 set = read(file, bytes, session);
  session.context().release_memory(bytes.size());
  return set;
}

Nef3 SolidInput::read(const std::string& file, const std::string& bytes, Session& session) const {
  require_solid(file, bytes);
  SolidRead solid = read_solid(file, bytes, read_options(session.options()), session.context());
  for (const std::string& note : solid.notes) session.note(input_name(file) + ": " + note);
  return std::move(solid.set);
}

Nef2 SolidInput::read_plane(const std::string& file, const std::string& bytes,
                            Session& session) const {
  if (!is_plain()) throw Error(ErrorCode::Usage, "--rule and --surface are for meshes");
  const PlaneFormat format = plane_format_of(file).value_or(guess_plane_format(bytes));
  const ReadOptions options{input_name(file), session.options().exact_decimals};
  return read_plane_set(bytes, format, options, session.context());
}

}  // namespace plumb::cli
