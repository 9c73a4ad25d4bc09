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
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/io/text/record_reader.h"

namespace plumb {

/// The format of the elements.
enum class PlyFormat : std::uint8_t { Text, LittleEndian, BigEndian };

/// The types of properties.
enum class PlyType : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64,
  Int64,
  UInt64
};

/// Returns the size of a value in a binary file, in bytes.
std::size_t size_of(PlyType type);

/// A property of the elements of one kind.
struct PlyProperty {
  /// The meaning of the property for a mesh.
  enum class Role : std::uint8_t { None, X, Y, Z, Corners };

  PlyType type;
  std::optional<PlyType> length;  ///< Type of the length, for a list.
  Role role = Role::None;
  std::string name = {};
  bool is_kept = false;  ///< Whether its values are attributes of the mesh.
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
  std::string passed_over;  ///< The names of parts that a mesh cannot represent; may be empty.
  std::string left_out;     ///< Geometry that is not read, by its names.

  /// Returns the number of vertices.
  std::uint32_t vertex_count() const;
};

/// Reads the header, from the first line to the end of the line `end_header`. A file has one
/// element of vertices, with x, y and z, and at most one of faces and one of triangle strips, each
/// with a list of vertices. Counts are compared with the bytes that follow. Throws with the place:
/// NotText, Syntax, UnknownFormat, CountMismatch. If `keeps_attributes` is true, scalar properties
/// of vertices and faces and the texture coordinates of faces are kept, up to a number of
/// properties.
PlyHeader read_ply_header(RecordReader& in, bool keeps_attributes = false);

}  // namespace plumb
