// Reads PLY, text and binary of either byte order (docs/formats.md, "PLY"): vertices with
// properties x, y and z of any type, faces with a list vertex_indices (or vertex_index); other
// properties and elements, in any order, are passed over and told.
//
//  1. read_ply_header   what there is (ply.h); claims are checked against the bytes that
//                       follow
//  2. the elements in their order: in a text each on a line of its own; in a binary file without
//     gaps
//  3. nothing may follow the last one
//
// Cost: O(bytes). Errors in the header and in a text are thrown with the place (file, line,
// column), in binary parts with the number of the byte: NotText, Syntax, NumberOutOfRange,
// CountMismatch, BadIndex, DegenerateFace (fewer than three corners, a vertex twice in a row),
// UnknownFormat, ResourceLimit; Cancelled.
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

/// The memory of the mesh stays charged to `context`.
MeshFile read_ply(std::string_view bytes, const ReadOptions& options, Context& context);

// Writes meshes as PLY, binary or text (docs/formats.md, "PLY").

/// read_ply() of what is written gives the same mesh, but for what `exact` holds: vertices are
/// rounded to doubles. Both throw Error{NumberOutOfRange} when one lies beyond the largest double;
/// what `out` throws.
void write_ply_text(std::ostream& out, const PolygonMesh& mesh);
/// Little-endian.
void write_ply_binary(std::ostream& out, const PolygonMesh& mesh);

// The header of PLY: which elements a file holds, and of which properties each of them consists.
//
//   ply
//   format ascii|binary_little_endian|binary_big_endian 1.0
//   comment ...                              anywhere; obj_info ... as well
//   element NAME COUNT
//   property TYPE NAME
//   property list LENGTH_TYPE TYPE NAME
//   end_header

enum class PlyFormat : std::uint8_t { Text, LittleEndian, BigEndian };

/// Integers first.
enum class PlyType : std::uint8_t { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

constexpr bool is_integer(PlyType type) { return type < PlyType::Float32; }
std::size_t size_of(PlyType type);

struct PlyProperty {
  /// What of a mesh it is.
  enum class Role : std::uint8_t { None, X, Y, Z, Corners };

  PlyType type;
  std::optional<PlyType> length;  ///< of a list
  Role role = Role::None;
};

struct PlyElement {
  enum class Kind : std::uint8_t { Vertex, Face, Other };

  Kind kind;
  std::uint32_t count;
  std::vector<PlyProperty> properties;

  /// The least bytes that one of them takes: in a text, a character and a blank or line break for
  /// each property.
  std::uint64_t least_bytes(PlyFormat format) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElement> elements;

  /// Of the vertices.
  std::uint32_t vertex_count() const;
};

/// From the first line on to the end of that of end_header. A file has one element of vertices,
/// with x, y and z, and at most one of faces, with a list vertex_indices or vertex_index. Counts
/// are held against the bytes that follow. Errors with their place: NotText, Syntax, UnknownFormat,
/// CountMismatch.
PlyHeader read_ply_header(RecordReader& in);

}  // namespace plumb
