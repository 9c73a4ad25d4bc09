// Collects the attributes that a mesh file lists, and makes complete arrays of them.
//
// Files list numbers per vertex, per corner or per face, and some of their records lack them.
// MeshAttributes has numbers per corner, and each of its arrays is complete. What is missing is
// white and opaque for colours, 0 for all other numbers, and MeshAttributes::kNone for faces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// How many numbers per corner are kept of a file. Further channels are passed over, so that the
/// memory of a mesh is in proportion to its file.
inline constexpr std::size_t kMostNumbersOfCorner = 32;

/// A number that belongs to a vertex or a face.
struct AttributeNumber {
  double value = 0;
  bool is_whole = false;   ///< Whether it is written without a decimal point and an exponent.
  bool is_finite = false;  ///< Whether the token is a finite number. The value is 0 otherwise.
};

/// Returns the number that a token states.
AttributeNumber attribute_number(std::string_view token);

/// A colour as a file states it: up to four numbers, in a scale that depends on the whole file.
struct StatedColor {
  std::array<double, 4> parts{};
  std::uint8_t count = 0;
  bool is_whole = true;  ///< Whether all numbers are written as integers.

  /// Appends a number. Requires count < 4.
  void add(double value, bool whole) {
    parts[count++] = value;
    is_whole = is_whole && whole;
  }
};

/// Returns the factor that maps the numbers of colours to the range from 0 to 1: 1/255 if one of
/// them is larger than 1, otherwise 1. A colour that is not written in integers and has no number
/// above 1 has the factor 1 in any case.
class ColorScale {
 public:
  /// Finds the scale of all colours of a file with three or four numbers.
  explicit ColorScale(const std::vector<StatedColor>& colors);
  /// Returns red, green, blue and opacity from 0 to 1. Requires three or four numbers.
  std::array<double, 4> operator()(const StatedColor& color) const;

 private:
  bool is_of_bytes_ = false;
};

/// Collects materials, groups and channels.
class AttributeBuilder {
 public:
  explicit AttributeBuilder(Context& context) : charge_(context), context_(context) {}

  /// Returns the material that has this colour and no name.
  std::uint32_t material_of(const std::array<double, 4>& color);
  /// Appends a material, even if there is an equal one, and returns it.
  std::uint32_t add_material(MeshMaterial material);
  /// Returns the material with this name.
  std::uint32_t material_named(std::string_view name);
  /// Returns the material with this name if it has been asked for before.
  std::optional<std::uint32_t> known_material(std::string_view name) const {
    const auto known = of_name_.find(name);
    return known == of_name_.end() ? std::nullopt : std::optional(known->second);
  }
  /// Returns the group with this name.
  std::uint32_t group_named(std::string_view name);
  /// Returns a material that one of the functions above has returned.
  MeshMaterial& material(std::uint32_t index) { return all_.materials[index]; }
  /// Returns the number of materials.
  std::size_t material_count() const { return all_.materials.size(); }

  /// Sets the material, the group or the id of a face.
  void set_material(std::size_t face, std::uint32_t material) {
    set(all_.face_material, face, material);
  }
  void set_group(std::size_t face, std::uint32_t group) { set(all_.face_group, face, group); }
  void set_id(std::size_t face, std::uint32_t id) { set(all_.face_id, face, id); }

  /// Adds a channel whose values are given per vertex: `width` numbers for each one, with gaps at
  /// the end. Returns false, and adds nothing, if there are too many numbers per corner or if there
  /// is a channel of this name.
  bool add_of_vertices(std::string name, std::uint32_t width, const std::vector<double>& values,
                       const PolygonMesh& mesh);
  /// Adds a channel of values per corner. Gaps at the end are filled. Returns false as above.
  bool add_of_corners(std::string name, std::uint32_t width, std::vector<double> values,
                      const PolygonMesh& mesh);

  /// Returns the attributes of the mesh, with complete arrays.
  MeshAttributes take(const PolygonMesh& mesh);

 private:
  void set(std::vector<std::uint32_t>& of_faces, std::size_t face, std::uint32_t value);
  bool has_room(std::string_view name, std::uint32_t width) const;

  MemoryCharge charge_;
  Context& context_;
  MeshAttributes all_;
  std::map<std::array<double, 4>, std::uint32_t> of_color_;
  std::map<std::string, std::uint32_t, std::less<>> of_name_, group_of_name_;
};

}  // namespace plumb
