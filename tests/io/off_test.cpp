#include "plumb/io/mesh/off.h"

#include <gtest/gtest.h>

#include <cfenv>
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

TEST(OffReader, accepts_what_the_format_allows) {
  const auto with = [&](const std::string& from, const std::string& to) {
    return changed(kOffTetrahedron, from, to);
  };
  std::string with_crlf;
  for (const char c : kOffTetrahedron) with_crlf += c == '\n' ? "\r\n" : std::string(1, c);
  const std::vector<std::string> same{
      kOffTetrahedron,
      with_crlf,
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
