// The header of PLY: which elements a file holds, and which properties each of them has.
//
// Every property has a type, so a binary reader can skip unknown properties. The role of a property
// states its meaning for a mesh. Properties without a role are skipped, and notes name them,
// because unknown elements may contain geometry. Counts are untrusted: an element needs at least
// the bytes of its fixed properties, so no count is believed for which the file is too short. Lines
// that do not belong to a header are skipped, too. But a line that may be a misspelled line of a
// header is an error, because otherwise the rest of the file would be misread. Format:
// docs/formats.md, section PLY.
// Tested by tests/io/ply_test.cpp.
#include "plumb/io/mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/io/mesh/attribute_builder.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

using Kind = PlyElement::Kind;
using Role = PlyProperty::Role;

template <class Value>
using Names = std::vector<std::pair<std::string_view, Value>>;

const Names<PlyType> kTypes{
    {"char", PlyType::Int8},       {"int8", PlyType::Int8},       {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},     {"short", PlyType::Int16},     {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16},   {"uint16", PlyType::UInt16},   {"int", PlyType::Int32},
    {"int32", PlyType::Int32},     {"uint", PlyType::UInt32},     {"uint32", PlyType::UInt32},
    {"float", PlyType::Float32},   {"float32", PlyType::Float32}, {"double", PlyType::Float64},
    {"float64", PlyType::Float64}, {"int64", PlyType::Int64},     {"uint64", PlyType::UInt64}};

const Names<PlyFormat> kFormats{{"ascii", PlyFormat::Text},
                                {"binary_little_endian", PlyFormat::LittleEndian},
                                {"binary_big_endian", PlyFormat::BigEndian}};

/// The names that programs use for the list of the corners of a face.
constexpr std::array<std::string_view, 14> kCornerNames{
    "vertex_indices", "vertex_index",  "vertex_indexes", "vertex_indicies", "vertex_ids",
    "vertex_list",    "vertexindices", "vertices",       "verts",           "indices",
    "indexes",        "index",         "point_indices",  "point_index"};

bool is_corner_name(std::string_view name) {
  return std::find(kCornerNames.begin(), kCornerNames.end(), name) != kCornerNames.end();
}

/// The names of skipped elements and properties, each once. Only the first few are stored, because
/// a file may have many.
class NameList {
 public:
  void add(std::string_view name) {
    std::string text = quoted(name);
    if (std::find(names_.begin(), names_.end(), text) != names_.end()) return;
    has_more_ = names_.size() == kMost;
    if (!has_more_) names_.push_back(std::move(text));
  }

  /// Appends "; before 'a', 'b' after" to a sentence.
  void append_to(std::string& sentence, std::string_view before, std::string_view after) const {
    if (names_.empty()) return;
    if (!sentence.empty()) sentence += "; ";
    sentence += before;
    for (std::size_t i = 0; i < names_.size(); ++i) sentence += (i == 0 ? " " : ", ") + names_[i];
    sentence.append(has_more_ ? " and more" : "").append(after);
  }

 private:
  static constexpr std::size_t kMost = 16;

  std::vector<std::string> names_;
  bool has_more_ = false;
};

class HeaderReader {
 public:
  HeaderReader(RecordReader& in, bool keeps_attributes)
      : in_(in), cursor_(in.cursor()), keeps_attributes_(keeps_attributes) {}

  PlyHeader read() {
    read_magic();
    while (read_line()) {
    }
    require_mesh();
    require_bytes();
    faces_elsewhere_.append_to(header_.left_out, "elements", " with lists of vertices");
    others_.append_to(header_.passed_over, "elements", "");
    of_vertices_.append_to(header_.passed_over, "properties", " of vertices");
    of_faces_.append_to(header_.passed_over, "properties", " of faces");
    lines_.append_to(header_.passed_over, "lines of the header", "");
    return std::move(header_);
  }

 private:
  void read_magic();
  bool read_line();
  void skip_line();
  void pass_over_line(std::string_view keyword);
  void read_format();
  void read_element();
  void read_property();
  void pass_over(std::string_view property, bool is_list);
  bool is_attribute(const PlyProperty& property) const;
  Role role_of(std::string_view name, bool is_list) const;
  void require_new(Role role, std::string_view name) const;
  void require_mesh() const;
  void require_bytes() const;
  std::string_view take(std::string_view expected);
  template <class Value>
  Value find(const Names<Value>& names, std::string_view word, std::string_view expected) const;
  void end_line() { in_.end_line("the end of the line"); }
  [[noreturn]] void fail(ErrorCode code, std::string message, const char* where = nullptr) const {
    cursor_.fail(code, std::move(message), where);
  }

  RecordReader& in_;
  TextCursor& cursor_;
  bool keeps_attributes_;
  std::uint32_t lines_read_ = 0;
  std::size_t kept_ = 0;  // The properties of the last element that are stored as single numbers.
  PlyHeader header_;
  bool has_format_ = false;
  std::string_view element_;  // The name of the last element.
  NameList others_, faces_elsewhere_, of_vertices_, of_faces_, lines_;
};

void HeaderReader::read_magic() {
  const bool has_content = cursor_.next_line();
  if (!has_content || cursor_.line() != 1 || cursor_.token() != "ply") {
    fail(ErrorCode::Syntax, "the first line is not 'ply'",
         has_content && cursor_.line() == 1 ? cursor_.line_start() : nullptr);
  }
  end_line();
}

/// Reads a line of the header; returns false at its end.
bool HeaderReader::read_line() {
  in_.begin_record("line", lines_read_++);
  if (!cursor_.next_line()) {
    fail(ErrorCode::CountMismatch, "the file ends within its header; end_header is missing");
  }
  const std::string_view keyword = cursor_.token();
  if (keyword == "comment" || keyword == "obj_info") {
    skip_line();
    return true;
  }
  if (keyword == "end_header") {
    end_line();
    return false;
  }
  if (keyword == "format") {
    read_format();
  } else if (keyword == "element") {
    read_element();
  } else if (keyword == "property") {
    read_property();
  } else {
    pass_over_line(keyword);
  }
  end_line();
  return true;
}

void HeaderReader::skip_line() {
  while (!cursor_.at_line_end()) cursor_.token();
}

/// Skips a line that does not belong to a header, because some programs write comments without the
/// keyword. If the line looks like a declaration, or consists of numbers, the rest of the file
/// contradicts the header, and the line is an error.
void HeaderReader::pass_over_line(std::string_view keyword) {
  constexpr std::array<std::string_view, 4> kBeginnings{"form", "elem", "prop", "end"};
  const bool is_declaration =
      std::any_of(kBeginnings.begin(), kBeginnings.end(),
                  [&](std::string_view beginning) { return keyword.starts_with(beginning); });
  const bool is_number = std::string_view("+-.0123456789").find(keyword.front()) != keyword.npos;
  const bool is_text = text_prefix(keyword) == keyword.size();
  if (is_declaration || is_number || !is_text) {
    cursor_.fail_token(keyword, "format, element, property, comment or end_header");
  }
  skip_line();
  const char* const begin = keyword.data();
  lines_.add({begin, static_cast<std::size_t>(cursor_.position() - begin)});
}

void HeaderReader::read_format() {
  if (has_format_) fail(ErrorCode::Syntax, "a second format", cursor_.line_start());
  has_format_ = true;
  constexpr std::string_view kKnown = "ascii, binary_little_endian or binary_big_endian";
  header_.format = find(kFormats, take(kKnown), kKnown);
  const std::string_view version = take("1.0");
  if (version != "1.0" && version != "1") {
    fail(ErrorCode::UnknownFormat,
         "version " + quoted(version) + " of the format; this program reads 1.0", version.data());
  }
}

void HeaderReader::read_element() {
  element_ = take("the name of an element");
  const Kind kind = element_ == "vertex"      ? Kind::Vertex
                    : element_ == "face"      ? Kind::Face
                    : element_ == "tristrips" ? Kind::Strips
                                              : Kind::Other;
  const auto is_same = [&](const PlyElement& element) { return element.kind == kind; };
  const auto& elements = header_.elements;
  if (kind != Kind::Other && std::any_of(elements.begin(), elements.end(), is_same)) {
    fail(ErrorCode::Syntax, "a second element " + std::string(element_), element_.data());
  }
  header_.elements.push_back({kind, in_.read_count("the number of elements"), {}});
  kept_ = 0;
}

/// Reads the type and name of a property of the last element. Only coordinates and lists of corners
/// have a role; others are read by their type and dropped.
void HeaderReader::read_property() {
  if (header_.elements.empty()) {
    fail(ErrorCode::Syntax, "a property before any element", cursor_.line_start());
  }
  PlyProperty property{};
  std::string_view word = take("a type or list");
  if (word == "list") {
    word = take("the type of a length");
    property.length = find(kTypes, word, "the type of a length");
    word = take("a type such as int or double");
  }
  property.type = find(kTypes, word, "a type such as int or double");
  const std::string_view name = take("the name of a property");
  property.role = role_of(name, property.length.has_value());
  require_new(property.role, name);
  property.name = name;
  property.is_kept = is_attribute(property);
  kept_ += property.is_kept && !property.length ? 1 : 0;
  if (property.role == Role::None && !property.is_kept) {
    pass_over(name, property.length.has_value());
  }
  header_.elements.back().properties.push_back(property);
}

/// Whether a property of the last element is an attribute of vertices or faces.
bool HeaderReader::is_attribute(const PlyProperty& property) const {
  const PlyElement& element = header_.elements.back();
  const bool has_attributes = element.kind == Kind::Vertex || element.kind == Kind::Face;
  if (!keeps_attributes_ || !has_attributes || property.role != Role::None) return false;
  const auto& properties = element.properties;
  if (property.length) {
    const auto is_same = [&](const PlyProperty& other) { return other.name == property.name; };
    return element.kind == Kind::Face && property.name == "texcoord" &&
           std::none_of(properties.begin(), properties.end(), is_same);
  }
  return kept_ < kMostNumbersOfCorner;
}

/// Notes a property of the last element that a mesh cannot represent, or the element if it is
/// unknown. An element with lists of vertices has faces in a form that is not read, such as fans.
void HeaderReader::pass_over(std::string_view property, bool is_list) {
  const PlyElement& element = header_.elements.back();
  if (element.count == 0) return;
  if (element.kind == Kind::Other) {
    // A range_grid states the positions of vertices in a scan. Its faces are in the element face.
    const bool has_corners = is_list && is_corner_name(property) && element_ != "range_grid";
    (has_corners ? faces_elsewhere_ : others_).add(element_);
  } else {
    (element.kind == Kind::Vertex ? of_vertices_ : of_faces_).add(property);
  }
}

Role HeaderReader::role_of(std::string_view name, bool is_list) const {
  const Kind kind = header_.elements.back().kind;
  if (kind == Kind::Vertex && !is_list) {
    return name == "x" ? Role::X : name == "y" ? Role::Y : name == "z" ? Role::Z : Role::None;
  }
  const bool has_corners = (kind == Kind::Face || kind == Kind::Strips) && is_list;
  return has_corners && is_corner_name(name) ? Role::Corners : Role::None;
}

bool has_role(const PlyElement& element, Role role) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const PlyProperty& property) { return property.role == role; });
}

void HeaderReader::require_new(Role role, std::string_view name) const {
  if (role == Role::None || !has_role(header_.elements.back(), role)) return;
  fail(ErrorCode::Syntax, "a second property " + quoted(name), name.data());
}

/// Requires a format, vertices with x, y and z, and for faces and strips a list of corners.
void HeaderReader::require_mesh() const {
  if (!has_format_) fail(ErrorCode::Syntax, "the header names no format");
  bool has_vertices = false;
  for (const PlyElement& element : header_.elements) {
    if (element.kind == Kind::Vertex) {
      has_vertices = true;
      const bool is_placed =
          has_role(element, Role::X) && has_role(element, Role::Y) && has_role(element, Role::Z);
      if (!is_placed) fail(ErrorCode::Syntax, "the vertices lack one of x, y and z");
    }
    if (element.kind == Kind::Vertex || element.kind == Kind::Other || element.count == 0) continue;
    if (has_role(element, Role::Corners)) continue;
    fail(ErrorCode::Syntax, element.kind == Kind::Face ? "the faces have no list vertex_indices"
                                                       : "the strips have no list vertex_indices");
  }
  if (!has_vertices) fail(ErrorCode::Syntax, "the header names no vertices");
}

/// Requires enough bytes for each element separately, because a sum of hostile counts could
/// overflow.
void HeaderReader::require_bytes() const {
  for (const PlyElement& element : header_.elements) {
    const std::uint64_t least = element.least_bytes(header_.format);
    in_.require_bytes(element.count * least, std::to_string(element.count) + " elements",
                      cursor_.line_start());
  }
}

std::string_view HeaderReader::take(std::string_view expected) {
  if (!cursor_.at_line_end()) return cursor_.token();
  fail(ErrorCode::Syntax, "expected " + std::string(expected) + ", found the end of the line");
}

template <class Value>
Value HeaderReader::find(const Names<Value>& names, std::string_view word,
                         std::string_view expected) const {
  for (const auto& [name, value] : names) {
    if (name == word) return value;
  }
  cursor_.fail_token(word, expected);
}

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 10> kSizes{1, 1, 2, 2, 4, 4, 4, 8, 8, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

std::uint64_t PlyElement::least_bytes(PlyFormat format) const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties) {
    bytes += format == PlyFormat::Text ? 2 : size_of(property.length.value_or(property.type));
  }
  return bytes;
}

std::uint32_t PlyHeader::vertex_count() const {
  const auto vertices =
      std::find_if(elements.begin(), elements.end(),
                   [](const PlyElement& element) { return element.kind == Kind::Vertex; });
  return vertices->count;
}

PlyHeader read_ply_header(RecordReader& in, bool keeps_attributes) {
  return HeaderReader(in, keeps_attributes).read();
}

}  // namespace plumb
