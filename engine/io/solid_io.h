// Meshes from files and to files: the one front door to the formats of polygons.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_file.h"
#include "plumb/io/read_options.h"

namespace plumb {

enum class MeshFormat : std::uint8_t { Off };

/// By the extension: .off; none for any other.
std::optional<MeshFormat> mesh_format_of(const std::string& path);

/// The mesh in `bytes`. Errors: those of off_reader.h.
MeshFile read_mesh(std::string_view bytes, MeshFormat format, const ReadOptions& options,
                   Context& context);

/// The same from a file, or from standard input for "-"; without `format` it is that of the
/// extension. `options.name` is ignored. The memory of the bytes is given back.
MeshFile read_mesh_file(const std::string& path, std::optional<MeshFormat> format,
                        ReadOptions options, Context& context);

/// Coordinates that are no doubles are rounded. Throws what `out` throws.
void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat format);

}  // namespace plumb
