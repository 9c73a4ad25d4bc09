// Attributes of a mesh: the data that a mesh can have in addition to its points and faces. These
// data are numbers at corners (such as colours), materials, groups and ids.
//
// All arrays are flat and belong to one mesh. Each array is either empty or complete. A complete
// array has an entry for each face, or `width` entries for each corner, in the order of the arrays
// of the mesh.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// A channel assigns a few numbers to each corner of each face, for example two texture
/// coordinates. The values at other points of a face are computed by linear interpolation from the
/// corners of the triangle that contains the point.
struct MeshChannel {
  /// The name of the channel. Readers and writers of files use the following names, with the given
  /// widths: "color" (3 or 4 numbers from 0 to 1), "normal" (3), "texcoord_0", "texcoord_1", ...
  /// (2).
  std::string name;
  std::uint32_t width = 1;  ///< The number of values at each corner.
  /// The numbers of corner c are values[c * width], ..., values[c * width + width - 1]. Corners are
  /// numbered as in PolygonMesh::corners.
  std::vector<double> values;
};

/// A material that faces refer to.
struct MeshMaterial {
  /// The name of the material in the file. Can be empty.
  std::string name;
  std::optional<std::array<double, 4>> color;  ///< Red, green, blue and opacity, from 0 to 1.
  std::string texture;  ///< The name of the texture file, as the input states it. Can be empty.
};

/// The attributes of a mesh. A default-constructed object holds no attributes.
struct MeshAttributes {
  /// The index of a face without a material or without a group.
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<MeshChannel> channels;         ///< Numbers at corners.
  std::vector<MeshMaterial> materials;       ///< The materials that faces refer to.
  std::vector<std::uint32_t> face_material;  ///< The material of each face, or kNone.
  std::vector<std::string> groups;           ///< Names of the groups that faces refer to.
  std::vector<std::uint32_t> face_group;     ///< The group of each face, or kNone.
  std::vector<std::uint32_t> face_id;        ///< The id of each face, which the user chose.

  /// Whether there are no attributes.
  [[nodiscard]] bool empty() const {
    return channels.empty() && face_material.empty() && face_group.empty() && face_id.empty();
  }
};

}  // namespace plumb
#pragma GCC visibility pop
