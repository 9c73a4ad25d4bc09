// Reads and writes PLY, text and binary of either byte order (docs/formats.md, "PLY"): vertices
// with properties x, y and z of any type, faces with a list vertex_indices (or another usual name),
// and triangle strips (element tristrips), which become triangles. Other properties and elements,
// in any order, are skipped; a note names them.
//
// Main flow of read_ply():
//  1. read_ply_header   reads what there is; claims are checked against the bytes that follow
//  2. elements          reads the elements in their order: in a text each on a line of its own, or
//                       all on one line, or each value on a line; in a binary file without gaps
//  3. pass_over_rest    notes bytes behind the last element; refuses text that may be more elements
//
// A vertex may have coordinates that are not finite if no face uses it, as scanners write them. It
// is the point 0 0 0 of the mesh. Lengths and corners may be written as any number whose value is
// whole. Lines may end with LF, CRLF or CR.
//
// Cost: O(bytes). Errors in the header and in a text are thrown with the place (file, line,
// column), in binary parts with the number of the byte: NotText, Syntax, NumberOutOfRange,
// CountMismatch, BadIndex, UnknownFormat, ResourceLimit; Cancelled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// Returns the mesh of a PLY file. Its memory stays charged to `context`.
MeshFile read_ply(std::string_view bytes, const ReadOptions& options, Context& context);

// Writes meshes as PLY, binary or text (docs/formats.md, "PLY").

/// Writes a mesh as text. read_ply() of it gives the same mesh, except that exact coordinates are
/// rounded to doubles. Both writers throw Error{NumberOutOfRange} if a vertex lies beyond the
/// largest double, and what `out` throws.
void write_ply_text(std::ostream& out, const PolygonMesh& mesh);
/// Writes a mesh in binary, little-endian.
void write_ply_binary(std::ostream& out, const PolygonMesh& mesh);

// The header of PLY: which elements a file holds, and which properties each of them has.
//
//   ply
//   format ascii|binary_little_endian|binary_big_endian 1.0
//   comment ...                              anywhere; obj_info ... as well
//   element NAME COUNT
//   property TYPE NAME
//   property list LENGTH_TYPE TYPE NAME
//   end_header
//
// A line with another first word is passed over, unless it seems to be one of these, misspelled.

/// The format of the elements.
enum class PlyFormat : std::uint8_t { Text, LittleEndian, BigEndian };

/// The types of properties, integers first.
enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

constexpr bool is_integer(PlyType type) { return type < PlyType::Float32; }
std::size_t size_of(PlyType type);

/// A property of the elements of one kind.
struct PlyProperty {
  /// What the property means for a mesh.
  enum class Role : std::uint8_t { None, X, Y, Z, Corners };

  PlyType type;
  std::optional<PlyType> length;  ///< Type of the length, for a list.
  Role role = Role::None;
};

/// A kind of element, as the header declares it.
struct PlyElement {
  enum class Kind : std::uint8_t { Vertex, Face, Strips, Other };

  Kind kind;
  std::uint32_t count;
  std::vector<PlyProperty> properties;

  /// Returns the least number of bytes that one element takes: in a text, a character and a blank
  /// or line break for each property.
  std::uint64_t least_bytes(PlyFormat format) const;
};

/// The header of a file.
struct PlyHeader {
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElement> elements;
  std::string passed_over;  ///< What no mesh holds, by its names; empty if there is nothing.

  /// Returns the number of vertices.
  std::uint32_t vertex_count() const;
};

/// Reads the header, from the first line to the end of that of end_header. A file has one element
/// of vertices, with x, y and z, and at most one of faces and one of triangle strips, each with a
/// list of vertices. Counts are compared with the bytes that follow. Throws with the place: NotText,
/// Syntax, UnknownFormat, CountMismatch.
PlyHeader read_ply_header(RecordReader& in);

}  // namespace plumb
