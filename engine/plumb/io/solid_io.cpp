#include "plumb/io/solid_io.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/solid/half_space_reader.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/space/space_audit.h"

namespace plumb {
namespace {

void add_note(const std::string& what, const std::vector<std::uint32_t>& faces,
              std::vector<std::string>& notes) {
  if (!faces.empty()) notes.push_back(what + ": " + listed(faces));
}

std::string crossings_of(const MeshReport& report) {
  std::vector<std::string> pairs;
  for (const auto& [f, g] : report.crossings) {
    pairs.push_back(std::to_string(f) + " and " + std::to_string(g));
  }
  return "the mesh crosses itself and is cut there; " + std::to_string(report.crossing_count) +
         " pair(s) of faces, the first: " + listed(pairs);
}

/// Describes what was done to the mesh. Face numbers are 0-based, as in the file.
void describe(const MeshReport& report, std::vector<std::string>& notes) {
  add_note("faces without area, left out", report.degenerate, notes);
  add_note("faces with repeated corners or spikes, trimmed", report.trimmed, notes);
  add_note("faces that are not planar, triangulated", report.not_planar, notes);
  add_note("faces that are not simple polygons, triangulated", report.not_simple, notes);
  std::vector<std::uint32_t> doubled;
  for (const auto& [face, earlier] : report.doubled) doubled.push_back(face);
  add_note("faces with the boundary of an earlier one, merged with it", doubled, notes);
  if (report.crosses_itself()) notes.push_back(crossings_of(report));
  add_note("components that were inside out, turned; their first faces", report.turned, notes);
}

SolidRead read_nef_set(const std::string& bytes, const ReadOptions& text, Context& context) {
  SpaceComplex complex = read_nef3(bytes, text, context);
  if (const auto flaw = audit(complex, AuditForm::Minimal, context)) {
    throw Error(ErrorCode::BadShape, "no set of space: " + flaw->invariant + ": " + flaw->place,
                {text.name});
  }
  return {Nef3::from_minimal_unchecked(std::move(complex)), {}, {}};
}

/// Returns the set of a mesh. Errors of the mesh are reported with the name of its file.
Nef3 set_of(const PolygonMesh& mesh, const FromMeshOptions& reading, const std::string& name,
            Context& context) {
  try {
    return Nef3::from_mesh(mesh, reading, context);
  } catch (const OpenMesh& error) {
    throw OpenMesh(error.report(), {name});
  }
}

/// Refuses a file without faces, unless it is to be read as the set of its facets: then the set is
/// empty, with a warning.
void refuse_without_faces(const MeshFile& file, bool is_surface, const std::string& name,
                          std::vector<std::string>& warnings) {
  const std::string lack = lack_of_faces(file);
  if (lack.empty()) return;
  if (!is_surface) {
    throw Error(ErrorCode::BadShape,
                lack + "; export it as polygons; --surface reads it as the empty set", {name});
  }
  warnings.push_back(lack + "; the set is empty");
}

}  // namespace

bool is_nef_file(const std::string& path, std::string_view bytes) {
  if (std::filesystem::path(path).extension() == ".nef") return true;
  take_prefix(bytes, "\xEF\xBB\xBF");
  return !mesh_format_of(path) && bytes.starts_with("plumb-nef3");
}

SolidRead read_solid(const std::string& path, const std::string& bytes,
                     const SolidReadOptions& options, Context& context) {
  const ReadOptions text{input_name(path), options.exact_decimals};
  if (is_nef_file(path, bytes)) return read_nef_set(bytes, text, context);
  MeshFile file = read_mesh_of(path, bytes, text, context);
  std::vector<std::string> warnings = file.warnings;
  refuse_without_faces(file, options.surface, text.name, warnings);
  MeshReport report;
  const FromMeshOptions reading{
      .rule = options.rule, .surface = options.surface, .report = &report};
  Nef3 set = set_of(file.mesh, reading, text.name, context);
  std::vector<std::string> notes = std::move(file.notes);
  describe(report, notes);
  return {std::move(set), std::move(notes), std::move(warnings)};
}

SolidRead read_solid_file(const std::string& path, const SolidReadOptions& options,
                          Context& context) {
  const std::string bytes = read_input(path, context);
  SolidRead read = read_solid(path, bytes, options, context);
  context.release_memory(bytes.size());
  return read;
}

HalfSpaceList read_half_spaces_file(const std::string& path, ReadOptions options,
                                    Context& context) {
  options.name = input_name(path);
  const std::string text = read_input(path, context);
  HalfSpaceList half_spaces = read_half_spaces(text, options, context);
  context.release_memory(text.size());
  return half_spaces;
}

}  // namespace plumb
