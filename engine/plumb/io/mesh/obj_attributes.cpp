// Reading and writing of the attributes of OBJ.
//
// The numbers of vt and vn are counted like vertices: from 1, or backwards from the latest of them.
// They may follow the face that names them, so corners keep numbers until the whole file has been
// read; a number that the file does not have is noted, and the values are 0. A material library is
// a second file with statements of the same form. It only decides how faces look. So if a library
// cannot be read, this is a note and not an error, and the statements of a library are not checked.
// Names are all that follows the keyword on its line, up to a comment. Blender and Maya write the
// material "(null)" for none; the specification calls the group of faces without a group "default".
// Tested by tests/io/mesh_attributes_test.cpp.
#include "plumb/io/mesh/obj_attributes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::string_view kObjAttributes = "the attributes of the mesh";
constexpr std::string_view kNoMaterial = "(null)";
constexpr std::string_view kNoGroup = "default";
constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Returns the first word of a line, and removes it from the line.
std::string_view take_first(std::string_view& line) {
  line = trimmed(line);
  const std::string_view word = line.substr(0, line.find_first_of(kBlanks));
  line = trimmed(line.substr(word.size()));
  return word;
}

/// Returns the name of a texture from the arguments of map_Kd. If options precede the name, it is
/// the last word.
std::string_view texture_name(std::string_view arguments) {
  if (!arguments.starts_with('-')) return arguments;
  return arguments.substr(arguments.find_last_of(kBlanks) + 1);
}

}  // namespace

template <class Value>
void ObjAttributes::push(std::vector<Value>& values, Value value) {
  constexpr std::size_t kLeast = 64;
  if (values.size() == values.capacity()) {
    const std::size_t capacity = std::max(2 * values.size(), kLeast);
    charge_.add((capacity - values.size()) * sizeof(Value), kObjAttributes);
    values.reserve(capacity);
  }
  values.push_back(std::move(value));
}

void ObjAttributes::add(List& list, std::size_t width,
                        const std::vector<AttributeNumber>& numbers) {
  if (!is_wanted_) return;
  for (std::size_t i = 0; i < width; ++i) {
    const bool is_given = i < numbers.size();
    if (is_given && !numbers[i].is_finite) ++not_finite_;
    push(list.values, is_given ? numbers[i].value : 0.0);
  }
}

/// Three numbers are a colour, and four numbers a weight and a colour.
void ObjAttributes::add_vertex(const std::vector<AttributeNumber>& numbers) {
  if (!is_wanted_) return;
  StatedColor color;
  if (numbers.size() == 3 || numbers.size() == 4) {
    for (std::size_t i = numbers.size() - 3; i < numbers.size(); ++i) {
      if (!numbers[i].is_finite) ++not_finite_;
      color.add(numbers[i].value, numbers[i].is_whole);
    }
    has_colors_ = true;
  }
  push(colors_, color);
}

/// Stores the number of a vt or vn, counted from 0. An empty text refers to none.
void ObjAttributes::add_reference(List& list, std::size_t width, std::string_view text) {
  std::uint32_t index = MeshAttributes::kNone;
  std::int64_t value = 0;
  const auto [rest, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (!text.empty()) {
    const auto count = static_cast<std::int64_t>(list.values.size() / width);
    const std::int64_t from_zero = value < 0 ? count + value : value - 1;
    const bool is_known = code == std::errc() && value != 0 && from_zero >= 0 &&
                          from_zero < std::int64_t{MeshAttributes::kNone};
    if (is_known) index = static_cast<std::uint32_t>(from_zero);
    if (!is_known) ++unknown_;
    list.has_corner = true;
  }
  push(list.of_corner, index);
}

void ObjAttributes::add_corner(std::string_view corner) {
  if (!is_wanted_) return;
  const std::size_t first = std::min(corner.find('/'), corner.size());
  const std::string_view rest = corner.substr(std::min(first + 1, corner.size()));
  const std::size_t second = std::min(rest.find('/'), rest.size());
  add_reference(textures_, 2, rest.substr(0, second));
  add_reference(normals_, 3, rest.substr(std::min(second + 1, rest.size())));
}

void ObjAttributes::end_face(std::size_t face) {
  if (!is_wanted_) return;
  if (material_ != MeshAttributes::kNone) builder_.set_material(face, material_);
  if (group_ != MeshAttributes::kNone) builder_.set_group(face, group_);
}

void ObjAttributes::use_material(std::string_view name) {
  if (!is_wanted_) return;
  const std::string_view word = trimmed(name);
  const bool is_none = word.empty() || word == kNoMaterial;
  material_ = is_none ? MeshAttributes::kNone : builder_.material_named(word);
}

void ObjAttributes::use_group(std::string_view name) {
  if (!is_wanted_) return;
  const std::string_view word = trimmed(name);
  const bool is_none = word.empty() || word == kNoGroup;
  group_ = is_none ? MeshAttributes::kNone : builder_.group_named(word);
}

void ObjAttributes::use_library(std::string_view name) {
  constexpr std::size_t kMostLibraries = 64;
  if (!is_wanted_ || libraries_.size() == kMostLibraries) return;
  const std::string word(trimmed(name));
  const bool is_known = std::find(libraries_.begin(), libraries_.end(), word) != libraries_.end();
  if (!word.empty() && !is_known) push(libraries_, word);
}

void ObjAttributes::give(MeshFile& file) {
  if (!is_wanted_) return;
  load_libraries(file.notes);
  give_list("texcoord_0", 2, textures_, file.mesh);
  give_list("normal", 3, normals_, file.mesh);
  give_colors(file.mesh);
  if (unknown_ > 0) {
    file.notes.push_back("corners that name a vt or vn that there is not, which are read as 0: " +
                         std::to_string(unknown_));
  }
  if (not_finite_ > 0) {
    file.notes.push_back("numbers of vt, vn or colours that are not finite, read as 0: " +
                         std::to_string(not_finite_));
  }
  file.attributes = builder_.take(file.mesh);
}

void ObjAttributes::give_list(const char* name, std::size_t width, List& list,
                              const PolygonMesh& mesh) {
  if (!list.has_corner) return;
  charge_.add(mesh.corners.size() * width * sizeof(double), kObjAttributes);
  std::vector<double> values(mesh.corners.size() * width);
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    const std::uint32_t index = list.of_corner[c];
    if (index == MeshAttributes::kNone) continue;
    if (index >= list.values.size() / width) {
      ++unknown_;
      continue;
    }
    for (std::size_t i = 0; i < width; ++i) values[c * width + i] = list.values[index * width + i];
  }
  builder_.add_of_corners(name, static_cast<std::uint32_t>(width), std::move(values), mesh);
}

void ObjAttributes::give_colors(const PolygonMesh& mesh) {
  if (!has_colors_) return;
  charge_.add(colors_.size() * 3 * sizeof(double), kObjAttributes);
  const ColorScale scale(colors_);
  std::vector<double> values;
  values.reserve(colors_.size() * 3);
  for (const StatedColor& color : colors_) {
    const auto parts = color.count == 3 ? scale(color) : std::array<double, 4>{1, 1, 1, 1};
    values.insert(values.end(), parts.begin(), parts.begin() + 3);
  }
  builder_.add_of_vertices("color", 3, values, mesh);
}

void ObjAttributes::load_libraries(std::vector<std::string>& notes) {
  for (const std::string& name : libraries_) {
    std::string why;
    if (load_library(name, why)) continue;
    notes.push_back("materials have no colours, because the library was not read: " + why);
  }
}

/// Loads a library. Its name is the whole argument, or the argument up to a comment. If there is no
/// such file, the words of the argument are the names of libraries.
bool ObjAttributes::load_library(const std::string& name, std::string& why) {
  if (!loader_) {
    why = "the name of the folder of the file is not known";
    return false;
  }
  const auto load = [&](const std::string& file) {
    try {
      const std::string text = loader_(file);
      read_library(text);
      context_.release_memory(text.size());
      return true;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::CannotOpen) throw;
      why = error.what();
      return false;
    }
  };
  if (load(name)) return true;
  const std::string without_comment(trimmed(std::string_view(name).substr(0, name.find(" #"))));
  if (without_comment != name && load(without_comment)) return true;
  bool are_loaded = without_comment.find_first_of(kBlanks) != without_comment.npos;
  std::string_view rest = without_comment;
  constexpr std::size_t kMostLibraries = 64;
  std::set<std::string> seen;
  while (are_loaded && !rest.empty() && seen.size() < kMostLibraries) {
    std::string word(take_first(rest));
    if (seen.insert(word).second) are_loaded = load(word);
  }
  return are_loaded;
}

void ObjAttributes::read_library(std::string_view text) {
  constexpr std::size_t kBytesPerCheckpoint = 65536;
  MeshMaterial* material = nullptr;
  std::size_t next_checkpoint = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (at >= next_checkpoint) {
      context_.checkpoint("read", at, text.size());
      next_checkpoint = at + kBytesPerCheckpoint;
    }
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    read_library_line(text.substr(at, end - at), material);
    at = end + 1;
  }
}

/// Reads a statement of a library. Materials that are not used by any face are skipped.
void ObjAttributes::read_library_line(std::string_view line, MeshMaterial*& material) {
  const std::string_view keyword = take_first(line);
  if (keyword == "newmtl") {
    const auto known = builder_.known_material(line);
    material = known ? &builder_.material(*known) : nullptr;
    return;
  }
  if (material == nullptr) return;
  const auto color = [&]() -> std::array<double, 4>& {
    if (!material->color) material->color = {1, 1, 1, 1};
    return *material->color;
  };
  const auto number = [&] {
    return std::clamp(attribute_number(take_first(line)).value, 0.0, 1.0);
  };
  const bool is_number = !line.empty() && !line.starts_with("spectral") && !line.starts_with("xyz");
  if (keyword == "Kd" && is_number) {
    // A single number is a shade of grey.
    for (std::size_t i = 0; i < 3; ++i) color()[i] = line.empty() ? color()[0] : number();
  } else if (keyword == "d") {
    take_prefix(line, "-halo ");
    color()[3] = number();
  } else if (keyword == "Tr") {
    color()[3] = 1 - number();
  } else if (keyword == "map_Kd") {
    material->texture = texture_name(line);
  }
}

// ---------------------------------------------------------------- writing

namespace {

/// Returns the names of materials or groups in their written form. They have no characters that a
/// reader would not accept in a name, are not empty, and are all different.
std::vector<std::string> written_names(const std::vector<std::string>& names,
                                       std::string_view otherwise, std::string_view reserved) {
  std::vector<std::string> written;
  std::set<std::string> taken{std::string(reserved)};
  for (const std::string& name : names) {
    std::string text(trimmed(name));
    for (char& c : text) {
      if (static_cast<unsigned char>(c) < ' ' || c == '#' || c == '\\') c = '_';
    }
    if (text.empty()) text = std::string(otherwise) + '_' + std::to_string(written.size());
    while (!taken.insert(text).second) text += '_' + std::to_string(written.size());
    written.push_back(text);
  }
  return written;
}

std::vector<std::string> material_names(const MeshAttributes& attributes) {
  std::vector<std::string> names;
  for (const MeshMaterial& material : attributes.materials) names.push_back(material.name);
  return written_names(names, "material", kNoMaterial);
}

/// Writes a statement if the entry of a face differs from the entry of the previous face.
class ObjStatement {
 public:
  ObjStatement(const char* keyword, std::string_view none, std::vector<std::string> names,
               const std::vector<std::uint32_t>& of_faces)
      : keyword_(keyword), none_(none), names_(std::move(names)), of_faces_(of_faces) {}

  void write(TextOutput& out, std::size_t face) {
    if (of_faces_.empty() || of_faces_[face] == current_) return;
    current_ = of_faces_[face];
    out << keyword_ << ' ';
    if (current_ == MeshAttributes::kNone) {
      out << none_;
    } else {
      out << names_[current_];
    }
    out << '\n';
  }

 private:
  const char* keyword_;
  std::string_view none_;
  std::vector<std::string> names_;
  const std::vector<std::uint32_t>& of_faces_;
  std::uint32_t current_ = MeshAttributes::kNone;
};

/// Writes the distinct values of a channel, and returns the number of each corner.
std::vector<std::uint32_t> write_list(TextOutput& out, const char* keyword,
                                      const MeshChannel* channel, std::size_t corners) {
  if (channel == nullptr) return {};
  DistinctCorners numbers = distinct_values(*channel, corners);
  for (const std::uint32_t corner : numbers.corner) {
    out << keyword;
    write_numbers(out, values_at(*channel, corner));
    out << '\n';
  }
  return std::move(numbers.of_corner);
}

void write_obj_vertices(TextOutput& out, const SplitMesh& split, const MeshChannel* color) {
  for (std::size_t i = 0; i < split.mesh.points.size(); ++i) {
    out << "v ";
    write_coordinates(out, split.mesh.points[i]);
    if (color != nullptr) {
      const std::vector<double> parts = values_of_vertex(*color, split.corner_of_vertex[i]);
      write_numbers(out, std::span(parts).first(3));
    }
    out << '\n';
  }
}

void write_obj_corner(TextOutput& out, std::uint32_t vertex, std::optional<std::uint32_t> texture,
                      std::optional<std::uint32_t> normal) {
  out << ' ' << std::uint64_t{vertex} + 1;
  if (texture) out << '/' << std::uint64_t{*texture} + 1;
  if (normal) out << (texture ? "/" : "//") << std::uint64_t{*normal} + 1;
}

}  // namespace

void write_obj(std::ostream& stream, const PolygonMesh& mesh, const MeshAttributes& attributes,
               const std::string& library) {
  require_doubles(mesh);
  const MeshChannel* const color = channel_of(attributes, "color", 3, 4);
  std::vector<const MeshChannel*> of_vertices;
  if (color != nullptr) of_vertices.push_back(color);
  const SplitMesh split = split_vertices(mesh, of_vertices);
  TextOutput out(stream);
  out << "# plumb\n";
  if (!library.empty()) out << "mtllib " << library << '\n';
  write_obj_vertices(out, split, color);
  const std::size_t corners = mesh.corners.size();
  const auto textures = write_list(out, "vt", channel_of(attributes, "texcoord_0", 2, 2), corners);
  const auto normals = write_list(out, "vn", channel_of(attributes, "normal", 3, 3), corners);
  ObjStatement group("g", kNoGroup, written_names(attributes.groups, "group", kNoGroup),
                     attributes.face_group);
  ObjStatement material("usemtl", kNoMaterial, material_names(attributes),
                        attributes.face_material);
  const auto entry = [](const std::vector<std::uint32_t>& list, std::size_t c) {
    return list.empty() ? std::nullopt : std::optional(list[c]);
  };
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    group.write(out, f);
    material.write(out, f);
    out << 'f';
    for (std::size_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
      write_obj_corner(out, split.mesh.corners[c], entry(textures, c), entry(normals, c));
    }
    out << '\n';
  }
  out.flush();
}

void write_obj_library(std::ostream& stream, const MeshAttributes& attributes) {
  TextOutput out(stream);
  out << "# plumb\n";
  const std::vector<std::string> names = material_names(attributes);
  for (std::size_t m = 0; m < names.size(); ++m) {
    const MeshMaterial& material = attributes.materials[m];
    out << "newmtl " << names[m] << '\n';
    if (material.color) {
      out << "Kd";
      write_numbers(out, std::span(*material.color).first(3));
      out << "\nd " << (*material.color)[3] << '\n';
    }
    if (!material.texture.empty()) {
      std::string texture = material.texture;
      for (char& c : texture) {
        if (static_cast<unsigned char>(c) < ' ') c = '_';
      }
      out << "map_Kd " << texture << '\n';
    }
  }
  out.flush();
}

}  // namespace plumb
