// What kind of thing a file holds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plumb {

enum class FileKind : std::uint8_t {
  Map,       ///< map_reader.h
  PlaneSet,  ///< plane_io.h
  Solid,     ///< solid_sets.h: meshes and .nef
};

/// By the extension; where that names none, by how the file begins: a .nef, binary STL (by its length), JSON of glTF, other JSON
/// (GeoJSON) or .nef2, a word of WKT; two numbers on the first line are a map. All else is taken for a mesh.
FileKind kind_of_file(const std::string& path, std::string_view bytes);

}  // namespace plumb
