// Reads and writes polygon meshes: the entry point to OFF, OBJ, STL, PLY and, for reading only,
// glTF.
//
// Reading: the format is given, taken from the extension, or guessed from the first bytes. Faces
// stay as the file lists them; what a reader leaves out is reported in MeshFile::notes.
//
// Writing: OFF, OBJ, PLY and text STL hold doubles, binary STL holds floats, exact OFF holds
// fractions. STL holds triangles only. as_written() returns what a reader of the file will get.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A mesh read from a file.
struct MeshFile {
  PolygonMesh mesh;  ///< The mesh as it stands in the file.
  /// What else the file says, and what was left out: one sentence each, for people.
  std::vector<std::string> notes;
};

/// Formats of mesh files. For reading, Stl and StlBinary accept both forms of STL, and Ply and
/// PlyText accept every form of PLY; for writing, they select the form.
enum class MeshFormat : std::uint8_t {
  Off,        ///< OFF with doubles.
  ExactOff,   ///< OFF with fractions p/q as coordinates.
  Obj,        ///< OBJ with doubles.
  Stl,        ///< Text STL, with doubles.
  StlBinary,  ///< Binary STL, with floats.
  Ply,        ///< Binary PLY, little-endian, with doubles.
  PlyText,    ///< Text PLY, with doubles.
  Gltf,       ///< glTF, text or binary; for reading only.
};

/// Returns the format that the extension of `path` names: .off, .obj, .stl, .ply, .gltf or .glb.
/// Returns nullopt for any other extension.
std::optional<MeshFormat> mesh_format_of(const std::string& path);
/// Returns the format called `name`: off, off-exact, obj, stl, stl-binary, ply, ply-text, gltf or
/// glb. Returns nullopt for any other name.
std::optional<MeshFormat> mesh_format_named(std::string_view name);

/// Returns the format that the file seems to have. Its first bytes decide: "glTF" or "{" begin
/// glTF, "ply" begins PLY, "solid" or a length that fits binary STL means STL, and "OFF" with its
/// prefixes or a number begins OFF. Everything else is taken for OBJ.
MeshFormat guess_mesh_format(std::string_view bytes);

/// Returns the mesh that `bytes` hold in the given format. Throws the errors that the reader of the
/// format states (off.h, obj.h, stl.h, ply.h, gltf.h).
MeshFile read_mesh(std::string_view bytes, MeshFormat format, const ReadOptions& options = {},
                   Context& context = unlimited_context());

/// Returns the mesh of the file `path`, whose bytes have been read already. The format is that of
/// the extension, or else guessed. Buffers of glTF are looked up in the folder of the file. Throws
/// as read_mesh() does.
MeshFile read_mesh_of(const std::string& path, std::string_view bytes,
                      const ReadOptions& options = {}, Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-", and returns its mesh. Without
/// `format`, the format is that of the extension, or else guessed. `options.name` is ignored. The
/// memory of the bytes is released. Throws as read_mesh() does, and if the file cannot be read.
MeshFile read_mesh_file(const std::string& path, std::optional<MeshFormat> format,
                        ReadOptions options = {}, Context& context = unlimited_context());

/// Writes a mesh to a stream. Requires a format other than Gltf. Throws, before the first byte is
/// written, Error{NumberOutOfRange} if a coordinate cannot be rounded, and Error{BadArgument} if a
/// face that is not a triangle is to be written as STL. Throws what `out` throws.
void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat format);

/// Writes a mesh to the file `path` in the given format, or else in that of the extension (.off,
/// .obj, .stl, .ply). The file appears, or replaces an older one, only after all of it is written.
/// Throws Error{UnknownFormat} for any other extension, Error{CannotWrite} if the file cannot be
/// written, and as write_mesh() does.
void write_mesh_file(const std::string& path, const PolygonMesh& mesh,
                     std::optional<MeshFormat> format = {});
/// Writes a mesh of triangles in plain arrays to a file, in the same way and with the same errors.
void write_mesh_file(const std::string& path, const TriangleMesh& mesh,
                     std::optional<MeshFormat> format = {});

/// Returns the mesh with the coordinates that a reader of the written file will get. Throws as
/// write_mesh() does.
PolygonMesh as_written(PolygonMesh mesh, MeshFormat format);

}  // namespace plumb
#pragma GCC visibility pop
