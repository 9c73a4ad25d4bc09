#include "plumb/io/mesh_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfenv>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "hostile_meshes.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/threemf_archive.h"
#include "plumb/predicates/error.h"

namespace plumb::mesh_io_test {
namespace {

using testing::is_same;

/// All formats that this build writes.
const std::vector<MeshFormat> kFormats = [] {
  std::vector<MeshFormat> all{MeshFormat::Off,     MeshFormat::ExactOff,  MeshFormat::Obj,
                              MeshFormat::Stl,     MeshFormat::StlBinary, MeshFormat::Ply,
                              MeshFormat::PlyText, MeshFormat::Gltf};
  if (has_threemf()) all.push_back(MeshFormat::ThreeMf);
  return all;
}();

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
    if (lists_triangles(format) && format != MeshFormat::ThreeMf) weld_vertices(expected, context);
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
  EXPECT_EQ(mesh_format_of("b.3mf"), MeshFormat::ThreeMf);
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
  if (has_threemf()) {
    EXPECT_TRUE(
        is_same(read_mesh_file("corpus/solids/tetrahedron.3mf", {}, {}, context).mesh, off));
  }
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

// The bounds are computed here from the floats in the file. The requirements on chunks and bounds
// are those of the glTF 2.0 Specification.
TEST(SolidIo, glb_is_sound_gltf) {
  PolygonMesh mesh = testing::tetrahedron();
  mesh.points[1] = {0.1, -1e30, 1e-40};
  const std::string bytes = written(mesh, MeshFormat::Gltf);
  const auto word_at = [&](std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;) word = word << 8U | static_cast<std::uint8_t>(bytes[at + i]);
    return word;
  };
  EXPECT_EQ(word_at(8), bytes.size());
  const std::uint32_t length = word_at(12);
  EXPECT_EQ(length % 4, 0U);
  const auto json = nlohmann::json::parse(bytes.substr(20, length));
  const std::size_t begin = 20 + length + 8;
  EXPECT_EQ(word_at(begin - 8), bytes.size() - begin);
  EXPECT_EQ(json["buffers"][0]["byteLength"], bytes.size() - begin);
  EXPECT_EQ(json["accessors"][0]["count"], 4);
  EXPECT_EQ(json["accessors"][1]["count"], 12);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (std::size_t v = 0; v < 4; ++v) {
      values.push_back(std::bit_cast<float>(word_at(begin + 12 * v + 4 * axis)));
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    EXPECT_EQ(json["accessors"][0]["min"][axis], *low);
    EXPECT_EQ(json["accessors"][0]["max"][axis], *high);
  }
}

TEST(SolidIo, glb_refuses_what_it_cannot_hold) {
  for (const PolygonMesh& mesh :
       {PolygonMesh{},
        testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}),
        testing::mesh_of({{1e39, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}})}) {
    std::ostringstream out;
    EXPECT_THROW(write_mesh(out, mesh, MeshFormat::Gltf), Error);
    EXPECT_EQ(out.str(), "");
    EXPECT_THROW(as_written(mesh, MeshFormat::Gltf), Error);
  }
  EXPECT_THROW(write_mesh_file("no.gltf", testing::tetrahedron()), Error);
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

TEST(MeshIo, refuses_corners_that_are_no_points) {
  for (const std::uint32_t corner : {3U, ~0U}) {
    const PolygonMesh mesh =
        testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, corner, 2}});
    for (const MeshFormat format :
         {MeshFormat::Off, MeshFormat::ExactOff, MeshFormat::Obj, MeshFormat::Stl,
          MeshFormat::StlBinary, MeshFormat::Ply, MeshFormat::PlyText, MeshFormat::Gltf}) {
      std::ostringstream out;
      try {
        write_mesh(out, mesh, format);
        ADD_FAILURE() << "written";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::BadIndex) << error.what();
      }
      EXPECT_EQ(out.str(), "");
    }
  }
}

// Writers that split vertices look corners up.
TEST(MeshIo, refuses_corners_that_are_no_points_with_attributes) {
  const PolygonMesh mesh = testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, ~0U}});
  MeshAttributes attributes;
  attributes.channels = {{"texcoord_0", 2, std::vector<double>(6, 0.5)}};
  for (const MeshFormat format :
       {MeshFormat::Off, MeshFormat::ExactOff, MeshFormat::Obj, MeshFormat::Stl,
        MeshFormat::StlBinary, MeshFormat::Ply, MeshFormat::PlyText, MeshFormat::Gltf}) {
    std::ostringstream out;
    try {
      write_mesh(out, mesh, attributes, format);
      ADD_FAILURE() << "written";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::BadIndex) << error.what();
    }
    EXPECT_EQ(out.str(), "");
  }
}

}  // namespace
}  // namespace plumb::mesh_io_test
