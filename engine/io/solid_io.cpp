#include "plumb/io/solid_io.h"

#include <filesystem>

#include "plumb/base/error.h"
#include "plumb/io/input.h"
#include "plumb/io/off_reader.h"
#include "plumb/io/off_writer.h"

namespace plumb {

std::optional<MeshFormat> mesh_format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".off") return MeshFormat::Off;
  return {};
}

MeshFile read_mesh(std::string_view bytes, MeshFormat /*format*/, const ReadOptions& options,
                   Context& context) {
  return read_off(bytes, options, context);
}

MeshFile read_mesh_file(const std::string& path, std::optional<MeshFormat> format,
                        ReadOptions options, Context& context) {
  options.name = input_name(path);
  const std::string bytes = read_input(path, context);
  if (!format) format = mesh_format_of(path);
  MeshFile file = read_mesh(bytes, format.value_or(MeshFormat::Off), options, context);
  context.release_memory(bytes.size());
  return file;
}

void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat /*format*/) {
  write_off(out, mesh);
}

}  // namespace plumb
