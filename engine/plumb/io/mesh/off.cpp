// Reading and writing of OFF.
//
// OFF is a sequence of numbers, and only the colour of a face ends with its line. Most files have a
// record a line, however, and many of these have numbers behind the coordinates that the keyword
// does not announce. Therefore the text is read line by line first. If this fails, the layouts in
// which records share lines, or extend over several lines, are tried in a fixed order, unless the
// number of lines equals the number of records. A layout fits only if the announced records use up
// all numbers of the text. If no layout fits, the reader reports the error of the layout that the
// number of lines suggests. Numbers beyond coordinates and corners are dropped without being
// parsed (exporters write nan there), and noted.
//
// The counts are compared with the bytes that follow, at the least number of bytes that a vertex or
// face can take, before memory is reserved; so a short file cannot claim a large mesh.
// Format: docs/formats.md, section OFF. Tested by tests/io/off_test.cpp.
#include "plumb/io/mesh/off.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "plumb/io/mesh/attribute_builder.h"
#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/line_writer.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/strong_id.h"

namespace plumb {
namespace {

constexpr std::uint32_t kColourNumbers = 4;

bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// Takes `word`, which has only capital letters, from the front of `text` in any case.
bool take_word(std::string_view& text, std::string_view word) {
  const auto fits = [](char c, char letter) { return c == letter || c == letter - 'A' + 'a'; };
  if (text.size() < word.size()) return false;
  if (!std::equal(word.begin(), word.end(), text.begin(),
                  [&](char letter, char c) { return fits(c, letter); })) {
    return false;
  }
  text.remove_prefix(word.size());
  return true;
}

/// What the keyword announces.
struct OffKeyword {
  bool has_texture = false;
  bool has_colour = false;
  bool has_normal = false;
  bool is_flat = true;  ///< Whether the vertices have three coordinates: neither 4OFF nor nOFF.

  /// How many numbers follow the coordinates of a vertex, besides those of the colour.
  std::uint32_t fixed_numbers() const { return (has_normal ? 3U : 0U) + (has_texture ? 2U : 0U); }
};

/// Takes the keyword [ST][C][N][4][n]OFF, whose letters may be small, from the front of `word`.
/// Returns nullopt if there is none. The n of nOFF announces a dimension, that of noff normals.
std::optional<OffKeyword> take_keyword(std::string_view& word) {
  OffKeyword keyword;
  std::string_view rest = word;
  while (!take_word(rest, "OFF")) {
    if (rest.starts_with('4') || rest.starts_with("nOFF")) {
      keyword.is_flat = false;
      rest.remove_prefix(1);
    } else if (take_word(rest, "ST")) {
      keyword.has_texture = true;
    } else if (take_word(rest, "C")) {
      keyword.has_colour = true;
    } else if (take_word(rest, "N")) {
      keyword.has_normal = true;
    } else {
      return {};
    }
  }
  word = rest;
  return keyword;
}

std::string announcement(std::uint32_t vertices, std::uint32_t faces) {
  return std::to_string(vertices) + " vertices and " + std::to_string(faces) + " faces";
}

void note_attributes(const OffKeyword& keyword, MeshCollector& mesh) {
  if (keyword.has_normal) mesh.pass_over("normals of vertices");
  if (keyword.has_colour) mesh.pass_over("colours of vertices");
  if (keyword.has_texture) mesh.pass_over("texture coordinates");
}

// ---------------------------------------------------------------- attributes

/// Keeps the numbers behind coordinates and corners if the caller asks for them. On the line of a
/// vertex they are, in this order, the normal, the colour and the texture coordinates.
class OffAttributes {
 public:
  OffAttributes(bool is_wanted, Context& context)
      : is_wanted_(is_wanted), charge_(context), builder_(context) {}

  bool is_wanted() const { return is_wanted_; }
  /// Takes the next number of the record, if attributes are wanted.
  void add(std::string_view token) {
    if (is_wanted_) add(attribute_number(token));
  }
  void add(double value) {
    if (is_wanted_) add({std::isfinite(value) ? value : 0, false, std::isfinite(value)});
  }
  /// End a record. Require that attributes are wanted.
  void end_vertex(const OffKeyword& keyword);
  void end_face();
  void clear();
  /// Adds the attributes to the file, and notes for what they do not hold.
  void give(MeshFile& file);

 private:
  static constexpr std::size_t kMostNumbers = 9;  // A normal, a colour and a texture of a vertex.

  void add(const AttributeNumber& number) {
    if (!number.is_finite) ++not_finite_;
    if (count_ < kMostNumbers) numbers_[count_++] = number;
  }
  template <class Record>
  void push(std::vector<Record>& records, const Record& record);
  StatedColor color_from(std::size_t first, std::size_t end) const;
  void give_faces(std::vector<std::string>& notes);
  void give_vertices(const PolygonMesh& mesh);

  bool is_wanted_;
  MemoryCharge charge_;
  AttributeBuilder builder_;
  std::array<AttributeNumber, kMostNumbers> numbers_;
  std::size_t count_ = 0;
  std::size_t not_finite_ = 0;
  std::vector<double> normals_, textures_;
  std::vector<StatedColor> vertex_colors_, face_colors_;
};

/// Appends a record and charges its memory if the vector grows.
template <class Record>
void OffAttributes::push(std::vector<Record>& records, const Record& record) {
  constexpr std::size_t kLeast = 64;
  if (records.size() == records.capacity()) {
    const std::size_t capacity = std::max(2 * records.size(), kLeast);
    charge_.add((capacity - records.size()) * sizeof(Record), "the attributes of the mesh");
    records.reserve(capacity);
  }
  records.push_back(record);
}

StatedColor OffAttributes::color_from(std::size_t first, std::size_t end) const {
  StatedColor color;
  for (std::size_t i = first; i < std::min(end, first + kColourNumbers); ++i) {
    color.add(numbers_[i].value, numbers_[i].is_whole);
  }
  return color;
}

void OffAttributes::end_vertex(const OffKeyword& keyword) {
  const std::size_t first = keyword.has_normal ? 3 : 0;
  const std::size_t textures = keyword.has_texture ? 2 : 0;
  if (keyword.has_normal) {
    for (std::size_t i = 0; i < 3; ++i) push(normals_, numbers_[i].value);
  }
  const std::size_t end = keyword.has_colour ? std::max(count_ - textures, first) : first;
  if (keyword.has_colour) push(vertex_colors_, color_from(first, end));
  for (std::size_t i = end; i < end + textures; ++i) push(textures_, numbers_[i].value);
  count_ = 0;
}

void OffAttributes::end_face() {
  push(face_colors_, color_from(0, count_));
  count_ = 0;
}

void OffAttributes::clear() {
  for (auto* numbers : {&normals_, &textures_}) numbers->clear();
  for (auto* colors : {&vertex_colors_, &face_colors_}) colors->clear();
  count_ = not_finite_ = 0;
}

void OffAttributes::give(MeshFile& file) {
  if (!is_wanted_) return;
  give_faces(file.notes);
  give_vertices(file.mesh);
  if (not_finite_ > 0) {
    file.notes.push_back("colours, normals or texture coordinates that are no finite numbers, " +
                         ("read as 0: " + std::to_string(not_finite_)));
  }
  file.attributes = builder_.take(file.mesh);
}

/// A single number is the index of a colour in a table that the file does not have. It becomes the
/// name of a material without a colour.
void OffAttributes::give_faces(std::vector<std::string>& notes) {
  const ColorScale scale(face_colors_);
  bool has_others = false;
  for (std::size_t f = 0; f < face_colors_.size(); ++f) {
    const StatedColor& color = face_colors_[f];
    if (color.count >= 3) {
      builder_.set_material(f, builder_.material_of(scale(color)));
    } else if (color.count == 1 && color.is_whole) {
      const auto index = static_cast<std::int64_t>(std::clamp(color.parts[0], -1e9, 1e9));
      builder_.set_material(f, builder_.material_named(std::to_string(index)));
    } else {
      has_others |= color.count > 0;
    }
  }
  if (has_others)
    notes.emplace_back("passed over: colours of faces that are not 1, 3 or 4 numbers");
}

void OffAttributes::give_vertices(const PolygonMesh& mesh) {
  const auto has_numbers = [](const StatedColor& color) { return color.count >= 3; };
  if (std::any_of(vertex_colors_.begin(), vertex_colors_.end(), has_numbers)) {
    const ColorScale scale(vertex_colors_);
    const bool has_opacity =
        std::any_of(vertex_colors_.begin(), vertex_colors_.end(),
                    [](const StatedColor& color) { return color.count == kColourNumbers; });
    const std::uint32_t width = has_opacity ? 4 : 3;
    std::vector<double> values;
    charge_.add(vertex_colors_.size() * width * sizeof(double), "the attributes of the mesh");
    values.reserve(vertex_colors_.size() * width);
    for (const StatedColor& color : vertex_colors_) {
      const std::array<double, 4> parts =
          has_numbers(color) ? scale(color) : std::array<double, 4>{1, 1, 1, 1};
      values.insert(values.end(), parts.begin(), parts.begin() + width);
    }
    builder_.add_of_vertices("color", width, values, mesh);
  }
  if (!normals_.empty()) builder_.add_of_vertices("normal", 3, normals_, mesh);
  if (!textures_.empty()) builder_.add_of_vertices("texcoord_0", 2, textures_, mesh);
}

// ---------------------------------------------------------------- text

// The shortest records: "0 0 0" and "0", each with a blank.
constexpr std::uint64_t kVertexBytes = 6;
constexpr std::uint64_t kFaceBytes = 2;

/// How the records of a file lie in its lines.
struct Layout {
  /// Whether each vertex has a line of its own. All that follows its coordinates there is dropped.
  bool has_vertex_lines;
  bool has_face_lines;  ///< Whether each face has a line of its own.
  /// Whether up to four numbers between the corners of a face and the end of the line are a colour.
  bool has_face_colours;
};

constexpr std::array<Layout, 5> kLayouts{{{true, true, true},
                                          {true, false, true},
                                          {true, false, false},
                                          {false, false, true},
                                          {false, false, false}}};

/// Returns how many lines have more than blanks and a comment.
std::size_t count_lines(std::string_view text) {
  std::size_t lines = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t first = text.find_first_not_of(" \t\r", at);
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
    if (first < at && text[first] != '\n' && text[first] != '#') ++lines;
  }
  return lines;
}

class OffReader {
 public:
  OffReader(std::string_view text, const ReadOptions& options, Context& context)
      : in_(text, options, context, "the mesh", ResultNumbers::Fractions),
        mesh_(context),
        attributes_(options.attributes, context) {}

  /// Reads the keyword, which may be missing. Returns whether it announces the binary form; the
  /// cursor is then at the first byte of that.
  bool read_keyword();
  /// Reads what follows the keyword.
  MeshFile read() {
    return with_place(cursor(), [this] {
      read_counts();
      read_records();
      return take();
    });
  }

  const OffKeyword& keyword() const { return keyword_; }
  std::size_t bytes_read() { return cursor().bytes_read(); }

 private:
  void read_counts();
  void skip_edges();
  void read_records();
  void read_as(const Layout& layout);
  void skip_rest_of_counts();
  const Error& likely_error(std::size_t lines, const std::vector<Error>& errors) const;
  std::size_t record_count() const { return std::size_t{vertices_} + faces_; }
  void begin_record(std::string_view what, std::uint32_t index, std::uint32_t count,
                    bool has_lines);
  void read_vertex(bool has_lines);
  void skip_rest_of_vertex();
  void skip_numbers(std::uint32_t count);
  void read_face(const Layout& layout);
  void skip_face_colour(bool has_lines);
  void require_end();
  MeshFile take();
  TextCursor& cursor() { return in_.cursor(); }
  [[noreturn]] void fail(ErrorCode code, std::string message, const char* where = nullptr) {
    cursor().fail(code, std::move(message), where);
  }

  /// What a layout has found.
  struct Found {
    /// How many numbers follow the coordinates on the line of a vertex. Unless the keyword
    /// announces colours, which may be missing, vertex 1 decides.
    std::uint32_t least = 0;
    std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
    bool has_more_numbers = false;  // Behind coordinates, besides those that are announced.
    bool has_more_counts = false;
    std::optional<std::uint32_t> face_colour;  // How many numbers it has, at most.
    std::string tail;                          // What follows the last face.
  };

  RecordReader in_;
  MeshCollector mesh_;
  OffAttributes attributes_;
  OffKeyword keyword_;
  std::size_t counts_line_ = 0;
  std::uint32_t vertices_ = 0;
  std::uint32_t faces_ = 0;
  Found found_;
  std::uint32_t required_ = kNone;  // A vertex that must be finite.
  ReadNumber x_, y_, z_;
};

/// The counts may follow the keyword at once, even without a blank ("OFF8 6 12").
bool OffReader::read_keyword() {
  if (!cursor().next_line()) {
    fail(ErrorCode::CountMismatch, "the file has no content; expected OFF");
  }
  const std::string_view rest = cursor().rest();
  const std::string_view token = rest.substr(0, rest.find_first_of(" \t\r\n"));
  std::string_view word = token;
  const std::optional<OffKeyword> keyword = take_keyword(word);
  if (!keyword) {
    if (token.empty() || !is_digit(token.front())) cursor().fail_token(cursor().token(), "OFF");
    return false;
  }
  if (!keyword->is_flat) {
    fail(ErrorCode::UnknownFormat,
         quoted(token) +
             ": only vertices of three coordinates are read; convert the file to plain OFF");
  }
  keyword_ = *keyword;
  cursor().skip(token.size() - word.size());
  if (cursor().at_line_end_or_comment()) return false;
  const TextCursor before = cursor();
  std::string_view binary = cursor().token();
  if (!take_word(binary, "BINARY") || !binary.empty()) {
    cursor() = before;
    return false;
  }
  if (!cursor().at_line_end() || cursor().bytes_left() == 0) {
    in_.end_line("the end of the line after BINARY");
    fail(ErrorCode::CountMismatch, "the file ends where its binary part is expected");
  }
  cursor().skip(1);
  return true;
}

void OffReader::read_counts() {
  if (!cursor().find_token()) {
    fail(ErrorCode::CountMismatch,
         "the file ends where the numbers of vertices, faces and edges are expected");
  }
  counts_line_ = cursor().line();
  const char* const start = cursor().position();
  vertices_ = in_.read_count("the number of vertices");
  cursor().find_token();
  faces_ = in_.read_count("the number of faces");
  in_.require_bytes(vertices_ * kVertexBytes + faces_ * kFaceBytes, announcement(vertices_, faces_),
                    cursor().line() == counts_line_ ? start : nullptr);
  skip_edges();
}

/// The number of edges follows on the same line, or it is alone on the next line, or it is missing.
void OffReader::skip_edges() {
  if (!cursor().at_line_end_or_comment()) {
    cursor().token();
    return;
  }
  const TextCursor before = cursor();
  if (!cursor().next_line()) return;
  cursor().token();
  if (!cursor().at_line_end_or_comment()) cursor() = before;
}

/// Reads the records in the first layout that fits. If a file has as many lines as records, each
/// record is assumed to be a line, and a record that does not fit is an error.
void OffReader::read_records() {
  const TextCursor start = cursor();
  const bool shares_line = !cursor().at_line_end_or_comment();  // Of the counts and a record.
  std::vector<Error> errors;
  std::size_t lines = 0;
  for (const Layout& layout : kLayouts) {
    try {
      return read_as(layout);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::ResourceLimit || error.code() == ErrorCode::Cancelled) throw;
      errors.push_back(error);
    }
    if (errors.size() == 1) lines = count_lines(start.rest());
    if (lines == record_count() && !shares_line) break;
    cursor() = start;
    mesh_.clear();
  }
  const bool ends_early = errors.front().code() == ErrorCode::CountMismatch && !shares_line;
  throw ends_early ? errors.front() : likely_error(lines, errors);
}

/// Returns the error of the layout that the number of lines suggests.
const Error& OffReader::likely_error(std::size_t lines, const std::vector<Error>& errors) const {
  constexpr std::size_t kOneIn = 4;
  const std::size_t slack = record_count() / kOneIn;
  if (lines + slack < record_count()) return errors.back();  // Records share lines.
  return lines > record_count() + slack ? errors[1] : errors.front();
}

void OffReader::read_as(const Layout& layout) {
  const TextCursor start = cursor();
  mesh_.expect(vertices_, faces_);
  attributes_.clear();
  found_ = {};
  found_.least = keyword_.fixed_numbers();
  if (keyword_.has_colour) found_.most = found_.least + kColourNumbers;
  if (layout.has_vertex_lines) skip_rest_of_counts();
  for (std::uint32_t i = 0; i < vertices_; ++i) {
    begin_record("vertex", i, vertices_, layout.has_vertex_lines);
    read_vertex(layout.has_vertex_lines);
  }
  for (std::uint32_t i = 0; i < faces_; ++i) {
    begin_record("face", i, faces_, layout.has_face_lines);
    read_face(layout);
  }
  require_end();
  if (const auto vertex = mesh_.needed_missing_point()) {
    required_ = *vertex;
    cursor() = start;
    mesh_.clear();
    read_as(layout);  // Throws at the vertex.
  }
}

void OffReader::skip_rest_of_counts() {
  while (!cursor().at_line_end_or_comment()) {
    cursor().token();
    found_.has_more_counts = true;
  }
}

void OffReader::begin_record(std::string_view what, std::uint32_t index, std::uint32_t count,
                             bool has_lines) {
  if (has_lines) return in_.next_record(what, index, count);
  in_.begin_record(what, index);
  if (cursor().find_token()) return;
  fail(ErrorCode::CountMismatch, "the file ends where " + in_.record_name() + " of " +
                                     std::to_string(count) + " is expected");
}

/// A vertex need not be finite if no face needs it.
void OffReader::read_vertex(bool has_lines) {
  bool is_missing = false;
  for (ReadNumber* number : {&x_, &y_, &z_}) {
    if (!has_lines) cursor().find_token();
    if (in_.read_number_if_finite(*number, "three numbers, x, y and z")) continue;
    const std::string_view token = cursor().token();
    if (mesh_.point_count() == required_) cursor().fail_token(token, "a number");
    is_missing = true;
  }
  if (is_missing) {
    mesh_.add_missing_point();
  } else {
    mesh_.add_point(x_, y_, z_);
  }
  if (!has_lines) {
    skip_numbers(keyword_.fixed_numbers() + (keyword_.has_colour ? kColourNumbers : 0));
  } else if (found_.most > 0 || !cursor().at_line_end()) {
    skip_rest_of_vertex();
  }
  if (attributes_.is_wanted()) attributes_.end_vertex(keyword_);
}

/// Drops what follows the coordinates on the line of a vertex.
void OffReader::skip_rest_of_vertex() {
  std::uint32_t count = 0;
  for (; !cursor().at_line_end_or_comment(); ++count) {
    if (count == found_.most) {
      in_.end_line("the end of the line after the coordinates of " + in_.record_name());
    }
    attributes_.add(cursor().token());
  }
  if (count < keyword_.fixed_numbers()) {
    fail(ErrorCode::Syntax, in_.record_name() + " lacks numbers that the first line announces");
  }
  if (count < found_.least) {
    fail(ErrorCode::Syntax, in_.record_name() + " has fewer numbers than vertex 1");
  }
  if (keyword_.has_colour) return;
  found_.least = found_.most = count;
  found_.has_more_numbers = count > keyword_.fixed_numbers();
}

void OffReader::skip_numbers(std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!cursor().find_token()) {
      fail(ErrorCode::Syntax, in_.record_name() + " lacks numbers that the first line announces");
    }
    attributes_.add(cursor().token());
  }
}

void OffReader::read_face(const Layout& layout) {
  const std::uint32_t corners = in_.read_count("the number of corners");
  for (std::uint32_t i = 0; i < corners; ++i) {
    if (!layout.has_face_lines) cursor().find_token();
    mesh_.add_corner(in_.read_index("vertex", vertices_));
  }
  mesh_.end_face();
  if (!layout.has_face_lines && corners == 0)
    fail(ErrorCode::Syntax, in_.record_name() + " has no corners");
  if (layout.has_face_colours) skip_face_colour(layout.has_face_lines);
  if (attributes_.is_wanted()) attributes_.end_face();
}

/// If faces are not lines, all of them must have a colour of the same form. Otherwise, numbers of a
/// layout that does not fit would be taken for colours.
void OffReader::skip_face_colour(bool has_lines) {
  std::uint32_t count = 0;
  for (; count < kColourNumbers && !cursor().at_line_end_or_comment(); ++count) {
    attributes_.add(cursor().token());
  }
  if (has_lines && !cursor().at_line_end_or_comment()) {
    in_.end_line("the end of the line after the corners and colour of " + in_.record_name());
  }
  if (!found_.face_colour) found_.face_colour = count;
  if (has_lines) {
    found_.face_colour = std::max(*found_.face_colour, count);
  } else if (count != *found_.face_colour) {
    fail(ErrorCode::Syntax, in_.record_name() + " has another number of numbers than face 1");
  }
}

/// Numbers after the last face contradict the counts. Words do not, and are passed over.
void OffReader::require_end() {
  if (!cursor().find_token()) return;
  const std::string_view token = cursor().token();
  if (is_digit(token.front()) || token.front() == '-') {
    fail(ErrorCode::CountMismatch,
         "there is more after the last face; line " + std::to_string(counts_line_) + " announces " +
             std::to_string(faces_) + " faces",
         token.data());
  }
  found_.tail = quoted(token) + " in line " + std::to_string(cursor().line());
}

MeshFile OffReader::take() {
  if (!attributes_.is_wanted()) note_attributes(keyword_, mesh_);
  if (found_.has_more_numbers) mesh_.pass_over("numbers behind the coordinates of vertices");
  if (found_.face_colour.value_or(0) > 0 && !attributes_.is_wanted()) {
    mesh_.pass_over("colours of faces");
  }
  if (found_.has_more_counts) mesh_.pass_over("numbers behind the counts");
  MeshFile file = mesh_.take();
  attributes_.give(file);
  if (!found_.tail.empty()) {
    file.warnings.push_back("what follows the last face was not read: " + found_.tail);
  }
  return file;
}

// ---------------------------------------------------------------- binary

/// Reads the binary form, as Geomview does. The line of the keyword is followed by integers and
/// floats of 32 bits in big-endian order. After its corners, a face has the count of the numbers of
/// its colour, and these numbers.
class OffBinaryReader {
 public:
  OffBinaryReader(std::string_view bytes, std::size_t start, const OffKeyword& keyword,
                  const ReadOptions& options, Context& context)
      : in_(bytes, start, std::endian::big, options.name),
        keyword_(keyword),
        mesh_(context),
        attributes_(options.attributes, context),
        context_(context),
        total_bytes_(bytes.size()) {}

  MeshFile read() {
    return with_place(in_, [this] {
      read_counts();
      for (std::uint32_t i = 0; i < vertices_; ++i) read_vertex(i);
      for (std::uint32_t i = 0; i < faces_; ++i) read_face(i);
      require_finite();
      return take();
    });
  }

 private:
  static constexpr std::uint64_t kNumberBytes = 4;

  void read_counts();
  void read_vertex(std::uint32_t index);
  void require_finite() const;
  void read_face(std::uint32_t index);
  MeshFile take();
  void checkpoint(std::uint32_t index) {
    constexpr std::uint32_t kRecordsPerCheckpoint = 4096;
    if (index % kRecordsPerCheckpoint == 0) {
      context_.checkpoint("read", in_.position(), total_bytes_);
    }
  }
  std::uint32_t take_count(std::uint32_t face, std::uint32_t more);
  /// How many numbers follow the coordinates of a vertex.
  std::uint32_t more_numbers() const {
    return keyword_.fixed_numbers() + (keyword_.has_colour ? kColourNumbers : 0);
  }

  BinaryInput in_;
  OffKeyword keyword_;
  MeshCollector mesh_;
  OffAttributes attributes_;
  Context& context_;
  std::size_t total_bytes_;
  std::size_t first_vertex_ = 0;  // Its byte.
  std::uint32_t vertices_ = 0;
  std::uint32_t faces_ = 0;
  bool has_face_colour_ = false;
};

/// Counts are compared with the bytes that follow. A face has at least two numbers.
void OffBinaryReader::read_counts() {
  if (in_.bytes_left() < 3 * kNumberBytes) {
    in_.fail(ErrorCode::CountMismatch,
             "the file ends where the numbers of vertices, faces and edges are expected");
  }
  const std::size_t start = in_.position();
  vertices_ = in_.take<std::uint32_t>();
  faces_ = in_.take<std::uint32_t>();
  in_.skip(kNumberBytes);
  const std::uint64_t numbers =
      std::uint64_t{vertices_} * (3 + more_numbers()) + std::uint64_t{faces_} * 2;
  if (numbers > in_.bytes_left() / kNumberBytes) {
    in_.fail(ErrorCode::CountMismatch,
             announcement(vertices_, faces_) + " are announced, but the file is too short for them",
             start);
  }
  first_vertex_ = in_.position();
  mesh_.expect(vertices_, faces_);
}

void OffBinaryReader::read_vertex(std::uint32_t index) {
  checkpoint(index);
  const double x = in_.take<float>();
  const double y = in_.take<float>();
  const double z = in_.take<float>();
  if (std::isfinite(x) && std::isfinite(y) && std::isfinite(z)) {
    mesh_.add_point({x, y, z});
  } else {
    mesh_.add_missing_point();
  }
  if (!attributes_.is_wanted()) return in_.skip(more_numbers() * kNumberBytes);
  for (std::uint32_t i = 0; i < more_numbers(); ++i) attributes_.add(double{in_.take<float>()});
  attributes_.end_vertex(keyword_);
}

/// Vertices need not be finite if no face needs them.
void OffBinaryReader::require_finite() const {
  const auto vertex = mesh_.needed_missing_point();
  if (!vertex) return;
  in_.fail(ErrorCode::NumberOutOfRange,
           "vertex " + std::to_string(*vertex + 1) + " is not finite, but a face uses it",
           first_vertex_ + *vertex * (3 + more_numbers()) * kNumberBytes);
}

/// Returns a number of numbers of a face. Throws unless so many follow, and `more` besides.
std::uint32_t OffBinaryReader::take_count(std::uint32_t face, std::uint32_t more) {
  const std::size_t start = in_.position();
  const std::uint64_t left = in_.bytes_left() / kNumberBytes;
  const std::uint32_t count = left > 0 ? in_.take<std::uint32_t>() : 0;
  if (std::uint64_t{1} + count + more <= left) return count;
  in_.fail(ErrorCode::CountMismatch,
           "the file is too short for face " + std::to_string(face + 1) + " of " +
               std::to_string(faces_),
           start);
}

void OffBinaryReader::read_face(std::uint32_t index) {
  checkpoint(index);
  const std::uint32_t corners = take_count(index, 1);
  for (std::uint32_t i = 0; i < corners; ++i) {
    const auto vertex = in_.take<std::uint32_t>();
    if (vertex >= vertices_) {
      in_.fail(ErrorCode::BadIndex,
               "face " + std::to_string(index + 1) + " names vertex " + std::to_string(vertex) +
                   "; there are " + std::to_string(vertices_) + ", numbered from 0",
               in_.position() - kNumberBytes);
    }
    mesh_.add_corner(vertex);
  }
  mesh_.end_face();
  const std::uint32_t colours = take_count(index, 0);
  has_face_colour_ |= colours > 0;
  if (!attributes_.is_wanted()) return in_.skip(colours * kNumberBytes);
  for (std::uint32_t i = 0; i < colours; ++i) attributes_.add(double{in_.take<float>()});
  if (attributes_.is_wanted()) attributes_.end_face();
}

MeshFile OffBinaryReader::take() {
  if (!attributes_.is_wanted()) note_attributes(keyword_, mesh_);
  if (has_face_colour_ && !attributes_.is_wanted()) mesh_.pass_over("colours of faces");
  MeshFile file = mesh_.take();
  attributes_.give(file);
  if (in_.bytes_left() > 0) {
    file.warnings.push_back(
        "what follows the last face was not read: " + std::to_string(in_.bytes_left()) +
        " bytes from byte " + std::to_string(in_.position()) + " on");
  }
  return file;
}

}  // namespace

bool begins_off(std::string_view word) {
  if (!word.empty() && is_digit(word.front())) return true;
  return take_keyword(word) && (word.empty() || is_digit(word.front()));
}

MeshFile read_off(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return read_lines(text, options, context, [&](std::string_view lines) {
    OffReader reader(without_padding(lines), options, context);
    if (!reader.read_keyword()) return reader.read();
    return OffBinaryReader(lines, reader.bytes_read(), reader.keyword(), options, context).read();
  });
}

namespace {

void write_point(TextOutput& out, const PolygonMesh& mesh, std::uint32_t i, MeshNumbers numbers,
                 std::size_t& next_exact) {
  const bool is_exact = numbers == MeshNumbers::Exact && next_exact < mesh.exact.size() &&
                        mesh.exact[next_exact].first == i;
  if (!is_exact) return write_coordinates(out, mesh.points[i]);
  const RationalPoint3& p = mesh.exact[next_exact++].second;
  out << format_exact(p.x) << ' ' << format_exact(p.y) << ' ' << format_exact(p.z);
}

/// Writes a line with point i, whichever point was written before.
void write_point_line(TextOutput& out, const PolygonMesh& mesh, std::uint32_t i,
                      MeshNumbers numbers) {
  const auto exact =
      std::ranges::lower_bound(mesh.exact, i, {}, [](const auto& e) { return e.first; });
  auto next_exact = static_cast<std::size_t>(exact - mesh.exact.begin());
  write_point(out, mesh, i, numbers, next_exact);
  out << '\n';
}

/// Writes the keyword and the counts; `variant` precedes OFF.
void write_head(TextOutput& out, const char* variant, const PolygonMesh& mesh) {
  out << variant << "OFF\n" << std::uint64_t{mesh.points.size()} << ' ';
  out << std::uint64_t{mesh.face_count()} << " 0\n";
}

// Attributes. Colours are integers from 0 to 255 if these hold all colours of their kind, otherwise
// numbers from 0 to 1. A reader tells the two apart by a number above 1.

/// How the colours of all faces or of all vertices are written.
class ColorStyle {
 public:
  /// `parts` are the numbers of all colours that are written.
  explicit ColorStyle(const std::vector<double>& parts)
      : has_bytes_(are_bytes(parts) && std::any_of(parts.begin(), parts.end(),
                                                   [](double part) { return byte_of(part) > 1; })) {
  }

  void write(TextOutput& out, double part) const {
    if (!has_bytes_) {
      out << ' ' << part;
    } else {
      out << ' ' << std::uint64_t{byte_of(part)};
    }
  }

 private:
  bool has_bytes_;
};

/// Returns red, green and blue, and the opacity unless it is 1.
std::vector<double> parts_of(const std::array<double, 4>& color) {
  return {color.begin(), color[3] == 1 ? color.end() - 1 : color.end()};
}

/// Returns the numbers of the colours that faces have. A material that no face has does not decide
/// how the others are written.
std::vector<double> parts_of_faces(const MeshAttributes& attributes) {
  std::vector<bool> is_used(attributes.materials.size());
  for (const std::uint32_t material : attributes.face_material) {
    if (material != MeshAttributes::kNone) is_used[material] = true;
  }
  std::vector<double> parts;
  for (std::size_t m = 0; m < is_used.size(); ++m) {
    const MeshMaterial& material = attributes.materials[m];
    if (!is_used[m] || !material.color) continue;
    const std::vector<double> more = parts_of(*material.color);
    parts.insert(parts.end(), more.begin(), more.end());
  }
  return parts;
}

/// Writes the faces with the colours of their materials. A material without a colour whose name is
/// an index of a colour is written as this index.
void write_colored_faces(TextOutput& out, const PolygonMesh& mesh,
                         const MeshAttributes& attributes) {
  const ColorStyle style(parts_of_faces(attributes));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out << std::uint64_t{face.size()};
    for (const std::uint32_t v : face) out << ' ' << v;
    const std::uint32_t index = attributes.face_material[f];
    if (index != MeshAttributes::kNone) {
      const MeshMaterial& material = attributes.materials[index];
      if (material.color) {
        for (const double part : parts_of(*material.color)) style.write(out, part);
      } else if (is_off_color_index(material)) {
        out << ' ' << material.name;
      }
    }
    out << '\n';
  }
}

/// The channels of vertices that OFF can hold.
struct OffChannels {
  const MeshChannel* normal;
  const MeshChannel* color;
  const MeshChannel* texture;

  std::vector<const MeshChannel*> all() const {
    std::vector<const MeshChannel*> list;
    for (const MeshChannel* channel : {normal, color, texture}) {
      if (channel != nullptr) list.push_back(channel);
    }
    return list;
  }
  std::string variant() const {
    return std::string(texture ? "ST" : "") + (color ? "C" : "") + (normal ? "N" : "");
  }
};

void write_vertices_with(TextOutput& out, const SplitMesh& split, const OffChannels& channels,
                         MeshNumbers numbers) {
  const ColorStyle style(channels.color ? channels.color->values : std::vector<double>{});
  std::size_t next_exact = 0;
  for (std::uint32_t i = 0; i < split.mesh.points.size(); ++i) {
    write_point(out, split.mesh, i, numbers, next_exact);
    const std::uint32_t corner = split.corner_of_vertex[i];
    if (channels.normal) write_numbers(out, values_of_vertex(*channels.normal, corner));
    if (channels.color) {
      for (const double part : values_of_vertex(*channels.color, corner)) style.write(out, part);
    }
    if (channels.texture) write_numbers(out, values_of_vertex(*channels.texture, corner));
    out << '\n';
  }
}

}  // namespace

bool is_off_color_index(const MeshMaterial& material) {
  constexpr std::size_t kMostDigits = 9;
  const std::string& name = material.name;
  return !material.color && !name.empty() && name.size() <= kMostDigits &&
         name.find_first_not_of("0123456789") == name.npos;
}

void write_off(std::ostream& stream, const PolygonMesh& mesh, MeshNumbers numbers,
               Context& context) {
  if (numbers == MeshNumbers::Nearest) require_doubles(mesh);
  TextOutput head(stream);
  write_head(head, "", mesh);
  head.flush();
  write_lines(stream, mesh.points.size(), context, [&](TextOutput& out, std::size_t i) {
    write_point_line(out, mesh, static_cast<std::uint32_t>(i), numbers);
  });
  write_lines(stream, mesh.face_count(), context,
              [&](TextOutput& out, std::size_t f) { write_face_line(out, mesh.face(f)); });
}

void write_off(std::ostream& stream, const PolygonMesh& mesh, const MeshAttributes& attributes,
               MeshNumbers numbers) {
  if (numbers == MeshNumbers::Nearest) require_doubles(mesh);
  const OffChannels channels{channel_of(attributes, "normal", 3, 3),
                             channel_of(attributes, "color", 3, 4),
                             channel_of(attributes, "texcoord_0", 2, 2)};
  const SplitMesh split = split_vertices(mesh, channels.all());
  TextOutput out(stream);
  write_head(out, channels.variant().c_str(), split.mesh);
  write_vertices_with(out, split, channels, numbers);
  if (attributes.face_material.empty()) {
    write_face_lines(out, split.mesh);
  } else {
    write_colored_faces(out, split.mesh, attributes);
  }
  out.flush();
}

}  // namespace plumb
