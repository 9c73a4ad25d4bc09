#include "plumb/io/mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

using Kind = PlyElement::Kind;
using Role = PlyProperty::Role;

template <class Value>
using Names = std::vector<std::pair<std::string_view, Value>>;

const Names<PlyType> kTypes{
    {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16},  {"uint16", PlyType::UInt16},   {"int", PlyType::Int32},
    {"int32", PlyType::Int32},    {"uint", PlyType::UInt32},     {"uint32", PlyType::UInt32},
    {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
    {"float64", PlyType::Float64}};

const Names<PlyFormat> kFormats{{"ascii", PlyFormat::Text},
                                {"binary_little_endian", PlyFormat::LittleEndian},
                                {"binary_big_endian", PlyFormat::BigEndian}};

class HeaderReader {
 public:
  explicit HeaderReader(RecordReader& in) : in_(in), cursor_(in.cursor()) {}

  PlyHeader read() {
    read_magic();
    while (read_line()) {
    }
    require_mesh();
    require_bytes();
    return std::move(header_);
  }

 private:
  void read_magic();
  bool read_line();
  void read_format();
  void read_element();
  void read_property();
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
  PlyHeader header_;
  bool has_format_ = false;
};

void HeaderReader::read_magic() {
  const bool has_content = cursor_.next_line();
  if (!has_content || cursor_.line() != 1 || cursor_.token() != "ply") {
    fail(ErrorCode::Syntax, "the first line is not 'ply'",
         has_content && cursor_.line() == 1 ? cursor_.line_start() : nullptr);
  }
  end_line();
}

/// False at the end of the header.
bool HeaderReader::read_line() {
  if (!cursor_.next_line()) {
    fail(ErrorCode::CountMismatch, "the file ends within its header; end_header is missing");
  }
  const std::string_view keyword = cursor_.token();
  if (keyword == "comment" || keyword == "obj_info") {
    while (!cursor_.at_line_end()) cursor_.token();
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
    cursor_.fail_token(keyword, "format, element, property, comment or end_header");
  }
  end_line();
  return true;
}

void HeaderReader::read_format() {
  if (has_format_) fail(ErrorCode::Syntax, "a second format", cursor_.line_start());
  has_format_ = true;
  constexpr std::string_view kKnown = "ascii, binary_little_endian or binary_big_endian";
  header_.format = find(kFormats, take(kKnown), kKnown);
  const std::string_view version = take("1.0");
  if (version != "1.0") {
    fail(ErrorCode::UnknownFormat,
         "version " + quoted(version) + " of the format; this program reads 1.0", version.data());
  }
}

void HeaderReader::read_element() {
  const std::string_view name = take("the name of an element");
  const Kind kind = name == "vertex" ? Kind::Vertex : name == "face" ? Kind::Face : Kind::Other;
  const auto is_same = [&](const PlyElement& element) { return element.kind == kind; };
  const auto& elements = header_.elements;
  if (kind != Kind::Other && std::any_of(elements.begin(), elements.end(), is_same)) {
    fail(ErrorCode::Syntax, "a second element " + std::string(name), name.data());
  }
  header_.elements.push_back({kind, in_.read_count("the number of elements"), {}});
}

void HeaderReader::read_property() {
  if (header_.elements.empty()) {
    fail(ErrorCode::Syntax, "a property before any element", cursor_.line_start());
  }
  PlyProperty property{};
  std::string_view word = take("a type or list");
  if (word == "list") {
    word = take("the type of a length");
    property.length = find(kTypes, word, "the type of a length");
    if (!is_integer(*property.length)) cursor_.fail_token(word, "an integer type for a length");
    word = take("a type such as int or double");
  }
  property.type = find(kTypes, word, "a type such as int or double");
  const std::string_view name = take("the name of a property");
  property.role = role_of(name, property.length.has_value());
  require_new(property.role, name);
  if (property.role == Role::Corners && !is_integer(property.type)) {
    cursor_.fail_token(word, "an integer type for vertices of a face");
  }
  header_.elements.back().properties.push_back(property);
}

Role HeaderReader::role_of(std::string_view name, bool is_list) const {
  const Kind kind = header_.elements.back().kind;
  if (kind == Kind::Vertex && !is_list) {
    return name == "x" ? Role::X : name == "y" ? Role::Y : name == "z" ? Role::Z : Role::None;
  }
  const bool is_corners = name == "vertex_indices" || name == "vertex_index";
  return kind == Kind::Face && is_list && is_corners ? Role::Corners : Role::None;
}

bool has_role(const PlyElement& element, Role role) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const PlyProperty& property) { return property.role == role; });
}

void HeaderReader::require_new(Role role, std::string_view name) const {
  if (role == Role::None || !has_role(header_.elements.back(), role)) return;
  fail(ErrorCode::Syntax, "a second property " + quoted(name), name.data());
}

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
    if (element.kind == Kind::Face && !has_role(element, Role::Corners)) {
      fail(ErrorCode::Syntax, "the faces have no list vertex_indices");
    }
  }
  if (!has_vertices) fail(ErrorCode::Syntax, "the header names no vertices");
}

/// Each by itself: a sum of hostile counts could overflow.
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
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
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

PlyHeader read_ply_header(RecordReader& in) { return HeaderReader(in).read(); }

}  // namespace plumb
