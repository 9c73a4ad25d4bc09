// Looks of faces in 3MF.
//
// Reading: entries of groups become materials when a face of the result uses them first, so that a
// library of thousands of unused colours costs nothing. Equal colours without a name are one
// material. A face whose corners have different entries gets the channel "color", in which all
// other corners are white; this fits the rule of glTF that a colour of a vertex multiplies the
// colour of the material.
//
// Writing: a named material becomes a base material, any other colour an entry of the group of
// colours. Colours of corners are multiplied by the colour of the material. Colours are bytes in
// 3MF. Names lose characters that XML does not allow.
//
// Format: 3MF Consortium, Core Specification 1.3 and Materials and Properties Extension; Triangle
// Sets Extension. Tested by tests/io/threemf_test.cpp.
#include "plumb/io/mesh/threemf_looks.h"

#include <algorithm>
#include <cmath>

#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/text/input_cursors.h"

namespace plumb {
namespace {

constexpr std::uint32_t kMaterialGroup = 2, kColorGroup = 3;  // The number of the object is 1.
constexpr std::uint32_t kWhite = 0xffffffff;

std::optional<std::uint32_t> hex_value(std::string_view digits) {
  std::uint32_t value = 0;
  for (const char c : digits) {
    const bool is_digit = '0' <= c && c <= '9';
    const char small = static_cast<char>(c | 0x20);
    if (!is_digit && !('a' <= small && small <= 'f')) return {};
    value = value << 4U | static_cast<std::uint32_t>(is_digit ? c - '0' : small - 'a' + 10);
  }
  return value;
}

/// Returns a colour as 0xRRGGBBAA.
std::uint32_t packed(const std::array<double, 4>& color) {
  std::uint32_t value = 0;
  for (const double part : color) {
    value = value << 8U | static_cast<std::uint32_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255));
  }
  return value;
}

void put_color(TextOutput& out, std::uint32_t color) {
  static constexpr std::string_view kDigits = "0123456789ABCDEF";
  out << '#';
  const unsigned digits = (color & 0xffU) == 0xffU ? 6 : 8;  // An opaque colour needs no opacity.
  for (unsigned i = 0; i < digits; ++i) out << kDigits[color >> (28 - 4 * i) & 0xfU];
}

/// Writes a text as the value of an attribute. Characters that XML does not allow become `_`.
void put_text(TextOutput& out, std::string_view text) {
  while (!text.empty()) {
    const std::size_t valid = text_prefix(text);
    for (const char c : text.substr(0, valid)) {
      if (c == '&') {
        out << "&amp;";
      } else if (c == '<') {
        out << "&lt;";
      } else if (c == '"') {
        out << "&quot;";
      } else {
        out << (static_cast<unsigned char>(c) < ' ' ? '_' : c);
      }
    }
    if (valid < text.size()) out << '_';
    text.remove_prefix(std::min(valid + 1, text.size()));
  }
}

}  // namespace

std::optional<std::array<double, 4>> threemf_color(std::string_view text) {
  if (text.size() != 7 && text.size() != 9) return {};
  if (text.front() != '#') return {};
  const auto value = hex_value(text.substr(1));
  if (!value) return {};
  const std::uint32_t all = text.size() == 9 ? *value : *value << 8U | 0xffU;
  const auto part = [&](unsigned shift) { return (all >> shift & 0xffU) / 255.0; };
  return std::array<double, 4>{part(24), part(16), part(8), part(0)};
}

// ---------------------------------------------------------------- reading

std::uint32_t ThreeMfPainter::material_of(std::uint32_t entry) {
  const auto known = material_.find(entry);
  if (known != material_.end()) return known->second;
  constexpr std::uint64_t kEntryBytes = 64;
  charge_.add(kEntryBytes, "the materials of the file");
  const ThreeMfEntry& from = looks_.entries[entry];
  std::uint32_t material = 0;
  if (from.name.empty() && from.color) {
    material = builder_.material_of(*from.color);
  } else {
    material = builder_.add_material({from.name, from.color, {}});
  }
  material_.emplace(entry, material);
  return material;
}

void ThreeMfPainter::add_face(std::uint32_t source, std::uint32_t object_name, bool turns) {
  const std::uint32_t face = faces_++;
  const ThreeMfLook look = source < looks_.faces.size() ? looks_.faces[source] : ThreeMfLook();
  const std::uint32_t name = look.name == ThreeMfLook::kNone ? object_name : look.name;
  if (name != ThreeMfLook::kNone) {
    builder_.set_group(face, builder_.group_named(looks_.names[name]));
  }
  const auto [a, b, c] = look.entry;
  if (a == ThreeMfLook::kNone) return;
  if (a == b && b == c) return builder_.set_material(face, material_of(a));
  const std::size_t end = 12 * (std::size_t{face} + 1);
  if (end > corner_colors_.capacity()) {
    charge_.add(2 * end * sizeof(double), "the colours of the file");
    corner_colors_.reserve(2 * end);
  }
  corner_colors_.resize(end, 1);
  const std::array<std::uint32_t, 3> placed{a, turns ? c : b, turns ? b : c};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto color = looks_.entries[placed[i]].color.value_or(std::array<double, 4>{1, 1, 1, 1});
    std::copy(color.begin(), color.end(),
              corner_colors_.end() - 12 + static_cast<std::ptrdiff_t>(4 * i));
  }
}

MeshAttributes ThreeMfPainter::take(const PolygonMesh& mesh) {
  if (!corner_colors_.empty()) {
    static_cast<void>(builder_.add_of_corners("color", 4, std::move(corner_colors_), mesh));
  }
  return builder_.take(mesh);
}

// ---------------------------------------------------------------- writing

ThreeMfResources::ThreeMfResources(const PolygonMesh& mesh, const MeshAttributes& attributes)
    : attributes_(attributes), channel_(channel_of(attributes, "color", 3, 4)) {
  const bool has_looks = !attributes.face_material.empty() || channel_ != nullptr;
  const auto faces = static_cast<std::uint32_t>(mesh.face_count());
  for (std::uint32_t f = 0; has_looks && f < faces; ++f) properties_.push_back(property_of(f));
  find_names();
}

/// If all faces have the same name, it is the name of the object. Otherwise, each name is a set of
/// triangles.
void ThreeMfResources::find_names() {
  const std::vector<std::uint32_t>& group = attributes_.face_group;
  if (group.empty()) return;
  const bool is_one =
      std::all_of(group.begin(), group.end(), [&](std::uint32_t g) { return g == group.front(); });
  if (is_one && group.front() != kNone) {
    name_ = attributes_.groups[group.front()];
    return;
  }
  std::vector<std::uint32_t> set_of(attributes_.groups.size(), kNone);
  for (std::uint32_t f = 0; f < group.size(); ++f) {
    if (group[f] == kNone) continue;
    std::uint32_t& set = set_of[group[f]];
    if (set == kNone) {
      set = static_cast<std::uint32_t>(sets_.size());
      sets_.push_back({attributes_.groups[group[f]], {}});
    }
    sets_[set].second.push_back(f);
  }
}

ThreeMfResources::Property ThreeMfResources::property_of(std::uint32_t face) {
  const std::uint32_t material =
      attributes_.face_material.empty() ? kNone : attributes_.face_material[face];
  std::array<double, 4> base{1, 1, 1, 1};
  const MeshMaterial* const from = material == kNone ? nullptr : &attributes_.materials[material];
  if (from != nullptr && from->color) base = *from->color;
  std::array<std::array<double, 4>, 3> corner{base, base, base};
  bool has_corners = false;  // Whether a corner has a colour other than white.
  for (std::uint32_t i = 0; channel_ != nullptr && i < 3; ++i) {
    const auto values = values_at(*channel_, 3 * face + i);
    for (std::size_t k = 0; k < values.size(); ++k) {
      corner[i][k] *= values[k];
      has_corners = has_corners || values[k] != 1;
    }
  }
  if (from != nullptr && !has_corners && !from->name.empty()) {
    const std::uint32_t number = number_of_material(material);
    return {kMaterialGroup, {number, number, number}};
  }
  const bool has_color = channel_ != nullptr || (from != nullptr && from->color);
  if (!has_color) return {};
  return {kColorGroup,
          {number_of_color(corner[0]), number_of_color(corner[1]), number_of_color(corner[2])}};
}

std::uint32_t ThreeMfResources::number_of_material(std::uint32_t material) {
  const auto next = static_cast<std::uint32_t>(materials_.size());
  const auto [at, is_new] = material_number_.try_emplace(material, next);
  if (is_new) materials_.push_back(material);
  return at->second;
}

std::uint32_t ThreeMfResources::number_of_color(const std::array<double, 4>& color) {
  const std::uint32_t value = packed(color);
  const auto next = static_cast<std::uint32_t>(colors_.size());
  const auto [at, is_new] = color_number_.try_emplace(value, next);
  if (is_new) colors_.push_back(value);
  return at->second;
}

void ThreeMfResources::write_groups(TextOutput& out) const {
  if (!materials_.empty()) {
    out << "<basematerials id=\"" << kMaterialGroup << "\">\n";
    for (const std::uint32_t m : materials_) {
      const MeshMaterial& material = attributes_.materials[m];
      out << "<base name=\"";
      put_text(out, material.name);
      out << "\" displaycolor=\"";
      put_color(out, material.color ? packed(*material.color) : kWhite);
      out << "\"/>\n";
    }
    out << "</basematerials>\n";
  }
  if (colors_.empty()) return;
  out << "<m:colorgroup id=\"" << kColorGroup << "\">\n";
  for (const std::uint32_t color : colors_) {
    out << "<m:color color=\"";
    put_color(out, color);
    out << "\"/>\n";
  }
  out << "</m:colorgroup>\n";
}

/// If all triangles have a look, the object gets the look of the first triangle, because some
/// programs require it.
void ThreeMfResources::write_object(TextOutput& out) const {
  if (!name_.empty()) {
    out << " name=\"";
    put_text(out, name_);
    out << '"';
  }
  const bool have_all =
      !properties_.empty() && std::all_of(properties_.begin(), properties_.end(),
                                          [](const Property& p) { return p.group != kNone; });
  if (!have_all) return;
  const Property& first = properties_.front();
  out << " pid=\"" << first.group << "\" pindex=\"" << first.entry[0] << '"';
}

void ThreeMfResources::write_triangle(TextOutput& out, std::uint32_t face) const {
  if (properties_.empty() || properties_[face].group == kNone) return;
  const auto& [group, entry] = properties_[face];
  out << " pid=\"" << group << "\" p1=\"" << entry[0] << '"';
  if (entry[1] == entry[0] && entry[2] == entry[0]) return;
  out << " p2=\"" << entry[1] << "\" p3=\"" << entry[2] << '"';
}

void ThreeMfResources::write_sets(TextOutput& out) const {
  if (sets_.empty()) return;
  out << "<t:trianglesets>\n";
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    const auto& [name, faces] = sets_[i];
    out << "<t:triangleset name=\"";
    put_text(out, name);
    out << "\" identifier=\"set" << std::uint64_t{i} << "\">\n";
    for (std::size_t f = 0; f < faces.size();) {
      std::size_t end = f + 1;
      while (end < faces.size() && faces[end] == faces[end - 1] + 1) ++end;
      if (end == f + 1) {
        out << "<t:ref index=\"" << faces[f] << "\"/>\n";
      } else {
        out << "<t:refrange startindex=\"" << faces[f] << "\" endindex=\"" << faces[end - 1]
            << "\"/>\n";
      }
      f = end;
    }
    out << "</t:triangleset>\n";
  }
  out << "</t:trianglesets>\n";
}

}  // namespace plumb
