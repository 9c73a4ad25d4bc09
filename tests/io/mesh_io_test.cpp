#include "plumb/io/mesh_io.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <sstream>
#include <string>
#include <vector>

#include "hostile_meshes.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/predicates/error.h"

namespace plumb::mesh_io_test {
namespace {

using testing::is_same;

constexpr MeshFormat kFormats[] = {MeshFormat::Off,    MeshFormat::ExactOff,  MeshFormat::Obj,
                                   MeshFormat::Stl,    MeshFormat::StlBinary, MeshFormat::Ply,
                                   MeshFormat::PlyText};

bool is_stl(MeshFormat format) {
  return format == MeshFormat::Stl || format == MeshFormat::StlBinary;
}

std::string written(const PolygonMesh& mesh, MeshFormat format) {
  std::ostringstream out;
  write_mesh(out, mesh, format);
  return out.str();
}

PolygonMesh read(const std::string& bytes, MeshFormat format) {
  Context context;
  return read_mesh(bytes, format, {"some.file"}, context).mesh;
}

TEST(SolidIo, reads_what_it_said_it_would_write) {
  PolygonMesh mesh = testing::exact_mesh();
  mesh.points[2] = {0.1, 1e-40, 12345678.9};
  for (const MeshFormat format : kFormats) {
    PolygonMesh expected = as_written(mesh, format);
    Context context;
    if (is_stl(format)) weld_vertices(expected, context);
    EXPECT_TRUE(is_same(read(written(mesh, format), format), expected));
  }
}

TEST(SolidIo, tells_formats_by_their_first_bytes) {
  for (const MeshFormat format : kFormats) {
    const std::string bytes = written(testing::tetrahedron(), format);
    const PolygonMesh mesh = read(bytes, guess_mesh_format(bytes));
    EXPECT_EQ(mesh.face_count(), 4U);
  }
  EXPECT_EQ(guess_mesh_format("# x\n\n  STCNOFF 8"), MeshFormat::Off);
  EXPECT_EQ(guess_mesh_format("4 4 6"), MeshFormat::Off);
  EXPECT_EQ(guess_mesh_format("\xEF\xBB\xBFOFF"), MeshFormat::Off);
  EXPECT_EQ(guess_mesh_format("coff\n"), MeshFormat::Off);
  EXPECT_EQ(guess_mesh_format("OFF8 6 12"), MeshFormat::Off);
  EXPECT_EQ(guess_mesh_format("nOFF\n4"), MeshFormat::Off);
  EXPECT_EQ(guess_mesh_format("offset"), MeshFormat::Obj);
  EXPECT_EQ(guess_mesh_format("# x\no thing\n"), MeshFormat::Obj);
  EXPECT_EQ(guess_mesh_format(""), MeshFormat::Obj);
  EXPECT_EQ(guess_mesh_format("solid"), MeshFormat::Stl);
  EXPECT_EQ(guess_mesh_format("\n SOLID name"), MeshFormat::Stl);
  const std::string stl = written(testing::tetrahedron(), MeshFormat::StlBinary);
  EXPECT_EQ(guess_mesh_format(stl + "\n"), MeshFormat::Stl);
  EXPECT_EQ(guess_mesh_format("ply\n" + stl), MeshFormat::Ply);
  EXPECT_EQ(guess_mesh_format(stl.substr(0, 83)), MeshFormat::Obj);
}

TEST(SolidIo, knows_extensions_and_names) {
  EXPECT_EQ(mesh_format_of("a/b.off"), MeshFormat::Off);
  EXPECT_EQ(mesh_format_of("b.obj"), MeshFormat::Obj);
  EXPECT_EQ(mesh_format_of("b.c.stl"), MeshFormat::Stl);
  EXPECT_EQ(mesh_format_of("b.ply"), MeshFormat::Ply);
  EXPECT_EQ(mesh_format_of("b.ply-text"), std::nullopt);
  EXPECT_EQ(mesh_format_of("off"), std::nullopt);
  EXPECT_EQ(mesh_format_of("-"), std::nullopt);
  EXPECT_EQ(mesh_format_named("stl-binary"), MeshFormat::StlBinary);
  EXPECT_EQ(mesh_format_named("stl-text"), std::nullopt);
}

TEST(SolidIo, reads_the_corpus_alike_in_every_format) {
  for (const std::string name : {"tetrahedron", "l-block", "square-hole"}) {
    Context context;
    PolygonMesh off = read_mesh_file("corpus/solids/" + name + ".off", {}, {}, context).mesh;
    EXPECT_GE(off.face_count(), 4U);
    for (const std::string extension : {".obj", ".ply"}) {
      const MeshFile file = read_mesh_file("corpus/solids/" + name + extension, {}, {}, context);
      EXPECT_TRUE(is_same(file.mesh, off)) << name << extension;
    }
  }
  Context context;
  PolygonMesh off = read_mesh_file("corpus/solids/tetrahedron.off", {}, {}, context).mesh;
  weld_vertices(off, context);
  for (const std::string file : {"tetrahedron.stl", "tetrahedron.binary.stl"}) {
    EXPECT_TRUE(is_same(read_mesh_file("corpus/solids/" + file, {}, {}, context).mesh, off));
  }
}

TEST(SolidIo, json_of_another_format_is_no_solid) {
  Context context;
  EXPECT_THROW(read_mesh_file("corpus/plane/frame.geojson", {}, {}, context), Error);
}

TEST(SolidIo, refuses_coordinates_beyond_the_largest_double) {
  PolygonMesh mesh = testing::exact_mesh();
  mesh.exact[0].second.x = Rational("1" + std::string(400, '0'));
  for (const MeshFormat format : kFormats) {
    if (format == MeshFormat::ExactOff) continue;
    EXPECT_THROW(written(mesh, format), Error);
    EXPECT_THROW(as_written(mesh, format), Error);
  }
  EXPECT_TRUE(is_same(as_written(mesh, MeshFormat::ExactOff), mesh));
}

TEST(SolidIo, writes_the_same_in_every_rounding_mode) {
  PolygonMesh mesh = testing::awkward_mesh();
  mesh.points[1].y = 1e30;
  mesh.points[1].z = -0.7;
  const PolygonMesh triangles = testing::mesh_of(mesh.points, {{0, 1, 2}, {2, 1, 3}, {4, 0, 3}});
  for (const MeshFormat format : kFormats) {
    const PolygonMesh expected = read(written(triangles, format), format);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const PolygonMesh again = read(written(triangles, format), format);
      std::fesetround(FE_TONEAREST);
      EXPECT_TRUE(is_same(again, expected));
    }
  }
}

TEST(SolidIo, gives_back_the_memory_of_the_bytes) {
  Limits limits;
  limits.max_memory_bytes = 1 << 20;
  Context context(limits);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(read_mesh_file("corpus/solids/tetrahedron.off", {}, {}, context).mesh.face_count(),
              4U);
  }
  EXPECT_THROW(read_mesh_file("no/such.off", {}, {}, context), Error);
}

}  // namespace
}  // namespace plumb::mesh_io_test
