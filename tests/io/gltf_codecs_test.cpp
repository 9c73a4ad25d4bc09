// Compressed data of glTF: what Draco and meshopt decode, what is damaged, and what to do without
// the libraries.
#include "plumb/io/mesh/gltf_codecs.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "gltf_documents.h"
#include "plumb/io/mesh/gltf_extensions.h"
#include "plumb/io/mesh/mesh_formats.h"

namespace plumb::gltf_codecs_test {
namespace {

using namespace gltf_documents;

std::string from_base64(const std::string& text) {
  Context context;
  return bytes_of_uri("data:;base64," + text, {}, context);
}

// The tetrahedron as draco_encoder writes it: by edgebreaker, sequentially, and sequentially
// without quantisation.
const std::array<const char*, 3> kDracoStreams{
    "RFJBQ08CAgEBAAAABAQAAwAAAS8BARAB/"
    "wAAAQAJAwAAAgEBAQADAwEQATADAFCCJJEEAAAAAP8AAAAAAAAAAAAAAAAAAAAAAIA/"
    "CA==",
    "RFJBQ08CAgEAAAAEBAEAAQIAAgMAAwECAQMBAQAJAwAAAgABAQADAwEgASADACCEUCIBAAAAAP8AAAAAAAAAAAAAAAAAAA"
    "AAAIA/"
    "CA==",
    "RFJBQ08CAgEAAAAEBAEAAQIAAgMAAwECAQMBAQAJAwAAAAAAAAAAAAAAAAAAAAAAAAAAAIA/"
    "AAAAAAAAgD8AAAAAAAAAAAAAAAAA"
    "AAAAAACAPw=="};

Document draco_document(const std::string& stream) {
  Document d = tetrahedron_document();
  const std::size_t view = add_view(d, stream);
  for (const std::size_t a : {0U, 1U}) d.json["accessors"][a].erase("bufferView");
  d.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
  d.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  d.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return d;
}

/// Whether two meshes have the same triangles, whatever the order of vertices and triangles.
bool has_same_triangles(const PolygonMesh& a, const PolygonMesh& b) {
  const auto triangles = [](const PolygonMesh& mesh) {
    std::vector<std::vector<std::array<double, 3>>> all;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      auto& face = all.emplace_back();
      for (const std::uint32_t v : mesh.face(f)) {
        face.push_back({mesh.points[v].x, mesh.points[v].y, mesh.points[v].z});
      }
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  return triangles(a) == triangles(b);
}

TEST(GltfCodecs, draco) {
  if (!has_draco()) GTEST_SKIP() << "plumb is built without Draco (libdraco-dev)";
  for (const char* stream : kDracoStreams) {
    Document d = draco_document(from_base64(stream));
    EXPECT_TRUE(has_same_triangles(read(glb(d)).mesh, expected()));
    EXPECT_TRUE(read(glb(d)).notes.empty());
    d.json["meshes"][0]["primitives"].push_back(d.json["meshes"][0]["primitives"][0]);
    EXPECT_EQ(read(glb(d)).mesh.face_count(), 8U) << "a stream that two primitives name";
  }
}

// The tetrahedron with colours, texture coordinates and normals, as the library writes it: by
// edgebreaker with one connectivity for all attributes, and with one for each.
const std::array<const char*, 2> kDracoChannels{
    "RFJBQ08CAgEBAAAABAQAAwAAAS8BARAB/wAABAICBAEAAwkCAQEBCQMAAgAJAwADAQAAAgABAQAJBwEQ"
    "DwEgARADAIiQFBQPOjn1oiECAQD9AAAAAP8AAAAAAAA+AABAPwAAAD8AAIA/AAAAAAAAAAAAAIA/AACA"
    "PgAAAAAAAAAAAACAPwAAAAAAAIA/AAAAAAAAgL8AAAAAAAAAAAAAgD8AAAAAAAAAAAABAQADAwEgASAD"
    "APCDJJEAAAAAAP8HAAAAAAAAAAAAAAAAAAAAAIA/Cw==",
    "RFJBQ08CAgEBAAAABAQDAwAAAS8BARD/AmZA/wJmQP8CZkAEAAAAAQAAAgAA/wAAAQICBAEAAQEDCQIB"
    "AQABAQkDAAIAAQAJAwADAgEBAQAJBwEQDwEgARADAIiQFBQPOjn1oiEWAT79AAAAAP8AAAAAAAA+AABA"
    "PwAAAD8AAIA/AAAAAAAAAAAAAIA/AACAPgAAAAAAAAAAAACAPwAAAAAAAIA/AAAAAAAAgL8AAAAAAAAA"
    "AAAAgD8AAAAAAAAAAAEBAQADAwEQATADAFCCJJEEAAAAAP8HAAAAAAAAAAAAAAAAAAAAAIA/Cw=="};

/// The document of one of these streams. Its attributes have the ids 0 to 3.
Document channels_document(const std::string& stream) {
  Document d = draco_document(stream);
  Json& primitive = d.json["meshes"][0]["primitives"][0];
  Json& ids = primitive["extensions"]["KHR_draco_mesh_compression"]["attributes"];
  ids = {{"COLOR_0", 0}, {"TEXCOORD_0", 1}, {"NORMAL", 2}, {"POSITION", 3}};
  const auto add = [&](const char* member, int component, const char* type, bool normalized) {
    primitive["attributes"][member] = d.json["accessors"].size();
    d.json["accessors"].push_back(
        {{"componentType", component}, {"count", 4}, {"type", type}, {"normalized", normalized}});
  };
  add("COLOR_0", 5121, "VEC4", true);
  add("TEXCOORD_0", 5126, "VEC2", false);
  add("NORMAL", 5126, "VEC3", false);
  return d;
}

MeshFile read_with_attributes(const Document& d) {
  ReadOptions options{"some.file"};
  options.attributes = true;
  Context context;
  return read_gltf(glb(d), {}, options, context);
}

/// The numbers of a channel at the corner of the tetrahedron that is at `at`.
std::vector<double> numbers_at(const MeshFile& file, const std::string& channel, const Point3& at) {
  for (const MeshChannel& c : file.attributes.channels) {
    if (c.name != channel) continue;
    for (std::size_t i = 0; i < file.mesh.corners.size(); ++i) {
      if (file.mesh.points[file.mesh.corners[i]] != at) continue;
      const auto first = c.values.begin() + static_cast<std::ptrdiff_t>(i * c.width);
      return {first, first + static_cast<std::ptrdiff_t>(c.width)};
    }
  }
  return {};
}

TEST(GltfCodecs, draco_channels) {
  if (!has_draco()) GTEST_SKIP() << "plumb is built without Draco (libdraco-dev)";
  using Numbers = std::vector<double>;
  const std::array<Point3, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  // The stream has 1 - v, because v points down in glTF.
  const std::array<Numbers, 4> places{{{0, 1}, {1, .75}, {.5, 0}, {.125, .25}}};
  const std::array<Numbers, 4> normals{{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::array<Numbers, 4> bytes{
      {{255, 0, 0, 255}, {0, 255, 0, 128}, {0, 0, 255, 255}, {10, 20, 30, 40}}};
  for (const char* text : kDracoChannels) {
    const MeshFile file = read_with_attributes(channels_document(from_base64(text)));
    EXPECT_TRUE(file.notes.empty()) << file.notes[0];
    EXPECT_TRUE(has_same_triangles(file.mesh, expected()));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      EXPECT_EQ(numbers_at(file, "texcoord_0", corners[i]), places[i]);
      EXPECT_EQ(numbers_at(file, "normal", corners[i]), normals[i]);
      Numbers color = bytes[i];
      for (double& part : color) part /= 255;
      EXPECT_EQ(numbers_at(file, "color", corners[i]), color);
    }
  }
}

// Two primitives name one stream, and each takes channels that the other does not take.
TEST(GltfCodecs, draco_channels_of_two_primitives) {
  if (!has_draco()) GTEST_SKIP() << "plumb is built without Draco (libdraco-dev)";
  for (const char* text : kDracoChannels) {
    Document d = channels_document(from_base64(text));
    Json& primitives = d.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    const auto drop = [&](std::size_t i, const char* member) {
      primitives[i]["attributes"].erase(member);
      primitives[i]["extensions"]["KHR_draco_mesh_compression"]["attributes"].erase(member);
    };
    for (const char* member : {"NORMAL", "TEXCOORD_0"}) drop(0, member);
    drop(1, "COLOR_0");
    const MeshFile file = read_with_attributes(d);
    for (const std::string& note : file.notes) EXPECT_EQ(note.find("cannot be read"), note.npos);
    ASSERT_EQ(file.mesh.face_count(), 8U);
    std::size_t with_normals = 0, with_colours = 0;
    for (const MeshChannel& c : file.attributes.channels) {
      for (std::size_t i = 0; i < file.mesh.corners.size(); ++i) {
        const double* const at = &c.values[i * c.width];
        if (c.name == "normal") with_normals += at[0] != 0 || at[1] != 0 || at[2] != 0 ? 1 : 0;
        if (c.name == "color") with_colours += at[0] != 1 || at[1] != 1 || at[2] != 1 ? 1 : 0;
      }
    }
    EXPECT_EQ(with_normals, 12U);
    EXPECT_EQ(with_colours, 12U);
  }
}

// What cannot be read of the looks of a mesh is named, and the shape is read.
TEST(GltfCodecs, passes_over_damaged_draco_channels) {
  if (!has_draco()) GTEST_SKIP() << "plumb is built without Draco (libdraco-dev)";
  const std::string stream = from_base64(kDracoChannels[0]);
  const auto expect_passed_over = [&](const std::string& path, const Json& value) {
    SCOPED_TRACE(path);
    Document d = channels_document(stream);
    d.json[Json::json_pointer(path)] = value;
    const MeshFile file = read_with_attributes(d);
    EXPECT_TRUE(has_same_triangles(file.mesh, expected()));
    ASSERT_EQ(file.notes.size(), 1U);
    EXPECT_NE(file.notes[0].find("that cannot be read"), std::string::npos) << file.notes[0];
    EXPECT_EQ(file.attributes.channels.size(), 2U);
  };
  const std::string ids = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes";
  expect_passed_over(ids + "/TEXCOORD_0", 7);
  expect_passed_over(ids + "/TEXCOORD_0", 2);
  expect_passed_over(ids + "/TEXCOORD_0", "one");
  expect_passed_over("/meshes/0/primitives/0/attributes/NORMAL", 99);
  expect_passed_over("/accessors/2/type", "VEC3");
  expect_passed_over("/accessors/3/componentType", 5125);
}

TEST(GltfCodecs, refuses_hostile_draco) {
  if (!has_draco()) GTEST_SKIP() << "plumb is built without Draco (libdraco-dev)";
  expect_refused(glb(draco_document("DRACO")), "bufferViews[2]: compressed by Draco: its bytes");
  expect_refused(glb(draco_document(std::string(100, 'x'))), "no mesh of Draco");
  for (const char* text : kDracoStreams) {
    const std::string stream = from_base64(text);
    Document d = draco_document(stream);
    Json& draco = d.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
    draco["attributes"]["POSITION"] = 7;
    expect_refused(glb(d), "no attribute 7 of 3 numbers");
    draco["attributes"] = 7;
    expect_refused(glb(d), "compressed without attributes");
    // Whatever becomes of the bytes, it is a mesh or an error.
    for (std::size_t i = 0; i < stream.size(); ++i) {
      EXPECT_THROW(read(glb(draco_document(stream.substr(0, i)))), Error) << i;
      for (const char byte : {'\x00', '\x01', '\x7f', '\xff'}) {
        std::string changed = stream;
        changed[i] = byte;
        try {
          read(glb(draco_document(changed)));
        } catch (const Error& error) {
          EXPECT_EQ(error.place().file, "some.file");
        }
      }
    }
  }
  // Numbers of triangles that its bytes cannot hold; those that they can are charged.
  std::string many = from_base64(kDracoStreams[0]);
  many.replace(13, 1, "\xff\xff\xff\xff\x04");
  expect_refused(glb(draco_document(many)), "triangles are not in its bytes");
  many = from_base64(kDracoStreams[0]);
  many.replace(13, 1, "\xff\xff\x04");
  Limits limits;
  limits.max_memory_bytes = 4U << 20U;
  try {
    read(glb(draco_document(many)), limits);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
  }
}

// Positions and triangles of the tetrahedron as gltfpack writes them.
const char* const kMeshoptPositions =
    "oAAAAQ8AAAD//wEPAAAAfn0AAAE8AAAA//"
    "8BPAAAAH59AAABAwAAAP8BAwAAAH4AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
    "AAAA==";
const char* const kMeshoptTriangles = "4fAQEwEAdodWZ3iphmWJaJgBaQAA";

Document meshopt_document(const std::string& name, std::string positions, std::string triangles) {
  Document d = tetrahedron_document();
  d.buffer = positions + triangles;
  d.json["buffers"] = {{{"byteLength", d.buffer.size()}},
                       {{"byteLength", 72}, {"extensions", {{name, {{"fallback", true}}}}}}};
  d.json["bufferViews"] = Json::parse(R"([{"buffer": 1, "byteLength": 48, "byteStride": 12},
                                          {"buffer": 1, "byteOffset": 48, "byteLength": 24}])");
  d.json["bufferViews"][0]["extensions"][name] = {{"buffer", 0},
                                                  {"byteLength", positions.size()},
                                                  {"byteStride", 12},
                                                  {"count", 4},
                                                  {"mode", "ATTRIBUTES"}};
  d.json["bufferViews"][1]["extensions"][name] = {{"buffer", 0},
                                                  {"byteOffset", positions.size()},
                                                  {"byteLength", triangles.size()},
                                                  {"byteStride", 2},
                                                  {"count", 12},
                                                  {"mode", "TRIANGLES"}};
  return d;
}
Document meshopt_document(const std::string& name) {
  return meshopt_document(name, from_base64(kMeshoptPositions), from_base64(kMeshoptTriangles));
}

TEST(GltfCodecs, meshopt) {
  if (!has_meshopt()) GTEST_SKIP() << "plumb is built without meshoptimizer (libmeshoptimizer-dev)";
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    Document d = meshopt_document(name);
    d.json["extensionsRequired"] = {name};
    EXPECT_TRUE(has_same_triangles(read(glb(d)).mesh, expected()));
    EXPECT_TRUE(read(glb(d)).notes.empty());
  }
}

TEST(GltfCodecs, refuses_hostile_meshopt) {
  if (!has_meshopt()) GTEST_SKIP() << "plumb is built without meshoptimizer (libmeshoptimizer-dev)";
  const std::string name = "EXT_meshopt_compression";
  const auto refuse_with = [&](std::size_t view, const char* member, const Json& value,
                               const char* message) {
    Document d = meshopt_document(name);
    d.json["bufferViews"][view]["extensions"][name][member] = value;
    SCOPED_TRACE(member + std::to_string(view));
    expect_refused(glb(d), message);
  };
  refuse_with(0, "mode", "OTHER", "its mode is not read");
  refuse_with(0, "mode", "INDICES", "does not suit its mode");
  refuse_with(0, "mode", "TRIANGLES", "does not suit its mode");
  refuse_with(1, "mode", "INDICES", "this version of it is not read");
  refuse_with(0, "filter", "OCTAHEDRAL", "its filter is not read");
  refuse_with(0, "filter", "COLOR", "its filter is not read");
  refuse_with(0, "count", 5, "is not that of its compressed elements");
  refuse_with(0, "byteStride", 0, "is not that of its compressed elements");
  refuse_with(0, "byteStride", 6, "is not that of its compressed elements");
  refuse_with(0, "byteLength", 78, "bytes are damaged");
  refuse_with(0, "byteLength", 1000, "is longer than its buffer");
  refuse_with(0, "buffer", 2, "buffers[2]: there is none");
  Document d = meshopt_document(name);
  d.json["bufferViews"][0]["byteLength"] = 12U << 20U;
  d.json["bufferViews"][0]["extensions"][name]["count"] = 1U << 20U;
  expect_refused(glb(d), "1048576 elements are not in 79 bytes");
  const std::string positions = from_base64(kMeshoptPositions);
  const std::string triangles = from_base64(kMeshoptTriangles);
  const auto read_or_refuse = [&](const std::string& p, const std::string& t) {
    try {
      read(glb(meshopt_document(name, p, t)));
    } catch (const Error& error) {
      EXPECT_EQ(error.place().file, "some.file");
    }
  };
  for (const char byte : {'\x00', '\x01', '\x7f', '\xff'}) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      std::string changed = positions;
      changed[i] = byte;
      read_or_refuse(changed, triangles);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      std::string changed = triangles;
      changed[i] = byte;
      read_or_refuse(positions, changed);
    }
  }
}

// Data that are there uncompressed are read as they are, with the libraries and without.
TEST(GltfCodecs, prefers_data_that_are_not_compressed) {
  Document d = draco_document("no stream");
  for (const std::size_t a : {0U, 1U}) d.json["accessors"][a]["bufferView"] = a;
  EXPECT_TRUE(is_same(read(glb(d)).mesh, expected()));
  d = tetrahedron_document();
  d.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
  EXPECT_TRUE(is_same(read(glb(d)).mesh, expected()));
}

TEST(GltfCodecs, says_what_to_do_without_the_libraries) {
  if (!has_draco()) {
    expect_refused(glb(draco_document("DRACO")), "install libdraco-dev and build plumb again, or");
  }
  if (!has_meshopt()) {
    expect_refused(glb(meshopt_document("EXT_meshopt_compression")),
                   "install libmeshoptimizer-dev and build plumb again, or");
  }
}

}  // namespace
}  // namespace plumb::gltf_codecs_test
