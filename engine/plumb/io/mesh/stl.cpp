// Reading and writing of STL, text and binary.
//
// The content of a file determines whether it is binary. The number of triangles in a binary file
// determines its size. If the size does not decide, control characters do, because no text has
// them. The word "solid" alone does not decide, because many binary files begin with it. Writers
// that stream leave the count of triangles open, and others append bytes, so layout_of() compares
// count and size, and accepts a file only if there is exactly one way to read it. A file whose
// count fits its size when read in the other order of bytes is refused. Programs do not agree on
// one grammar of the text form either, so a text is read as a list of statements. Only the
// statements that every facet needs are required: a facet that the end of the file cuts off is
// refused. STL has no shared vertices, so equal points are welded, exactly, after reading; a
// triangle that then has two equal corners is left out with a note. Binary coordinates are floats,
// which are exact in doubles. Format: 3D Systems, StereoLithography Interface Specification;
// docs/formats.md, section STL. Tested by tests/io/stl_test.cpp.
#include "plumb/io/mesh/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/space/rounded_mesh.h"

namespace plumb {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kTrianglesPerCheckpoint = 4096;
constexpr std::string_view kNowhere = "triangles without a finite coordinate";
constexpr std::size_t kLeastBinaryBytes = kHeaderBytes + sizeof(std::uint32_t);

constexpr char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_word(std::string_view token, std::string_view lower_case) {
  return std::equal(token.begin(), token.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return lower(a) == b; });
}

/// Returns the first position of a word, in capital or small letters, or npos if the word does not
/// occur.
std::size_t place_of(std::string_view text, std::string_view lower_case) {
  const auto found = std::search(text.begin(), text.end(), lower_case.begin(), lower_case.end(),
                                 [](char a, char b) { return lower(a) == b; });
  return found == text.end() ? text.npos : static_cast<std::size_t>(found - text.begin());
}

/// Whether the token begins a comment in some format of meshes.
bool begins_comment(std::string_view token) {
  return token.starts_with('#') || token.starts_with(';') || token.starts_with('!') ||
         token.starts_with("//");
}

/// Whether the token is a word or a number that belongs to a facet.
bool is_of_facet(std::string_view token) {
  constexpr std::array<std::string_view, 5> kWords{"normal", "loop", "vertex", "endloop",
                                                   "endfacet"};
  return std::any_of(kWords.begin(), kWords.end(),
                     [&](std::string_view word) { return is_word(token, word); }) ||
         std::string_view("+-.0123456789").find(token.front()) != token.npos;
}

/// Returns "1 byte", "2 bytes", ...
std::string count_of(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

void add_triangle(MeshCollector& mesh) {
  for (std::uint32_t i = 3; i > 0; --i) mesh.add_corner(mesh.point_count() - i);
  mesh.end_face();
}

// ---------------------------------------------------------------- text

class StlTextReader {
 public:
  StlTextReader(std::string_view text, const ReadOptions& options, Context& context)
      : cursor_(text, options.name, &context),
        numbers_(context, options.exact_decimals, text.size()),
        mesh_(context),
        context_(context),
        total_bytes_(text.size()) {}

  MeshFile read() {
    return with_place(cursor_, [this] {
      if (!cursor_.next_line()) {
        cursor_.fail(ErrorCode::CountMismatch, "the file has no content; expected solid");
      }
      do {
        read_statement();
      } while (find_token());
      // If there is not a single facet, the file may be cut off at any place.
      if (is_open_ && mesh_.face_count() == 0) require_token("facet or endsolid");
      MeshFile file = mesh_.take();
      if (is_open_) file.notes.push_back("the last endsolid is missing; every facet is whole");
      return file;
    });
  }

 private:
  void read_statement();
  bool has_facet_ahead();
  void skip_name();
  bool is_at_facet() const;
  bool is_next(std::string_view lower_case) const;
  void read_facet();
  void skip_normal();
  void read_loop();
  bool is_not_finite_next();
  bool find_token();
  void require_token(std::string_view expected);
  std::string_view take(std::string_view expected);
  void expect(std::string_view lower_case);
  void expect_end(std::string_view lower_case);

  TextCursor cursor_;
  NumberReader numbers_;
  MeshCollector mesh_;
  Context& context_;
  std::size_t total_bytes_;
  bool is_open_ = false;  // Whether the current solid has not ended yet.
  std::optional<bool> is_facet_ahead_;
  ReadNumber x_, y_, z_;
};

/// Reads the beginning or the end of a solid, a facet, or a colour. Solids need not be well nested:
/// some writers repeat the first line or the last. Comments are skipped. Before the first facet,
/// all other lines are skipped, too, because some writers write a name on several lines.
void StlTextReader::read_statement() {
  const std::string_view token = cursor_.token();
  if (is_word(token, "facet")) return read_facet();
  if (is_word(token, "outer")) return read_loop();  // Some writers leave out the word facet.
  if (is_word(token, "solid")) {
    is_open_ = true;
    return skip_name();
  }
  if (is_word(token, "endsolid") || is_word(token, "end")) {
    if (token.size() == 3) expect("solid");
    is_open_ = false;
    return skip_name();
  }
  if (is_word(token, "color")) {
    mesh_.pass_over("colours of solids");
    return skip_name();
  }
  const bool may_be_name = mesh_.face_count() == 0 && !is_of_facet(token) && has_facet_ahead();
  if (!begins_comment(token) && !may_be_name) {
    cursor_.fail_token(token, is_open_ ? "facet or endsolid" : "solid");
  }
  mesh_.pass_over("comments");
  skip_name();
}

/// Whether a facet follows that begins with the word facet. The text is searched once. As long as
/// no facet was read, the position of the next facet does not change.
bool StlTextReader::has_facet_ahead() {
  if (!is_facet_ahead_) {
    is_facet_ahead_ = place_of(cursor_.rest(), "facet") < place_of(cursor_.rest(), "outer");
  }
  return *is_facet_ahead_;
}

/// Skips the rest of a line, because a name may be any text. A facet is not a name, because a file
/// may have no line breaks at all.
void StlTextReader::skip_name() {
  while (!cursor_.at_line_end() && !is_at_facet()) cursor_.token();
}

/// Whether "facet normal" or "facet outer" follows. Requires that the cursor is at a token.
bool StlTextReader::is_at_facet() const {
  if (!is_next("facet")) return false;
  std::string_view rest = cursor_.rest().substr(5);
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  return is_word(rest.substr(0, 6), "normal") || is_word(rest.substr(0, 5), "outer");
}

/// Whether the next token begins with a word. Requires that the cursor is at a token.
bool StlTextReader::is_next(std::string_view lower_case) const {
  return is_word(cursor_.rest().substr(0, lower_case.size()), lower_case);
}

void StlTextReader::read_facet() {
  skip_normal();
  read_loop();
}

/// Skips the text between facet and loop: the word normal, up to three numbers of any form (real
/// files contain "nan"), and the word outer. Some writers leave out the normal, or parts of it.
void StlTextReader::skip_normal() {
  constexpr int kMostTokens = 4;
  for (int i = 0; i < kMostTokens; ++i) {
    if (is_word(take("normal or outer"), "outer")) return;
  }
  expect("outer");
}

/// Reads the rest of a facet, beginning with the word loop. Some writers leave out endfacet. In
/// this case, the text after the facet must be unambiguous, because at the end of the file the
/// facet may be cut off.
void StlTextReader::read_loop() {
  if (mesh_.face_count() % kTrianglesPerCheckpoint == 0) {
    context_.checkpoint("read", cursor_.bytes_read(), total_bytes_);
  }
  expect("loop");
  const bool is_nowhere = is_not_finite_next();
  for (int i = 0; i < 3; ++i) {
    expect("vertex");
    for (ReadNumber* number : {&x_, &y_, &z_}) {
      require_token("a number");
      if (is_nowhere && starts_not_finite(cursor_.rest())) {
        cursor_.token();
      } else if (is_nowhere) {
        cursor_.fail_token(cursor_.token(), "a coordinate that is not finite, as those before it");
      } else {
        numbers_.read_next(cursor_, *number);
      }
    }
    if (!is_nowhere) mesh_.add_point(x_, y_, z_);
  }
  expect_end("endloop");
  require_token("endfacet");
  if (!is_next("facet") && !is_next("outer") && !is_next("endsolid")) expect_end("endfacet");
  if (is_nowhere) return mesh_.leave_out(kNowhere);
  add_triangle(mesh_);
}

/// Whether a corner follows whose first coordinate is not finite.
bool StlTextReader::is_not_finite_next() {
  constexpr std::string_view kVertex = "vertex";
  if (!find_token() || !is_next(kVertex)) return false;
  std::string_view rest = cursor_.rest().substr(kVertex.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  return starts_not_finite(rest);
}

/// Moves to the next token; returns false at the end of the text.
bool StlTextReader::find_token() {
  while (cursor_.at_line_end()) {
    if (!cursor_.next_line()) return false;
  }
  return true;
}

void StlTextReader::require_token(std::string_view expected) {
  if (find_token()) return;
  cursor_.fail(ErrorCode::Syntax,
               "expected " + std::string(expected) + ", found the end of the file");
}

std::string_view StlTextReader::take(std::string_view expected) {
  require_token(expected);
  return cursor_.token();
}

void StlTextReader::expect(std::string_view lower_case) {
  const std::string_view token = take(lower_case);
  if (!is_word(token, lower_case)) cursor_.fail_token(token, lower_case);
}

/// Reads "endloop" or "endfacet", which some writers write as two words.
void StlTextReader::expect_end(std::string_view lower_case) {
  constexpr std::string_view kEnd = "end";
  const std::string_view token = take(lower_case);
  if (is_word(token, lower_case)) return;
  if (!is_word(token, kEnd)) cursor_.fail_token(token, lower_case);
  expect(lower_case.substr(kEnd.size()));
}

/// Reads a text that is followed by `stray` bytes of padding.
MeshFile read_text(std::string_view text, std::size_t stray, const ReadOptions& options,
                   Context& context) {
  MemoryCharge charge(context);
  std::string copy;
  if (ends_lines_with_cr(text)) {
    with_place(WholeFile{options.name}, [&] { charge.add(text.size(), "the lines of the file"); });
    copy = with_line_feeds(text, text.size());
    text = copy;
  }
  MeshFile file = StlTextReader(text, options, context).read();
  if (stray > 0) {
    file.notes.push_back("passed over: " + count_of(stray, "byte") + " behind the text");
  }
  return file;
}

// ---------------------------------------------------------------- binary

std::uint32_t announced(std::string_view bytes) {
  return BinaryInput(bytes, kHeaderBytes, std::endian::little, {}).take<std::uint32_t>();
}

/// What follows the header of a binary file.
struct BinaryLayout {
  std::uint64_t triangles = 0;
  /// Whether the last number of a triangle is the number of bytes that follow it.
  bool has_attribute_bytes = false;
  std::size_t stray_bytes = 0;  ///< Bytes behind the last triangle.
};

/// Whether the file has exactly the announced number of triangles, each followed by as many bytes
/// as its last number states. The number was intended for this purpose, but most writers that use
/// it store a colour there. Therefore only an exact fit counts.
bool has_attribute_bytes(std::string_view bytes) {
  BinaryInput in(bytes, kLeastBinaryBytes, std::endian::little, {});
  for (std::uint32_t left = announced(bytes); left > 0; --left) {
    if (in.bytes_left() < kTriangleBytes) return false;
    in.skip(kTriangleBytes - sizeof(std::uint16_t));
    const auto attribute_bytes = in.take<std::uint16_t>();
    if (in.bytes_left() < attribute_bytes) return false;
    in.skip(attribute_bytes);
  }
  return in.bytes_left() == 0;
}

[[noreturn]] void refuse_cut(std::string_view bytes, const ReadOptions& options) {
  const std::size_t whole = (bytes.size() - kLeastBinaryBytes) / kTriangleBytes;
  const std::size_t at = kLeastBinaryBytes + whole * kTriangleBytes;
  const std::string triangle = "triangle " + std::to_string(whole + 1);
  BinaryInput(bytes, at, std::endian::little, options.name)
      .fail(ErrorCode::CountMismatch,
            "the file, which is binary, ends " +
                (at == bytes.size() ? "where " + triangle + " is expected" : "within " + triangle) +
                "; it announces " + count_of(announced(bytes), "triangle"));
}

/// Refuses a file if its count, read in the other byte order, is the number of its triangles.
void refuse_big_endian(std::string_view bytes, const ReadOptions& options) {
  BinaryInput in(bytes, kHeaderBytes, std::endian::big, options.name);
  const std::uint64_t triangles = in.take<std::uint32_t>();
  if (triangles == 0 || triangles * kTriangleBytes != in.bytes_left()) return;
  in.fail(ErrorCode::UnknownFormat,
          "the file has its numbers in big-endian order; binary STL is little-endian",
          kHeaderBytes);
}

/// Compares the count of a binary file with its size. If they differ by less than a triangle, the
/// count is right. If the size is a multiple of the size of a triangle, the size is right. Writers
/// that do not know the count in advance write 0 or the largest number.
BinaryLayout layout_of(std::string_view bytes, const ReadOptions& options) {
  const std::uint32_t count = announced(bytes);
  const std::size_t room = bytes.size() - kLeastBinaryBytes;
  const std::uint64_t needed = std::uint64_t{count} * kTriangleBytes;
  if (needed == room) return {count};
  if (has_attribute_bytes(bytes)) return {count, true};
  refuse_big_endian(bytes, options);
  const bool has_more = needed < room;
  // The attribute of the last triangle has no meaning, and may be cut off.
  if (!has_more && needed - room <= sizeof(std::uint16_t)) return {count};
  if (has_more && room - needed < kTriangleBytes) {
    return {count, false, static_cast<std::size_t>(room - needed)};
  }
  const std::size_t whole = room / kTriangleBytes;
  const std::size_t rest = room % kTriangleBytes;
  const bool is_open = has_more || count == 0xffff'ffff;
  const bool rest_is_blank =
      bytes.substr(bytes.size() - rest).find_first_not_of(" \t\r\n\x1A") == bytes.npos;
  if (whole > 0 && (rest == 0 || (is_open && rest_is_blank))) {
    return {whole, false, rest};
  }
  if (!has_more || count == 0) refuse_cut(bytes, options);
  return {count, false, static_cast<std::size_t>(room - needed)};
}

/// Adds the corners of a triangle whose coordinates began at byte `begin`. Returns false if none of
/// the coordinates is finite: some programs write such triangles in place of those that they drop.
bool add_points(const BinaryInput& in, std::size_t begin, const std::array<float, 9>& coordinates,
                MeshCollector& mesh) {
  const auto is_bad = [](float value) { return !std::isfinite(value); };
  const auto* const bad = std::find_if(coordinates.begin(), coordinates.end(), is_bad);
  if (bad != coordinates.end() && std::all_of(coordinates.begin(), coordinates.end(), is_bad)) {
    mesh.leave_out(kNowhere);
    return false;
  }
  if (bad != coordinates.end()) {
    in.fail(ErrorCode::NumberOutOfRange, "a coordinate that is not finite",
            begin + sizeof(float) * static_cast<std::size_t>(bad - coordinates.begin()));
  }
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    mesh.add_point({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  }
  return true;
}

void read_triangle(BinaryInput& in, const BinaryLayout& layout, MeshCollector& mesh) {
  in.skip(3 * sizeof(float));  // The normal is skipped.
  const std::size_t begin = in.position();
  std::array<float, 9> coordinates{};
  for (float& value : coordinates) value = in.take<float>();
  const bool has_point = add_points(in, begin, coordinates, mesh);
  const bool has_attribute = in.bytes_left() >= sizeof(std::uint16_t);
  if (const auto attribute = has_attribute ? in.take<std::uint16_t>() : std::uint16_t{0};
      attribute != 0) {
    mesh.pass_over("attributes of triangles");
    if (layout.has_attribute_bytes) in.skip(attribute);
  }
  if (has_point) add_triangle(mesh);
}

MeshFile read_binary(std::string_view bytes, const ReadOptions& options, Context& context) {
  BinaryInput in(bytes, kHeaderBytes, std::endian::little, options.name);
  MeshCollector mesh(context);
  const auto count = in.take<std::uint32_t>();
  const BinaryLayout layout = layout_of(bytes, options);
  if (layout.triangles > 0xffff'ffffU / 3) {
    in.fail(ErrorCode::ResourceLimit, "more than 2^32 corners");
  }
  const auto triangles = static_cast<std::uint32_t>(layout.triangles);
  return with_place(in, [&] {
    mesh.expect(3 * triangles, triangles);
    for (std::uint32_t i = 0; i < triangles; ++i) {
      if (i % kTrianglesPerCheckpoint == 0) context.checkpoint("read", in.position(), bytes.size());
      read_triangle(in, layout, mesh);
    }
    MeshFile file = mesh.take();
    if (triangles != count) {
      file.notes.push_back("the file announces " + count_of(count, "triangle") + " and has " +
                           std::to_string(triangles) + "; all of these were read");
    }
    if (layout.stray_bytes > 0) {
      file.notes.push_back("passed over: " + count_of(layout.stray_bytes, "byte") +
                           " behind the last triangle");
    }
    return file;
  });
}

// ---------------------------------------------------------------- both

/// Returns the position of the first control character among the first bytes of a file, or npos.
/// Binary files have one there: a count below 2^24, a normal of zeros, an attribute of zero.
std::size_t first_control_byte(std::string_view bytes) {
  constexpr std::size_t kInspected = 1024;
  const std::string_view first = bytes.substr(0, kInspected);
  const auto* const found = std::find_if(first.begin(), first.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && (c < '\t' || c > '\r');
  });
  return found == first.end() ? bytes.npos : static_cast<std::size_t>(found - first.begin());
}

[[noreturn]] void refuse(std::string_view bytes, const WholeFile& file) {
  if (bytes.empty()) file.fail(ErrorCode::CountMismatch, "the file has no content");
  const std::string reason =
      is_text_stl(bytes) ? "byte " + std::to_string(first_control_byte(bytes)) + " is no character"
                         : "it does not begin with solid";
  const std::string message = "neither text (" + reason + ") nor binary STL: ";
  if (bytes.size() < kLeastBinaryBytes) {
    file.fail(ErrorCode::UnknownFormat, message + "it is too short for that");
  }
  file.fail(ErrorCode::CountMismatch, message + std::to_string(announced(bytes)) +
                                          " triangles are announced, " +
                                          std::to_string(bytes.size()) + " bytes are there");
}

/// Whether the text has facets near its beginning. Comments may precede the first solid, and some
/// writers leave out the word solid.
bool begins_with_facets(std::string_view text) {
  constexpr std::size_t kInspected = 4096;
  return place_of(text.substr(0, kInspected), "vertex") != text.npos;
}

MeshFile read_triangles(std::string_view bytes, const ReadOptions& options, Context& context) {
  if (is_binary_stl(bytes)) return read_binary(bytes, options, context);
  // Some systems fill up their files with zeros, or end them with Ctrl-Z.
  constexpr std::string_view kPadding("\0\x1A", 2);
  const std::string_view text = bytes.substr(0, bytes.find_last_not_of(kPadding) + 1);
  const bool is_text = first_control_byte(text) == text.npos;
  if (is_text && (is_text_stl(text) || begins_with_facets(text))) {
    return read_text(text, bytes.size() - text.size(), options, context);
  }
  if (has_binary_content(bytes)) return read_binary(bytes, options, context);
  refuse(bytes, {options.name});
}

}  // namespace

bool is_text_stl(std::string_view bytes) {
  take_prefix(bytes, "\xEF\xBB\xBF");
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return is_word(bytes.substr(0, 5), "solid");
}

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= kLeastBinaryBytes &&
         bytes.size() - kLeastBinaryBytes == std::uint64_t{announced(bytes)} * kTriangleBytes;
}

bool has_binary_content(std::string_view bytes) {
  return bytes.size() >= kLeastBinaryBytes && first_control_byte(bytes) != bytes.npos;
}

MeshFile read_stl(std::string_view bytes, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  MeshFile file = read_triangles(bytes, options, context);
  const std::size_t dropped =
      with_place(WholeFile{options.name}, [&] { return weld_vertices(file.mesh, context); });
  if (dropped > 0) {
    file.notes.push_back(count_of(dropped, "triangle") + " with two equal corners left out");
  }
  file.faces_left_out = dropped;
  return file;
}

namespace {

using Triangle = std::array<Point3, 3>;

Triangle triangle(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  return {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]};
}

/// Returns a normal for programs that do not compute it. Its length is 1 up to rounding. If doubles
/// do not determine the normal, it is 0 0 0.
Point3 rough_normal(const Triangle& t) {
  const Point3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z};
  const Point3 v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  if (!std::isfinite(length) || length == 0) return {};
  return {n.x / length, n.y / length, n.z / length};
}

void put_floats(TextOutput& out, const Point3& p) {
  for (const double value : {p.x, p.y, p.z}) put_little_endian(out, static_cast<float>(value));
}

}  // namespace

void write_stl_text(std::ostream& stream, const PolygonMesh& mesh) {
  require_triangles(mesh);
  require_doubles(mesh);
  TextOutput out(stream);
  out << "solid plumb\n";
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle corners = triangle(mesh, f);
    out << "facet normal ";
    write_coordinates(out, rough_normal(corners));
    out << "\n  outer loop\n";
    for (const Point3& p : corners) {
      out << "    vertex ";
      write_coordinates(out, p);
      out << '\n';
    }
    out << "  endloop\nendfacet\n";
  }
  out << "endsolid plumb\n";
  out.flush();
}

PolygonMesh rounded_to_floats(PolygonMesh mesh) {
  const RoundToNearest rounding;
  require_doubles(mesh);
  for (Point3& p : mesh.points) {
    for (double* const c : {&p.x, &p.y, &p.z}) *c = nearest_coordinate(*c, CoordinateType::Float);
  }
  mesh.exact.clear();
  return mesh;
}

void write_stl_binary(std::ostream& stream, const PolygonMesh& mesh) {
  require_triangles(mesh);
  const PolygonMesh floats = rounded_to_floats(mesh);
  TextOutput out(stream);
  std::string header("plumb");
  header.resize(kHeaderBytes, ' ');
  out << header;
  put_little_endian(out, static_cast<std::uint32_t>(floats.face_count()));
  for (std::size_t f = 0; f < floats.face_count(); ++f) {
    const Triangle corners = triangle(floats, f);
    put_floats(out, rough_normal(corners));
    for (const Point3& p : corners) put_floats(out, p);
    put_little_endian(out, std::uint16_t{0});
  }
  out.flush();
}

}  // namespace plumb
