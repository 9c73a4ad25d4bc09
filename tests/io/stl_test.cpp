#include "plumb/io/mesh/stl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "expect_refusals.h"
#include "generate/crowded_points.h"
#include "hostile_meshes.h"
#include "little_endian.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/stl.h"

namespace plumb::stl_test {
namespace {

using testing::changed;
using testing::is_same;
using testing::kStlFacet;
using testing::kStlTriangle;

MeshFile read(const std::string& bytes, Limits limits = {}) {
  Context context(limits);
  return read_stl(bytes, {"some.file"}, context);
}

std::string text_of(const PolygonMesh& mesh) {
  std::ostringstream out;
  write_stl_text(out, mesh);
  return out.str();
}

std::string binary_of(const PolygonMesh& mesh) {
  std::ostringstream out;
  write_stl_binary(out, mesh);
  return out.str();
}

/// The number at byte `at` replaced.
template <class Number>
std::string with_number(std::string bytes, std::size_t at, Number value) {
  testing::place(bytes, at, value);
  return bytes;
}

/// The vertices in order of their use by faces, as STL has them.
PolygonMesh by_first_use(PolygonMesh mesh) {
  Context context;
  EXPECT_EQ(weld_vertices(mesh, context), 0U);
  return mesh;
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

TEST(StlReader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(testing::hostile_stl(), [](const std::string& text) { read(text); });
}

TEST(StlReader, refuses_hostile_binary_files) {
  const std::string good = binary_of(testing::tetrahedron());
  ASSERT_EQ(good.size(), 84U + 4 * 50);
  constexpr std::size_t kFirstCoordinate = 84 + 12;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const std::size_t size : {1U, 83U, 84U, 100U, 281U}) {
    EXPECT_THROW(read(good.substr(0, size)), Error) << size;
  }
  expect_refused(good.substr(0, 83), ErrorCode::UnknownFormat, "too short");
  expect_refused(good.substr(0, 84), ErrorCode::CountMismatch,
                 "at byte 84: the file, which is binary, ends where triangle 1 is expected; it "
                 "announces 4 triangles");
  expect_refused(good.substr(0, 281), ErrorCode::CountMismatch,
                 "at byte 234: the file, which is binary, ends within triangle 4; it announces 4");
  for (const std::uint32_t count : {0U, 5U, ~0U}) {
    expect_refused(with_number(good, 80, count).substr(0, 283), ErrorCode::CountMismatch,
                   "at byte 234: the file, which is binary, ends within triangle 4");
  }
  expect_refused(with_number(good, kFirstCoordinate, nan), ErrorCode::NumberOutOfRange,
                 "at byte 96: a coordinate that is not finite");
  expect_refused(with_number(good, kFirstCoordinate + 54, -infinity), ErrorCode::NumberOutOfRange,
                 "at byte 150: ");
}

/// The last two bytes of a triangle mean nothing, so the last triangle may lack them.
TEST(StlReader, the_last_attribute_may_be_cut_off) {
  const std::string good = binary_of(testing::tetrahedron());
  for (const std::size_t size : {282U, 283U}) {
    EXPECT_TRUE(is_same(read(good.substr(0, size)).mesh, read(good).mesh)) << size;
  }
}

TEST(StlReader, the_other_order_of_bytes_is_refused) {
  std::string reversed = binary_of(testing::tetrahedron());
  std::reverse(reversed.begin() + 80, reversed.begin() + 84);
  expect_refused(reversed, ErrorCode::UnknownFormat,
                 "at byte 80: the file has its numbers in big-endian order");
}

TEST(StlReader, accepts_what_the_format_allows) {
  const auto with = [&](const std::string& from, const std::string& to) {
    return changed(kStlTriangle, from, to);
  };
  const auto with_breaks = [](const std::string& line_break) {
    std::string text;
    for (const char c : kStlTriangle) text += c == '\n' ? line_break : std::string(1, c);
    return text;
  };
  std::string in_one_line = kStlTriangle;
  for (std::size_t i = in_one_line.find('\n') + 1; i < in_one_line.size(); ++i) {
    if (in_one_line[i] == '\n') in_one_line[i] = ' ';
  }
  const std::vector<std::string> same{
      kStlTriangle,
      in_one_line,
      "\xEF\xBB\xBF\n " + kStlTriangle,
      kStlTriangle.substr(0, kStlTriangle.size() - 1),
      kStlTriangle + "\nsolid two\nendsolid\n",
      with("solid one", "SOLID caf\xE9 # a b c"),
      with("facet normal", "FACET Normal"),
      with("normal 0 0 -1", "normal nan -nan(ind) 1e999"),
      with("endsolid one", "EndSolid"),
      with("vertex 0 1 0", "\tvertex  0.0 10e-1 -0.0\r"),
      with("normal 0 0 -1", "normal 0 0"),
      with(" normal 0 0 -1", ""),
      with("facet normal 0 0 -1\n", ""),
      with("endloop\nendfacet", "END LOOP\nend facet"),
      with("endfacet\n", ""),
      with("endsolid one", "end Solid one two"),
      with("endsolid one\n", "endsolid one\nendsolid one\n"),
      with("solid one\nfacet", "solid one\nsolid facet of one\nfacet"),
      with("solid one\nfacet", "solid one facet"),
      with_breaks("\r"),
      with_breaks("\r\n"),
      binary_of(testing::mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2}})),
  };
  const PolygonMesh expected = testing::mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2}});
  for (const std::string& text : same) {
    const MeshFile file = read(text);
    EXPECT_TRUE(is_same(file.mesh, expected)) << text;
    EXPECT_TRUE(file.notes.empty()) << text;
  }
  EXPECT_TRUE(is_same(read("solid nothing\nendsolid nothing\n").mesh, PolygonMesh{}));
}

TEST(StlReader, knows_binary_files_that_begin_with_solid) {
  std::string bytes = binary_of(testing::tetrahedron());
  bytes.replace(0, 11, "solid thing");
  EXPECT_TRUE(is_binary_stl(bytes));
  EXPECT_TRUE(is_same(read(bytes).mesh, by_first_use(testing::tetrahedron())));
  EXPECT_FALSE(is_binary_stl(kStlTriangle));
}

TEST(StlReader, names_what_it_passes_over_in_texts) {
  const PolygonMesh expected = testing::mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 2}});
  const std::vector<std::pair<std::string, std::string>> files{
      {"solid one\n" + kStlFacet, "the last endsolid is missing; every facet is whole"},
      {kStlTriangle + "solid two\n", "the last endsolid is missing; every facet is whole"},
      {changed(kStlTriangle, "facet", "color 1 0 0\nfacet"), "passed over: colours of solids"},
      {kStlTriangle + std::string(9, '\0') + '\x1A', "passed over: 10 bytes behind the text"},
  };
  for (const auto& [text, note] : files) {
    const MeshFile file = read(text);
    EXPECT_TRUE(is_same(file.mesh, expected)) << text;
    EXPECT_EQ(file.notes, std::vector<std::string>{note});
  }
  EXPECT_EQ(read("solid one\n" + kStlFacet + "solid two\n" + kStlFacet).mesh.face_count(), 2U);
}

/// A binary tetrahedron that says it has `count` triangles, before and behind what its writer adds.
std::string announcing(std::uint32_t count, const std::string& begin, const std::string& end) {
  std::string bytes = with_number(binary_of(testing::tetrahedron()), 80, count);
  return bytes.replace(0, begin.size(), begin) + end;
}

TEST(StlReader, decides_between_text_and_binary_by_content) {
  const PolygonMesh expected = by_first_use(testing::tetrahedron());
  const std::string more = "passed over: 2 bytes behind the last triangle";
  const auto count = [](const std::string& announced) {
    return "the file announces " + announced + " and has 4; all of these were read";
  };
  using Notes = std::vector<std::string>;
  const std::vector<std::pair<std::string, Notes>> ends{{"", {}}, {"\r\n", {more}}};
  for (const std::string begin : {"", "solid", "solid part\nfacet normal 0 0 1\nouter loop\n"}) {
    for (const auto& [end, of_end] : ends) {
      for (const auto& [announced, words] : std::vector<std::pair<std::uint32_t, std::string>>{
               {4, ""}, {0, "0 triangles"}, {~0U, "4294967295 triangles"}, {1, "1 triangle"}}) {
        Notes notes = of_end;
        if (announced != 4) notes.insert(notes.begin(), count(words));
        const MeshFile file = read(announcing(announced, begin, end));
        EXPECT_TRUE(is_same(file.mesh, expected)) << begin << announced;
        EXPECT_EQ(file.notes, notes) << begin << announced;
      }
    }
    const MeshFile file = read(announcing(5, begin, ""));
    EXPECT_TRUE(is_same(file.mesh, expected));
    EXPECT_EQ(file.notes, Notes{count("5 triangles")});
  }
  EXPECT_EQ(read(announcing(4, "", std::string(512, '\0'))).notes,
            Notes{"passed over: 512 bytes behind the last triangle"});
  expect_refused(announcing(5, "solid", "\n"), ErrorCode::CountMismatch,
                 "at byte 284: the file, which is binary, ends within triangle 5; it announces 5");
}

TEST(StlReader, skips_the_bytes_that_attributes_announce) {
  const std::string plain = binary_of(testing::tetrahedron());
  std::string bytes = plain.substr(0, 84);
  for (std::uint16_t t = 0; t < 4; ++t) {
    bytes += with_number(plain.substr(84 + 50 * std::size_t{t}, 50), 48, t) + std::string(t, 'x');
  }
  const MeshFile file = read(bytes);
  EXPECT_TRUE(is_same(file.mesh, by_first_use(testing::tetrahedron())));
  EXPECT_EQ(file.notes, std::vector<std::string>{"passed over: attributes of triangles"});
}

TEST(StlReader, charges_the_lines_that_it_copies) {
  std::string text = kStlTriangle;
  std::replace(text.begin(), text.end(), '\n', '\r');
  Limits limits;
  limits.max_memory_bytes = text.size() - 1;
  EXPECT_THROW(read(text, limits), Error);
}

TEST(StlReader, tells_of_attributes) {
  const std::string bytes =
      with_number(binary_of(testing::tetrahedron()), 84 + 48, std::uint16_t{7});
  EXPECT_EQ(read(bytes).notes, std::vector<std::string>{"passed over: attributes of triangles"});
}

TEST(StlReader, leaves_out_triangles_with_equal_corners_and_says_so) {
  const PolygonMesh mesh =
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {9, 9, 9}, {2, 0, 0}},
                       {{0, 3, 1}, {4, 1, 4}, {3, 1, 2}, {0, 1, 5}, {2, 1, 0}});
  const MeshFile file = read(text_of(mesh));
  EXPECT_EQ(file.notes, std::vector<std::string>{"2 triangles with two equal corners left out"});
  // The one whose corners are on one line stays: its edges hold the others together.
  EXPECT_TRUE(is_same(file.mesh, testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}},
                                                  {{0, 1, 2}, {0, 1, 3}, {2, 1, 0}})));
}

TEST(StlReader, merges_by_exact_coordinates) {
  const std::string text =
      "solid\nfacet normal 0 0 0 outer loop vertex 1/3 0 0 vertex 0 1 0 vertex 0.3333333333333333 "
      "0 0"
      " endloop endfacet\nfacet normal 0 0 0 outer loop vertex 2/6 0 0 vertex 0 1 0 vertex 3 3 3"
      " endloop endfacet\nendsolid\n";
  const PolygonMesh mesh = read(text).mesh;
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3}));
  ASSERT_EQ(mesh.exact.size(), 1U);
  EXPECT_EQ(mesh.exact[0].first, 0U);
  EXPECT_EQ(mesh.points[0], mesh.points[2]);
}

TEST(StlReader, points_that_crowd_in_a_table_take_no_more_memory) {
  PolygonMesh mesh;
  mesh.points = testing::crowded_points(9999);
  for (std::uint32_t i = 0; i < 9999; i += 3) mesh.add_face(std::array{i, i + 1, i + 2});
  const PolygonMesh soup = mesh;
  for (std::uint32_t i = 9999; i-- > 0;)
    mesh.add_face(std::array{i, (i + 1) % 9999, (i + 2) % 9999});
  Context context;
  EXPECT_EQ(weld_vertices(mesh, context), 0U);
  EXPECT_TRUE(
      std::equal(soup.points.begin(), soup.points.end(), mesh.points.begin(), mesh.points.end()));
}

TEST(StlReader, keeps_to_its_limits) {
  const std::string bytes = binary_of(testing::tetrahedron());
  Limits limits;
  limits.max_memory_bytes = 4 * 3 * sizeof(Point3);
  EXPECT_THROW(read(bytes, limits), Error);
  limits.max_memory_bytes = 100'000;
  EXPECT_EQ(read(bytes, limits).mesh.face_count(), 4U);
}

TEST(StlWriter, writes_what_reads_back_as_the_same) {
  PolygonMesh awkward = testing::awkward_mesh();
  awkward = testing::mesh_of(awkward.points, {{0, 1, 2}, {2, 1, 3}, {4, 0, 3}});
  EXPECT_TRUE(is_same(read(text_of(awkward)).mesh, by_first_use(awkward)));
  const PolygonMesh tetrahedron = by_first_use(testing::tetrahedron());
  EXPECT_TRUE(is_same(read(text_of(tetrahedron)).mesh, tetrahedron));
  EXPECT_TRUE(is_same(read(binary_of(tetrahedron)).mesh, tetrahedron));
  EXPECT_TRUE(is_same(read(binary_of(PolygonMesh{})).mesh, PolygonMesh{}));
}

TEST(StlWriter, rounds_to_floats) {
  const PolygonMesh mesh =
      testing::mesh_of({{0.1, 1.0 / 3, 1e-50}, {16777217, 3e38, 0}, {0, 0, 1e-45}}, {{0, 1, 2}});
  const PolygonMesh rounded = rounded_to_floats(mesh);
  EXPECT_EQ(rounded.points[0], (Point3{0.1F, static_cast<double>(1.0F / 3), 0}));
  EXPECT_EQ(rounded.points[1].x, 16777216);
  EXPECT_TRUE(is_same(read(binary_of(mesh)).mesh, rounded));
  EXPECT_THROW(binary_of(testing::mesh_of({{3.5e38, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})),
               Error);
}

TEST(StlWriter, holds_triangles_only) {
  const PolygonMesh square =
      testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  EXPECT_THROW(text_of(square), Error);
  EXPECT_THROW(binary_of(square), Error);
}

}  // namespace
}  // namespace plumb::stl_test
