// Reading and writing of OFF.
//
// The file claims its counts in the first lines. They are compared with the bytes that follow, at
// the least number of bytes that a vertex or face can take, before memory is reserved for them; so
// a short file cannot claim a large mesh. Numbers beyond coordinates and corners (normals, colours,
// texture coordinates) are read for their form, dropped, and noted. Format: docs/formats.md,
// section OFF.
// Tested by tests/io/off_test.cpp.
#include "plumb/io/mesh/off.h"

#include <cstdint>
#include <string>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// The shortest lines: "0 0 0" and "3 0 1 2", each with its line break.
constexpr std::uint64_t kVertexBytes = 6;
constexpr std::uint64_t kFaceBytes = 8;
constexpr std::uint32_t kColourNumbers = 4;

class OffReader {
 public:
  OffReader(std::string_view text, const ReadOptions& options, Context& context)
      : in_(text, options, context, "the mesh"), mesh_(context) {}

  MeshFile read() {
    return with_place(cursor(), [this] {
      read_keyword();
      read_counts();
      read_vertices();
      read_faces();
      require_end();
      add_notes();
      return mesh_.take();
    });
  }

 private:
  void read_keyword();
  void require_known(std::string_view keyword);
  void read_counts();
  void read_vertices();
  void read_extra_numbers(std::uint32_t least, std::uint32_t most, std::string_view owner);
  void read_faces();
  void read_face();
  void require_end();
  void add_notes();
  TextCursor& cursor() { return in_.cursor(); }
  [[noreturn]] void fail(ErrorCode code, std::string message, const char* where = nullptr) {
    cursor().fail(code, std::move(message), where);
  }

  RecordReader in_;
  MeshCollector mesh_;
  bool has_texture_ = false;
  bool has_colour_ = false;
  bool has_normal_ = false;
  bool has_face_colour_ = false;
  std::size_t counts_line_ = 0;
  std::uint32_t vertices_ = 0;
  std::uint32_t faces_ = 0;
  ReadNumber x_, y_, z_, dropped_;
};

/// Reads the keyword, which may be missing. The counts may follow at once, even without a blank
/// ("OFF8 6 12").
void OffReader::read_keyword() {
  if (!cursor().next_line()) {
    fail(ErrorCode::CountMismatch, "the file has no content; expected OFF");
  }
  const std::string_view rest = cursor().rest();
  const std::string_view token = rest.substr(0, rest.find_first_of(" \t\r\n"));
  std::string_view word = token;
  has_texture_ = take_prefix(word, "ST");
  has_colour_ = take_prefix(word, "C");
  has_normal_ = take_prefix(word, "N");
  const bool has_four = take_prefix(word, "4");
  const bool has_dimension = take_prefix(word, "n");
  if (!take_prefix(word, "OFF")) {
    const bool is_number = !token.empty() && '0' <= token.front() && token.front() <= '9';
    if (!is_number) cursor().fail_token(cursor().token(), "OFF");
    has_texture_ = has_colour_ = has_normal_ = false;
    return;
  }
  if (has_four || has_dimension) {
    fail(ErrorCode::UnknownFormat, quoted(token) + ": only vertices of three coordinates are read");
  }
  cursor().skip(token.size() - word.size());
  if (!cursor().at_line_end() && cursor().rest().starts_with("BINARY")) {
    fail(ErrorCode::UnknownFormat, "binary OFF is not read");
  }
}

void OffReader::read_counts() {
  if (cursor().at_line_end_or_comment() && !cursor().next_line()) {
    fail(ErrorCode::CountMismatch,
         "the file ends where the numbers of vertices, faces and edges are expected");
  }
  counts_line_ = cursor().line();
  const char* const start = cursor().position();
  vertices_ = in_.read_count("the number of vertices");
  faces_ = in_.read_count("the number of faces");
  if (!cursor().at_line_end_or_comment()) in_.read_count("the number of edges");
  if (!cursor().at_line_end_or_comment()) {
    in_.end_line("three numbers on this line: vertices, faces and edges");
  }
  in_.require_bytes(
      vertices_ * kVertexBytes + faces_ * kFaceBytes,
      std::to_string(vertices_) + " vertices and " + std::to_string(faces_) + " faces", start);
  mesh_.expect(vertices_, faces_);
}

void OffReader::read_vertices() {
  const std::uint32_t least = (has_normal_ ? 3U : 0U) + (has_texture_ ? 2U : 0U);
  const std::uint32_t most = least + (has_colour_ ? kColourNumbers : 0U);
  for (std::uint32_t i = 0; i < vertices_; ++i) {
    in_.next_record("vertex", i, vertices_);
    for (ReadNumber* number : {&x_, &y_, &z_}) {
      in_.read_number(*number, "three numbers, x, y and z");
    }
    mesh_.add_point(x_, y_, z_);
    if (least > 0 || !cursor().at_line_end()) read_extra_numbers(least, most, "coordinates");
  }
}

/// Reads numbers for their form and drops them.
void OffReader::read_extra_numbers(std::uint32_t least, std::uint32_t most,
                                   std::string_view owner) {
  for (std::uint32_t i = 0; i < most && !cursor().at_line_end_or_comment(); ++i) {
    in_.read_number(dropped_, "more numbers");
    least -= least > 0 ? 1 : 0;
  }
  if (least > 0) {
    fail(ErrorCode::Syntax, in_.record_name() + " lacks numbers that the first line announces");
  }
  if (!cursor().at_line_end_or_comment()) {
    in_.end_line("the end of the line after the " + std::string(owner) + " of " +
                 in_.record_name());
  }
}

void OffReader::read_faces() {
  for (std::uint32_t i = 0; i < faces_; ++i) {
    in_.next_record("face", i, faces_);
    read_face();
  }
}

/// A face is followed by nothing, or by up to four numbers of a colour.
void OffReader::read_face() {
  const std::uint32_t corners = in_.read_count("the number of corners");
  for (std::uint32_t i = 0; i < corners; ++i) {
    mesh_.add_corner(in_.read_index("vertex", vertices_));
  }
  mesh_.end_face();
  if (cursor().at_line_end_or_comment()) return;
  read_extra_numbers(0, kColourNumbers, "corners and colour");
  has_face_colour_ = true;
}

void OffReader::require_end() {
  if (!cursor().next_line()) return;
  fail(ErrorCode::CountMismatch, "there is more after the last face; line " +
                                     std::to_string(counts_line_) + " announces " +
                                     std::to_string(faces_) + " faces");
}

void OffReader::add_notes() {
  if (has_normal_) mesh_.pass_over("normals of vertices");
  if (has_colour_) mesh_.pass_over("colours of vertices");
  if (has_texture_) mesh_.pass_over("texture coordinates");
  if (has_face_colour_) mesh_.pass_over("colours of faces");
}

}  // namespace

MeshFile read_off(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return OffReader(text, options, context).read();
}

namespace {

void write_vertices(TextOutput& out, const PolygonMesh& mesh, MeshNumbers numbers) {
  auto exact = mesh.exact.begin();
  if (numbers == MeshNumbers::Nearest) exact = mesh.exact.end();
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (exact != mesh.exact.end() && exact->first == i) {
      const RationalPoint3& p = (exact++)->second;
      out << format_exact(p.x) << ' ' << format_exact(p.y) << ' ' << format_exact(p.z);
    } else {
      write_coordinates(out, mesh.points[i]);
    }
    out << '\n';
  }
}

}  // namespace

void write_off(std::ostream& stream, const PolygonMesh& mesh, MeshNumbers numbers) {
  if (numbers == MeshNumbers::Nearest) require_doubles(mesh);
  TextOutput out(stream);
  out << "OFF\n" << std::uint64_t{mesh.points.size()} << ' ' << std::uint64_t{mesh.face_count()};
  out << " 0\n";
  write_vertices(out, mesh, numbers);
  write_face_lines(out, mesh);
  out.flush();
}

}  // namespace plumb
