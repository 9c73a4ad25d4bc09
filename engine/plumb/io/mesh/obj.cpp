// Reading and writing of OBJ, statement by statement.
//
// A statement is a line, continued by a backslash at its end. Only v and f carry geometry; every
// other keyword of the format is skipped with a note, and an unknown keyword is an error, because
// it usually means that the file is something else. The common corner, a short positive number, is
// read without taking a token; other forms are validated in full. Format: Wavefront OBJ, as in
// docs/formats.md, section OBJ.
// Tested by tests/io/obj_test.cpp.
#include "plumb/io/mesh/obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

/// Statements that carry no geometry: a name for the note, and their keywords between blanks.
struct PassedOver {
  std::string_view name;
  std::string_view keywords;
};

constexpr std::array<PassedOver, 8> kPassedOver{{
    {"normals of vertices", " vn "},
    {"texture coordinates", " vt "},
    {"names, groups and materials", " o g s mg usemtl mtllib usemap maplib "},
    {"lines", " l "},
    {"points", " p "},
    {"display attributes", " bevel c_interp d_interp lod shadow_obj trace_obj ctech stech "},
    {"free-form curves and surfaces",
     " vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con bzp bsp cdc cdp "
     "res "},
    {"commands", " call csh "},
}};

constexpr std::string_view kCorner = "a corner: v, v/vt, v//vn or v/vt/vn";

/// Whether the text is a number of something, from the front or (negative) from the back.
bool is_reference(std::string_view text) {
  take_prefix(text, "-");
  return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

/// Returns the vertex of a corner, or an empty text if it does not have the form of one.
std::string_view vertex_of(std::string_view corner) {
  const std::string_view vertex = corner.substr(0, corner.find('/'));
  std::string_view rest = corner.substr(vertex.size());
  if (!is_reference(vertex)) return {};
  if (!take_prefix(rest, "/")) return vertex;
  const std::string_view texture = rest.substr(0, rest.find('/'));
  rest.remove_prefix(texture.size());
  const bool has_normal = take_prefix(rest, "/");
  const bool is_corner =
      (texture.empty() ? has_normal : is_reference(texture)) && (!has_normal || is_reference(rest));
  return is_corner ? vertex : std::string_view();
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const ReadOptions& options, Context& context)
      : cursor_(text, options.name),
        numbers_(context.limits(), options.exact_decimals, text.size()),
        mesh_(context),
        context_(context),
        total_bytes_(text.size()) {}

  MeshFile read() {
    return with_place(cursor_, [this] {
      while (cursor_.next_line()) {
        checkpoint();
        read_statement();
      }
      return mesh_.take();
    });
  }

 private:
  void checkpoint();
  void read_statement();
  void pass_over(std::string_view keyword);
  bool at_end();
  bool take_continuation();
  void read_vertex();
  void read_face();
  void read_corner();
  std::uint32_t find_vertex(std::string_view number) const;
  std::string face_name() const { return "face " + std::to_string(mesh_.face_count() + 1); }

  TextCursor cursor_;
  NumberReader numbers_;
  MeshCollector mesh_;
  Context& context_;
  std::size_t total_bytes_;
  std::size_t statements_ = 0;
  ReadNumber x_, y_, z_, dropped_;
};

void ObjReader::checkpoint() {
  constexpr std::size_t kStatementsPerCheckpoint = 4096;
  if (statements_++ % kStatementsPerCheckpoint == 0) {
    context_.checkpoint("read", cursor_.bytes_read(), total_bytes_);
  }
}

void ObjReader::read_statement() {
  const std::string_view keyword = cursor_.token();
  if (keyword == "v") return read_vertex();
  if (keyword == "f") return read_face();
  pass_over(keyword);
}

void ObjReader::pass_over(std::string_view keyword) {
  std::string between_blanks(" ");
  between_blanks.append(keyword).append(" ");
  const auto* const found =
      std::find_if(kPassedOver.begin(), kPassedOver.end(), [&](const PassedOver& statements) {
        return statements.keywords.find(between_blanks) != statements.keywords.npos;
      });
  if (found == kPassedOver.end()) cursor_.fail_token(keyword, "a statement such as v or f");
  while (!at_end()) cursor_.token();
  mesh_.pass_over(found->name);
}

/// Whether the statement is at its end.
bool ObjReader::at_end() {
  while (!cursor_.at_line_end_or_comment()) {
    if (!take_continuation()) return false;
  }
  return true;
}

/// Takes a backslash at the end of a line and moves to the next line; returns false if there is
/// none.
bool ObjReader::take_continuation() {
  std::string_view rest = cursor_.rest();
  if (!take_prefix(rest, "\\")) return false;
  take_prefix(rest, "\r");
  if (!rest.empty() && !take_prefix(rest, "\n")) return false;
  cursor_.move_to(rest.data());
  return true;
}

/// Reads x y z, possibly followed by a weight, a colour or both.
void ObjReader::read_vertex() {
  int count = 0;
  for (ReadNumber* number : {&x_, &y_, &z_, &dropped_, &dropped_, &dropped_, &dropped_}) {
    if (at_end()) break;
    numbers_.read_next(cursor_, *number);
    ++count;
  }
  if (count < 3 || count == 5 || !at_end()) {
    cursor_.fail(ErrorCode::Syntax, "vertex " + std::to_string(mesh_.point_count() + 1) +
                                        " needs three numbers, x, y and z, or with a weight 4, a "
                                        "colour 6, both 7");
  }
  if (count == 4) mesh_.pass_over("weights of vertices");
  if (count > 4) mesh_.pass_over("colours of vertices");
  mesh_.add_point(x_, y_, z_);
}

void ObjReader::read_face() {
  while (!at_end()) read_corner();
  mesh_.end_face();
}

/// Reads a corner, usually a short number and nothing else.
void ObjReader::read_corner() {
  const char* const start = cursor_.position();
  std::uint32_t number = 0;
  if (cursor_.short_number(number) && 0 < number && number <= mesh_.point_count()) {
    return mesh_.add_corner(number - 1);
  }
  if (cursor_.position() == start) cursor_.token();
  const std::string_view token(start, static_cast<std::size_t>(cursor_.position() - start));
  const std::string_view vertex = vertex_of(token);
  if (vertex.empty()) cursor_.fail_token(token, kCorner);
  mesh_.add_corner(find_vertex(vertex));
}

std::uint32_t ObjReader::find_vertex(std::string_view number) const {
  const std::int64_t count = mesh_.point_count();
  std::int64_t value = 0;
  const char* const end = number.data() + number.size();
  const auto [rest, code] = std::from_chars(number.data(), end, value);
  const std::int64_t vertex = value < 0 ? count + value : value - 1;
  if (code != std::errc() || vertex < 0 || vertex >= count) {
    cursor_.fail(ErrorCode::BadIndex,
                 face_name() + " names vertex " + quoted(number) + "; " + std::to_string(count) +
                     (count == 1 ? " vertex has" : " vertices have") + " been given before it",
                 number.data());
  }
  return static_cast<std::uint32_t>(vertex);
}

}  // namespace

MeshFile read_obj(std::string_view text, const ReadOptions& options, Context& context) {
  if (text.find_first_not_of(" \t\r\n") == text.npos) {
    WholeFile{options.name}.fail(ErrorCode::CountMismatch, "the file has no content");
  }
  const RoundToNearest rounding;
  return ObjReader(text, options, context).read();
}

void write_obj(std::ostream& stream, const PolygonMesh& mesh) {
  require_doubles(mesh);
  TextOutput out(stream);
  out << "# plumb\n";
  for (const Point3& p : mesh.points) {
    out << "v ";
    write_coordinates(out, p);
    out << '\n';
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    out << 'f';
    for (const std::uint32_t v : mesh.face(f)) out << ' ' << std::uint64_t{v} + 1;
    out << '\n';
  }
  out.flush();
}

}  // namespace plumb
