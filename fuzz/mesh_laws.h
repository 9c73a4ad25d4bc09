// What a mesh that was read from a file keeps on its way through the formats: for fuzz targets.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace plumb::fuzz {

inline bool is_same(const PolygonMesh& a, const PolygonMesh& b) {
  return a.points == b.points && a.exact == b.exact && a.face_begin == b.face_begin &&
         a.corners == b.corners;
}

inline void require_sound_points(const PolygonMesh& mesh) {
  for (const Point3& p : mesh.points) {
    for (const double value : {p.x, p.y, p.z}) {
      require(std::isfinite(value), "coordinates are finite");
      require(value != 0 || !std::signbit(value), "zeros are not negative");
    }
  }
  std::uint64_t least = 0;
  for (const auto& [vertex, exact] : mesh.exact) {
    require(vertex >= least && vertex < mesh.points.size(), "exact vertices are in order");
    least = std::uint64_t{vertex} + 1;
    const Point3 nearest{clamped_to_finite(nearest_double(exact.x)),
                         clamped_to_finite(nearest_double(exact.y)),
                         clamped_to_finite(nearest_double(exact.z))};
    require(mesh.points[vertex] == nearest, "points are the nearest doubles");
  }
}

inline void require_sound_faces(const PolygonMesh& mesh) {
  require(mesh.face_begin.front() == 0 && mesh.face_begin.back() == mesh.corners.size(),
          "faces are all corners");
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const std::uint32_t v : mesh.face(f)) {
      require(v < mesh.points.size(), "corners are vertices");
    }
  }
}

inline bool has_triangles_only(const PolygonMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() != 3) return false;
  }
  return true;
}

/// Written and read again it is what as_written() says; STL numbers vertices by their use.
inline void require_round(const PolygonMesh& mesh, MeshFormat format) {
  const bool is_stl = format == MeshFormat::Stl || format == MeshFormat::StlBinary;
  if (is_stl && !has_triangles_only(mesh)) return;
  Context context;
  try {
    PolygonMesh expected = as_written(mesh, format);
    std::ostringstream out;
    write_mesh(out, mesh, format);
    if (is_stl) weld_vertices(expected, context);
    const MeshFile copy = read_mesh(out.str(), format, {"written"}, context);
    require(is_same(copy.mesh, expected), "a mesh survives its formats");
  } catch (const Error& error) {
    require(error.code() == ErrorCode::NumberOutOfRange && format != MeshFormat::ExactOff,
            "only far coordinates cannot be written");
  }
}

/// In text with a line and a column inside the file; elsewhere with the file at least. Lines may
/// end with CR, if the first line does.
inline void require_mesh_place(const Error& error, std::string_view bytes) {
  if (error.place().line == 0 || !ends_lines_with_cr(bytes)) {
    return require_binary_place(error, bytes);
  }
  require_place(error, with_line_feeds(bytes, bytes.size()));
}

/// What a file of `bytes` bytes may be charged at most: records come in steps; "1/3 0 0" (8 bytes
/// with its line break) takes 48 + 208 + 192 + 48, and 96 while vertices are merged.
inline Limits mesh_limits_for(std::size_t bytes) {
  Limits limits;
  limits.max_memory_bytes = 80 * bytes + (std::size_t{1} << 19U);
  return limits;
}

inline std::optional<MeshFile> mesh_of(std::string_view bytes, MeshFormat format,
                                       bool exact_decimals, bool attributes) {
  Limits limits = mesh_limits_for(bytes.size());
  if (attributes) limits.max_memory_bytes *= 64;  // A corner of two bytes may have 32 numbers.
  Context context(limits);
  ReadOptions options{kFileName, exact_decimals};
  options.attributes = attributes;
  try {
    return read_mesh(bytes, format, options, context);
  } catch (const Error& error) {
    require(error.code() != ErrorCode::ResourceLimit || exact_decimals,
            "memory charged is in proportion to the input");
    require_mesh_place(error, bytes);
    return {};
  }
}

/// Every array of attributes is empty or complete, and refers to what there is.
inline void require_sound_attributes(const MeshFile& file) {
  const MeshAttributes& all = file.attributes;
  const auto require_faces = [&](const std::vector<std::uint32_t>& of_faces, std::size_t entries) {
    require(of_faces.empty() || of_faces.size() == file.mesh.face_count(), "one entry per face");
    for (const std::uint32_t entry : of_faces) {
      require(entry < entries || entry == MeshAttributes::kNone, "entries are in the list");
    }
  };
  require_faces(all.face_material, all.materials.size());
  require_faces(all.face_group, all.groups.size());
  require_faces(all.face_id, MeshAttributes::kNone);
  for (const MeshChannel& channel : all.channels) {
    require(channel.width > 0, "channels have numbers");
    require(channel.values.size() == channel.width * file.mesh.corners.size(),
            "channels have an entry per corner");
    for (const double value : channel.values) require(std::isfinite(value), "numbers are finite");
  }
}

/// Written with its attributes and read again, a mesh has the same faces and channels.
inline void require_attributes_round(const MeshFile& file, MeshFormat format) {
  if (file.mesh.face_count() == 0) return;
  Context context;
  std::ostringstream out;
  try {
    write_mesh(out, file.mesh, file.attributes, format);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::NumberOutOfRange, "only far coordinates cannot be written");
    return;
  }
  if (!lost_attributes(file.attributes, format).empty()) return;
  ReadOptions options{"written"};
  options.attributes = true;
  const MeshFile copy = read_mesh(out.str(), format, options, context);
  require_sound_attributes(copy);
  require(copy.mesh.face_begin == file.mesh.face_begin, "faces stay in order");
  if (format == MeshFormat::Ply) return;  // Names of properties may come to form one channel.
  require(copy.attributes.channels.size() == file.attributes.channels.size(), "channels stay");
}

/// A reader on arbitrary bytes: the first says how decimals are read and whether attributes are,
/// the rest is the file.
/// `formats` are those it can be written in again, the first the one it is read as.
inline void judge_mesh_reader(std::initializer_list<MeshFormat> formats, const std::uint8_t* data,
                              std::size_t size) {
  begin_input();
  if (size == 0) return;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const bool attributes = (data[0] & 2U) != 0;
  const auto file = mesh_of(bytes, *formats.begin(), (data[0] & 1U) != 0, attributes);
  if (!file) return;
  oracle_reached();
  require_sound_points(file->mesh);
  require_sound_faces(file->mesh);
  require_sound_attributes(*file);
  for (const MeshFormat format : formats) require_round(file->mesh, format);
  const bool can_hold = *formats.begin() != MeshFormat::Stl && *formats.begin() != MeshFormat::Gltf;
  if (attributes && can_hold) require_attributes_round(*file, *formats.begin());
}

}  // namespace plumb::fuzz
