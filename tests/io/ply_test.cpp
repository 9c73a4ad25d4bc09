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
  std::string with_crlf;
  for (const char c : kPlyTetrahedron) with_crlf += c == '\n' ? "\r\n" : std::string(1, c);
  const std::vector<std::string> same{
      kPlyTetrahedron,
      with_crlf,
      kPlyTetrahedron.substr(0, kPlyTetrahedron.size() - 1),
      kPlyTetrahedron + "\n\n",
      with("format ascii 1.0\n", "comment caf\xE9\nformat ascii 1.0\nobj_info x y z\n"),
      with("vertex_indices", "vertex_index"),
      with("uchar int", "int32 uint8"),
      with("property double x", "property float32 x"),
      with("\n1 0 0\n", "\n 1.0\t0/3 -0.0 \n"),
      with("element face 4", "element nothing 4294967294\nelement face 4"),
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
                            "passed over: other elements, other properties of faces, other "
                            "properties of vertices"});
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
    expect_refused(header + bytes.text() + '\n', ErrorCode::CountMismatch, "after the last");
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
  const std::string head =
      format_line(true) +
      "element vertex 1\nproperty double x\nproperty double y\nproperty float z\n"
      "end_header\n";
  Bytes bytes(true);
  bytes.add(0.0).add(std::numeric_limits<double>::infinity()).add(0.0F);
  expect_refused(head + bytes.text(), ErrorCode::NumberOutOfRange,
                 "a coordinate of vertex 1 is not finite");
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
