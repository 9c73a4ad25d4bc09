// Meshes from files and to files: the one front door to OFF, OBJ, STL, PLY and, reading only, glTF.
//
// Writing: OFF, OBJ, PLY and text STL hold doubles, binary STL floats; STL holds triangles only. What a
// reader will get is as_written().
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_file.h"
#include "plumb/io/read_options.h"

#pragma GCC visibility push(default)
namespace plumb {

/// STL is read in either form, PLY in any; these say how they are written.
enum class MeshFormat : std::uint8_t {
  Off,
  ExactOff,  ///< with coordinates p/q
  Obj,
  Stl,  ///< text: it holds doubles
  StlBinary,
  Ply,  ///< binary, little-endian
  PlyText,
  Gltf,  ///< text or binary; only read
};

/// By the extension: .off, .obj, .stl, .ply, .gltf, .glb; none for any other.
std::optional<MeshFormat> mesh_format_of(const std::string& path);
/// By the name: off, off-exact, obj, stl, stl-binary, ply, ply-text, gltf, glb; none for any other.
std::optional<MeshFormat> mesh_format_named(std::string_view name);

/// By how the file begins: "glTF" or "{", "ply", "solid" or the length of binary STL, "OFF" with its prefixes or a number;
/// all else is taken for OBJ.
MeshFormat guess_mesh_format(std::string_view bytes);

/// The mesh in `bytes`. Errors: those of off_reader.h, obj_reader.h, stl_reader.h, ply_reader.h, gltf_reader.h.
MeshFile read_mesh(std::string_view bytes, MeshFormat format, const ReadOptions& options,
                   Context& context);

/// The mesh of the file `path`, whose bytes these are: by its extension, else guessed. Buffers of glTF are sought in
/// its folder.
MeshFile read_mesh_of(const std::string& path, std::string_view bytes, const ReadOptions& options,
                      Context& context);

/// The same from a file, or from standard input for "-"; without `format` it is that of the
/// extension, else guessed. `options.name` is ignored. The memory of the bytes is given back.
MeshFile read_mesh_file(const std::string& path, std::optional<MeshFormat> format,
                        ReadOptions options, Context& context);

/// Requires another format than Gltf. Throws, before the first byte, Error{NumberOutOfRange} when a coordinate cannot be rounded,
/// Error{BadArgument} when STL is to hold other faces than triangles; what `out` throws.
void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat format);

/// The mesh with the coordinates that a reader of the file will get. Throws as write_mesh() does.
PolygonMesh as_written(PolygonMesh mesh, MeshFormat format);

}  // namespace plumb
#pragma GCC visibility pop
