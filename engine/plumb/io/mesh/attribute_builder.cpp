// Makes complete arrays of attributes from the lists in files.
//
// All numbers are doubles and are only copied, divided by 255, or filled in, so an attribute never
// changes the geometry. A number that is not finite becomes 0. Memory is charged before it is
// allocated and stays charged while the file is read. The number of numbers per corner is limited,
// because a corner takes two bytes in a text and each of its numbers eight bytes in memory.
// Tested by tests/io/mesh_attributes_test.cpp.
#include "plumb/io/mesh/attribute_builder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "plumb/io/text/double_text.h"

namespace plumb {
namespace {

constexpr double kByteColor = 255;
constexpr std::uint64_t kNameBytes = 256;  // A material or a group, with its entry in a map.
constexpr std::string_view kAttributes = "the attributes of the mesh";

}  // namespace

AttributeNumber attribute_number(std::string_view token) {
  if (!token.empty() && token.front() == '+') token.remove_prefix(1);
  AttributeNumber number;
  double value = 0;
  const char* const end = token.data() + token.size();
  const auto [rest, code] = double_from_chars(token.data(), end, value);
  number.is_whole = token.find_first_not_of("-0123456789") == token.npos;
  number.is_finite = code == std::errc() && rest == end && std::isfinite(value);
  if (number.is_finite) number.value = value;
  return number;
}

ColorScale::ColorScale(const std::vector<StatedColor>& colors) {
  for (const StatedColor& color : colors) {
    if (color.count < 3) continue;
    is_of_bytes_ |= *std::max_element(color.parts.begin(), color.parts.end()) > 1;
  }
}

std::array<double, 4> ColorScale::operator()(const StatedColor& color) const {
  const bool is_above = *std::max_element(color.parts.begin(), color.parts.end()) > 1;
  const double divisor = is_of_bytes_ && (color.is_whole || is_above) ? kByteColor : 1;
  std::array<double, 4> scaled{1, 1, 1, 1};
  for (std::size_t i = 0; i < color.count; ++i) {
    scaled[i] = std::clamp(color.parts[i] / divisor, 0.0, 1.0);
  }
  return scaled;
}

std::uint32_t AttributeBuilder::add_material(MeshMaterial material) {
  charge_.add(kNameBytes + 2 * material.name.size(), kAttributes);
  all_.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(all_.materials.size() - 1);
}

std::uint32_t AttributeBuilder::material_of(const std::array<double, 4>& color) {
  const auto known = of_color_.find(color);
  if (known != of_color_.end()) return known->second;
  return of_color_[color] = add_material({{}, color, {}});
}

std::uint32_t AttributeBuilder::material_named(std::string_view name) {
  const auto known = of_name_.find(name);
  if (known != of_name_.end()) return known->second;
  return of_name_[std::string(name)] = add_material({std::string(name), {}, {}});
}

std::uint32_t AttributeBuilder::group_named(std::string_view name) {
  const auto known = group_of_name_.find(name);
  if (known != group_of_name_.end()) return known->second;
  charge_.add(kNameBytes + 2 * name.size(), kAttributes);
  all_.groups.emplace_back(name);
  return group_of_name_[std::string(name)] = static_cast<std::uint32_t>(all_.groups.size() - 1);
}

void AttributeBuilder::set(std::vector<std::uint32_t>& of_faces, std::size_t face,
                           std::uint32_t value) {
  if (face >= of_faces.size()) {
    if (face >= of_faces.capacity()) {
      const std::size_t capacity = std::max(2 * face, std::size_t{64});
      charge_.add((capacity - of_faces.capacity()) * sizeof(std::uint32_t), kAttributes);
      of_faces.reserve(capacity);
    }
    of_faces.resize(face + 1, MeshAttributes::kNone);
  }
  of_faces[face] = value;
}

bool AttributeBuilder::has_room(std::string_view name, std::uint32_t width) const {
  std::size_t numbers = width;
  for (const MeshChannel& channel : all_.channels) {
    if (channel.name == name) return false;
    numbers += channel.width;
  }
  return numbers <= kMostNumbersOfCorner;
}

bool AttributeBuilder::add_of_vertices(std::string name, std::uint32_t width,
                                       const std::vector<double>& values, const PolygonMesh& mesh) {
  if (!has_room(name, width)) return false;
  constexpr std::size_t kCornersPerCheckpoint = 4096;
  charge_.add(mesh.corners.size() * width * sizeof(double), kAttributes);
  std::vector<double> of_corners;
  of_corners.reserve(mesh.corners.size() * width);
  const double gap = name == "color" ? 1 : 0;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    if (c % kCornersPerCheckpoint == 0) context_.checkpoint("read", c, mesh.corners.size());
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t at = std::size_t{mesh.corners[c]} * width + i;
      of_corners.push_back(at < values.size() ? values[at] : gap);
    }
  }
  all_.channels.push_back({std::move(name), width, std::move(of_corners)});
  return true;
}

bool AttributeBuilder::add_of_corners(std::string name, std::uint32_t width,
                                      std::vector<double> values, const PolygonMesh& mesh) {
  if (!has_room(name, width)) return false;
  charge_.add(mesh.corners.size() * width * sizeof(double), kAttributes);
  values.resize(mesh.corners.size() * width, name == "color" ? 1 : 0);
  all_.channels.push_back({std::move(name), width, std::move(values)});
  return true;
}

MeshAttributes AttributeBuilder::take(const PolygonMesh& mesh) {
  for (auto* of_faces : {&all_.face_material, &all_.face_group, &all_.face_id}) {
    if (of_faces->empty()) continue;
    charge_.add(mesh.face_count() * sizeof(std::uint32_t), kAttributes);
    of_faces->resize(mesh.face_count(), MeshAttributes::kNone);
  }
  if (all_.face_material.empty()) all_.materials.clear();
  if (all_.face_group.empty()) all_.groups.clear();
  return std::move(all_);
}

}  // namespace plumb
