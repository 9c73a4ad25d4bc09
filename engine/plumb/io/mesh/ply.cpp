// Reading and writing of PLY: its header, text elements, and binary elements of either byte order.
//
// The header is read first and names every property with a type, so a binary reader can skip what
// it does not know. Counts and lengths of lists are untrusted: an element needs at least the bytes
// of its fixed properties, and the lists of a record share what is left after all fixed parts
// (spare_), so no list can claim bytes that do not exist or that other properties need. All numbers
// up to 32 bits and floats are exact in doubles, which are used for every type. PlyGeometry takes
// what both readers read: it turns strips into triangles, and keeps faces away from vertices that
// are not finite. Format: G. Turk, The PLY polygon file format (Stanford University);
// docs/formats.md, section PLY.
// Tested by tests/io/ply_test.cpp.
#include "plumb/io/mesh/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
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

/// The names by which programs call the list of the corners of a face.
constexpr std::array<std::string_view, 14> kCornerNames{
    "vertex_indices", "vertex_index",  "vertex_indexes", "vertex_indicies", "vertex_ids",
    "vertex_list",    "vertexindices", "vertices",       "verts",           "indices",
    "indexes",        "index",         "point_indices",  "point_index"};

/// Names of what is passed over, each once. Only the first few are kept: a file can have many.
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
  explicit HeaderReader(RecordReader& in) : in_(in), cursor_(in.cursor()) {}

  PlyHeader read() {
    read_magic();
    while (read_line()) {
    }
    require_mesh();
    require_bytes();
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
  void pass_over(std::string_view property);
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
  std::string_view element_;  // The name of the last element.
  NameList others_, of_vertices_, of_faces_, lines_;
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

/// Passes over a line that belongs to no header: some programs write comments without the word. A
/// line that seems to declare something, or to be one of numbers, says that the rest of the file is
/// not what the header makes of it.
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
  if (version != "1.0") {
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
  if (property.role == Role::None) pass_over(name);
  header_.elements.back().properties.push_back(property);
}

/// Notes a property of the last element that no mesh holds, or the element if it is unknown.
void HeaderReader::pass_over(std::string_view property) {
  const PlyElement& element = header_.elements.back();
  if (element.count == 0) return;
  if (element.kind == Kind::Other) {
    others_.add(element_);
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
  const bool is_corners = has_corners && std::find(kCornerNames.begin(), kCornerNames.end(),
                                                   name) != kCornerNames.end();
  return is_corners ? Role::Corners : Role::None;
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

/// Requires enough bytes for each element on its own: a sum of hostile counts could overflow.
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

namespace {

using Kind = PlyElement::Kind;
using Role = PlyProperty::Role;

std::string_view name_of(Kind kind) {
  switch (kind) {
    case Kind::Vertex:
      return "vertex";
    case Kind::Face:
      return "face";
    case Kind::Strips:
      return "tristrips";
    default:
      return "element";
  }
}

// ---------------------------------------------------------------- geometry

/// What both readers read, on its way into the mesh: vertices, which need not be finite if no face
/// uses them, faces and strips.
class PlyGeometry {
 public:
  PlyGeometry(MeshCollector& mesh, const PlyHeader& header, Context& context)
      : mesh_(mesh), vertices_(header.vertex_count()), charge_(context) {}

  MeshCollector& mesh() { return mesh_; }
  std::uint32_t vertex_count() const { return vertices_; }

  /// Whether a face may use vertex v. It may if the vertex has not been read yet.
  bool is_usable(std::uint32_t v) const { return missing_ == 0 || !is_missing_[v]; }
  /// Adds a vertex that is not finite. Returns false if a face uses it.
  bool add_missing_point();

  /// Adds the next vertex of a strip. From the third on, each one makes a triangle with the two
  /// before it, and every other triangle is turned round, so that all have the same orientation.
  void add_to_strip(std::uint32_t v);
  void end_strip();

  /// Returns the mesh with its notes.
  MeshFile take(const std::string& passed_over, std::uint64_t stray_bytes);

 private:
  void prepare_missing();

  MeshCollector& mesh_;
  std::uint32_t vertices_;
  MemoryCharge charge_;
  std::vector<bool> is_missing_, is_used_;  // Of each vertex, from the first missing one on.
  std::uint32_t missing_ = 0;
  std::array<std::uint32_t, 2> strip_end_{};  // The last two vertices of the strip.
  std::uint32_t strip_length_ = 0;
};

bool PlyGeometry::add_missing_point() {
  if (is_missing_.empty()) prepare_missing();
  const std::uint32_t v = mesh_.point_count();
  mesh_.add_point({});
  is_missing_[v] = true;
  ++missing_;
  return !is_used_[v];
}

/// Faces may come before vertices; those that come later ask is_usable().
void PlyGeometry::prepare_missing() {
  charge_.add(vertices_ / 4, "the vertices of the file");
  is_missing_.resize(vertices_);
  is_used_.resize(vertices_);
  for (const std::uint32_t v : mesh_.corners()) is_used_[v] = true;
}

void PlyGeometry::add_to_strip(std::uint32_t v) {
  const auto [a, b] = strip_end_;
  if (strip_length_ >= 2) {
    const bool is_turned = strip_length_ % 2 == 1;
    for (const std::uint32_t corner : {is_turned ? b : a, is_turned ? a : b, v}) {
      mesh_.add_corner(corner);
    }
    mesh_.end_face();
  }
  strip_end_ = {b, v};
  ++strip_length_;
}

void PlyGeometry::end_strip() {
  if (strip_length_ == 1 || strip_length_ == 2) {
    mesh_.pass_over("strips of fewer than three vertices");
  }
  strip_length_ = 0;
}

MeshFile PlyGeometry::take(const std::string& passed_over, std::uint64_t stray_bytes) {
  MeshFile file = mesh_.take();
  if (!passed_over.empty()) file.notes.push_back("passed over: " + passed_over);
  if (missing_ > 0) {
    file.notes.push_back("vertices that are not finite, used by no face: " +
                         std::to_string(missing_));
  }
  if (stray_bytes > 0) {
    file.notes.push_back("passed over: " + std::to_string(stray_bytes) +
                         " byte(s) behind the last element");
  }
  return file;
}

/// Whether a number in a list of strips ends a strip: -1, which unsigned types cannot hold.
bool ends_strip(double value, PlyType type, std::uint32_t vertices) {
  const double all_bits = type == PlyType::UInt8    ? 0xff
                          : type == PlyType::UInt16 ? 0xffff
                                                    : 0xffff'ffff;
  return value == -1 || (value == all_bits && value >= vertices);
}

/// Whether a number is that of a vertex. Lists of floats are allowed.
bool is_vertex(double value, std::uint32_t vertices) {
  return value >= 0 && value < vertices &&
         value == static_cast<double>(static_cast<std::uint32_t>(value));
}

// ---------------------------------------------------------------- text

/// Whether a text begins as numbers do that are not finite, in the spelling of any C library.
bool begins_not_finite(std::string_view text) {
  constexpr std::array<std::string_view, 7> kSpellings{"nan", "NaN", "NAN", "inf",
                                                       "Inf", "INF", "1.#"};
  if (text.front() == '-' || text.front() == '+') text.remove_prefix(1);
  if (text.empty() || ('0' <= text.front() && text.front() <= '9' && text.substr(1, 2) != ".#")) {
    return false;
  }
  return std::any_of(kSpellings.begin(), kSpellings.end(),
                     [&](std::string_view spelling) { return text.starts_with(spelling); });
}

class PlyTextReader {
 public:
  PlyTextReader(RecordReader& in, PlyGeometry& geometry) : in_(in), geometry_(geometry) {}

  void read(const PlyElement& element);
  std::uint64_t pass_over_rest();

 private:
  void begin_record(const PlyElement& element, std::uint32_t index);
  bool is_free_form(const PlyElement& first);
  void end_record(const PlyElement& element);
  void read_property(const PlyElement& element, const PlyProperty& property);
  void find_value();
  std::string_view value_text() const {
    return {value_, static_cast<std::size_t>(in_.cursor().position() - value_)};
  }
  double take_whole(std::string_view needs);
  std::uint32_t take_length(std::string_view what);
  void read_corner(const PlyElement& element, const PlyProperty& property);
  void read_coordinate(ReadNumber& number);
  void skip_value();

  RecordReader& in_;
  PlyGeometry& geometry_;
  bool is_first_ = true;  // Whether no record has been read yet.
  bool is_free_form_ = false;
  bool may_wrap_ = false;          // Whether the values of a record may stand on several lines.
  const char* value_ = nullptr;    // The beginning of the last value.
  const char* missing_ = nullptr;  // A coordinate of this vertex that is not finite.
  std::array<ReadNumber, 3> at_;
  ReadNumber whole_;
};

void PlyTextReader::read(const PlyElement& element) {
  if (element.properties.empty()) return;
  may_wrap_ = is_free_form_ || element.kind == Kind::Strips;
  for (std::uint32_t i = 0; i < element.count; ++i) {
    begin_record(element, i);
    for (const PlyProperty& property : element.properties) read_property(element, property);
    end_record(element);
  }
}

void PlyTextReader::begin_record(const PlyElement& element, std::uint32_t index) {
  if (is_free_form_ && !in_.cursor().at_line_end()) {
    return in_.begin_record(name_of(element.kind), index);
  }
  in_.next_record(name_of(element.kind), index, element.count);
  if (!is_first_) return;
  is_first_ = false;
  may_wrap_ = is_free_form_ = is_free_form(element);
}

/// Whether line breaks mean nothing: some programs write all vertices on one line, or each value on
/// its own. The first line says so. Otherwise each record is a line, which shows earlier and better
/// where a file is not what its header says.
bool PlyTextReader::is_free_form(const PlyElement& first) {
  const auto is_list = [](const PlyProperty& property) { return property.length.has_value(); };
  if (std::any_of(first.properties.begin(), first.properties.end(), is_list)) return false;
  const std::uint64_t record = first.properties.size();
  TextCursor line = in_.cursor();
  std::uint64_t values = 0;
  for (; !line.at_line_end(); ++values) line.token();
  return record > 1 && (values == 1 || (first.count > 1 && values >= record * first.count));
}

void PlyTextReader::end_record(const PlyElement& element) {
  if (!is_free_form_ && !in_.cursor().at_line_end()) {
    in_.end_line("the end of the line after the properties of " + in_.record_name());
  }
  if (element.kind == Kind::Face) geometry_.mesh().end_face();
  if (element.kind == Kind::Strips) geometry_.end_strip();
  if (element.kind != Kind::Vertex) return;
  if (missing_ == nullptr) return geometry_.mesh().add_point(at_[0], at_[1], at_[2]);
  if (!geometry_.add_missing_point()) {
    // Only a place in the current line can be reported.
    in_.cursor().fail(ErrorCode::NumberOutOfRange,
                      in_.record_name() + " is not finite, but a face uses it",
                      may_wrap_ ? nullptr : missing_);
  }
  missing_ = nullptr;
}

void PlyTextReader::read_property(const PlyElement& element, const PlyProperty& property) {
  switch (property.role) {
    case Role::Corners: {
      const std::uint32_t count = take_length("the number of corners");
      for (std::uint32_t i = 0; i < count; ++i) read_corner(element, property);
      return;
    }
    case Role::None: {
      const std::uint32_t count = property.length ? take_length("the length of a list") : 1;
      for (std::uint32_t i = 0; i < count; ++i) skip_value();
      return;
    }
    default:
      read_coordinate(at_[static_cast<std::size_t>(property.role) - 1]);
  }
}

/// Moves to the next value of the record.
void PlyTextReader::find_value() {
  if (in_.cursor().at_line_end() && may_wrap_) in_.cursor().next_line();
  value_ = in_.cursor().position();
}

/// Returns the next number if a double holds it, else a number that is not whole.
double PlyTextReader::take_whole(std::string_view needs) {
  find_value();
  std::uint32_t small = 0;
  if (in_.cursor().short_number(small)) return small;
  in_.read_number(whole_, needs);
  return whole_.is_double() ? whole_.as_double() : 0.5;
}

std::uint32_t PlyTextReader::take_length(std::string_view what) {
  const double length = take_whole(what);
  if (is_vertex(length, RecordReader::kMostIds + 1)) return static_cast<std::uint32_t>(length);
  in_.cursor().fail_token(value_text(), what);
}

void PlyTextReader::read_corner(const PlyElement& element, const PlyProperty& property) {
  const double value = take_whole("the number of a vertex");
  const std::uint32_t vertices = geometry_.vertex_count();
  if (element.kind == Kind::Strips && ends_strip(value, property.type, vertices)) {
    return geometry_.end_strip();
  }
  if (!is_vertex(value, vertices)) {
    in_.cursor().fail(ErrorCode::BadIndex,
                      in_.record_name() + " names vertex " + quoted(value_text()) +
                          (vertices == 0 ? "; there are none"
                                         : "; ids run from 0 to " + std::to_string(vertices - 1)),
                      value_);
  }
  const auto v = static_cast<std::uint32_t>(value);
  if (!geometry_.is_usable(v)) {
    in_.cursor().fail(
        ErrorCode::NumberOutOfRange,
        in_.record_name() + " uses vertex " + quoted(value_text()) + ", which is not finite",
        value_);
  }
  if (element.kind == Kind::Strips) return geometry_.add_to_strip(v);
  geometry_.mesh().add_corner(v);
}

void PlyTextReader::read_coordinate(ReadNumber& number) {
  find_value();
  if (!in_.cursor().at_line_end() && begins_not_finite(in_.cursor().rest())) {
    in_.cursor().token();
    missing_ = value_;
  } else {
    in_.read_number(number, "more properties");
  }
}

/// Skips a value of any form; real files contain "nan".
void PlyTextReader::skip_value() {
  find_value();
  if (in_.cursor().at_line_end()) {
    in_.cursor().fail(ErrorCode::Syntax, in_.record_name() + " needs more properties");
  }
  in_.cursor().token();
}

/// Returns how many bytes there are behind the last element. Numbers are refused, because they may
/// be more elements.
std::uint64_t PlyTextReader::pass_over_rest() {
  TextCursor& cursor = in_.cursor();
  if (cursor.at_line_end() && !cursor.next_line()) return 0;
  if (std::string_view("+-.0123456789").find(*cursor.position()) == std::string_view::npos) {
    return cursor.bytes_left();
  }
  cursor.fail(ErrorCode::CountMismatch, "there is more after the last element");
}

// ---------------------------------------------------------------- binary

class PlyBinaryReader {
 public:
  PlyBinaryReader(BinaryInput in, const PlyHeader& header, PlyGeometry& geometry, Context& context)
      : in_(std::move(in)),
        format_(header.format),
        geometry_(geometry),
        context_(context),
        total_bytes_(in_.position() + in_.bytes_left()) {}

  const BinaryInput& input() const { return in_; }

  void read(const PlyElement& element);
  std::uint64_t pass_over_rest() const { return in_.bytes_left(); }

 private:
  void read_property(const PlyProperty& property);
  void end_record();
  std::uint64_t take_length(const PlyProperty& property);
  double take(PlyType type);
  double take_coordinate(PlyType type);
  void read_corner(PlyType type);
  std::string record_name() const {
    return std::string(name_of(kind_)) + ' ' + std::to_string(std::uint64_t{index_} + 1);
  }

  BinaryInput in_;
  PlyFormat format_;
  PlyGeometry& geometry_;
  Context& context_;
  std::size_t total_bytes_;
  Kind kind_ = Kind::Other;  // Kind of the record.
  std::uint32_t index_ = 0;
  std::uint64_t spare_ = 0;  // Bytes available for the lists of this record.
  std::array<double, 3> at_{};
  std::size_t missing_ = 0;  // Where a coordinate of this vertex is that is not finite.
};

/// Reads the records of one element. Before each, the bytes of its fixed parts must exist; what is
/// left beyond these may be used by its lists.
void PlyBinaryReader::read(const PlyElement& element) {
  constexpr std::uint32_t kRecordsPerCheckpoint = 4096;
  if (element.properties.empty()) return;
  const std::uint64_t least = element.least_bytes(format_);
  kind_ = element.kind;
  for (index_ = 0; index_ < element.count; ++index_) {
    if (index_ % kRecordsPerCheckpoint == 0) {
      context_.checkpoint("read", in_.position(), total_bytes_);
    }
    if (in_.bytes_left() < least) {
      in_.fail(ErrorCode::CountMismatch, "the file ends where " + record_name() + " of " +
                                             std::to_string(element.count) + " is expected");
    }
    spare_ = in_.bytes_left() - least;
    for (const PlyProperty& property : element.properties) read_property(property);
    end_record();
  }
}

void PlyBinaryReader::end_record() {
  if (kind_ == Kind::Face) geometry_.mesh().end_face();
  if (kind_ == Kind::Strips) geometry_.end_strip();
  if (kind_ != Kind::Vertex) return;
  if (missing_ == 0) return geometry_.mesh().add_point({at_[0], at_[1], at_[2]});
  if (!geometry_.add_missing_point()) {
    in_.fail(ErrorCode::NumberOutOfRange, record_name() + " is not finite, but a face uses it",
             missing_);
  }
  missing_ = 0;
}

void PlyBinaryReader::read_property(const PlyProperty& property) {
  if (property.role == Role::Corners) {
    for (std::uint64_t count = take_length(property); count > 0; --count) {
      read_corner(property.type);
    }
  } else if (property.role == Role::None) {
    const std::uint64_t count = property.length ? take_length(property) : 1;
    in_.skip(count * size_of(property.type));
  } else {
    at_[static_cast<std::size_t>(property.role) - 1] = take_coordinate(property.type);
  }
}

/// Returns the length of a list for which there are enough bytes besides those that the other
/// properties need.
std::uint64_t PlyBinaryReader::take_length(const PlyProperty& property) {
  const std::size_t start = in_.position();
  const double length = take(*property.length);
  if (length < 0) in_.fail(ErrorCode::Syntax, "a list of negative length", start);
  const double bytes = length * static_cast<double>(size_of(property.type));
  if (!(bytes <= static_cast<double>(spare_))) {
    in_.fail(ErrorCode::CountMismatch, "a list of " + record_name() + " is longer than the file",
             start);
  }
  const auto count = static_cast<std::uint64_t>(length);
  if (static_cast<double>(count) != length) {
    in_.fail(ErrorCode::Syntax, "a list of length " + format_double(length), start);
  }
  spare_ -= static_cast<std::uint64_t>(bytes);
  return count;
}

/// Returns the next value; every type is exact in a double.
double PlyBinaryReader::take(PlyType type) {
  switch (type) {
    case PlyType::Int8:
      return in_.take<std::int8_t>();
    case PlyType::UInt8:
      return in_.take<std::uint8_t>();
    case PlyType::Int16:
      return in_.take<std::int16_t>();
    case PlyType::UInt16:
      return in_.take<std::uint16_t>();
    case PlyType::Int32:
      return in_.take<std::int32_t>();
    case PlyType::UInt32:
      return in_.take<std::uint32_t>();
    case PlyType::Float32:
      return static_cast<double>(in_.take<float>());
    default:
      return in_.take<double>();
  }
}

double PlyBinaryReader::take_coordinate(PlyType type) {
  const double value = take(type);
  if (!std::isfinite(value)) missing_ = in_.position() - size_of(type);
  return value;
}

void PlyBinaryReader::read_corner(PlyType type) {
  const double value = take(type);
  const std::uint32_t vertices = geometry_.vertex_count();
  if (kind_ == Kind::Strips && ends_strip(value, type, vertices)) return geometry_.end_strip();
  if (!is_vertex(value, vertices)) {
    in_.fail(ErrorCode::BadIndex,
             record_name() + " names vertex " + format_double(value) + "; there are " +
                 std::to_string(vertices),
             in_.position() - size_of(type));
  }
  const auto v = static_cast<std::uint32_t>(value);
  if (!geometry_.is_usable(v)) {
    in_.fail(ErrorCode::NumberOutOfRange,
             record_name() + " uses vertex " + std::to_string(v) + ", which is not finite",
             in_.position() - size_of(type));
  }
  if (kind_ == Kind::Strips) return geometry_.add_to_strip(v);
  geometry_.mesh().add_corner(v);
}

// ---------------------------------------------------------------- both

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const ReadOptions& options, Context& context)
      : in_(bytes, options, context, "the mesh"),
        bytes_(bytes),
        name_(options.name),
        mesh_(context),
        context_(context) {}

  MeshFile read() {
    with_place(in_.cursor(), [this] {
      header_ = read_ply_header(in_);
      expect();
    });
    PlyGeometry geometry(mesh_, header_, context_);
    if (header_.format == PlyFormat::Text) {
      PlyTextReader reader(in_, geometry);
      return read_elements(reader, in_.cursor(), geometry);
    }
    PlyBinaryReader reader(data(), header_, geometry, context_);
    return read_elements(reader, reader.input(), geometry);
  }

 private:
  void expect();
  BinaryInput data() const;
  template <class Reader, class Input>
  MeshFile read_elements(Reader& reader, const Input& input, PlyGeometry& geometry) {
    return with_place(input, [&] {
      for (const PlyElement& element : header_.elements) reader.read(element);
      return geometry.take(header_.passed_over, reader.pass_over_rest());
    });
  }

  RecordReader in_;
  std::string_view bytes_;
  const std::string& name_;
  MeshCollector mesh_;
  Context& context_;
  PlyHeader header_;
};

/// Reserves memory for counts that the header has compared with the bytes of the file.
void PlyReader::expect() {
  std::uint32_t faces = 0;
  for (const PlyElement& element : header_.elements) {
    if (element.kind == Kind::Face) faces = element.count;
  }
  mesh_.expect(header_.vertex_count(), faces);
}

/// Returns what follows the line break of the header.
BinaryInput PlyReader::data() const {
  const std::size_t end = in_.cursor().bytes_read();
  const std::endian order =
      header_.format == PlyFormat::BigEndian ? std::endian::big : std::endian::little;
  return {bytes_, std::min(end + 1, bytes_.size()), order, name_};
}

/// Returns how many bytes of a file whose lines end with CR are lines: the header, and the elements
/// if they are text.
std::size_t bytes_of_lines(std::string_view bytes) {
  const std::string_view header = bytes.substr(0, bytes.find("\rend_header"));
  const std::string_view from_format =
      header.substr(std::min(header.find("\rformat"), header.size()));
  const std::string_view format = from_format.substr(0, from_format.find('\r', 1));
  const std::size_t end = bytes.find('\r', std::min(header.size() + 1, bytes.size()));
  return format.find("binary") == format.npos || end == bytes.npos ? bytes.size() : end + 1;
}

}  // namespace

MeshFile read_ply(std::string_view bytes, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  if (!ends_lines_with_cr(bytes)) return PlyReader(bytes, options, context).read();
  MemoryCharge charge(context);
  with_place(WholeFile{options.name}, [&] { charge.add(bytes.size(), "the lines of the file"); });
  return PlyReader(with_line_feeds(bytes, bytes_of_lines(bytes)), options, context).read();
}

namespace {

/// The types of a list of corners.
struct CornerTypes {
  bool short_length;  ///< Whether lengths are uchar; else uint.
  bool is_signed;     ///< Whether corners are int, which more programs read; else uint.
};

CornerTypes types_for(const PolygonMesh& mesh) {
  std::size_t longest = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    longest = std::max(longest, mesh.face(f).size());
  }
  return {longest <= 0xff, mesh.points.size() <= 0x8000'0000U};
}

void write_header(TextOutput& out, std::string_view format, const PolygonMesh& mesh,
                  CornerTypes types) {
  out << "ply\nformat " << format << " 1.0\ncomment plumb\n";
  out << "element vertex " << std::uint64_t{mesh.points.size()};
  out << "\nproperty double x\nproperty double y\nproperty double z\n";
  out << "element face " << std::uint64_t{mesh.face_count()};
  out << "\nproperty list " << (types.short_length ? "uchar" : "uint");
  out << (types.is_signed ? " int" : " uint") << " vertex_indices\nend_header\n";
}

}  // namespace

void write_ply_text(std::ostream& stream, const PolygonMesh& mesh) {
  require_doubles(mesh);
  TextOutput out(stream);
  write_header(out, "ascii", mesh, types_for(mesh));
  for (const Point3& p : mesh.points) {
    write_coordinates(out, p);
    out << '\n';
  }
  write_face_lines(out, mesh);
  out.flush();
}

void write_ply_binary(std::ostream& stream, const PolygonMesh& mesh) {
  require_doubles(mesh);
  TextOutput out(stream);
  const CornerTypes types = types_for(mesh);
  write_header(out, "binary_little_endian", mesh, types);
  for (const Point3& p : mesh.points) {
    for (const double value : {p.x, p.y, p.z}) put_little_endian(out, value);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const auto length = static_cast<std::uint32_t>(face.size());
    if (types.short_length) {
      out << static_cast<char>(length);
    } else {
      put_little_endian(out, length);
    }
    for (const std::uint32_t v : face) put_little_endian(out, v);
  }
  out.flush();
}

}  // namespace plumb
