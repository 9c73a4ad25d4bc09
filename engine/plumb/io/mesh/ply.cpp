// Reading and writing of PLY: text elements, and binary elements of either byte order.
//
// Lengths of lists are untrusted: the lists of a record share what is left after all fixed parts
// (spare_), so no list can claim bytes that do not exist or that other properties need. All numbers
// up to 32 bits and floats are exact in doubles, which are used for every type. PlyGeometry takes
// the elements of both readers. It turns strips into triangles, and keeps faces away from vertices
// that are not finite. Format: G. Turk, The PLY polygon file format (Stanford University);
// docs/formats.md, section PLY.
// Tested by tests/io/ply_test.cpp.
#include "plumb/io/mesh/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/io/mesh/attribute_builder.h"
#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/ply_attributes.h"
#include "plumb/io/mesh/ply_header.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {
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

/// Whether three of the corners of a face differ. If they do not, the face has no area, and belongs
/// to no solid.
bool has_three_vertices(std::span<const std::uint32_t> face) {
  const auto is_other = [&](std::uint32_t v) { return v != face.front(); };
  const auto second = std::find_if(face.begin(), face.end(), is_other);
  return second != face.end() && std::any_of(second, face.end(), [&](std::uint32_t v) {
           return is_other(v) && v != *second;
         });
}

/// The data of both readers before the mesh is made: vertices, faces and strips. A vertex need not
/// be finite if no face with an area uses it.
class PlyGeometry {
 public:
  PlyGeometry(MeshCollector& mesh, const PlyHeader& header, Context& context)
      : mesh_(mesh),
        vertices_(header.vertex_count()),
        charge_(context),
        attributes_(header, context) {}

  MeshCollector& mesh() { return mesh_; }
  PlyAttributes& attributes() { return attributes_; }
  std::uint32_t vertex_count() const { return vertices_; }

  /// Whether faces may use vertex v. They may also use a vertex that has not been read yet.
  bool is_usable(std::uint32_t v) const { return missing_ == 0 || !is_missing_[v]; }
  /// If the face of the last corners has an area and a vertex that is not finite, returns this
  /// vertex.
  std::optional<std::uint32_t> needed_missing(std::size_t corners) const;
  /// Adds a vertex that is not finite. Returns false if a face needs it.
  bool add_missing_point();

  /// Adds the next vertex of a strip. From the third vertex on, each vertex makes a triangle with
  /// the two vertices before it. Every other triangle is reversed, so that all have the same
  /// orientation.
  void add_to_strip(std::uint32_t v);
  void end_strip();

  /// Returns the mesh with its notes.
  MeshFile take(const PlyHeader& header, std::uint64_t stray_bytes);

 private:
  void prepare_missing();

  MeshCollector& mesh_;
  std::uint32_t vertices_;
  MemoryCharge charge_;
  PlyAttributes attributes_;
  std::vector<bool> is_missing_, is_used_;  // For each vertex, from the first missing one on.
  std::uint32_t missing_ = 0;
  std::array<std::uint32_t, 2> strip_end_{};  // The last two vertices of the strip.
  std::uint32_t strip_length_ = 0;
};

std::optional<std::uint32_t> PlyGeometry::needed_missing(std::size_t corners) const {
  const auto face = std::span(mesh_.mesh().corners).last(corners);
  const auto found =
      std::find_if(face.begin(), face.end(), [&](std::uint32_t v) { return !is_usable(v); });
  return found != face.end() && has_three_vertices(face) ? std::optional(*found) : std::nullopt;
}

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
  const PolygonMesh& mesh = mesh_.mesh();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!has_three_vertices(mesh.face(f))) continue;
    for (const std::uint32_t v : mesh.face(f)) is_used_[v] = true;
  }
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

MeshFile PlyGeometry::take(const PlyHeader& header, std::uint64_t stray_bytes) {
  MeshFile file = mesh_.take();
  attributes_.give(file);
  if (!header.passed_over.empty()) file.notes.push_back("passed over: " + header.passed_over);
  if (!header.left_out.empty()) {
    file.warnings.push_back("geometry that was not read: " + header.left_out);
  }
  if (missing_ > 0) {
    file.notes.push_back("vertices that are not finite, used by no face with area: " +
                         std::to_string(missing_));
  }
  if (stray_bytes > 0) {
    file.notes.push_back("passed over: " + std::to_string(stray_bytes) +
                         " byte(s) behind the last element");
  }
  return file;
}

/// Whether a number in a list of strips ends a strip. It does if it is -1, or the value of -1 in
/// the unsigned type, and no vertex has this number.
bool ends_strip(double value, PlyType type, std::uint32_t vertices) {
  const double all_bits = type == PlyType::UInt8    ? 0xff
                          : type == PlyType::UInt16 ? 0xffff
                          : type == PlyType::UInt64 ? 0x1p64
                                                    : 0xffff'ffff;
  return value == -1 || (value == all_bits && value >= vertices);
}

/// Whether a number is that of a vertex. Lists of floats are allowed.
bool is_vertex(double value, std::uint32_t vertices) {
  return value >= 0 && value < vertices &&
         value == static_cast<double>(static_cast<std::uint32_t>(value));
}

// ---------------------------------------------------------------- text

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
  void read_corners(const PlyElement& element, const PlyProperty& property);
  void read_corner(const PlyElement& element, const PlyProperty& property);
  [[noreturn]] void fail_not_finite(std::uint32_t vertex, const char* where) const;
  void read_coordinate(ReadNumber& number);
  void read_other(const PlyElement& element, const PlyProperty& property);
  void skip_value();

  RecordReader& in_;
  PlyGeometry& geometry_;
  bool is_first_ = true;  // Whether no record has been read yet.
  bool is_free_form_ = false;
  bool may_wrap_ = false;          // Whether the values of a record may stand on several lines.
  const char* value_ = nullptr;    // The beginning of the last value.
  const char* missing_ = nullptr;  // The vertex has a coordinate that is not finite at this place.
  // The face has a corner whose vertex is not finite at this place.
  const char* unusable_ = nullptr;
  std::array<ReadNumber, 3> at_;
  ReadNumber whole_;
};

void PlyTextReader::read(const PlyElement& element) {
  if (element.properties.empty()) return;
  may_wrap_ = is_free_form_ || element.kind == Kind::Strips;
  if (element.kind == Kind::Face) {
    geometry_.attributes().begin_faces(geometry_.mesh().face_count());
  }
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
  if (is_free_form(element)) may_wrap_ = is_free_form_ = true;
}

/// Whether line breaks have no meaning. Some programs write all vertices on one line, or each value
/// on a separate line. The first line shows this. In all other files, each record is a line, so a
/// file that contradicts its header is detected earlier and better.
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
    case Role::Corners:
      return read_corners(element, property);
    case Role::None:
      return read_other(element, property);
    default:
      read_coordinate(at_[static_cast<std::size_t>(property.role) - 1]);
  }
}

/// Reads a property that is not geometry. Its values are stored if they are attributes.
void PlyTextReader::read_other(const PlyElement& element, const PlyProperty& property) {
  PlyAttributes& attributes = geometry_.attributes();
  const std::uint32_t count = property.length ? take_length("the length of a list") : 1;
  if (property.is_kept && property.length) attributes.begin_texture_list();
  for (std::uint32_t i = 0; i < count; ++i) {
    skip_value();
    if (!property.is_kept) continue;
    const AttributeNumber number = attribute_number(value_text());
    const double value = number.is_finite ? number.value : std::nan("");
    property.length ? attributes.add_texture(value) : attributes.add(element.kind, value);
  }
}

/// Moves to the next value of the record.
void PlyTextReader::find_value() {
  if (in_.cursor().at_line_end() && may_wrap_) in_.cursor().next_line();
  value_ = in_.cursor().position();
}

/// Returns the next number if a double can represent it; otherwise, a number that is not an
/// integer.
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

void PlyTextReader::read_corners(const PlyElement& element, const PlyProperty& property) {
  const std::uint32_t count = take_length("the number of corners");
  for (std::uint32_t i = 0; i < count; ++i) read_corner(element, property);
  if (unusable_ == nullptr) return;
  if (const auto vertex = geometry_.needed_missing(count)) fail_not_finite(*vertex, unusable_);
  unusable_ = nullptr;
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
  if (element.kind == Kind::Strips) {
    if (!geometry_.is_usable(v)) fail_not_finite(v, value_);
    return geometry_.add_to_strip(v);
  }
  if (!geometry_.is_usable(v) && unusable_ == nullptr) unusable_ = value_;
  geometry_.mesh().add_corner(v);
}

/// Reports a vertex that a face needs. Only a place in the current line can be reported.
void PlyTextReader::fail_not_finite(std::uint32_t vertex, const char* where) const {
  in_.cursor().fail(
      ErrorCode::NumberOutOfRange,
      in_.record_name() + " uses vertex " + std::to_string(vertex) + ", which is not finite",
      is_free_form_ ? nullptr : where);
}

void PlyTextReader::read_coordinate(ReadNumber& number) {
  find_value();
  if (!in_.cursor().at_line_end() && starts_not_finite(in_.cursor().rest())) {
    in_.cursor().token();
    missing_ = value_;
  } else {
    in_.read_number(number, "more properties");
  }
}

/// Skips a value of any form, because real files contain "nan".
void PlyTextReader::skip_value() {
  find_value();
  if (in_.cursor().at_line_end()) {
    in_.cursor().fail(ErrorCode::Syntax, in_.record_name() + " needs more properties");
  }
  in_.cursor().token();
}

/// Returns the number of bytes after the last element. Numbers are refused, because they may be
/// further elements.
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
        vertices_(geometry.vertex_count()),
        context_(context),
        total_bytes_(in_.position() + in_.bytes_left()) {}

  const BinaryInput& input() const { return in_; }

  void read(const PlyElement& element);
  std::uint64_t pass_over_rest() const { return in_.bytes_left(); }

 private:
  void read_property(const PlyProperty& property);
  void read_other(const PlyProperty& property);
  void read_corners(const PlyProperty& property);
  void end_record();
  std::uint64_t take_length(const PlyProperty& property);
  double take(PlyType type);
  double take_coordinate(PlyType type);
  template <class Number>
  void read_usual_corners(std::uint64_t count, PlyType type);
  void read_corner(double value, PlyType type);
  [[noreturn]] void fail_not_finite(std::uint32_t vertex, std::size_t at) const;
  std::string record_name() const {
    return std::string(name_of(kind_)) + ' ' + std::to_string(std::uint64_t{index_} + 1);
  }

  BinaryInput in_;
  PlyFormat format_;
  PlyGeometry& geometry_;
  std::uint32_t vertices_;
  Context& context_;
  std::size_t total_bytes_;
  Kind kind_ = Kind::Other;  // The kind of the record.
  std::uint32_t index_ = 0;
  std::uint64_t spare_ = 0;  // The number of bytes that are available for the lists of this record.
  std::array<double, 3> at_{};
  std::size_t missing_ = 0;   // The place of the coordinate of this vertex that is not finite.
  std::size_t unusable_ = 0;  // The place of the corner of this face whose vertex is not finite.
};

/// Reads the records of one element. Before each, the bytes of its fixed parts must exist; what is
/// left beyond these may be used by its lists.
void PlyBinaryReader::read(const PlyElement& element) {
  constexpr std::uint32_t kRecordsPerCheckpoint = 4096;
  if (element.properties.empty()) return;
  const std::uint64_t least = element.least_bytes(format_);
  kind_ = element.kind;
  if (kind_ == Kind::Face) geometry_.attributes().begin_faces(geometry_.mesh().face_count());
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
    read_corners(property);
  } else if (property.role == Role::None) {
    read_other(property);
  } else {
    at_[static_cast<std::size_t>(property.role) - 1] = take_coordinate(property.type);
  }
}

/// Reads a property that is not geometry. Its values are stored if they are attributes.
void PlyBinaryReader::read_other(const PlyProperty& property) {
  const std::uint64_t count = property.length ? take_length(property) : 1;
  if (!property.is_kept) return in_.skip(count * size_of(property.type));
  PlyAttributes& attributes = geometry_.attributes();
  if (!property.length) return attributes.add(kind_, take(property.type));
  attributes.begin_texture_list();
  for (std::uint64_t i = 0; i < count; ++i) attributes.add_texture(take(property.type));
}

void PlyBinaryReader::read_corners(const PlyProperty& property) {
  const std::uint64_t count = take_length(property);
  if (kind_ == Kind::Face && property.type == PlyType::Int32) {
    read_usual_corners<std::int32_t>(count, property.type);
  } else if (kind_ == Kind::Face && property.type == PlyType::UInt32) {
    read_usual_corners<std::uint32_t>(count, property.type);
  } else {
    for (std::uint64_t i = 0; i < count; ++i) read_corner(take(property.type), property.type);
  }
  if (unusable_ == 0) return;
  if (const auto vertex = geometry_.needed_missing(count)) fail_not_finite(*vertex, unusable_);
  unusable_ = 0;
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

/// Returns the next value, which a double holds exactly; integers of 64 bits may be rounded.
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
    case PlyType::Int64:
      return static_cast<double>(in_.take<std::int64_t>());
    case PlyType::UInt64:
      return static_cast<double>(in_.take<std::uint64_t>());
    default:
      return in_.take<double>();
  }
}

double PlyBinaryReader::take_coordinate(PlyType type) {
  constexpr double kMostExact = 0x1p53;
  const double value = take(type);
  const bool is_long = type == PlyType::Int64 || type == PlyType::UInt64;
  if (is_long && std::fabs(value) > kMostExact) {
    in_.fail(ErrorCode::NumberOutOfRange, "a coordinate of more than 53 bits",
             in_.position() - size_of(type));
  }
  if (!std::isfinite(value)) missing_ = in_.position() - size_of(type);
  return value;
}

/// Reads the corners of a face in one of the types that nearly all files use. This function takes a
/// large part of the time.
template <class Number>
void PlyBinaryReader::read_usual_corners(std::uint64_t count, PlyType type) {
  for (; count > 0; --count) {
    const auto v = in_.take<Number>();
    if (std::cmp_greater_equal(v, 0) && std::cmp_less(v, vertices_) &&
        geometry_.is_usable(static_cast<std::uint32_t>(v))) {
      geometry_.mesh().add_corner(static_cast<std::uint32_t>(v));
    } else {
      read_corner(v, type);
    }
  }
}

/// Processes a number of a list of corners or strips that has just been read.
void PlyBinaryReader::read_corner(double value, PlyType type) {
  const std::size_t at = in_.position() - size_of(type);
  if (kind_ == Kind::Strips && ends_strip(value, type, vertices_)) return geometry_.end_strip();
  if (!is_vertex(value, vertices_)) {
    in_.fail(ErrorCode::BadIndex,
             record_name() + " names vertex " + format_double(value) + "; there are " +
                 std::to_string(vertices_),
             at);
  }
  const auto v = static_cast<std::uint32_t>(value);
  if (kind_ == Kind::Strips) {
    if (!geometry_.is_usable(v)) fail_not_finite(v, at);
    return geometry_.add_to_strip(v);
  }
  if (!geometry_.is_usable(v) && unusable_ == 0) unusable_ = at;
  geometry_.mesh().add_corner(v);
}

/// Reports a vertex that a face needs.
void PlyBinaryReader::fail_not_finite(std::uint32_t vertex, std::size_t at) const {
  in_.fail(ErrorCode::NumberOutOfRange,
           record_name() + " uses vertex " + std::to_string(vertex) + ", which is not finite", at);
}

// ---------------------------------------------------------------- both

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const ReadOptions& options, Context& context)
      : in_(bytes, options, context, "the mesh"),
        bytes_(bytes),
        name_(options.name),
        keeps_attributes_(options.attributes),
        mesh_(context),
        context_(context) {}

  MeshFile read() {
    with_place(in_.cursor(), [this] {
      header_ = read_ply_header(in_, keeps_attributes_);
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
      return geometry.take(header_, reader.pass_over_rest());
    });
  }

  RecordReader in_;
  std::string_view bytes_;
  const std::string& name_;
  bool keeps_attributes_;
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

/// Returns the text after the line break of the header.
BinaryInput PlyReader::data() const {
  const std::size_t end = in_.cursor().bytes_read();
  const std::endian order =
      header_.format == PlyFormat::BigEndian ? std::endian::big : std::endian::little;
  return {bytes_, std::min(end + 1, bytes_.size()), order, name_};
}

/// If the lines of a file end with CR, returns the number of bytes in lines: the header, and the
/// elements if they are text.
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

// Attributes. Every property is a byte of a colour, a double, or the id of a face.

/// A property of vertices: one number of a channel.
struct WrittenProperty {
  const MeshChannel* channel;
  std::size_t part;  ///< The index of the number in the channel.
  bool is_byte;
  std::string name;
};

/// Returns the name of a number of a channel.
std::string property_name(const MeshChannel& channel, std::size_t part) {
  constexpr std::array<std::string_view, 4> kColor{"red", "green", "blue", "alpha"};
  constexpr std::array<std::string_view, 3> kNormal{"nx", "ny", "nz"};
  constexpr std::array<std::string_view, 2> kTexture{"s", "t"};
  if (channel.name == "color" && (channel.width == 3 || channel.width == 4)) {
    return std::string(kColor[part]);
  }
  if (channel.name == "normal" && channel.width == 3) return std::string(kNormal[part]);
  if (channel.name == "texcoord_0" && channel.width == 2) return std::string(kTexture[part]);
  std::string name = channel.name.empty() ? "channel" : channel.name;
  const bool is_coordinate = name == "x" || name == "y" || name == "z";
  if (is_coordinate) name = "channel_" + name;
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  }
  return channel.width == 1 ? name : name + '_' + std::to_string(part);
}

std::vector<WrittenProperty> properties_of(const MeshAttributes& attributes) {
  std::vector<WrittenProperty> properties;
  for (const MeshChannel& channel : attributes.channels) {
    const bool is_color = channel.name == "color" && (channel.width == 3 || channel.width == 4);
    const bool has_bytes = is_color && are_bytes(channel.values);
    for (std::size_t i = 0; i < channel.width; ++i) {
      properties.push_back({&channel, i, has_bytes, property_name(channel, i)});
    }
  }
  return properties;
}

/// The properties of faces.
struct WrittenFaces {
  bool has_color = false;
  bool has_bytes = false;    ///< Whether bytes hold all colours.
  bool has_opacity = false;  ///< Whether a colour is not opaque.
  bool has_id = false;
};

constexpr std::array<double, 4> kNoColor{1, 1, 1, 1};

WrittenFaces faces_of(const MeshAttributes& attributes) {
  WrittenFaces faces{false, true, false, !attributes.face_id.empty()};
  if (attributes.face_material.empty()) return faces;
  for (const MeshMaterial& material : attributes.materials) {
    if (!material.color) continue;
    faces.has_color = true;
    faces.has_bytes = faces.has_bytes && are_bytes(*material.color);
    faces.has_opacity |= (*material.color)[3] != 1;
  }
  return faces;
}

/// Returns the colour of a face. A face without a colour is white.
std::array<double, 4> color_of_face(const MeshAttributes& attributes, std::size_t face) {
  const std::uint32_t material = attributes.face_material[face];
  if (material == MeshAttributes::kNone) return kNoColor;
  return attributes.materials[material].color.value_or(kNoColor);
}

void write_header(TextOutput& out, std::string_view format, const PolygonMesh& mesh,
                  CornerTypes types, const std::vector<WrittenProperty>& properties,
                  const WrittenFaces& faces) {
  out << "ply\nformat " << format << " 1.0\ncomment plumb\n";
  out << "element vertex " << std::uint64_t{mesh.points.size()};
  out << "\nproperty double x\nproperty double y\nproperty double z\n";
  for (const WrittenProperty& property : properties) {
    out << "property " << (property.is_byte ? "uchar " : "double ") << property.name << '\n';
  }
  out << "element face " << std::uint64_t{mesh.face_count()};
  out << "\nproperty list " << (types.short_length ? "uchar" : "uint");
  out << (types.is_signed ? " int" : " uint") << " vertex_indices\n";
  if (faces.has_color) {
    for (const char* name : {"red", "green", "blue", "alpha"}) {
      if (std::string_view(name) == "alpha" && !faces.has_opacity) continue;
      out << "property " << (faces.has_bytes ? "uchar " : "double ") << name << '\n';
    }
  }
  if (faces.has_id) out << "property uint face_id\n";
  out << "end_header\n";
}

/// Writes numbers as text. Each number except the first of a line follows a blank.
class PlyTextNumbers {
 public:
  explicit PlyTextNumbers(TextOutput& out) : out_(out) {}
  void number(double value) { separated() << value; }
  void byte(std::uint32_t value) { separated() << value; }
  void length(std::uint32_t value, bool /*is_short*/) { separated() << value; }
  void integer(std::uint32_t value) { separated() << value; }
  void end_record() {
    out_ << '\n';
    is_first_ = true;
  }

 private:
  TextOutput& separated() {
    if (!is_first_) out_ << ' ';
    is_first_ = false;
    return out_;
  }

  TextOutput& out_;
  bool is_first_ = true;
};

/// Writes numbers in binary.
class PlyBinaryNumbers {
 public:
  explicit PlyBinaryNumbers(TextOutput& out) : out_(out) {}
  void number(double value) { put_little_endian(out_, value); }
  void byte(std::uint32_t value) { out_ << static_cast<char>(value); }
  void length(std::uint32_t value, bool is_short) { is_short ? byte(value) : integer(value); }
  void integer(std::uint32_t value) { put_little_endian(out_, value); }
  void end_record() {}

 private:
  TextOutput& out_;
};

template <class Numbers>
void write_vertex_records(Numbers numbers, const PolygonMesh& mesh,
                          const std::vector<std::uint32_t>& corner_of_vertex,
                          const std::vector<WrittenProperty>& properties) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Point3& p = mesh.points[v];
    for (const double value : {p.x, p.y, p.z}) numbers.number(value);
    const std::uint32_t corner = properties.empty() ? 0 : corner_of_vertex[v];
    for (const WrittenProperty& property : properties) {
      const bool is_used = corner != MeshAttributes::kNone;
      const double value = is_used ? values_at(*property.channel, corner)[property.part] : 0;
      property.is_byte ? numbers.byte(byte_of(value)) : numbers.number(value);
    }
    numbers.end_record();
  }
}

template <class Numbers>
void write_face_records(Numbers numbers, const PolygonMesh& mesh, CornerTypes types,
                        const MeshAttributes& attributes, const WrittenFaces& faces) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    numbers.length(static_cast<std::uint32_t>(face.size()), types.short_length);
    for (const std::uint32_t v : face) numbers.integer(v);
    if (faces.has_color) {
      const std::array<double, 4> color = color_of_face(attributes, f);
      for (std::size_t i = 0; i < (faces.has_opacity ? 4U : 3U); ++i) {
        faces.has_bytes ? numbers.byte(byte_of(color[i])) : numbers.number(color[i]);
      }
    }
    if (faces.has_id) numbers.integer(attributes.face_id[f]);
    numbers.end_record();
  }
}

template <class Numbers>
void write_ply(std::ostream& stream, std::string_view format, const PolygonMesh& mesh,
               const MeshAttributes& attributes) {
  require_doubles(mesh);
  const std::vector<WrittenProperty> properties = properties_of(attributes);
  const WrittenFaces faces = faces_of(attributes);
  std::vector<const MeshChannel*> channels;
  for (const MeshChannel& channel : attributes.channels) channels.push_back(&channel);
  const SplitMesh split = channels.empty() ? SplitMesh{} : split_vertices(mesh, channels);
  const PolygonMesh& written = channels.empty() ? mesh : split.mesh;
  const CornerTypes types = types_for(written);
  TextOutput out(stream);
  write_header(out, format, written, types, properties, faces);
  write_vertex_records(Numbers(out), written, split.corner_of_vertex, properties);
  write_face_records(Numbers(out), written, types, attributes, faces);
  out.flush();
}

}  // namespace

void write_ply_text(std::ostream& stream, const PolygonMesh& mesh,
                    const MeshAttributes& attributes) {
  write_ply<PlyTextNumbers>(stream, "ascii", mesh, attributes);
}

void write_ply_binary(std::ostream& stream, const PolygonMesh& mesh,
                      const MeshAttributes& attributes) {
  write_ply<PlyBinaryNumbers>(stream, "binary_little_endian", mesh, attributes);
}

}  // namespace plumb
