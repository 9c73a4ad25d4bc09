// Attributes from the properties of PLY files.
//
// The reader hands over the values of each record in the order of the properties, so the values of
// an element are a table without gaps. After all elements have been read, neighbouring columns
// whose names belong together become one channel, and the others become channels of one number.
// Rows of faces belong to consecutive faces of the mesh, which may follow the triangles of strips;
// these have no row. Types of integers decide the scale of colours.
// Tested by tests/io/mesh_attributes_test.cpp.
#include "plumb/io/mesh/ply_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {
namespace {

constexpr std::string_view kPlyAttributes = "the attributes of the mesh";

/// Names of columns that belong together, and the name of their channel.
struct PlyNames {
  std::string_view channel;
  std::array<std::string_view, 4> names;
};

constexpr std::array<PlyNames, 10> kPlyChannels{{
    {"color", {"red", "green", "blue", "alpha"}},
    {"color", {"r", "g", "b", "a"}},
    {"color", {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}},
    {"color", {"red", "green", "blue", ""}},
    {"color", {"r", "g", "b", ""}},
    {"color", {"diffuse_red", "diffuse_green", "diffuse_blue", ""}},
    {"normal", {"nx", "ny", "nz", ""}},
    {"texcoord_0", {"s", "t", "", ""}},
    {"texcoord_0", {"u", "v", "", ""}},
    {"texcoord_0", {"texture_u", "texture_v", "", ""}},
}};

constexpr std::array<std::string_view, 9> kIdNames{"face_id",   "id",    "faceid",
                                                   "object_id", "label", "segment",
                                                   "category",  "group", "material_index"};

/// Returns the number of columns from `first` on that have the given names, or 0 if one is missing.
std::size_t count_named(const std::vector<PlyProperty>& columns, std::size_t first,
                        const std::array<std::string_view, 4>& names) {
  std::size_t count = 0;
  for (const std::string_view name : names) {
    if (name.empty()) break;
    if (first + count == columns.size() || columns[first + count].name != name) return 0;
    ++count;
  }
  return count;
}

/// Returns the number of columns from `first` on that have the names NAME_0, NAME_1 and so on, or 0
/// if the first one has a different name.
std::size_t count_numbered(const std::vector<PlyProperty>& columns, std::size_t first) {
  const std::string& name = columns[first].name;
  if (name.size() < 3 || !name.ends_with("_0")) return 0;
  const std::string base = name.substr(0, name.size() - 1);
  std::size_t count = 1;
  while (first + count < columns.size() &&
         columns[first + count].name == base + std::to_string(count)) {
    ++count;
  }
  return count;
}

/// Returns the number that represents 1 in a colour of this type, or 0 if the values decide.
double one_of(PlyType type) {
  switch (type) {
    case PlyType::UInt16:
      return 0xffff;
    case PlyType::Float32:
    case PlyType::Float64:
      return 0;
    default:
      return 0xff;
  }
}

}  // namespace

/// Columns of a table that make a channel.
struct PlyAttributes::Group {
  std::string channel;
  std::size_t first;
  std::size_t width;

  bool is_color() const { return channel == "color" && width >= 3; }
};

PlyAttributes::PlyAttributes(const PlyHeader& header, Context& context)
    : charge_(context), builder_(context) {
  for (const PlyElement& element : header.elements) {
    Table& table = element.kind == PlyElement::Kind::Vertex ? vertices_ : faces_;
    for (const PlyProperty& property : element.properties) {
      if (property.is_kept && !property.length) table.properties.push_back(property);
    }
  }
}

void PlyAttributes::push(std::vector<double>& values, double value) {
  constexpr std::size_t kLeast = 64;
  if (values.size() == values.capacity()) {
    const std::size_t capacity = std::max(2 * values.size(), kLeast);
    charge_.add((capacity - values.size()) * sizeof(double), kPlyAttributes);
    values.reserve(capacity);
  }
  if (!std::isfinite(value)) ++not_finite_;
  values.push_back(std::isfinite(value) ? value : 0);
}

void PlyAttributes::add(PlyElement::Kind kind, double value) {
  push(kind == PlyElement::Kind::Vertex ? vertices_.values : faces_.values, value);
}

void PlyAttributes::add_texture(double value) { push(textures_.values, value); }

std::vector<PlyAttributes::Group> PlyAttributes::groups_of(const Table& table, bool of_faces) {
  std::vector<Group> groups;
  const auto& columns = table.properties;
  for (std::size_t i = 0; i < columns.size(); i += groups.back().width) {
    Group group{columns[i].name, i, 1};
    for (const PlyNames& known : kPlyChannels) {
      const std::size_t width = count_named(columns, i, known.names);
      if (width <= group.width) continue;
      group = {std::string(known.channel), i, width};
    }
    const std::size_t numbered = group.width == 1 && !of_faces ? count_numbered(columns, i) : 0;
    if (numbered > 0) {
      const std::string& name = columns[i].name;
      group = {name.substr(0, name.size() - 2), i, numbered};
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Returns the values of the columns of a group, row by row. Values of colours are between 0 and 1.
std::vector<double> PlyAttributes::column(const Table& table, const Group& group) {
  std::vector<double> values;
  const std::size_t width = table.properties.size();
  values.reserve(table.rows() * group.width);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t i = 0; i < group.width; ++i) {
      values.push_back(table.values[row * width + group.first + i]);
    }
  }
  if (!group.is_color() || values.empty()) return values;
  double one = one_of(table.properties[group.first].type);
  if (one == 0) one = *std::max_element(values.begin(), values.end()) > 1 ? 0xff : 1;
  for (double& value : values) value = std::clamp(value / one, 0.0, 1.0);
  return values;
}

void PlyAttributes::give(MeshFile& file) {
  std::vector<std::string> lost;
  give_faces(file.mesh, lost);
  give_vertices(file.mesh, lost);
  if (!lost.empty()) {
    std::string note = "passed over: properties";
    for (const std::string& name : lost) note += (&name == lost.data() ? " " : ", ") + name;
    file.notes.push_back(std::move(note));
  }
  if (not_finite_ > 0) {
    file.notes.push_back("values of properties that are no finite numbers, read as 0: " +
                         std::to_string(not_finite_));
  }
  file.attributes = builder_.take(file.mesh);
}

void PlyAttributes::give_vertices(const PolygonMesh& mesh, std::vector<std::string>& lost) {
  for (const Group& group : groups_of(vertices_, false)) {
    charge_.add(vertices_.rows() * group.width * sizeof(double), kPlyAttributes);
    const bool is_added = builder_.add_of_vertices(
        group.channel, static_cast<std::uint32_t>(group.width), column(vertices_, group), mesh);
    if (!is_added) lost.push_back(group.channel + " of vertices");
  }
}

/// The list of texture coordinates has precedence over coordinates of vertices, because it contains
/// more information.
void PlyAttributes::give_faces(const PolygonMesh& mesh, std::vector<std::string>& lost) {
  if (!textures_.begins.empty()) give_textures(mesh, lost);
  bool has_id = false;
  for (const Group& group : groups_of(faces_, true)) {
    const std::string& name = faces_.properties[group.first].name;
    const PlyType type = faces_.properties[group.first].type;
    const bool is_integer = type != PlyType::Float32 && type != PlyType::Float64;
    const bool is_id = !has_id && group.width == 1 && is_integer &&
                       std::find(kIdNames.begin(), kIdNames.end(), name) != kIdNames.end();
    if (group.is_color()) {
      give_face_colors(group);
    } else if (is_id) {
      give_ids(group, lost);
      has_id = true;
    } else {
      give_constants(group, mesh, lost);
    }
  }
}

void PlyAttributes::give_face_colors(const Group& group) {
  const std::vector<double> values = column(faces_, group);
  for (std::size_t row = 0; row < faces_.rows(); ++row) {
    std::array<double, 4> color{1, 1, 1, 1};
    for (std::size_t i = 0; i < group.width; ++i) color[i] = values[row * group.width + i];
    builder_.set_material(first_face_ + row, builder_.material_of(color));
  }
}

/// An id is a number of 32 bits. A negative number means that there is none, and so does the
/// largest number of 32 bits, with which plumb writes such faces.
void PlyAttributes::give_ids(const Group& group, std::vector<std::string>& lost) {
  bool has_negative = false, has_large = false;
  const std::vector<double> values = column(faces_, group);
  for (std::size_t row = 0; row < faces_.rows(); ++row) {
    has_negative |= values[row] < -1;
    has_large |= values[row] > MeshAttributes::kNone;
    const bool is_id = values[row] >= 0 && values[row] < MeshAttributes::kNone;
    builder_.set_id(first_face_ + row,
                    is_id ? static_cast<std::uint32_t>(values[row]) : MeshAttributes::kNone);
  }
  if (has_negative) lost.push_back("negative numbers of " + group.channel);
  if (has_large) lost.push_back("numbers of more than 32 bits of " + group.channel);
}

void PlyAttributes::give_constants(const Group& group, const PolygonMesh& mesh,
                                   std::vector<std::string>& lost) {
  const std::vector<double> values = column(faces_, group);
  const std::size_t width = group.width;
  charge_.add((mesh.corners.size() + faces_.rows()) * width * sizeof(double), kPlyAttributes);
  std::vector<double> of_corners(mesh.corners.size() * width);
  for (std::size_t row = 0; row < faces_.rows(); ++row) {
    const std::size_t face = first_face_ + row;
    for (std::size_t c = mesh.face_begin[face]; c < mesh.face_begin[face + 1]; ++c) {
      for (std::size_t i = 0; i < width; ++i) of_corners[c * width + i] = values[row * width + i];
    }
  }
  const bool is_added = builder_.add_of_corners(group.channel, static_cast<std::uint32_t>(width),
                                                std::move(of_corners), mesh);
  if (!is_added) lost.push_back(group.channel + " of faces");
}

/// A list that does not have two numbers for each corner is skipped.
void PlyAttributes::give_textures(const PolygonMesh& mesh, std::vector<std::string>& lost) {
  charge_.add(mesh.corners.size() * 2 * sizeof(double), kPlyAttributes);
  std::vector<double> of_corners(mesh.corners.size() * 2);
  std::size_t others = 0;
  for (std::size_t row = 0; row < textures_.begins.size(); ++row) {
    const std::size_t face = first_face_ + row;
    const std::size_t begin = textures_.begins[row];
    const std::size_t end =
        row + 1 < textures_.begins.size() ? textures_.begins[row + 1] : textures_.values.size();
    if (end - begin == 2 * mesh.face(face).size()) {
      std::copy(textures_.values.begin() + static_cast<std::ptrdiff_t>(begin),
                textures_.values.begin() + static_cast<std::ptrdiff_t>(end),
                of_corners.begin() + 2 * static_cast<std::ptrdiff_t>(mesh.face_begin[face]));
    } else if (end > begin) {
      ++others;
    }
  }
  if (others > 0) lost.push_back("texcoord of faces with another number of corners");
  builder_.add_of_corners("texcoord_0", 2, std::move(of_corners), mesh);
}

}  // namespace plumb
