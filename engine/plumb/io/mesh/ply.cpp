// Reading and writing of PLY: its header, text elements, and binary elements of either byte order.
//
// The header is read first and names every property with a type, so a binary reader can skip what
// it does not know. Counts and lengths of lists are untrusted: an element needs at least the bytes
// of its fixed properties, and the lists of a record share what is left after all fixed parts
// (spare_), so no list can claim bytes that do not exist or that other properties need. All numbers
// up to 32 bits and floats are exact in doubles, which are used for every type. Format: G. Turk,
// The PLY polygon file format (Stanford University); docs/formats.md, section PLY.
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

/// Reads a line of the header; returns false at its end.
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

/// Requires a format, vertices with x, y and z, and for faces a list of corners.
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
  return kind == Kind::Vertex ? "vertex" : kind == Kind::Face ? "face" : "element";
}

/// Notes what the mesh will not have.
void pass_over(const PlyElement& element, MeshCollector& mesh) {
  if (element.kind == Kind::Other) return mesh.pass_over("other elements");
  for (const PlyProperty& property : element.properties) {
    if (property.role != Role::None) continue;
    mesh.pass_over(element.kind == Kind::Vertex ? "other properties of vertices"
                                                : "other properties of faces");
  }
}

// ---------------------------------------------------------------- text

class PlyTextReader {
 public:
  PlyTextReader(RecordReader& in, const PlyHeader& header, MeshCollector& mesh)
      : in_(in), vertices_(header.vertex_count()), mesh_(mesh) {}

  void read(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (std::uint32_t i = 0; i < element.count; ++i) {
      in_.next_record(name_of(element.kind), i, element.count);
      for (const PlyProperty& property : element.properties) read_property(property);
      if (!in_.cursor().at_line_end()) {
        in_.end_line("the end of the line after the properties of " + in_.record_name());
      }
      if (element.kind == Kind::Vertex) mesh_.add_point(at_[0], at_[1], at_[2]);
      if (element.kind == Kind::Face) mesh_.end_face();
    }
  }

  void require_end() {
    if (!in_.cursor().next_line()) return;
    in_.cursor().fail(ErrorCode::CountMismatch, "there is more after the last element");
  }

 private:
  void read_property(const PlyProperty& property);
  void skip_value();

  RecordReader& in_;
  std::uint32_t vertices_;
  MeshCollector& mesh_;
  std::array<ReadNumber, 3> at_;
};

void PlyTextReader::read_property(const PlyProperty& property) {
  switch (property.role) {
    case Role::Corners: {
      const std::uint32_t count = in_.read_count("the number of corners");
      for (std::uint32_t i = 0; i < count; ++i)
        mesh_.add_corner(in_.read_index("vertex", vertices_));
      return;
    }
    case Role::None: {
      const std::uint32_t count = property.length ? in_.read_count("the length of a list") : 1;
      for (std::uint32_t i = 0; i < count; ++i) skip_value();
      return;
    }
    default:
      in_.read_number(at_[static_cast<std::size_t>(property.role) - 1], "more properties");
  }
}

/// Skips a value of any form; real files contain "nan".
void PlyTextReader::skip_value() {
  if (in_.cursor().at_line_end()) {
    in_.cursor().fail(ErrorCode::Syntax, in_.record_name() + " needs more properties");
  }
  in_.cursor().token();
}


// ---------------------------------------------------------------- binary

class PlyBinaryReader {
 public:
  PlyBinaryReader(BinaryInput in, const PlyHeader& header, MeshCollector& mesh, Context& context)
      : in_(std::move(in)),
        format_(header.format),
        vertices_(header.vertex_count()),
        mesh_(mesh),
        context_(context),
        total_bytes_(in_.position() + in_.bytes_left()) {}

  const BinaryInput& input() const { return in_; }

  void read(const PlyElement& element);
  void require_end() const {
    if (in_.bytes_left() == 0) return;
    in_.fail(ErrorCode::CountMismatch, "there is more after the last element");
  }

 private:
  void read_property(const PlyProperty& property);
  std::uint32_t take_length(const PlyProperty& property);
  double take(PlyType type);
  double take_coordinate(PlyType type);
  void add_corner(PlyType type);
  std::string record_name() const {
    return std::string(name_of(kind_)) + ' ' + std::to_string(std::uint64_t{index_} + 1);
  }

  BinaryInput in_;
  PlyFormat format_;
  std::uint32_t vertices_;
  MeshCollector& mesh_;
  Context& context_;
  std::size_t total_bytes_;
  Kind kind_ = Kind::Other;  // Kind of the record.
  std::uint32_t index_ = 0;
  std::uint64_t spare_ = 0;  // Bytes available for the lists of this record.
  std::array<double, 3> at_{};
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
    if (kind_ == Kind::Vertex) mesh_.add_point({at_[0], at_[1], at_[2]});
    if (kind_ == Kind::Face) mesh_.end_face();
  }
}

void PlyBinaryReader::read_property(const PlyProperty& property) {
  if (property.role == Role::Corners) {
    for (std::uint32_t count = take_length(property); count > 0; --count) add_corner(property.type);
  } else if (property.role == Role::None) {
    const std::uint64_t count = property.length ? take_length(property) : 1;
    in_.skip(count * size_of(property.type));
  } else {
    at_[static_cast<std::size_t>(property.role) - 1] = take_coordinate(property.type);
  }
}

/// Returns the length of a list for which there are enough bytes besides those that the other
/// properties need.
std::uint32_t PlyBinaryReader::take_length(const PlyProperty& property) {
  const std::size_t start = in_.position();
  const double length = take(*property.length);
  if (length < 0) in_.fail(ErrorCode::Syntax, "a list of negative length", start);
  const double bytes = length * static_cast<double>(size_of(property.type));
  if (bytes > static_cast<double>(spare_)) {
    in_.fail(ErrorCode::CountMismatch, "a list of " + record_name() + " is longer than the file",
             start);
  }
  spare_ -= static_cast<std::uint64_t>(bytes);
  return static_cast<std::uint32_t>(length);
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
  if (!std::isfinite(value)) {
    in_.fail(ErrorCode::NumberOutOfRange, "a coordinate of " + record_name() + " is not finite",
             in_.position() - size_of(type));
  }
  return value;
}

void PlyBinaryReader::add_corner(PlyType type) {
  const double vertex = take(type);
  if (vertex < 0 || vertex >= vertices_) {
    in_.fail(ErrorCode::BadIndex,
             record_name() + " names vertex " + std::to_string(static_cast<std::int64_t>(vertex)) +
                 "; there are " + std::to_string(vertices_),
             in_.position() - size_of(type));
  }
  mesh_.add_corner(static_cast<std::uint32_t>(vertex));
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
    if (header_.format == PlyFormat::Text) {
      PlyTextReader reader(in_, header_, mesh_);
      return read_elements(reader, in_.cursor());
    }
    PlyBinaryReader reader(data(), header_, mesh_, context_);
    return read_elements(reader, reader.input());
  }

 private:
  void expect();
  BinaryInput data() const;
  template <class Reader, class Input>
  MeshFile read_elements(Reader& reader, const Input& input) {
    return with_place(input, [&] {
      for (const PlyElement& element : header_.elements) {
        reader.read(element);
        pass_over(element, mesh_);
      }
      reader.require_end();
      return mesh_.take();
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

}  // namespace

MeshFile read_ply(std::string_view bytes, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return PlyReader(bytes, options, context).read();
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
