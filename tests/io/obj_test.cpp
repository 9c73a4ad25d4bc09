#include "plumb/io/mesh/obj.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "hostile_meshes.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/obj.h"

namespace plumb::obj_test {
namespace {

using testing::changed;
using testing::is_same;
using testing::kObjTetrahedron;

MeshFile read(const std::string& text, bool exact_decimals = false, Limits limits = {}) {
  Context context(limits);
  return read_obj(text, {"some.file", exact_decimals}, context);
}

TEST(ObjReader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(testing::hostile_obj(), [](const std::string& text) { read(text); });
}

TEST(ObjReader, accepts_what_the_format_allows) {
  const auto with = [&](const std::string& from, const std::string& to) {
    return changed(kObjTetrahedron, from, to);
  };
  std::string with_crlf;
  for (const char c : kObjTetrahedron) with_crlf += c == '\n' ? "\r\n" : std::string(1, c);
  std::string with_cr = kObjTetrahedron;
  std::replace(with_cr.begin(), with_cr.end(), '\n', '\r');
  const std::vector<std::string> same{
      kObjTetrahedron,
      with_crlf,
      with_cr,
      kObjTetrahedron.substr(0, kObjTetrahedron.size() - 1),
      "\xEF\xBB\xBF" + kObjTetrahedron,
      "# first\n\n" + kObjTetrahedron + "\n# last\n",
      with("v 1 0 0", "  v\t1.0  0e7 -0.0 # second"),
      with("v 1 0 0", "v 3/3 +0 0"),
      with("v 1 0 0", "v 1 \\\n0 \\\n\\\n 0"),
      with("f 1 3 2", "f 1/1 3/2 2/3"),
      with("f 1 3 2", "f 1//1 3//1 2//1"),
      with("f 1 3 2", "f 1/1/1 3/-2/-1 2/3/1 # first"),
      with("f 1 3 2", "f -4 -2 -3"),
      with("f 1 3 2", "f -4/7 -2//-9 0002"),
      with("f 1 3 2", "f 1 \\\n3 \\\r\n\\\n2"),
      with("f 1 3 2", "f 1 3 2 \\\n"),
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf 1 2 4\nf 1 4 3\nf 2 3 4 \\",
      with("v 1 0 0", "V 1 0 0"),
      with("f 1 3 2", "F 1 3 2"),
      with("f 1 3 2", "fo 1 3 2"),
      with("f 1 3 2", "f 1// 3/ 2/1/"),
      with("f 1 3 2", "f 1/nan 3/x/ 2//-"),
      with("f 1 3 2", "f 1 3\\\n 2"),
      with("f 1 3 2", "f 1/1\\\n3//\\\r\n 2"),
      with("f 1 3 2", "f 1 3 \\ \t\n2"),
      with("f 1 3 2", "f\\\n1 3 2"),
      with("v 1 0 0", "v 1\\\n 0.0\\  \n0"),
      with("v 1 0 0", "\\\nv 1 0 0"),
      with("v 1 0 0", "# \\\nv 1 0 0"),
      "f 1 3 2\nf 1 2 4\nf 1/2 4/3 3/2\nf 2 3 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n",
      "v 0 0 0\nv 1 0 0\nf 1 3 2\nf -2 -1 4\nv 0 1 0\nf 1 4 3\nv 0 0 1\nf 2 3 -1\n",
  };
  for (const std::string& text : same) {
    const MeshFile file = read(text);
    EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron())) << text;
    EXPECT_TRUE(file.notes.empty()) << text;
  }
}

TEST(ObjReader, passes_over_what_no_mesh_holds_and_says_so) {
  const std::vector<std::pair<std::string, std::string>> statements{
      {"vn 0 0 nan\n", "normals of vertices"},
      {"vt 0.5 0.5\n", "texture coordinates"},
      {"o thing\ng a b c\ns off\nmtllib caf\xE9.mtl\nusemtl a#b\n", "names, groups and materials"},
      {"l 1 2 \\\n3\n", "lines"},
      {"p 1\nvn 0 0 1\np 2\n", "points, normals of vertices"},
      {"cstype bezier\nvp 0.5\\\n1\nend\n", "parameters of free-form curves and surfaces"},
      {"lod 3\n", "display attributes"},
      {"csh -ls\n", "commands"},
      {"vn 0\\\n0 1\nvt 1 2 \\ \n3\n", "normals of vertices, texture coordinates"},
      {"mtllib C:\\models\\\n", "names, groups and materials"},
      {"g a \\\nb\n", "names, groups and materials"},
      {"vw 0 1\nt crease\n#x\nvw 1 2\n", "unknown statements 'vw', 't'"},
      {"C:\\\n", "unknown statements 'C:'"},
      {"a\nb\nc\nd\ne\nff\nh\ni\nj\nk\n",
       "unknown statements 'a', 'b', 'c', 'd', 'e', 'ff', 'h', 'i' and others"},
  };
  for (const auto& [text, passed] : statements) {
    for (const std::string& all : {kObjTetrahedron + text, text + kObjTetrahedron}) {
      const MeshFile file = read(all);
      EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron())) << all;
      EXPECT_EQ(file.notes, std::vector<std::string>{"passed over: " + passed}) << all;
    }
  }
}

TEST(ObjReader, warns_of_geometry_that_it_does_not_read) {
  const std::vector<std::pair<std::string, std::string>> statements{
      {"curv 0 1 1 2\n", "free-form curves"},
      {"surf 0 1 0 1 1 2 3 4\ntrim 0 1 1\n", "free-form surfaces"},
      {"bsp 1 2 3 4\ncdc 1 2\nsurf 0 1 0 1 1\\\n2 3 4\n", "free-form surfaces, free-form curves"},
      {"call other.obj\n", "other files (call)"},
  };
  for (const auto& [text, left_out] : statements) {
    for (const std::string& all : {kObjTetrahedron + text, text + kObjTetrahedron}) {
      const MeshFile file = read(all);
      EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron())) << all;
      EXPECT_EQ(file.warnings, std::vector<std::string>{"geometry that was not read: " + left_out})
          << all;
    }
  }
}

TEST(ObjReader, passes_over_vertices_that_are_not_finite_if_no_face_needs_them) {
  for (const std::string more :
       {"v nan nan nan\nv 1\\\n -inf 1.#QNAN 1\n", "v 0 NaN 0\nv INF 0 0\nf 5 6 5 6\nf 5\n"}) {
    const MeshFile file = read(kObjTetrahedron + more);
    EXPECT_EQ(file.mesh.points.size(), 6U);
    EXPECT_EQ(file.notes.back(), "vertices that are not finite, used by no face with area: 2");
  }
}

TEST(ObjReader, takes_weights_and_colours_of_vertices) {
  for (const auto& [more, passed] : std::vector<std::pair<std::string, std::string>>{
           {" 1", "weights of vertices"},
           {" 0.5 0.5 0.5", "colours of vertices"},
           {" nan nan nan", "colours of vertices"},
           {" 1\\\n-nan(ind) inf", "colours of vertices"},
           {" 0.5 0.5", "other numbers of vertices"},
           {" 0 0 1 w 0 0", "other numbers of vertices"},
           {" 0.5 0.5 0.5 1", "colours of vertices"}}) {
    const MeshFile file = read(changed(kObjTetrahedron, "v 1 0 0", "v 1 0 0" + more));
    EXPECT_TRUE(is_same(file.mesh, testing::tetrahedron()));
    EXPECT_EQ(file.notes, std::vector<std::string>{"passed over: " + passed});
  }
}

TEST(ObjReader, reads_numbers_exactly) {
  const PolygonMesh mesh = read("v 1/3 9007199254740993 0.1\n", true).mesh;
  ASSERT_EQ(mesh.exact.size(), 1U);
  EXPECT_EQ(mesh.exact[0].second,
            (RationalPoint3{Rational(1, 3), Rational("9007199254740993"), Rational(1, 10)}));
}

TEST(ObjReader, keeps_to_its_limits) {
  const std::string text = testing::repeated("v 1 2 3\n", 20000);
  Limits limits;
  limits.max_memory_bytes = 20000 * sizeof(Point3);
  EXPECT_THROW(read(text, false, limits), Error);
  limits.max_memory_bytes *= 3;
  EXPECT_EQ(read(text, false, limits).mesh.points.size(), 20000U);
}

TEST(ObjWriter, writes_what_reads_back_as_the_same) {
  for (PolygonMesh mesh :
       {testing::tetrahedron(), testing::awkward_mesh(), testing::exact_mesh()}) {
    std::ostringstream out;
    write_obj(out, mesh);
    mesh.exact.clear();
    EXPECT_TRUE(is_same(read(out.str()).mesh, mesh)) << out.str();
  }
}

}  // namespace
}  // namespace plumb::obj_test
