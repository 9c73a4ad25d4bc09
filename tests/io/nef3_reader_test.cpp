#include "plumb/io/nef3_reader.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "expect_refusals.h"
#include "hostile_meshes.h"
#include "mesh_checks.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/query/volumes.h"

namespace plumb::nef3_reader_test {
namespace {

using testing::changed;

SpaceComplex read(const std::string& text, Limits limits = {}) {
  Context context(limits);
  return read_nef3(text, {"some.file", true}, context);
}

std::string written(const SpaceComplex& complex) {
  std::ostringstream out;
  write_nef3(out, complex);
  return out.str();
}

SpaceComplex complex_of(const PolygonMesh& mesh) {
  Context context;
  SpaceComplex complex = complex_of_mesh(mesh, {}, context).complex;
  label_volumes(complex, context);
  for (std::size_t v = 0; v < complex.volume_count(); ++v) {
    complex.volume_mark[v] = static_cast<Mark>(v % 2);
  }
  return complex;
}

SpaceComplex complex_of(const std::string& file) {
  Context context;
  return complex_of(read_mesh_file(file, {}, {}, context).mesh);
}

/// All arrays but those that name planes and points, which have other numbers in other tables.
void expect_same_arrays(const SpaceComplex& a, const SpaceComplex& b) {
  EXPECT_EQ(a.vertex_mark, b.vertex_mark);
  EXPECT_EQ(a.vertex_volume, b.vertex_volume);
  EXPECT_EQ(a.vertex_facet, b.vertex_facet);
  EXPECT_EQ(a.star_begin, b.star_begin);
  EXPECT_EQ(a.star, b.star);
  EXPECT_EQ(a.edge_mark, b.edge_mark);
  EXPECT_EQ(a.edge_use, b.edge_use);
  EXPECT_EQ(a.edge_volume, b.edge_volume);
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.use_halfedge, b.use_halfedge);
  EXPECT_EQ(a.use_next, b.use_next);
  EXPECT_EQ(a.use_prev, b.use_prev);
  EXPECT_EQ(a.use_radial, b.use_radial);
  EXPECT_EQ(a.use_facet, b.use_facet);
  EXPECT_EQ(a.facet_mark, b.facet_mark);
  EXPECT_EQ(a.facet_volume, b.facet_volume);
  EXPECT_EQ(a.facet_origin, b.facet_origin);
  EXPECT_EQ(a.cycle_begin, b.cycle_begin);
  EXPECT_EQ(a.cycle, b.cycle);
  EXPECT_EQ(a.inner_begin, b.inner_begin);
  EXPECT_EQ(a.inner, b.inner);
  EXPECT_EQ(a.volume_mark, b.volume_mark);
}

void expect_same_planes(const SpaceComplex& a, const SpaceComplex& b) {
  for (std::size_t f = 0; f < a.facet_count(); ++f) {
    EXPECT_EQ(a.planes().primitive(a.facet_plane[f]), b.planes().primitive(b.facet_plane[f]));
  }
  for (std::size_t e = 0; e < a.edge_count(); ++e) {
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_EQ(a.planes().primitive(a.edge_planes[e][i]),
                b.planes().primitive(b.edge_planes[e][i]));
    }
  }
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    ASSERT_EQ(a.vertex_point[v].is_input(), b.vertex_point[v].is_input());
    if (!a.vertex_point[v].is_input()) continue;
    EXPECT_EQ(a.planes().point(a.vertex_point[v].input()),
              b.planes().point(b.vertex_point[v].input()));
  }
}

/// A set of every kind of lone item in an unbounded space: a vertex in a volume, one where three
/// planes meet, one on a line and a plane, a free edge, and of marks.
const std::string kLoners =
    "plumb-nef3 1\n"
    "11 6 4 1 0 0 2\n"
    "1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "frame -x\nframe +x\nframe -y\nframe +y\nframe -z\nframe +z\n"
    "3 0 0 -1\n0 123456789012345678901234567890 0 -1\n"
    "i 0.1 -5e-324 1e+300\ni 0 0 0\ni 0 2 0\n"
    "t 10 2 3\nl 2 3 11\nt 5 7 9\n"
    "1 1 1\n4 0 2\n5 1 0 1\n6 2 0 2\n"
    "1 3 0 2 0\n"
    "0\n1\n"
    "end\n";

TEST(Nef3, comes_back_as_it_was) {
  for (const char* name : {"tetrahedron.off", "l-block.off", "square-hole.off"}) {
    const SpaceComplex complex = complex_of("corpus/solids/" + std::string(name));
    const std::string text = written(complex);
    const SpaceComplex copy = read(text);
    expect_same_arrays(copy, complex);
    expect_same_planes(copy, complex);
    EXPECT_EQ(written(copy), text);
  }
}

TEST(Nef3, holds_vertices_that_no_double_is) {
  PolygonMesh mesh = testing::tetrahedron();
  mesh.exact = {{1, {Rational(4, 3), 0, 0}}};
  mesh.points[1].x = 4.0 / 3;
  const SpaceComplex complex = complex_of(mesh);
  const std::string text = written(complex);
  EXPECT_NE(text.find("\nt "), std::string::npos);
  const SpaceComplex copy = read(text);
  expect_same_arrays(copy, complex);
  expect_same_planes(copy, complex);
  EXPECT_EQ(written(copy), text);
}

// The plane through three doubles of very different sizes has longer coefficients than any double,
// and what plumb writes it reads.
TEST(Nef3, holds_planes_longer_than_any_double) {
  PolygonMesh mesh = testing::tetrahedron();
  mesh.points = {
      {1e-300, 2e300, 3e-10}, {5e299, 1e-299, 7e-305}, {3e-298, 9e-303, 1e300}, {0.1, 0.2, 0.3}};
  const SpaceComplex complex = complex_of(mesh);
  const std::string text = written(complex);
  EXPECT_EQ(written(read(text)), text);
}

TEST(Nef3, holds_lone_items_and_the_frame) {
  const SpaceComplex complex = read(kLoners);
  EXPECT_EQ(written(complex), kLoners);
  EXPECT_EQ(complex.planes().point(complex.vertex_point[0].input()), (Point3{0.1, -5e-324, 1e300}));
  EXPECT_TRUE(complex.planes().is_frame(complex.points().source(complex.vertex_point[3]).plane(0)));
  EXPECT_EQ(complex.vertex_mark[3], kBeyond);
  EXPECT_TRUE(complex.points().source(complex.vertex_point[2]).is_line());
}

TEST(Nef3, writes_what_is_used_alone) {
  SpaceComplex complex = complex_of(testing::tetrahedron());
  const std::string text = written(complex);
  const auto tables = copy(*complex.tables);
  tables->planes.intern(1, 2, 3, 4);
  tables->planes.intern_frame();
  tables->planes.add_point({7, 7, 7});
  tables->points.add(kPlaneX, kPlaneY, kPlaneZ);
  complex.tables = tables;
  EXPECT_EQ(written(complex), text);
}

TEST(Nef3, refuses_hostile_texts_with_their_place) {
  const auto with = [](const std::string& from, const std::string& to) {
    return changed(kLoners, from, to);
  };
  const std::vector<testing::HostileText> texts{
      {"empty", "", 1, 1, "plumb-nef3 1"},
      {"the plane", "plumb-nef2 1\n", 1, 1, "plumb-nef3 1"},
      {"another version", with("nef3 1", "nef3 2"), 1, 13, "version '2'"},
      {"nothing else", "plumb-nef3 1\n", 2, 1, "numbers of planes"},
      {"six counts", with("11 6 4 1 0 0 2", "11 6 4 1 0 0"), 2, 13, "the number of volumes"},
      {"eight counts", with("11 6 4 1 0 0 2", "11 6 4 1 0 0 2 1"), 2, 16, "seven numbers"},
      {"2^31 planes", with("11 6", "2147483648 6"), 2, 1, "too short"},
      {"2^32 - 2 uses", with("4 1 0 0 2", "4 1 4294967294 0 2"), 2, 1, "too short"},
      {"two planes", with("11 6", "2 6"), 2, 1, "at least three planes"},
      {"no volume", with("0 0 2", "0 0 0"), 2, 1, "at least three planes and one volume"},
      {"axes in another order", with("0 1 0 0\n0 0 1 0", "0 0 1 0\n0 1 0 0"), 4, 1,
       "in this order"},
      {"no normal", with("3 0 0 -1", "0 0 0 -1"), 12, 1, "no normal"},
      {"against its orientation", with("3 0 0 -1", "-3 0 0 1"), 12, 1, "not canonical"},
      {"a plane again", with("3 0 0 -1", "0 0 2 0"), 12, 1, "plane 10 is plane 3 again"},
      {"three coefficients", with("3 0 0 -1", "3 0 0"), 12, 6, "needs four numbers"},
      {"a frame out of order", with("frame -y\nframe +y", "frame +y\nframe -y"), 8, 1, "or none"},
      {"a frame too late", with("3 0 0 -1", "frame -x"), 12, 1, "or none"},
      {"a frame too early", with("\n1 0 0 0\n", "\nframe -x\n"), 3, 1, "or none"},
      {"a frame without a side", with("frame -x\n", "frame\n"), 6, 1, "or none"},
      {"a word like frame", with("frame -x\n", "frames -x\n"), 6, 1, "a plane, found 'frames'"},
      {"a frame of one",
       "plumb-nef3 1\n4 0 0 0 0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\nframe -x\n1\nend\n", 6, 1,
       "or none"},
      {"five coefficients", with("3 0 0 -1", "3 0 0 -1 7"), 12, 10, "the end of plane 10"},
      {"part of a frame", with("frame +z\n", "1 1 1 1\n"), 11, 1, "plane 9"},
      {"a kind of point", with("i 0 0 0", "p 0 0 0"), 15, 1, "i, t or l, found 'p'"},
      {"a point that is no double", with("i 0 0 0", "i 0 1/3 0"), 15, 5, "is no double"},
      {"nan", with("i 0 0 0", "i nan 0 0"), 15, 3, "'nan'"},
      {"parallel planes", with("t 10 2 3", "t 10 1 3"), 17, 1, "point 4 is not one point"},
      {"a plane too many", with("t 10 2 3", "t 10 2 12"), 17, 8, "ids run from 1 to 11"},
      {"a line in its plane", with("l 2 3 11", "l 2 3 1"), 18, 1, "not one point"},
      {"a line of constructed points", with("l 2 3 11", "l 2 4 11"), 18, 5, "no i before it"},
      {"a line of later points", with("l 2 3 11", "l 2 6 11"), 18, 5, "no i before it"},
      {"a vertex nowhere", with("4 0 2\n", "7 0 2\n"), 21, 1, "names point '7'"},
      {"a mark of 3", with("4 0 2\n", "4 3 2\n"), 21, 3, "names mark '3'"},
      {"volume 3", with("4 0 2\n", "4 0 3\n"), 21, 5, "names volume '3'"},
      {"a half-edge too many", with("5 1 0 1\n", "5 1 0 3\n"), 22, 7, "names half-edge '3'"},
      {"a half-edge of two vertices", with("6 2 0 2\n", "6 2 0 1\n"), 23, 7, "leaves two vertices"},
      {"a half-edge of none", with("6 2 0 2\n", "6 2 2\n"), 23, 6, "half-edge 2 leaves no vertex"},
      {"a use of no uses", with("1 3 0 2 0\n", "1 3 0 2 1\n"), 24, 9, "names use '1'"},
      {"a volume missing", with("0\n1\nend", "0\nend"), 26, 1, "a mark id, found 'end'"},
      {"no end", with("end\n", "#...\n"), 28, 1, "where end 1 of 1"},
      {"more after the end", kLoners + "1\n", 28, 1, "more after the end"},
      // whole records that do not fit together
      {"an edge from a vertex to itself", with("5 1 0 1\n6 2 0 2\n", "5 1 0 1 2\n6 2 2\n"), 0, 0,
       "edge 1: joins a vertex to itself"},
      {"an edge on one plane", with("1 3 0 2 0\n", "1 1 0 2 0\n"), 0, 0, "lies on one plane"},
      {"an edge nowhere", with("1 3 0 2 0\n", "1 3 0 0 0\n"), 0, 0, "is free in a volume or"},
      {"a lone vertex without volume", with("4 0 2\n", "4 0 0\n"), 0, 0, "vertex 2: has a volume"},
      {"a vertex of an edge with one", with("5 1 0 1\n", "5 1 1 1\n"), 0, 0, "vertex 3: has a"},
  };
  testing::expect_refusals(texts, [](const std::string& text) { read(text); });
}

/// The first facet of a tetrahedron: its plane, mark and volumes, then what `end` says.
std::string with_first_facet(const std::string& end) {
  std::istringstream in(written(complex_of(testing::tetrahedron())));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::string& facet = lines[lines.size() - 7];  // 4 facets, 2 volumes, the end
  std::istringstream words(facet);
  std::string plane, mark, above, below;
  words >> plane >> mark >> above >> below;
  facet = plane + ' ' + mark + ' ' + above + ' ' + below + ' ' + end;
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

TEST(Nef3, origins_of_facets_have_32_bits) {
  const SpaceComplex plain = complex_of(testing::tetrahedron());
  const std::string cycle = " 1 " + std::to_string(plain.cycle[0].value() + 1) + " 0";
  for (const std::uint32_t origin : {0U, 7U, 0xffff'fffeU, 0xffff'ffffU}) {
    const std::string text = with_first_facet(std::to_string(origin) + cycle);
    EXPECT_EQ(read(text).facet_origin[0], origin);
    EXPECT_EQ(written(read(text)), text);
  }
  for (const char* origin : {"4294967296", "42949672950", "4294967295x", "-1", "x"}) {
    EXPECT_THROW(read(with_first_facet(origin + cycle)), Error) << origin;
  }
}

TEST(Nef3, refuses_facets_that_hold_too_much) {
  const auto expect_refused = [](const std::string& end, const char* message) {
    try {
      read(with_first_facet(end));
      ADD_FAILURE() << message;
    } catch (const Error& error) {
      EXPECT_NE(error.message().find(message), std::string::npos) << error.what();
    }
  };
  expect_refused("0 13 " + testing::repeated("1 ", 13) + "0", "more cycles than uses");
  expect_refused("0 1 1 2 1 1", "vertex 1 is in two facets");
  expect_refused("0 1 1 1 1 1", "the end of facet 1");
}

/// Every word of a file replaced by every small number: refused, or links that can be followed.
TEST(Nef3, can_be_followed_whatever_word_is_changed) {
  const std::string text = written(complex_of(testing::tetrahedron()));
  std::size_t refused = 0;
  std::size_t all = 0;
  std::size_t at = text.find('\n') + 1;
  while (at < text.size()) {
    const std::size_t end = text.find_first_of(" \n", at);
    for (const std::string word : {"0", "1", "2", "3", "7", "12", "24"}) {
      const std::string other = text.substr(0, at) + word + text.substr(end);
      ++all;
      try {
        const SpaceComplex complex = read(other);
        EXPECT_EQ(flaw_of_links(complex), "");
        EXPECT_EQ(written(read(written(complex))), written(complex));
      } catch (const Error& error) {
        EXPECT_EQ(error.place().file, "some.file");
        ++refused;
      }
    }
    at = end + 1;
  }
  EXPECT_GT(refused, all / 2);
  EXPECT_LT(refused, all);
}

TEST(Nef3, keeps_to_its_limits) {
  const std::string text = written(complex_of(testing::tetrahedron()));
  Limits limits;
  limits.max_memory_bytes = 1000;
  EXPECT_THROW(read(text, limits), Error);
  limits.max_memory_bytes = 100 * text.size();
  EXPECT_EQ(read(text, limits).facet_count(), 4U);
}

}  // namespace
}  // namespace plumb::nef3_reader_test
