// Reading and writing of OBJ, statement by statement.
//
// A statement is a line, continued by a backslash at its end. Only v and f carry geometry that a
// mesh can represent. Statements with other geometry are skipped with a warning, and all other
// statements with a note; programs add keywords of their own, so unknown keywords are named and
// skipped, too. If a text has neither v nor f, it is not OBJ, and its first unknown keyword is an
// error. Fields of v and f that are dropped are not parsed, because exporters write nan there, or
// leave them out. The most frequent form of a corner, a short positive number, is read without
// making a token. A face may precede its vertices, so the largest vertex number that was not yet
// defined is compared with the number of vertices at the end.
//
// Format: Wavefront OBJ, as in docs/formats.md, section OBJ. Tested by tests/io/obj_test.cpp.
#include "plumb/io/mesh/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/obj_attributes.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/line_writer.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/strong_id.h"

namespace plumb {
namespace {

/// A group of statements that are skipped: its name for the message, and the keywords, separated by
/// blanks.
struct Skipped {
  std::string_view name;
  std::string_view keywords;
  bool is_geometry = false;
  /// Whether the arguments are names. A backslash after a blank continues such a statement. A
  /// backslash at the end of a name is a part of the name ("mtllib C:\\models\\").
  bool has_names = false;
};

constexpr std::array<Skipped, 11> kSkipped{{
    {"normals of vertices", " vn "},
    {"texture coordinates", " vt "},
    {"names, groups and materials", " o g s mg usemtl mtllib usemap maplib ", false, true},
    {"lines", " l "},
    {"points", " p "},
    {"display attributes", " bevel c_interp d_interp lod shadow_obj trace_obj ctech stech ", false,
     true},
    {"free-form curves", " curv cdc ", true},
    {"free-form surfaces", " surf bzp bsp cdp ", true},
    {"parameters of free-form curves and surfaces",
     " vp cstype deg bmat step curv2 parm trim hole scrv sp end con res "},
    {"other files (call)", " call ", true, true},
    {"commands", " csh ", false, true},
}};

constexpr std::string_view kCorner = "a corner: v, v/vt, v//vn or v/vt/vn";
constexpr std::string_view kContinuation = "\\";

/// Whether the text is the number of an element, counted from the first one or, if it is negative,
/// from the last one.
bool is_reference(std::string_view text) {
  take_prefix(text, "-");
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

/// Returns the vertex of a corner, or an empty text if the corner has a different form. Texture and
/// normal may be missing after their slashes.
std::string_view vertex_of(std::string_view corner) {
  const std::string_view vertex = corner.substr(0, corner.find('/'));
  const bool is_corner = is_reference(vertex) && std::ranges::count(corner, '/') <= 2;
  return is_corner ? vertex : std::string_view();
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const ReadOptions& options, const ObjLoader& loader,
            Context& context)
      : cursor_(text, options.name, &context),
        numbers_(context, options.exact_decimals, text.size()),
        mesh_(context),
        attributes_(std::in_place, options.attributes, loader, context),
        loader_(loader),
        context_(context),
        name_(options.name),
        total_bytes_(text.size()) {}

  MeshFile read() {
    return with_place(cursor_, [this] {
      const TextCursor start = cursor_;
      read_statements();
      if (const auto vertex = mesh_.needed_missing_point()) {
        required_ = *vertex;
        cursor_ = start;
        mesh_.clear();
        attributes_.emplace(false, loader_, context_);
        read_statements();  // The error has the place of the vertex.
      }
      require_obj();
      require_vertices();
      return take();
    });
  }

 private:
  /// A token and its place.
  struct Mention {
    std::string_view token;
    std::size_t line = 0;
    std::size_t column = 0;
  };

  void checkpoint();
  void read_statements();
  void read_statement();
  void read_other(std::string_view keyword);
  bool keep(std::string_view keyword);
  std::vector<AttributeNumber> take_numbers();
  void skip(std::string_view keyword);
  void skip_unknown(std::string_view keyword);
  void skip_arguments(bool has_names);
  /// Whether the end of the statement is reached.
  bool at_end() {
    if (cursor_.at_line_end_or_comment()) return true;
    return *cursor_.position() == kContinuation[0] && is_at_end_if_continued();
  }
  bool is_at_end_if_continued();
  bool take_continuation();
  void read_vertex();
  void skip_rest_of_vertex();
  void read_face();
  void read_corner();
  std::uint32_t find_vertex(std::string_view number);
  void expect_vertex(std::uint32_t number, std::string_view token);
  void require_obj() const;
  void require_vertices() const;
  MeshFile take();
  Mention mention(std::string_view token) const {
    return {token, cursor_.line(),
            static_cast<std::size_t>(token.data() - cursor_.line_start()) + 1};
  }
  [[noreturn]] void fail_at(const Mention& where, ErrorCode code, std::string message) const {
    throw Error(code, std::move(message), {name_, where.line, where.column});
  }

  TextCursor cursor_;
  NumberReader numbers_;
  MeshCollector mesh_;
  std::optional<ObjAttributes> attributes_;
  const ObjLoader& loader_;
  Context& context_;
  const std::string& name_;
  std::size_t total_bytes_;
  std::size_t statements_ = 0;
  ReadNumber x_, y_, z_;
  std::uint32_t required_ = kNone;       // A vertex that must be finite, because a face uses it.
  Mention unknown_;                      // The first unknown keyword.
  std::vector<std::string_view> named_;  // The first few unknown keywords.
  bool has_more_unknown_ = false;
  std::uint32_t latest_ = 0;  // The largest vertex number that was used before its v.
  Mention latest_place_;
  std::size_t latest_face_ = 0;
};

void ObjReader::checkpoint() {
  constexpr std::size_t kStatementsPerCheckpoint = 4096;
  if (statements_++ % kStatementsPerCheckpoint == 0) {
    context_.checkpoint("read", cursor_.bytes_read(), total_bytes_);
  }
}

void ObjReader::read_statements() {
  while (cursor_.next_line()) {
    checkpoint();
    read_statement();
  }
}

void ObjReader::read_statement() {
  const char* const start = cursor_.position();
  const std::string_view keyword = cursor_.token();
  if (keyword == "v") return read_vertex();
  if (keyword == "f") return read_face();
  if (keyword.find(kContinuation) == keyword.npos) return read_other(keyword);
  cursor_.move_back(start);
  if (!at_end()) read_other(cursor_.word(kContinuation));
}

/// In old versions of the format, the statement fo is an f.
void ObjReader::read_other(std::string_view keyword) {
  if (keyword == "v" || keyword == "V") return read_vertex();
  if (keyword == "f" || keyword == "F" || keyword == "fo") return read_face();
  if (!attributes_->is_wanted() || !keep(keyword)) skip(keyword);
}

/// Reads a statement of attributes. If it is a different statement, consumes no text and returns
/// false.
bool ObjReader::keep(std::string_view keyword) {
  if (keyword == "vt" || keyword == "vn") {
    const std::vector<AttributeNumber> numbers = take_numbers();
    keyword == "vt" ? attributes_->add_texture(numbers) : attributes_->add_normal(numbers);
    return true;
  }
  const bool has_name =
      keyword == "usemtl" || keyword == "mtllib" || keyword == "g" || keyword == "o";
  if (!has_name) return false;
  const std::string_view line = cursor_.rest().substr(0, cursor_.rest().find('\n'));
  const std::string_view name = line.substr(0, line.find(" #"));
  if (keyword == "usemtl") {
    attributes_->use_material(name);
  } else if (keyword == "mtllib") {
    // The name of a file may contain characters that look like a comment.
    attributes_->use_library(line);
  } else {
    attributes_->use_group(name);
  }
  skip_arguments(true);
  return true;
}

/// Reads the numbers up to the end of a statement, and stores the first few.
std::vector<AttributeNumber> ObjReader::take_numbers() {
  constexpr std::size_t kMostNumbers = 8;
  std::vector<AttributeNumber> numbers;
  while (!at_end()) {
    const std::string_view token = cursor_.word(kContinuation);
    if (numbers.size() < kMostNumbers) numbers.push_back(attribute_number(token));
  }
  return numbers;
}

void ObjReader::skip(std::string_view keyword) {
  std::string between_blanks(" ");
  between_blanks.append(keyword).append(" ");
  const auto* const found =
      std::find_if(kSkipped.begin(), kSkipped.end(), [&](const Skipped& statements) {
        return statements.keywords.find(between_blanks) != statements.keywords.npos;
      });
  if (found == kSkipped.end()) return skip_unknown(keyword);
  skip_arguments(found->has_names);
  if (found->is_geometry) {
    mesh_.leave_out(found->name);
  } else {
    mesh_.pass_over(found->name);
  }
}

void ObjReader::skip_unknown(std::string_view keyword) {
  constexpr std::size_t kMostNamed = 8;
  if (text_prefix(keyword) < keyword.size()) cursor_.fail_token(keyword, "a statement");
  if (named_.empty()) unknown_ = mention(keyword);
  if (std::ranges::find(named_, keyword) == named_.end()) {
    if (named_.size() < kMostNamed) {
      named_.push_back(keyword);
    } else {
      has_more_unknown_ = true;
    }
  }
  if (cursor_.rest().starts_with(kContinuation)) cursor_.token();  // A part of the keyword.
  skip_arguments(true);
}

void ObjReader::skip_arguments(bool has_names) {
  while (!at_end()) cursor_.word(has_names ? std::string_view() : kContinuation);
}

/// Skips backslashes at the ends of lines. Returns whether the end of the statement is reached.
bool ObjReader::is_at_end_if_continued() {
  while (!cursor_.at_line_end_or_comment()) {
    if (!take_continuation()) return false;
  }
  return true;
}

/// Skips a backslash at the end of a line, and blanks after it, and moves to the next line. Returns
/// false if there is no backslash.
bool ObjReader::take_continuation() {
  std::string_view rest = cursor_.rest();
  if (!take_prefix(rest, kContinuation)) return false;
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  take_prefix(rest, "\r");
  if (!rest.empty() && !take_prefix(rest, "\n")) return false;
  cursor_.move_to(rest.data());
  return true;
}

/// A vertex need not be finite if no face needs it.
void ObjReader::read_vertex() {
  bool is_missing = false;
  for (ReadNumber* number : {&x_, &y_, &z_}) {
    if (at_end()) {
      cursor_.fail(ErrorCode::Syntax, "vertex " + std::to_string(mesh_.point_count() + 1) +
                                          " needs three numbers, x, y and z");
    }
    if (numbers_.read_next_if_finite(cursor_, *number, kContinuation)) continue;
    const std::string_view token = cursor_.word(kContinuation);
    if (mesh_.point_count() == required_) cursor_.fail_token(token, "a number");
    is_missing = true;
  }
  if (is_missing) {
    mesh_.add_missing_point();
  } else {
    mesh_.add_point(x_, y_, z_);
  }
  if (attributes_->is_wanted()) {
    const std::vector<AttributeNumber> numbers = take_numbers();
    const std::size_t count = numbers.size();
    if (count == 1) mesh_.pass_over("weights of vertices");
    if (count == 2 || count > 4) mesh_.pass_over("other numbers of vertices");
    return attributes_->add_vertex(numbers);
  }
  if (!at_end()) skip_rest_of_vertex();
}

/// Skips the fields after the coordinates: a weight, a colour, both, or other fields.
void ObjReader::skip_rest_of_vertex() {
  std::size_t count = 0;
  for (; !at_end(); ++count) cursor_.word(kContinuation);
  mesh_.pass_over(count == 1                 ? "weights of vertices"
                  : count == 3 || count == 4 ? "colours of vertices"
                                             : "other numbers of vertices");
}

void ObjReader::read_face() {
  while (!at_end()) read_corner();
  attributes_->end_face(mesh_.face_count());
  mesh_.end_face();
}

/// Reads a corner, which is usually a short number.
void ObjReader::read_corner() {
  const char* const start = cursor_.position();
  const auto token = [&] {
    return std::string_view(start, static_cast<std::size_t>(cursor_.position() - start));
  };
  std::uint32_t number = 0;
  if (cursor_.short_number(number) && 0 < number) {
    if (number > mesh_.point_count()) expect_vertex(number, token());
    if (attributes_->is_wanted()) attributes_->add_corner({});
    return mesh_.add_corner(number - 1);
  }
  if (cursor_.position() == start) cursor_.word(kContinuation);
  const std::string_view vertex = vertex_of(token());
  if (vertex.empty()) cursor_.fail_token(token(), kCorner);
  if (attributes_->is_wanted()) attributes_->add_corner(token());
  mesh_.add_corner(find_vertex(vertex));
}

/// Returns the index of a vertex. The number counts from the first vertex, and may refer to a later
/// vertex, or it counts backwards.
std::uint32_t ObjReader::find_vertex(std::string_view number) {
  constexpr std::int64_t kMost = 0xffff'ffff;
  const std::int64_t count = mesh_.point_count();
  std::int64_t value = 0;
  const char* const end = number.data() + number.size();
  const auto [rest, code] = std::from_chars(number.data(), end, value);
  if (code == std::errc() && 0 < value && value <= kMost) {
    const auto from_front = static_cast<std::uint32_t>(value);
    if (value > count) expect_vertex(from_front, number);
    return from_front - 1;
  }
  const std::int64_t vertex = count + value;
  if (code != std::errc() || value >= 0 || vertex < 0) {
    cursor_.fail(ErrorCode::BadIndex,
                 "face " + std::to_string(mesh_.face_count() + 1) + " names vertex " +
                     quoted(number) + "; " + std::to_string(count) +
                     (count == 1 ? " vertex has" : " vertices have") + " been given before it" +
                     (value == 0 && code == std::errc() ? "; OBJ counts from 1" : ""),
                 number.data());
  }
  return static_cast<std::uint32_t>(vertex);
}

/// Notes that vertex `number` must be defined later.
void ObjReader::expect_vertex(std::uint32_t number, std::string_view token) {
  if (number <= latest_) return;
  latest_ = number;
  latest_place_ = mention(token);
  latest_face_ = mesh_.face_count() + 1;
}

void ObjReader::require_obj() const {
  if (named_.empty() || mesh_.point_count() > 0 || mesh_.face_count() > 0) return;
  fail_at(unknown_, ErrorCode::Syntax,
          "expected a statement such as v or f, found " + quoted(unknown_.token));
}

void ObjReader::require_vertices() const {
  const std::uint32_t count = mesh_.point_count();
  if (latest_ <= count) return;
  fail_at(latest_place_, ErrorCode::BadIndex,
          "face " + std::to_string(latest_face_) + " names vertex " + quoted(latest_place_.token) +
              "; the file has " + std::to_string(count) + (count == 1 ? " vertex" : " vertices"));
}

MeshFile ObjReader::take() {
  MeshFile file = mesh_.take();
  attributes_->give(file);
  if (named_.empty()) return file;
  std::string note = "passed over: unknown statements ";
  for (const std::string_view& keyword : named_) {
    note.append(&keyword == named_.data() ? "" : ", ").append(quoted(keyword));
  }
  if (has_more_unknown_) note += " and others";
  file.notes.push_back(std::move(note));
  return file;
}

}  // namespace

MeshFile read_obj(std::string_view text, const ReadOptions& options, Context& context,
                  const ObjLoader& loader) {
  if (text.find_first_not_of(" \t\r\n") == text.npos) {
    WholeFile{options.name}.fail(ErrorCode::CountMismatch, "the file has no content");
  }
  const RoundToNearest rounding;
  return read_lines(without_padding(text), options, context, [&](std::string_view lines) {
    return ObjReader(lines, options, loader, context).read();
  });
}

void write_obj(std::ostream& stream, const PolygonMesh& mesh, Context& context) {
  require_doubles(mesh);
  stream << "# plumb\n";
  write_lines(stream, mesh.points.size(), context, [&](TextOutput& out, std::size_t i) {
    out << "v ";
    write_coordinates(out, mesh.points[i]);
    out << '\n';
  });
  write_lines(stream, mesh.face_count(), context, [&](TextOutput& out, std::size_t f) {
    out << 'f';
    for (const std::uint32_t v : mesh.face(f)) out << ' ' << std::uint64_t{v} + 1;
    out << '\n';
  });
}

}  // namespace plumb
