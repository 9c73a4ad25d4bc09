// Reading and writing of STL, text and binary.
//
// The kind of a file is decided by its size, which a binary file fixes through its count of
// triangles; the word "solid" alone does not decide, because many binary files begin with it. STL
// has no shared vertices, so equal points are welded, exactly, after reading; a triangle that then
// has two equal corners is left out with a note. Binary coordinates are floats, which are exact in
// doubles. Format: 3D Systems, StereoLithography Interface Specification; docs/formats.md, section
// STL.
// Tested by tests/io/stl_test.cpp.
#include "plumb/io/mesh/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
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

constexpr char lower(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_word(std::string_view token, std::string_view lower_case) {
  return std::equal(token.begin(), token.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return lower(a) == b; });
}

void add_triangle(MeshCollector& mesh) {
  for (std::uint32_t i = 3; i > 0; --i) mesh.add_corner(mesh.point_count() - i);
  mesh.end_face();
}

// ---------------------------------------------------------------- text

class StlTextReader {
 public:
  StlTextReader(std::string_view text, const ReadOptions& options, Context& context)
      : cursor_(text, options.name),
        numbers_(context.limits(), options.exact_decimals, text.size()),
        mesh_(context),
        context_(context),
        total_bytes_(text.size()) {}

  MeshFile read() {
    return with_place(cursor_, [this] {
      if (!cursor_.next_line()) {
        cursor_.fail(ErrorCode::CountMismatch, "the file has no content; expected solid");
      }
      do {
        read_solid();
      } while (find_token());
      return mesh_.take();
    });
  }

 private:
  void read_solid();
  void skip_line();
  void read_facet();
  bool find_token();
  void require_token(std::string_view expected);
  std::string_view take(std::string_view expected);
  void expect(std::string_view lower_case);

  TextCursor cursor_;
  NumberReader numbers_;
  MeshCollector mesh_;
  Context& context_;
  std::size_t total_bytes_;
  ReadNumber x_, y_, z_;
};

/// Reads `solid NAME`, facets, `endsolid NAME`.
void StlTextReader::read_solid() {
  expect("solid");
  skip_line();
  for (;;) {
    const std::string_view token = take("facet or endsolid");
    if (is_word(token, "endsolid")) return skip_line();
    if (!is_word(token, "facet")) cursor_.fail_token(token, "facet or endsolid");
    read_facet();
  }
}

/// Skips the rest of a line: a name may be anything.
void StlTextReader::skip_line() {
  while (!cursor_.at_line_end()) cursor_.token();
}

/// Reads a facet. Its normal is read for its form only.
void StlTextReader::read_facet() {
  if (mesh_.face_count() % kTrianglesPerCheckpoint == 0) {
    context_.checkpoint("read", cursor_.bytes_read(), total_bytes_);
  }
  expect("normal");
  for (int i = 0; i < 3; ++i) take("a number");  // Real files contain "nan".
  expect("outer");
  expect("loop");
  for (int i = 0; i < 3; ++i) {
    expect("vertex");
    for (ReadNumber* number : {&x_, &y_, &z_}) {
      require_token("a number");
      numbers_.read_next(cursor_, *number);
    }
    mesh_.add_point(x_, y_, z_);
  }
  expect("endloop");
  expect("endfacet");
  add_triangle(mesh_);
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

// ---------------------------------------------------------------- binary

std::uint32_t announced(std::string_view bytes) {
  return BinaryInput(bytes, kHeaderBytes, std::endian::little, {}).take<std::uint32_t>();
}

float take_coordinate(BinaryInput& in) {
  const auto value = in.take<float>();
  if (!std::isfinite(value)) {
    in.fail(ErrorCode::NumberOutOfRange, "a coordinate that is not finite",
            in.position() - sizeof(float));
  }
  return value;
}

void read_triangle(BinaryInput& in, MeshCollector& mesh) {
  in.skip(3 * sizeof(float));  // The normal.
  for (int i = 0; i < 3; ++i) {
    const double x = take_coordinate(in);
    const double y = take_coordinate(in);
    const double z = take_coordinate(in);
    mesh.add_point({x, y, z});
  }
  if (in.take<std::uint16_t>() != 0) mesh.pass_over("attributes of triangles");
  add_triangle(mesh);
}

MeshFile read_binary(std::string_view bytes, const ReadOptions& options, Context& context) {
  BinaryInput in(bytes, kHeaderBytes, std::endian::little, options.name);
  MeshCollector mesh(context);
  const auto triangles = in.take<std::uint32_t>();
  if (triangles > 0xffff'ffffU / 3) in.fail(ErrorCode::ResourceLimit, "more than 2^32 corners");
  return with_place(in, [&] {
    mesh.expect(3 * triangles, triangles);
    for (std::uint32_t i = 0; i < triangles; ++i) {
      if (i % kTrianglesPerCheckpoint == 0) context.checkpoint("read", in.position(), bytes.size());
      read_triangle(in, mesh);
    }
    return mesh.take();
  });
}

[[noreturn]] void refuse(std::string_view bytes, const WholeFile& file) {
  if (bytes.empty()) file.fail(ErrorCode::CountMismatch, "the file has no content");
  const std::string message = "neither text (it does not begin with solid) nor binary STL: ";
  if (bytes.size() < kHeaderBytes + sizeof(std::uint32_t)) {
    file.fail(ErrorCode::UnknownFormat, message + "it is too short for that");
  }
  file.fail(ErrorCode::CountMismatch, message + std::to_string(announced(bytes)) +
                                          " triangles are announced, " +
                                          std::to_string(bytes.size()) + " bytes are there");
}

MeshFile read_triangles(std::string_view bytes, const ReadOptions& options, Context& context) {
  if (is_binary_stl(bytes)) return read_binary(bytes, options, context);
  if (is_text_stl(bytes)) return StlTextReader(bytes, options, context).read();
  refuse(bytes, {options.name});
}

}  // namespace

bool is_text_stl(std::string_view bytes) {
  take_prefix(bytes, "\xEF\xBB\xBF");
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return is_word(bytes.substr(0, 5), "solid");
}

bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t kLeast = kHeaderBytes + sizeof(std::uint32_t);
  return bytes.size() >= kLeast &&
         bytes.size() - kLeast == std::uint64_t{announced(bytes)} * kTriangleBytes;
}

MeshFile read_stl(std::string_view bytes, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  MeshFile file = read_triangles(bytes, options, context);
  const std::size_t dropped =
      with_place(WholeFile{options.name}, [&] { return weld_vertices(file.mesh, context); });
  if (dropped > 0) {
    file.notes.push_back(std::to_string(dropped) + (dropped == 1 ? " triangle" : " triangles") +
                         " with two equal corners left out");
  }
  return file;
}

namespace {

using Triangle = std::array<Point3, 3>;

Triangle triangle(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  return {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]]};
}

/// Returns a normal for programs that do not compute it themselves: of length 1 up to rounding, or
/// 0 0 0 if doubles do not determine it.
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
  constexpr std::size_t kHeaderBytes = 80;
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
