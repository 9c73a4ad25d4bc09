#include "plumb/io/mesh/off.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <limits>
#include <sstream>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "expect_refusals.h"
#include "hostile_meshes.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/off.h"

namespace plumb::off_test {
namespace {

using testing::changed;
using testing::is_same;
using testing::kOffTetrahedron;

MeshFile read(const std::string& text, bool exact_decimals = false, Limits limits = {}) {
  Context context(limits);
  return read_off(text, {"some.file", exact_decimals}, context);
}

std::string written(const PolygonMesh& mesh, MeshNumbers numbers = MeshNumbers::Nearest) {
  std::ostringstream out;
  write_off(out, mesh, numbers);
  return out.str();
}

TEST(OffReader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(testing::hostile_off(), [](const std::string& text) { read(text); });
}

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string number_a_line(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '\n');
  return text;
}

TEST(OffReader, accepts_what_the_format_allows) {
  const auto with = [&](const std::string& from, const std::string& to) {
    return changed(kOffTetrahedron, from, to);
  };
  std::string with_crlf;
  for (const char c : kOffTetrahedron) with_crlf += c == '\n' ? "\r\n" : std::string(1, c);
  std::string with_cr = kOffTetrahedron;
  std::replace(with_cr.begin(), with_cr.end(), '\n', '\r');
  const std::vector<std::string> same{
      kOffTetrahedron,
      with_crlf,
      with_cr,
      kOffTetrahedron.substr(0, kOffTetrahedron.size() - 1),
      "\xEF\xBB\xBF" + kOffTetrahedron,
      "# first\n\n" + kOffTetrahedron + "\n# last\n",
      with("OFF\n", ""),
      with("OFF\n", "OFF "),
      with("OFF\n", "OFF"),
      with("OFF\n", "OFF # the object\n\n"),
      with("4 4 6", "4 4"),
      with("4 4 6", "  4\t4 0  # counts"),
      with("1 0 0", "1.0 0e7 -0.0 # second"),
      with("1 0 0", "3/3 +0 -0/5"),
      with("1 0 0", "1.00000000000000000000000000000000000000 0. .0"),
      with("3 0 2 1", "3  0 2\t1 # first"),
      with("OFF\n", "off\n"),
      with("OFF\n", "Off "),
      with("4 4 6", "4\n4 # faces\n6"),
      with("4 4 6", "4\n\n4 6"),
      with("4 4 6\n", "4\n4\n"),
      with("4 4 6", "4 4 -1"),
      with("4 4 6", "4 4 4294967296"),
      with("1 0 0", "1 # x\n\n0 # y\n0"),
      testing::kOffOverLines,
      on_one_line(kOffTetrahedron),
      on_one_line(kOffTetrahedron.substr(4)),
      with("4 4 6\n", "4 4 6 "),
      with("1 0 0\n", "1 0 0 "),
      with("3 0 2 1\n", "3 0 2 1 "),
      with("0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "0 0 0 1 0 0\n0 1 0 0 0 1\n"),
      number_a_line(kOffTetrahedron),
  };
  for (const std::string& text : same) {
    const MeshFile file = read(text);
    EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron())) << text;
    EXPECT_TRUE(file.notes.empty()) << text;
  }
}

TEST(OffReader, passes_over_normals_and_colours_and_says_so) {
  const std::string body = kOffTetrahedron.substr(4);
  const auto with_each_vertex = [&](const std::string& keyword, const std::string& more) {
    std::string text = keyword + '\n' + body;
    for (const std::string line : {"\n0 0 0\n", "\n1 0 0\n", "\n0 1 0\n", "\n0 0 1\n"}) {
      text = changed(text, line, line.substr(0, 6) + more + '\n');
    }
    return text;
  };
  const std::vector<std::pair<std::string, std::string>> texts{
      {with_each_vertex("NOFF", " 0 0 1"), "normals of vertices"},
      {with_each_vertex("COFF", " 255 0 0 255"), "colours of vertices"},
      {with_each_vertex("COFF", " 0.5 0.5 1"), "colours of vertices"},
      {with_each_vertex("COFF", ""), "colours of vertices"},
      {with_each_vertex("STOFF", " 0.1 0.2"), "texture coordinates"},
      {with_each_vertex("CNOFF", " 0 0 -1 255 0 0 255"),
       "normals of vertices, colours of vertices"},
      {with_each_vertex("STCNOFF", " 0 0 -1 255 0 0 255 0 1"),
       "normals of vertices, colours of vertices, texture coordinates"},
      {changed(kOffTetrahedron, "3 0 2 1", "3 0 2 1 255 0 0"), "colours of faces"},
      {changed(kOffTetrahedron, "3 0 2 1", "3 0 2 1 0.5 0.5 0.5 1 # red"), "colours of faces"},
      {changed(kOffTetrahedron, "3 0 2 1", "3 0 2 1 7"), "colours of faces"},
      {changed(kOffTetrahedron, "3 0 2 1", "3 0 2 1 red"), "colours of faces"},
      {with_each_vertex("coff", " 255 0 0"), "colours of vertices"},
      {with_each_vertex("noff", " 0 0 1"), "normals of vertices"},
      {with_each_vertex("NOFF", " nan nan nan"), "normals of vertices"},
      {with_each_vertex("COFF", " nan -nan(ind) inf"), "colours of vertices"},
      {with_each_vertex("OFF", " 255 0 0"), "numbers behind the coordinates of vertices"},
      {with_each_vertex("OFF", " 1 2 3 4 5 6 7 # x"), "numbers behind the coordinates of vertices"},
      {with_each_vertex("NOFF", " 0 0 1 255 0 0"),
       "normals of vertices, numbers behind the coordinates of vertices"},
      {with_each_vertex("COFF", "\n255 0 0 1"), "colours of vertices"},
      {on_one_line(with_each_vertex("STCNOFF", " 0 0 -1 255 0 0 255 0 1")),
       "normals of vertices, colours of vertices, texture coordinates"},
      {"OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0\n2 1 9\n3\n0\n1 3 8\n3 0 3 2 7\n3 1 2 3 6\n",
       "colours of faces"},
      {changed(kOffTetrahedron, "4 4 6", "4 4 6 0 0"), "numbers behind the counts"},
  };
  for (const auto& [text, passed] : texts) {
    const MeshFile file = read(text);
    EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron())) << text;
    EXPECT_EQ(file.notes, std::vector<std::string>{"passed over: " + passed}) << text;
  }
}

TEST(OffReader, reads_numbers_exactly) {
  const std::string text =
      "OFF\n4 1 0\n1/3 -22/7 0\n9007199254740993 9007199254740992 1\n0.1 5e-324 1e-400\n" +
      std::string(400, '9') + " 0 0\n3 0 1 2\n";
  const PolygonMesh mesh = read(text).mesh;
  ASSERT_EQ(mesh.exact.size(), 3U);
  EXPECT_EQ(mesh.exact[0].first, 0U);
  EXPECT_EQ(mesh.exact[0].second, (RationalPoint3{Rational(1, 3), Rational(-22, 7), 0}));
  EXPECT_EQ(mesh.points[0], (Point3{1.0 / 3, -22.0 / 7, 0}));
  EXPECT_EQ(mesh.exact[1].second.x, Rational("9007199254740993"));
  EXPECT_EQ(mesh.exact[2].first, 3U);
  EXPECT_EQ(mesh.points[2], (Point3{0.1, 5e-324, 0}));
  EXPECT_EQ(mesh.points[3].x, 1.7976931348623157e308);
  const PolygonMesh exact = read(changed(text, "1e-400", "1e-300"), true).mesh;
  EXPECT_EQ(exact.exact.size(), 4U);
  EXPECT_EQ(exact.exact[2].second.x, Rational(1, 10));
}

TEST(OffReader, rounds_to_nearest_in_every_rounding_mode) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const MeshFile file = read("OFF\n2 0 0\n0.1 0.3 1/3\n-1/3 12345678901234567890.1 0.7\n");
    EXPECT_EQ(std::fegetround(), mode);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(file.mesh.points[0], (Point3{0.1, 0.3, 1.0 / 3}));
    EXPECT_EQ(file.mesh.points[1], (Point3{-1.0 / 3, 12345678901234567890.1, 0.7}));
  }
}

/// A mesh in the binary form. `more` follows the coordinates of each vertex.
std::string binary(const std::string& keyword, const PolygonMesh& mesh, std::vector<float> more,
                   std::vector<float> colour) {
  std::string bytes = keyword + " BINARY\n";
  const auto put = [&](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift));
  };
  const auto put_float = [&](double value) {
    put(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  };
  put(static_cast<std::uint32_t>(mesh.points.size()));
  put(static_cast<std::uint32_t>(mesh.face_count()));
  put(7);
  for (const Point3& p : mesh.points) {
    for (const double value : {p.x, p.y, p.z}) put_float(value);
    for (const float value : more) put_float(value);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    put(static_cast<std::uint32_t>(mesh.face(f).size()));
    for (const std::uint32_t v : mesh.face(f)) put(v);
    put(static_cast<std::uint32_t>(colour.size()));
    for (const float value : colour) put_float(value);
  }
  return bytes;
}

TEST(OffReader, passes_over_vertices_that_are_not_finite_if_no_face_needs_them) {
  const std::vector<std::string> files{
      changed(changed(kOffTetrahedron, "4 4 6", "6 5 6"), "3 0 2 1",
              "0 nan 0\n-nan(ind) 1.#IND inf\n4 4 0 4 0\n3 0 2 1"),
      "OFF 6 4 6 0 0 0 1 0 0 0 1 0 0 0 1 0 -INF 0 NaN 0 0 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3"};
  for (const std::string& text : files) {
    const MeshFile file = read(text);
    EXPECT_EQ(file.mesh.points.size(), 6U);
    EXPECT_EQ(file.mesh.points[5], Point3{});
    EXPECT_EQ(file.notes, std::vector<std::string>{
                              "vertices that are not finite, used by no face with area: 2"});
  }
  PolygonMesh mesh = testing::tetrahedron();
  mesh.points.push_back({0, std::numeric_limits<double>::quiet_NaN(), 0});
  EXPECT_EQ(read(binary("OFF", mesh, {}, {})).notes.size(), 1U);
}

TEST(OffReader, names_what_follows_the_last_face) {
  for (const std::string& text : {kOffTetrahedron, testing::kOffOverLines}) {
    const MeshFile file = read(text + "# x\n\nend of file 7\n");
    EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron()));
    const auto lines = std::count(text.begin(), text.end(), '\n');
    EXPECT_EQ(file.warnings, std::vector<std::string>{"what follows the last face was not read: "
                                                      "'end' in line " +
                                                      std::to_string(lines + 3)});
  }
}

TEST(OffReader, reads_the_binary_form) {
  PolygonMesh mesh = testing::tetrahedron();
  mesh.points[1].x = -0.125;
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const MeshFile plain = read(binary("OFF", mesh, {}, {}));
  EXPECT_TRUE(is_same(plain.mesh, mesh));
  EXPECT_TRUE(plain.notes.empty());
  EXPECT_TRUE(
      is_same(read(changed(binary("off", mesh, {}, {}), "BINARY\n", "binary\r\n")).mesh, mesh));
  const MeshFile all =
      read(binary("# x\nSTCNOFF", mesh, {0, 0, 1, 1, 0, 0, 1, kNan, 0}, {1, 0, 0}));
  EXPECT_TRUE(is_same(all.mesh, mesh));
  EXPECT_EQ(all.notes, std::vector<std::string>{"passed over: normals of vertices, colours of "
                                                "vertices, texture coordinates, colours of faces"});
  const MeshFile more = read(binary("OFF", mesh, {}, {}) + "abc");
  EXPECT_EQ(more.warnings, std::vector<std::string>{"what follows the last face was not read: 3 "
                                                    "bytes from byte 151 on"});
}

TEST(OffReader, refuses_broken_binary_files) {
  PolygonMesh mesh = testing::tetrahedron();
  const std::string good = binary("OFF", mesh, {}, {});
  for (std::size_t size = 11; size < good.size(); ++size) {
    EXPECT_THROW(read(good.substr(0, size)), Error) << size;
  }
  const auto message = [](const std::string& bytes) {
    try {
      read(bytes);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("was read");
  };
  mesh.corners[4] = 4;
  EXPECT_EQ(message(binary("OFF", mesh, {}, {})),
            "some.file: at byte 99: face 2 names vertex 4; there are 4, numbered from 0");
  mesh.corners[4] = 1;
  mesh.points[2].z = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(binary("OFF", mesh, {}, {})),
            "some.file: at byte 47: vertex 3 is not finite, but a face uses it");
  EXPECT_EQ(message(good.substr(0, 140)),
            "some.file: at byte 131: the file is too short for face 4 of 4");
  EXPECT_EQ(
      message("OFF BINARY\n" + std::string(12, '\x7F') + std::string(99, 'x')),
      "some.file: at byte 11: 2139062143 vertices and 2139062143 faces are announced, but the "
      "file is too short for them");
}

TEST(OffReader, releases_the_memory_of_layouts_that_do_not_fit) {
  const std::string text = "OFF\n20000 0 0\n" + testing::repeated("1 2 3 ", 20000);
  Limits limits;
  limits.max_memory_bytes = 20001 * sizeof(Point3);
  EXPECT_EQ(read(text, false, limits).mesh.points.size(), 20000U);
}

TEST(OffReader, reads_an_empty_mesh) {
  EXPECT_TRUE(is_same(read("OFF\n0 0 0\n").mesh, PolygonMesh{}));
}

TEST(OffReader, keeps_to_its_limits) {
  const std::string text = "OFF\n20000 0 0\n" + testing::repeated("1 2 3\n", 20000);
  Limits limits;
  limits.max_memory_bytes = 19999 * sizeof(Point3);
  EXPECT_THROW(read(text, false, limits), Error);
  limits.max_memory_bytes = 20001 * sizeof(Point3);
  EXPECT_EQ(read(text, false, limits).mesh.points.size(), 20000U);
  std::stop_source source;
  source.request_stop();
  Context context({}, source.get_token());
  EXPECT_THROW(read_off(kOffTetrahedron, {}, context), Error);
}

TEST(OffReader, tells_where_a_limit_was_met) {
  const std::string text = "OFF\n1000 0 0\n" + testing::repeated("1/3 2/3 1/7\n", 1000);
  Limits limits;
  limits.max_memory_bytes = 100'000;
  try {
    read(text, false, limits);
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    EXPECT_EQ(error.place().file, "some.file");
    EXPECT_GT(error.place().line, 100U);
  }
}

TEST(OffWriter, writes_what_reads_back_as_the_same) {
  for (const PolygonMesh& mesh :
       {PolygonMesh{}, testing::tetrahedron(), testing::awkward_mesh(), testing::exact_mesh()}) {
    EXPECT_TRUE(is_same(read(written(mesh, MeshNumbers::Exact)).mesh, mesh));
    PolygonMesh rounded = mesh;
    rounded.exact.clear();
    EXPECT_TRUE(is_same(read(written(mesh)).mesh, rounded)) << written(mesh);
  }
}

}  // namespace
}  // namespace plumb::off_test
