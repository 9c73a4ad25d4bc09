// Reads and writes polygon meshes as OFF, OBJ, STL, PLY, glTF and 3MF.
//
// Reading: the caller may state the format. Otherwise the extension of the file determines the
// format. If the extension names no format, the format is guessed from the bytes of the file. Faces
// are not changed: they have the corners that the file lists. MeshFile::notes and
// MeshFile::warnings report all contents of the file that are not in the mesh.
//
// Writing: the coordinates in OFF, OBJ, PLY, 3MF and text STL are doubles. The coordinates in
// binary STL and in glTF are floats. The coordinates in exact OFF are fractions. STL, glTF and 3MF
// files contain triangles only. The function as_written() returns the mesh that a reader of the
// written file will get.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A mesh read from a file.
struct MeshFile {
  PolygonMesh mesh;  ///< The mesh as the file lists it.
  /// Notes for a human reader. Each note is one sentence. The notes report contents of the file
  /// that are not in `mesh`.
  std::vector<std::string> notes;
  /// Warnings for a human reader. Each warning is one sentence. The warnings report geometry of the
  /// file that is not in `mesh`. A program should show warnings even if it does not show notes.
  std::vector<std::string> warnings;
  /// The number of faces of the file that are not in `mesh` because two of their corners are equal.
  /// If this is not 0, a face can have another number in `mesh` than in the file.
  std::size_t faces_left_out = 0;
  /// The attributes of `mesh`, such as colours. They are empty unless ReadOptions::attributes is
  /// true and the file has attributes. Attributes are read from OFF, OBJ, PLY, glTF and 3MF files.
  MeshAttributes attributes = {};
};

/// Formats of mesh files. For some formats there are several forms, such as text and binary STL. A
/// writer writes exactly the form that the enumerator names. A reader accepts every form. For Stl
/// and for StlBinary, a reader accepts text STL and binary STL. For Ply and for PlyText, a reader
/// accepts every form of PLY. For Gltf, a reader accepts binary and text glTF.
enum class MeshFormat : std::uint8_t {
  Off,        ///< OFF with doubles.
  ExactOff,   ///< OFF with fractions p/q as coordinates.
  Obj,        ///< OBJ with doubles.
  Stl,        ///< Text STL, with doubles.
  StlBinary,  ///< Binary STL, with floats.
  Ply,        ///< Binary PLY, little-endian, with doubles.
  PlyText,    ///< Text PLY, with doubles.
  Gltf,       ///< Binary glTF (GLB), with floats.
  ThreeMf,    ///< 3MF, with doubles.
  Amf,        ///< AMF. It is read, but not written.
};

/// Returns the format that the extension of `path` names: .off, .obj, .stl, .ply, .gltf, .glb,
/// .3mf or .amf. Returns nullopt for any other extension.
std::optional<MeshFormat> mesh_format_of(const std::string& path);
/// Returns the format called `name`: off, off-exact, obj, stl, stl-binary, ply, ply-text, gltf,
/// glb, 3mf or amf. Returns nullopt for any other name.
std::optional<MeshFormat> mesh_format_named(std::string_view name);

/// Whether files of this format contain triangles only: Stl, StlBinary, Gltf, ThreeMf and
/// Amf.
bool lists_triangles(MeshFormat format);

/// Returns the format that a file with these bytes seems to have:
///   - 3MF if the bytes begin as a ZIP archive does
///   - glTF if the bytes begin with "glTF" or "{"
///   - PLY if the bytes begin with "ply"
///   - STL if the bytes begin with "solid"
///   - STL if the bytes state a number of triangles as a binary STL file does, and the number of
///     bytes agrees with this number of triangles
///   - OFF if the bytes begin with "OFF" in capital or small letters, with a variant of this word
///     such as "COFF", or with a number
///   - STL if there are 84 bytes or more, and some of the first bytes are control characters
///   - OBJ in all other cases
MeshFormat guess_mesh_format(std::string_view bytes);

/// Returns the mesh that `bytes` describe in the given format. Throws the errors that the
/// header of the reader of this format lists (off.h, obj.h, stl.h, ply.h, gltf.h, threemf.h).
MeshFile read_mesh(std::string_view bytes, MeshFormat format, const ReadOptions& options = {},
                   Context& context = unlimited_context());

/// Returns the mesh of the file `path`. The caller has already read the bytes of the file. The
/// extension of `path` determines the format. If the extension names no format, the format is
/// guessed by guess_mesh_format(). A glTF file may refer to other files, and an OBJ file refers to
/// its material library if it has materials. Such other files are read from the folder of `path`. A
/// material library is read only if attributes are read. Throws as read_mesh() does.
MeshFile read_mesh_of(const std::string& path, std::string_view bytes,
                      const ReadOptions& options = {}, Context& context = unlimited_context());

/// Explains why a mesh has no faces although its file is not empty. Returns a sentence that states
/// what the file contains instead of faces, such as vertices or contents that the reader left out.
/// Returns an empty text if the mesh has faces or the file is empty.
std::string lack_of_faces(const MeshFile& file);

/// Reads the file `path`, or standard input if `path` is "-", and returns its mesh. If `format` is
/// not given, the function finds the format in the same way as read_mesh_of(). `options.name` is
/// ignored. The bytes of the file are no longer charged to `context` when the function returns.
/// Throws the errors of read_mesh(). Also throws if the file cannot be read.
MeshFile read_mesh_file(const std::string& path, std::optional<MeshFormat> format,
                        ReadOptions options = {}, Context& context = unlimited_context());

/// Writes a mesh to a stream. Exceptions of `out` reach the caller. Throws, before the first byte
/// is written:
///   - Error{NumberOutOfRange} if a coordinate is too large for the doubles or floats of the format
///   - Error{BadIndex} if a corner of a face is not the index of a point
///   - Error{BadArgument} if lists_triangles(format) is true and a face is not a triangle
///   - Error{BadArgument} if the format is Gltf and the mesh has no faces
///   - Error{CannotWrite} if the format is Gltf and the file would have 2^32 bytes or more
///   - Error{UnknownFormat} if the format is ThreeMf or Amf and plumb is built without libzip or
///     expat
void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat format);

/// Writes a mesh with its attributes. Attributes that the format cannot represent are left out;
/// lost_attributes() names them, and docs/formats.md lists the attributes that each format
/// represents. Some attributes belong to corners of faces, but OFF and PLY store them at vertices,
/// and so does OBJ for colours. If the corners at a vertex have different values, the vertex is
/// written several times, with the same coordinates. This does not change the set that is made from
/// the file, because equal points become one vertex of the set. If the format is Obj, `library` is
/// the file name of the material library that the file refers to. The caller writes the library
/// with write_material_library(). The file refers to no library if `library` is empty. Throws the
/// errors of write_mesh(). Also throws, before the first byte is written, Error{BadArgument} if an
/// array of the attributes is neither empty nor complete.
void write_mesh(std::ostream& out, const PolygonMesh& mesh, const MeshAttributes& attributes,
                MeshFormat format, const std::string& library = {});

/// Writes the materials of a mesh as a material library of OBJ: a text in the format MTL.
void write_material_library(std::ostream& out, const MeshAttributes& attributes);

/// Returns a sentence that names the attributes that this format cannot represent. Returns an empty
/// text if the format can represent all of them. A colour of a material that is only rounded to
/// bytes does not count as lost.
std::string lost_attributes(const MeshAttributes& attributes, MeshFormat format);

/// Writes a mesh to the file `path`. If `format` is not given, the extension of `path` determines
/// the format: .off, .obj, .stl, .ply, .glb or .3mf. The bytes are first written to a temporary
/// file. The file `path` is created or replaced only after all bytes have been written. Throws:
///   - Error{UnknownFormat} if `format` is not given and the extension is none of these
///     extensions
///   - Error{CannotWrite} if the file cannot be written
///   - the errors of write_mesh()
void write_mesh_file(const std::string& path, const PolygonMesh& mesh,
                     std::optional<MeshFormat> format = {});
/// Writes a TriangleMesh to a file. The function chooses the format, replaces the file and throws
/// errors in the same way as the function above.
void write_mesh_file(const std::string& path, const TriangleMesh& mesh,
                     std::optional<MeshFormat> format = {});

/// Writes a PolygonMesh with attributes to a file, as write_mesh() does. If the format is Obj and
/// there are materials, the material library is written to a second file. Its path is `path` with
/// the extension replaced by .mtl. The function chooses the format, replaces the files and throws
/// errors in the same way as the functions above.
void write_mesh_file(const std::string& path, const PolygonMesh& mesh,
                     const MeshAttributes& attributes, std::optional<MeshFormat> format = {});

/// Returns the mesh with its coordinates rounded as write_mesh() rounds them. A reader of the
/// written file will get this mesh. A reader of STL or glTF also merges equal vertices. Throws as
/// write_mesh() does, but does not check the size of the file.
PolygonMesh as_written(PolygonMesh mesh, MeshFormat format);

}  // namespace plumb
#pragma GCC visibility pop
