#include "plumb/io/mesh/ply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "expect_refusals.h"
#include "hostile_meshes.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/ply.h"

namespace plumb::ply_test {
namespace {

using testing::changed;
using testing::is_same;
using testing::kPlyHeader;
using testing::kPlyTetrahedron;

MeshFile read(const std::string& bytes, Limits limits = {}) {
  Context context(limits);
  return read_ply(bytes, {"some.file"}, context);
}

std::string text_of(const PolygonMesh& mesh) {
  std::ostringstream out;
  write_ply_text(out, mesh);
  return out.str();
}

std::string binary_of(const PolygonMesh& mesh) {
  std::ostringstream out;
  write_ply_binary(out, mesh);
  return out.str();
}

/// Bytes of numbers one after the other, in one of the two orders.
class Bytes {
 public:
  explicit Bytes(bool is_big) : is_big_(is_big) {}
  template <class Number>
  Bytes& add(Number value) {
    std::string raw(sizeof(Number), '\0');
    std::memcpy(raw.data(), &value, sizeof(Number));
    if (is_big_ == (std::endian::native == std::endian::little)) {
      std::reverse(raw.begin(), raw.end());
    }
    text_ += raw;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  bool is_big_;
  std::string text_;
};

std::string format_line(bool is_big) {
  return is_big ? "ply\nformat binary_big_endian 1.0\n" : "ply\nformat binary_little_endian 1.0\n";
}

void expect_refused(const std::string& bytes, ErrorCode code, const char* message) {
  try {
    read(bytes);
    ADD_FAILURE() << message << ": was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_EQ(error.place().file, "some.file");
    EXPECT_NE(error.message().find(message), std::string::npos) << error.what();
  }
}

TEST(PlyReader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(testing::hostile_ply(), [](const std::string& text) { read(text); });
}

TEST(PlyReader, accepts_what_the_format_allows) {
  const auto with = [&](const std::string& from, const std::string& to) {
    return changed(kPlyTetrahedron, from, to);
  };
  const auto with_breaks = [](const std::string& line_break) {
    std::string text;
    for (const char c : kPlyTetrahedron) text += c == '\n' ? line_break : std::string(1, c);
    return text;
  };
  const auto one_value_a_line = [](std::string text) {
    std::replace(text.begin(), text.end(), ' ', '\n');
    return text;
  };
  const std::vector<std::string> same{
      kPlyTetrahedron,
      with_breaks("\r\n"),
      kPlyTetrahedron.substr(0, kPlyTetrahedron.size() - 1),
      kPlyTetrahedron + "\n\n",
      with("format ascii 1.0\n", "comment caf\xE9\nformat ascii 1.0\nobj_info x y z\n"),
      with("vertex_indices", "vertex_index"),
      with("uchar int", "int32 uint8"),
      with("property double x", "property float32 x"),
      with("\n1 0 0\n", "\n 1.0\t0/3 -0.0 \n"),
      with("element face 4", "element nothing 4294967294\nelement face 4"),
      with("vertex_indices", "vertex_indexes"),
      with("vertex_indices", "indices"),
      with("uchar int", "float double"),
      changed(with("3 0 2 1", "3.0 0.000 2e0 10e-1"), "3 1 2 3", "+3 1 2 3."),
      with("end_header\n", "end_header\n\n"),
      with_breaks("\r"),
      kPlyHeader + "0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3",
      kPlyHeader + "0 0 0 1 0 0 0 1 0 0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
      kPlyHeader + one_value_a_line(kPlyTetrahedron.substr(kPlyHeader.size())),
  };
  for (const std::string& text : same) {
    const MeshFile file = read(text);
    EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron())) << text;
  }
  EXPECT_TRUE(read(kPlyTetrahedron).notes.empty());
}

TEST(PlyReader, passes_over_what_no_mesh_holds_and_says_so) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement camera 2\nproperty list int float view\nproperty char c\n"
      "element face 1\nproperty uchar red\nproperty list uchar float texcoord\n"
      "property list uchar uint vertex_indices\nproperty list uchar int more\n"
      "element vertex 3\nproperty float nx\nproperty double z\nproperty double y\nproperty int x\n"
      "property list short short ids\nend_header\n"
      "3 1.5 nan x 7\n0 7\n255 2 0.1 0.2 3 2 0 1 1 99\nnan 30 20 10 0\n0 31 21 11 1 5\n"
      "0 32 22 12 2 5 5\n";
  const MeshFile file = read(text);
  EXPECT_TRUE(is_same(file.mesh,
                      testing::mesh_of({{10, 20, 30}, {11, 21, 31}, {12, 22, 32}}, {{2, 0, 1}})));
  EXPECT_EQ(file.notes, std::vector<std::string>{
                            "passed over: elements 'camera'; properties 'nx', 'ids' of vertices; "
                            "properties 'red', 'texcoord', 'more' of faces"});
}

TEST(PlyReader, names_elements_that_may_hold_geometry) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\n"
      "element edge 2\nproperty int vertex1\nproperty int vertex2\nelement polygons 0\n"
      "property list uchar int vertex_indices\nelement range_grid 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n0 0\n0 0\n1 0\n";
  EXPECT_EQ(read(text).notes,
            std::vector<std::string>{"passed over: elements 'edge', 'range_grid'"});
  std::string many =
      "ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nproperty int y\n"
      "property int z\n";
  for (int i = 0; i < 100; ++i) many += "element e" + std::to_string(i) + " 1\nproperty int a\n";
  many += "end_header\n";
  for (int i = 0; i < 100; ++i) many += "0\n";
  const std::vector<std::string> notes = read(many).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(notes[0].ends_with("'e14', 'e15' and more")) << notes[0];
}

TEST(PlyReader, passes_over_lines_of_the_header_and_says_so) {
  const std::string text =
      changed(kPlyTetrahedron, "element vertex", "Created by a program, 1999\nelement vertex");
  const MeshFile file = read(text);
  EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron()));
  EXPECT_EQ(file.notes, std::vector<std::string>{
                            "passed over: lines of the header 'Created by a program, 1999'"});
}

TEST(PlyReader, passes_over_bytes_behind_the_end_and_says_so) {
  const std::string binary = binary_of(testing::tetrahedron());
  const std::string zeros(3, '\0');
  for (const std::string& text : {kPlyTetrahedron, binary}) {
    for (const std::string& tail : {std::string("\x1A"), std::string("end"), zeros}) {
      const MeshFile file = read(text + tail);
      EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron()));
      EXPECT_EQ(file.notes, std::vector<std::string>{"passed over: " + std::to_string(tail.size()) +
                                                     " byte(s) behind the last element"});
    }
  }
}

/// Each strip as triangles, every other one turned round.
PolygonMesh triangles_of(std::vector<Point3> points,
                         const std::vector<std::vector<std::uint32_t>>& strips) {
  PolygonMesh mesh;
  mesh.points = std::move(points);
  for (const std::vector<std::uint32_t>& strip : strips) {
    for (std::size_t i = 2; i < strip.size(); ++i) {
      std::vector<std::uint32_t> triangle{strip[i - 2], strip[i - 1], strip[i]};
      if (i % 2 == 1) std::swap(triangle[0], triangle[1]);
      mesh.add_face(triangle);
    }
  }
  return mesh;
}

const std::string kStripHeader =
    "element vertex 4\nproperty char x\nproperty char y\nproperty char z\n"
    "element tristrips 2\n";

TEST(PlyReader, makes_triangles_of_strips) {
  const PolygonMesh expected =
      triangles_of(testing::tetrahedron().points, {{0, 2, 1, 3, 0, 2}, {1, 3, 2}, {0, 1, 1, 2}});
  for (const std::string type : {"int", "uint", "float"}) {
    const std::string text = "ply\nformat ascii 1.0\n" + kStripHeader + "property list int " +
                             type + " vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    EXPECT_TRUE(is_same(read(text + "11 0 2 1 3 0 2 -1 1 3 2 -1\n4 0 1 1 2\n").mesh, expected));
    // Long lists may go on on the next line.
    EXPECT_TRUE(is_same(read(text + "11 0 2 1\n3 0 2 -1\n1 3 2 -1\n4\n0 1 1 2").mesh, expected));
    const MeshFile pieces = read(text + "8 -1 1 -1 -1 1 2 -1 0\n13 0 2 1 3 0 2 -1 1 3 2 -1 0 1\n");
    EXPECT_EQ(pieces.mesh.face_count(), 5U);
    EXPECT_EQ(pieces.notes,
              std::vector<std::string>{"passed over: strips of fewer than three vertices"});
  }
}

TEST(PlyReader, reads_strips_before_vertices) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\n"
      "element vertex 4\nproperty int x\nproperty int y\nproperty int z\nend_header\n"
      "9 0 2\n1 3 0\n-1 3\n2 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const PolygonMesh expected =
      triangles_of(testing::tetrahedron().points, {{0, 2, 1, 3, 0}, {3, 2, 1}});
  EXPECT_TRUE(is_same(read(text).mesh, expected));
  expect_refused(changed(text, "0 1 0", "0 nan 0"), ErrorCode::NumberOutOfRange,
                 "vertex 3 is not finite, but a face uses it");
}

template <class Number>
void expect_strips(const std::string& type) {
  const PolygonMesh expected =
      triangles_of(testing::tetrahedron().points, {{0, 2, 1, 3, 0}, {3, 2, 1}});
  for (const bool is_big : {false, true}) {
    Bytes bytes(is_big);
    for (const Point3& p : testing::tetrahedron().points) {
      for (const double x : {p.x, p.y, p.z}) bytes.add(static_cast<std::int8_t>(x));
    }
    bytes.add(std::uint16_t{8});
    for (const int v : {0, 2, 1, 3, 0, -1, 3, 2}) bytes.add(static_cast<Number>(v));
    const std::size_t before = bytes.text().size();
    bytes.add(std::uint16_t{4});
    for (const int v : {3, 2, 1, -1}) bytes.add(static_cast<Number>(v));
    const std::string header = format_line(is_big) + kStripHeader + "property list ushort " + type +
                               " vertex_indices\nend_header\n";
    EXPECT_TRUE(is_same(read(header + bytes.text()).mesh, expected)) << type;
    for (std::size_t cut = before; cut < bytes.text().size(); ++cut) {
      EXPECT_THROW(read(header + bytes.text().substr(0, cut)), Error) << cut;
    }
  }
}

TEST(PlyReader, ends_strips_by_minus_one_of_every_type) {
  expect_strips<std::int8_t>("char");
  expect_strips<std::uint8_t>("uchar");
  expect_strips<std::int16_t>("short");
  expect_strips<std::uint16_t>("ushort");
  expect_strips<std::int32_t>("int");
  expect_strips<std::uint32_t>("uint");
  expect_strips<float>("float");
  expect_strips<double>("double");
}

/// A text as write_ply_text() makes it, with its faces before its vertices.
std::string faces_first(const std::string& text) {
  const std::size_t vertex = text.find("element vertex");
  const std::size_t face = text.find("element face");
  const std::size_t points = text.find("end_header\n") + 11;
  std::size_t faces = points;
  const auto count = std::stoul(text.substr(vertex + 15));
  for (std::size_t i = 0; i < count; ++i) faces = text.find('\n', faces) + 1;
  return text.substr(0, vertex) + text.substr(face, points - 11 - face) +
         text.substr(vertex, face - vertex) + "end_header\n" + text.substr(faces) +
         text.substr(points, faces - points);
}

TEST(PlyReader, keeps_vertices_that_are_not_finite_if_no_face_needs_them) {
  PolygonMesh expected = testing::tetrahedron();
  expected.points.insert(expected.points.begin() + 3, 2, Point3{});
  for (std::uint32_t& v : expected.corners) v = v == 3 ? 5 : v;
  const std::vector<std::string> notes{
      "vertices that are not finite, used by no face with area: 2"};
  for (const std::string spelling : {"nan", "-NaN", "inf", "-nan(ind)", "1.#QNAN", "-1.#IND00"}) {
    const std::string text =
        changed(kPlyTetrahedron, "vertex 4", "vertex 6")
            .replace(kPlyHeader.size(), std::string::npos,
                     "0 0 0\n1 0 0\n0 1 0\n" + spelling + " 1 2\n1 " + spelling + " " + spelling +
                         "\n0 0 1\n3 0 2 1\n3 0 1 5\n3 0 5 2\n3 1 2 5\n");
    const MeshFile file = read(text);
    EXPECT_TRUE(is_same(file.mesh, expected)) << spelling;
    EXPECT_EQ(file.notes, notes);
  }
  PolygonMesh mesh = expected;
  mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
  mesh.points[4].z = -std::numeric_limits<double>::infinity();
  const MeshFile file = read(binary_of(mesh));
  EXPECT_TRUE(is_same(file.mesh, expected));
  EXPECT_EQ(file.notes, notes);
  // Faces without area do not need their vertices.
  const std::vector<std::vector<std::uint32_t>> without_area{{3}, {4, 4, 4}, {1, 3}, {3, 1, 3, 1}};
  for (const std::vector<std::uint32_t>& face : without_area) {
    for (PolygonMesh* const m : {&expected, &mesh}) m->add_face(face);
  }
  for (const std::string& bytes : {binary_of(mesh), faces_first(text_of(mesh))}) {
    EXPECT_TRUE(is_same(read(bytes).mesh, expected)) << bytes;
    EXPECT_EQ(read(bytes).notes, notes);
  }
  mesh.points[5].x = std::numeric_limits<double>::infinity();
  expect_refused(binary_of(mesh), ErrorCode::NumberOutOfRange,
                 "face 2 uses vertex 5, which is not finite");
}

/// A binary file of three vertices and a face; `line_break` ends the lines of its header. Faces
/// may come first. The first byte behind the header is that of a line feed.
std::string ten_high(const std::string& line_break, bool has_faces_first, float x) {
  const std::string vertices =
      "element vertex 3\nproperty char z\nproperty float x\nproperty char y\n";
  const std::string faces = "element face 1\nproperty list uchar uchar vertex_indices\n";
  const std::string lines =
      format_line(false) + (has_faces_first ? faces + vertices : vertices + faces) + "end_header\n";
  std::string header;
  for (const char c : lines) header += c == '\n' ? line_break : std::string(1, c);
  Bytes points(false);
  points.add(std::int8_t{10}).add(x).add(std::int8_t{13});
  points.add(std::int8_t{10}).add(1.0F).add(std::int8_t{0});
  points.add(std::int8_t{10}).add(0.0F).add(std::int8_t{1});
  const std::string face("\x3\x0\x1\x2", 4);
  return header + (has_faces_first ? face + points.text() : points.text() + face);
}

TEST(PlyReader, reads_binary_data_behind_every_line_break) {
  const PolygonMesh expected = testing::mesh_of({{5, 13, 10}, {1, 0, 10}, {0, 1, 10}}, {{0, 1, 2}});
  for (const std::string line_break : {"\n", "\r\n", "\r"}) {
    for (const bool has_faces_first : {false, true}) {
      EXPECT_TRUE(is_same(read(ten_high(line_break, has_faces_first, 5)).mesh, expected));
    }
  }
  expect_refused(ten_high("\n", true, std::numeric_limits<float>::infinity()),
                 ErrorCode::NumberOutOfRange, "vertex 1 is not finite, but a face uses it");
}

TEST(PlyReader, charges_the_lines_that_it_copies) {
  const std::string text = ten_high("\r", false, 5);
  Limits limits;
  limits.max_memory_bytes = text.size() - 1;
  EXPECT_THROW(read(text, limits), Error);
}

TEST(PlyReader, reads_every_type_in_both_orders) {
  for (const bool is_big : {false, true}) {
    const std::string header =
        format_line(is_big) +
        "element vertex 3\nproperty char x\nproperty ushort skipped\nproperty short y\nproperty "
        "float z\n"
        "property list uint double more\nelement edge 2\nproperty int a\nproperty uint b\n"
        "element face 1\nproperty uchar skipped\nproperty list ushort short "
        "vertex_index\nend_header\n";
    Bytes bytes(is_big);
    bytes.add(std::int8_t{-1}).add(std::uint16_t{9}).add(std::int16_t{-300}).add(0.5F);
    bytes.add(std::uint32_t{0});
    bytes.add(std::int8_t{2}).add(std::uint16_t{9}).add(std::int16_t{300}).add(-0.0F);
    bytes.add(std::uint32_t{2}).add(1.5).add(std::numeric_limits<double>::quiet_NaN());
    bytes.add(std::int8_t{3}).add(std::uint16_t{9}).add(std::int16_t{7}).add(1e-45F);
    bytes.add(std::uint32_t{0});
    for (int i = 0; i < 4; ++i) bytes.add(std::int32_t{-1});
    bytes.add(std::uint8_t{200}).add(std::uint16_t{3});
    bytes.add(std::int16_t{2}).add(std::int16_t{1}).add(std::int16_t{0});
    const PolygonMesh expected = testing::mesh_of(
        {{-1, -300, 0.5}, {2, 300, 0}, {3, 7, static_cast<double>(1e-45F)}}, {{2, 1, 0}});
    EXPECT_TRUE(is_same(read(header + bytes.text()).mesh, expected));
    for (std::size_t cut = 0; cut < bytes.text().size(); ++cut) {
      EXPECT_THROW(read(header + bytes.text().substr(0, cut)), Error) << cut;
    }
    EXPECT_TRUE(is_same(read(header + bytes.text() + '\n').mesh, expected));
  }
}

/// A file of three vertices and one face, each with 1-byte coordinates.
std::string small(const std::string& list, const std::string& face) {
  return format_line(false) +
         "element vertex 3\nproperty char x\nproperty char y\nproperty char z\nelement face 1\n"
         "property list " +
         list + " vertex_indices\nend_header\n" + std::string(9, '\x01') + face;
}

TEST(PlyReader, refuses_hostile_binary_files) {
  const auto face = [](std::initializer_list<int> bytes) {
    std::string text;
    for (const int b : bytes) text += static_cast<char>(b);
    return text;
  };
  EXPECT_EQ(read(small("uchar uchar", face({3, 0, 1, 2}))).mesh.face_count(), 1U);
  expect_refused(small("uchar uchar", face({3, 0, 1, 3})), ErrorCode::BadIndex,
                 "face 1 names vertex 3; there are 3");
  expect_refused(small("uchar char", face({3, 0, 1, -1})), ErrorCode::BadIndex, "names vertex -1");
  EXPECT_EQ(read(small("uchar uchar", face({2, 0, 1}))).mesh.corners.size(), 2U);
  expect_refused(small("char uchar", face({-3, 0, 1, 2})), ErrorCode::Syntax, "negative length");
  expect_refused(small("uchar uchar", face({4, 0, 1, 2})), ErrorCode::CountMismatch,
                 "longer than the file");
  expect_refused(small("uint uint", face({-1, -1, -1, -1, 0, 1, 2})), ErrorCode::CountMismatch,
                 "longer than the file");
  const auto floats = [](float length, float corner) {
    return Bytes(false).add(length).add(0.0F).add(corner).add(2.0F).text();
  };
  EXPECT_EQ(read(small("float float", floats(3, 1))).mesh.face_count(), 1U);
  expect_refused(small("float float", floats(3, 1.5F)), ErrorCode::BadIndex, "names vertex 1.5");
  expect_refused(small("float float", floats(3, 3)), ErrorCode::BadIndex, "names vertex 3;");
  expect_refused(small("float float", floats(2.5F, 1)), ErrorCode::Syntax, "a list of length 2.5");
  expect_refused(small("float float", floats(1e30F, 1)), ErrorCode::CountMismatch, "longer than");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_refused(small("float float", floats(3, nan)), ErrorCode::BadIndex, "names vertex nan");
  expect_refused(small("float float", floats(nan, 1)), ErrorCode::CountMismatch, "longer than");
  const std::string head =
      format_line(true) +
      "element vertex 1\nproperty double x\nproperty double y\nproperty float z\n"
      "end_header\n";
  expect_refused(head, ErrorCode::CountMismatch, "too short");
}

TEST(PlyReader, reads_exact_numbers_in_texts) {
  const PolygonMesh mesh = read(changed(kPlyTetrahedron, "\n1 0 0\n", "\n1/3 0 5\n")).mesh;
  ASSERT_EQ(mesh.exact.size(), 1U);
  EXPECT_EQ(mesh.exact[0].second, (RationalPoint3{Rational(1, 3), 0, 5}));
}

TEST(PlyWriter, writes_what_reads_back_as_the_same) {
  std::vector<Point3> ring;
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < 300; ++i) {
    ring.push_back({static_cast<double>(i), 0.1, -1e300});
    corners.push_back(i);
  }
  for (PolygonMesh mesh : {PolygonMesh{}, testing::tetrahedron(), testing::awkward_mesh(),
                           testing::exact_mesh(), testing::mesh_of(ring, {corners})}) {
    const std::string text = text_of(mesh);
    const std::string binary = binary_of(mesh);
    mesh.exact.clear();
    EXPECT_TRUE(is_same(read(text).mesh, mesh)) << text;
    EXPECT_TRUE(is_same(read(binary).mesh, mesh));
  }
}

}  // namespace
}  // namespace plumb::ply_test
