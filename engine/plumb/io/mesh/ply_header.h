// The header of PLY: which elements a file holds, and of which properties each of them consists.
//
//   ply
//   format ascii|binary_little_endian|binary_big_endian 1.0
//   comment ...                              anywhere; obj_info ... as well
//   element NAME COUNT
//   property TYPE NAME
//   property list LENGTH_TYPE TYPE NAME
//   end_header
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/io/text/record_reader.h"

namespace plumb {

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
