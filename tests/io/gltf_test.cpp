// glTF: known files in both containers, every layout, hostile files, and our own writer's.

#include "plumb/io/mesh/gltf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stop_token>
#include <string>
#include <tuple>
#include <vector>

#include "gltf_documents.h"
#include "little_endian.h"
#include "plumb/io/mesh/gltf_extensions.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh_io.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/svg/svg_text.h"

namespace plumb::gltf_test {
namespace {

using namespace gltf_documents;

TEST(GltfReader, reads_both_containers_and_every_index) {
  EXPECT_TRUE(is_same(read(glb(tetrahedron_document())).mesh, expected()));
  EXPECT_TRUE(is_same(read(text(tetrahedron_document())).mesh, expected()));
  EXPECT_TRUE(is_same(read("\xEF\xBB\xBF\n" + text(tetrahedron_document())).mesh, expected()));
  EXPECT_TRUE(is_same(read(glb(tetrahedron_document<std::uint8_t>(5121))).mesh, expected()));
  EXPECT_TRUE(is_same(read(glb(tetrahedron_document<std::uint32_t>(5125))).mesh, expected()));
}

TEST(GltfReader, interleaved_attributes) {
  Document d = tetrahedron_document();
  std::vector<float> rows;
  for (std::size_t v = 0; v < 4; ++v) {
    rows.insert(rows.end(), {7, 8, 9});  // normals
    for (std::size_t k = 0; k < 3; ++k) rows.push_back(kCorners[3 * v + k]);
  }
  const std::string points = bytes_of(rows);
  d.buffer = points + d.buffer.substr(48);
  d.json["buffers"][0]["byteLength"] = d.buffer.size();
  d.json["bufferViews"][0]["byteLength"] = points.size();
  d.json["bufferViews"][0]["byteStride"] = 24;
  d.json["bufferViews"][1]["byteOffset"] = points.size();
  d.json["accessors"][0]["byteOffset"] = 12;
  EXPECT_TRUE(is_same(read(glb(d)).mesh, expected()));
}

TEST(GltfReader, strips_fans_and_no_indices) {
  Document d = tetrahedron_document();
  Json& primitive = d.json["meshes"][0]["primitives"][0];
  primitive.erase("indices");
  d.json["accessors"][0]["count"] = 4;
  primitive["mode"] = 5;
  EXPECT_EQ(read(glb(d)).mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
  primitive["mode"] = 6;
  EXPECT_EQ(read(glb(d)).mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  Json lines = primitive;
  lines["mode"] = 1;
  d.json["meshes"][0]["primitives"].push_back(lines);
  const MeshFile both = read(glb(d));
  EXPECT_EQ(both.mesh.face_count(), 2U);
  EXPECT_EQ(both.notes, std::vector<std::string>{"passed over: lines and points"});
  d.json["meshes"][0]["primitives"].erase(0);
  expect_refused(glb(d), "no triangles");
}

// Placed twice, below a node that turns and moves; the second is mirrored, so its triangles turn
// around.
TEST(GltfReader, nodes_place_meshes) {
  Document d = tetrahedron_document();
  const double half = std::sqrt(.5);
  d.json["nodes"] = Json::parse(R"([{"children": [1, 2], "translation": [10, 0, 0]},
                                    {"mesh": 0}, {"mesh": 0, "scale": [1, 1, -2]}])");
  d.json["nodes"][0]["rotation"] = {-half, 0, 0, half};  // (x, y, z) goes to (x, z, -y)
  const PolygonMesh mesh = read(glb(d)).mesh;
  ASSERT_EQ(mesh.face_count(), 8U);
  std::vector<Point3> points = mesh.points;
  const auto has = [&](const Point3& p) {
    return std::find(points.begin(), points.end(), p) != points.end();
  };
  EXPECT_EQ(points.size(), 5U);
  EXPECT_TRUE(has({10, 0, 0}) && has({11, 0, 0}) && has({10, 0, -1}) && has({10, 1, 0}) &&
              has({10, -2, 0}));
  double volume = 0;
  for (std::size_t f = 0; f < 8; ++f) {
    const Point3 a = points[mesh.face(f)[0]], b = points[mesh.face(f)[1]],
                 c = points[mesh.face(f)[2]];
    volume += ((a.x - 10) * (b.y * c.z - b.z * c.y) - a.y * ((b.x - 10) * c.z - b.z * (c.x - 10)) +
               a.z * ((b.x - 10) * c.y - b.y * (c.x - 10))) /
              6;
  }
  EXPECT_DOUBLE_EQ(volume, 3. / 6);
  d.json["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
  EXPECT_EQ(read(glb(d)).mesh.points[0], (Point3{15, 7, -6}));
}

// The determinant of a scale is its cube: no double where the scale is one.
TEST(GltfReader, scales_too_small_for_a_determinant_mirror) {
  Document large = tetrahedron_document(), small = large;
  large.json["nodes"][0]["scale"] = {-1, 1, 1};
  small.json["nodes"][0]["scale"] = {-1e-120, 1e-120, 1e-120};
  EXPECT_EQ(read(glb(small)).mesh.corners, read(glb(large)).mesh.corners);
  EXPECT_NE(read(glb(small)).mesh.corners, expected().corners);
}

TEST(GltfReader, equal_points_are_one_and_flat_triangles_go) {
  Document d = tetrahedron_document();
  d.json["nodes"] = Json::parse(R"([{"mesh": 0}, {"mesh": 0}])");
  d.json["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(read(glb(d)).mesh.points.size(), 4U);
  const std::uint16_t twice = 2;
  testing::place(d.buffer, 48, twice);
  const MeshFile file = read(glb(d));
  EXPECT_EQ(file.mesh.face_count(), 6U);
  EXPECT_EQ(file.notes, std::vector<std::string>{"2 triangles with two equal corners left out"});
}

TEST(GltfReader, buffers_beside_the_file_and_no_others) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / "plumb-gltf-test";
  fs::create_directories(folder);
  Document d = tetrahedron_document();
  std::ofstream(folder / "a b.bin", std::ios::binary) << d.buffer;
  d.json["buffers"][0]["uri"] = "a%20b.bin";
  std::ofstream(folder / "a.gltf") << d.json.dump();
  Context context;
  const std::string file = (folder / "a.gltf").string();
  EXPECT_TRUE(is_same(read_mesh_file(file, {}, {}, context).mesh, expected()));
  std::ofstream(folder / "a.glb", std::ios::binary) << glb(tetrahedron_document());
  EXPECT_TRUE(
      is_same(read_mesh_file((folder / "a.glb").string(), {}, {}, context).mesh, expected()));
  expect_refused(d.json.dump(), "folder of its file is not known");
  for (const char* name : {"../a b.bin", "/etc/passwd", "..", "..%2fa b.bin", "http://x/y", ""}) {
    d.json["buffers"][0]["uri"] = name;
    expect_refused(d.json.dump(), "same folder");
  }
  fs::remove_all(folder);
}

// A name is the same with any of its bytes spelled as a code; what is no code stands for itself.
TEST(GltfReader, names_of_buffers_may_be_encoded) {
  const GltfLoader name_itself = [](const std::string& name) { return name; };
  const auto loaded = [&](const std::string& uri) {
    Context context;
    return bytes_of_uri(uri, name_itself, context);
  };
  for (const char* digits : {"0123456789abcdef", "0123456789ABCDEF"}) {
    for (unsigned byte = 1; byte < 256; ++byte) {
      const std::string name{'a', static_cast<char>(byte), 'b'};
      const std::string uri{'a', '%', digits[byte >> 4U], digits[byte & 15U], 'b'};
      if (name.find_first_of("/\\:") != name.npos) {
        EXPECT_THROW(loaded(uri), Error) << uri;
      } else {
        EXPECT_EQ(loaded(uri), name);
      }
    }
  }
  for (const char* name : {"%", "%4", "a%", "%zz", "%4g", "%G4", "%4`", "%@4", "%!4"}) {
    EXPECT_EQ(loaded(name), name);
  }
  for (const char* name : {"", ".", "..", "%2e", "%2E.", "%00"}) {
    EXPECT_THROW(loaded(name), Error) << name;
  }
  EXPECT_EQ(loaded(std::string(255, 'a')).size(), 255U);
  EXPECT_THROW(loaded(std::string(256, 'a')), Error);
  Document d = tetrahedron_document();
  d.json["buffers"][0]["uri"] = "b.bin";
  const GltfLoader refuses = [](const std::string& name) -> std::string {
    throw Error(ErrorCode::CannotOpen, "not there", {name});
  };
  Context context;
  try {
    read_gltf(d.json.dump(), refuses, {"some.file"}, context);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.place().file, "b.bin");
  }
}

// Without a scene, what hangs below no other node is placed: as if a scene listed it.
TEST(GltfReader, no_scene_places_all_roots) {
  Document d = tetrahedron_document();
  d.json["nodes"] = Json::parse(R"([{"mesh": 0, "translation": [0, 0, 9]},
                                    {"children": [0, 3], "scale": [2, 2, 2]}, {"mesh": 0},
                                    {"mesh": 0, "translation": [5, 0, 0]}])");
  d.json["scenes"][0]["nodes"] = {1, 2};
  const PolygonMesh listed = read(glb(d)).mesh;
  EXPECT_EQ(listed.face_count(), 12U);
  d.json.erase("scene");
  EXPECT_TRUE(is_same(read(glb(d)).mesh, listed)) << "the first scene is the one";
  d.json.erase("scenes");
  EXPECT_TRUE(is_same(read(glb(d)).mesh, listed));
  d.json["scene"] = 0;
  expect_refused(glb(d), "scenes[0]: there is none");
  d.json.erase("scene");
  for (const Json& child : {Json(4), Json(-1), Json("0"), Json(0.5)}) {
    d.json["nodes"][1]["children"] = Json::array({child});
    expect_refused(glb(d), "a node that there is not");
  }
  d.json["nodes"][1]["children"] = Json::array({1});  // a ring has no root
  d.json["nodes"][2]["children"] = {0, 3};
  EXPECT_EQ(read(glb(d)).mesh.face_count(), 12U);
}

TEST(GltfReader, chunks_of_other_kinds_are_passed_over) {
  const Document d = tetrahedron_document();
  const auto file = [](const std::string& chunks, std::uint32_t more = 0) {
    return "glTF" +
           bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(12 + chunks.size() + more)}) +
           chunks;
  };
  const std::string json = chunk("JSON", d.json.dump());
  const std::string bytes = chunk(std::string("BIN\0", 4), d.buffer);
  EXPECT_TRUE(is_same(read(file(json + chunk("NOTE", "abc") + bytes)).mesh, expected()));
  EXPECT_TRUE(
      is_same(read(file(json + bytes + chunk(std::string("BIN\0", 4), "x"))).mesh, expected()));
  EXPECT_TRUE(is_same(read(file(json + bytes) + "behind").mesh, expected()));
  expect_refused(file(json + bytes + json), "the first chunk, and no other, is JSON");
  expect_refused(file(json + bytes + "NOTE"), "a chunk is cut off");
  expect_refused(file(json), "buffers[0]: no bytes are there");
}

TEST(GltfReader, says_what_it_passes_over) {
  Document d = tetrahedron_document();
  d.json["nodes"][0]["skin"] = 0;
  d.json["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform",
                                  "KHR_lights_punctual", "EXT_texture_webp"};
  Json& primitives = d.json["meshes"][0]["primitives"];
  primitives[0]["targets"] = Json::array();
  // As glTF has it, nothing to draw.
  for (const char* primitive : {"{}", R"({"attributes": 1})", R"({"attributes": {}})"}) {
    primitives.push_back(Json::parse(primitive));
  }
  d.json["accessors"].push_back(d.json["accessors"][0]);
  d.json["accessors"][2]["count"] = 0;
  primitives.push_back(Json::parse(R"({"attributes": {"POSITION": 2}})"));
  primitives.push_back(Json::parse(R"({"attributes": {"POSITION": 2}, "mode": 5})"));
  const std::uint16_t twice = 2;
  testing::place(d.buffer, 48, twice);
  const MeshFile file = read(glb(d));
  EXPECT_EQ(file.mesh.face_count(), 3U);
  EXPECT_EQ(file.notes, (std::vector<std::string>{"passed over: morph targets",
                                                  "1 triangle with two equal corners left out"}));
  EXPECT_EQ(file.warnings,
            std::vector<std::string>{"geometry that was not read: skins, which move vertices"});
  d = tetrahedron_document();
  d.json["scenes"].push_back(Json::object());
  EXPECT_EQ(read(glb(d)).notes, std::vector<std::string>{"passed over: other scenes"});
}

// Targets move vertices if a weight of the mesh is not 0. Those of the node count instead.
TEST(GltfReader, warns_of_morph_targets_with_weights) {
  const std::vector<std::string> warned{
      "geometry that was not read: morph targets, which move vertices"};
  for (const auto& [mesh, node, is_moved] :
       std::vector<std::tuple<const char*, const char*, bool>>{{"null", "null", false},
                                                               {"[0]", "null", false},
                                                               {"[0, 0.5]", "null", true},
                                                               {"[1]", "[0]", false},
                                                               {"[0]", "[1]", true}}) {
    Document d = tetrahedron_document();
    d.json["meshes"][0]["primitives"][0]["targets"] = Json::array();
    if (Json::parse(mesh).is_array()) d.json["meshes"][0]["weights"] = Json::parse(mesh);
    if (Json::parse(node).is_array()) d.json["nodes"][0]["weights"] = Json::parse(node);
    const MeshFile file = read(glb(d));
    EXPECT_EQ(file.warnings, is_moved ? warned : std::vector<std::string>{}) << mesh << node;
  }
}

TEST(GltfReader, names_nodes_outside_of_the_scene) {
  Document d = tetrahedron_document();
  d.json["nodes"].push_back({{"translation", {1, 2, 3}}});
  EXPECT_TRUE(read(glb(d)).notes.empty());
  d.json["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(read(glb(d)).notes,
            std::vector<std::string>{"passed over: nodes that are not in the scene"});
}

// A file without triangles says why.
TEST(GltfReader, refusals_name_what_was_passed_over) {
  Document d = tetrahedron_document();
  d.json["meshes"][0]["primitives"][0]["mode"] = 0;
  expect_refused(glb(d), "no triangles are placed; passed over: lines and points");
}

// ---------------------------------------------------------------- extensions

/// The node 0 with these instances.
void set_instances(Document& d, const Json& attributes) {
  d.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
}

// Instances are what nodes below their node would be: moved, turned and scaled, one of them
// mirrored.
TEST(GltfReader, instances_are_copies) {
  Document d = tetrahedron_document();
  d.json["nodes"][0]["matrix"] = {2, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 5, 0, 0, 1};
  Document nodes = d;
  const std::vector<float> moves{0, 0, 0, 5, 0, 0, 0, .25, -9};
  const std::vector<float> scales{1, 1, 1, 1, -1, 1, 3, .5, 2};
  const std::vector<std::int8_t> turns{0, 0, 0, 127, 127, 0, 0, 127, 3, -4, 5, -128};
  nodes.json["nodes"][0]["children"] = {1, 2, 3};
  nodes.json["nodes"][0].erase("mesh");
  for (std::size_t i = 0; i < 3; ++i) {
    Json node{{"mesh", 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      node["translation"].push_back(moves[3 * i + k]);
      node["scale"].push_back(scales[3 * i + k]);
    }
    for (std::size_t k = 0; k < 4; ++k) node["rotation"].push_back(meant(turns[4 * i + k], true));
    nodes.json["nodes"].push_back(node);
  }
  const std::size_t move = add_accessor(d, moves, 5126, "VEC3", 3);
  const std::size_t scale = add_accessor(d, scales, 5126, "VEC3", 3);
  const std::size_t turn = add_accessor(d, turns, 5120, "VEC4", 4);
  d.json["accessors"][turn]["normalized"] = true;
  set_instances(d, {{"TRANSLATION", move}, {"ROTATION", turn}, {"SCALE", scale}, {"_ID", 1}});
  d.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  const MeshFile file = read(glb(d));
  EXPECT_EQ(file.mesh.face_count(), 12U);
  EXPECT_TRUE(is_same(file.mesh, read(glb(nodes)).mesh));
  EXPECT_TRUE(file.notes.empty());
  // Attributes that move nothing leave the mesh where it is.
  set_instances(d, {{"_ID", 1}});
  EXPECT_EQ(read(glb(d)).mesh.face_count(), 4U);
  d.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = Json::object();
  EXPECT_EQ(read(glb(d)).mesh.face_count(), 4U);
}

TEST(GltfReader, refuses_hostile_instances) {
  Document d = tetrahedron_document();
  const std::size_t moves = add_accessor(d, std::vector<float>(6), 5126, "VEC3", 3);
  const std::size_t turns = add_accessor(d, std::vector<float>{0, 0, 0, 1}, 5126, "VEC4", 4);
  set_instances(d, {{"TRANSLATION", moves}, {"ROTATION", turns}});
  expect_refused(glb(d), "nodes[0]: attributes of instances differ in number");
  set_instances(d, {{"TRANSLATION", turns}});
  expect_refused(glb(d), "type is not VEC3");
  set_instances(d, {{"TRANSLATION", 9}});
  expect_refused(glb(d), "accessors[9]: there is none");
  set_instances(d, {{"ROTATION", add_accessor(d, std::vector<float>(4), 5126, "VEC4", 4)}});
  expect_refused(glb(d), "nodes[0]: no rotation of instance 0");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  set_instances(d, {{"SCALE", add_accessor<float>(d, {1, nan, 1}, 5126, "VEC3", 3)}});
  expect_refused(glb(d), "not finite");
  // A large mesh in many places is charged.
  for (int i = 0; i < 200; ++i) {
    d.json["meshes"][0]["primitives"].push_back(d.json["meshes"][0]["primitives"][0]);
  }
  set_instances(d, {{"TRANSLATION", add_accessor(d, std::vector<float>(9000), 5126, "VEC3", 3)}});
  Limits limits;
  limits.max_memory_bytes = 16U << 20U;
  EXPECT_THROW(read(glb(d), limits), Error);
}

// Hidden nodes are as if they were not there, with all below them; a note names them.
TEST(GltfReader, hidden_nodes_are_left_out) {
  Document d = tetrahedron_document();
  d.json["nodes"] = Json::parse(R"([{"mesh": 0}, {"mesh": 0, "children": [2]},
      {"mesh": 0, "translation": [9, 0, 0], "extensions": {"KHR_node_visibility":
          {"visible": true}}}])");
  d.json["scenes"][0]["nodes"] = {0, 1};
  d.json["extensionsUsed"] = {"KHR_node_visibility"};
  EXPECT_EQ(read(glb(d)).mesh.face_count(), 12U);
  EXPECT_TRUE(read(glb(d)).notes.empty());
  d.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = false;
  const MeshFile file = read(glb(d));
  EXPECT_TRUE(is_same(file.mesh, expected()));
  EXPECT_EQ(file.notes, std::vector<std::string>{"hidden nodes, left out with all below them: 1"});
  d.json["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = false;
  expect_refused(glb(d), "no triangles are placed; hidden nodes, left out with all below them");
}

TEST(GltfReader, extensions_are_known_by_their_effect) {
  for (const char* name : {"KHR_materials_unlit", "KHR_texture_transform", "KHR_lights_punctual",
                           "KHR_xmp_json_ld", "EXT_texture_webp", "EXT_structural_metadata"}) {
    EXPECT_EQ(effect_of_extension(name), GltfEffect::None) << name;
  }
  for (const char* name : {"EXT_mesh_gpu_instancing", "KHR_mesh_quantization"}) {
    EXPECT_EQ(effect_of_extension(name), GltfEffect::Read) << name;
  }
  EXPECT_EQ(effect_of_extension("MSFT_lod"), GltfEffect::Shape);
  for (const char* name : {"", "ACME_melts_models", "KHR_", "materials"}) {
    EXPECT_EQ(effect_of_extension(name), GltfEffect::Unknown) << name;
  }
}

// What changes nothing is not named; what may change the shape is named once, or refused.
TEST(GltfReader, names_extensions_that_may_change_the_shape) {
  Document d = tetrahedron_document();
  d.json["extensionsUsed"] = {"KHR_xmp_json_ld", "MSFT_lod",          "ACME_melts_models",
                              "MSFT_lod",        "ACME_melts_models", "KHR_materials_unlit",
                              "ACME\x1b[2Jx"};
  EXPECT_EQ(read(glb(d)).warnings,
            std::vector<std::string>{"extensions that change the shape, passed over: MSFT_lod "
                                     "(only the finest level of detail)"});
  EXPECT_EQ(read(glb(d)).notes,
            std::vector<std::string>{
                "extensions that are not known, passed over: 'ACME_melts_models', 'ACME...'"});
  for (int i = 0; i < 1000; ++i) d.json["extensionsUsed"].push_back("X" + std::to_string(i));
  EXPECT_LT(read(glb(d)).notes.back().size(), 200U);
  d.json["extensionsUsed"] = Json::array();
  d.json["extensionsRequired"] = {"KHR_xmp_json_ld", "KHR_mesh_quantization", "KHR_audio_emitter",
                                  "KHR_draco_mesh_compression"};
  EXPECT_TRUE(is_same(read(glb(d)).mesh, expected()));
  EXPECT_TRUE(read(glb(d)).notes.empty());
}

TEST(GltfReader, refuses_missing_members) {
  const auto refuse_without = [](const char* path, const char* member, const char* message) {
    Document d = tetrahedron_document();
    d.json[Json::json_pointer(path)].erase(member);
    SCOPED_TRACE(member);
    expect_refused(glb(d), message);
  };
  refuse_without("/buffers/0", "byteLength", "buffers[0]: needs byteLength");
  refuse_without("/bufferViews/0", "buffer", "bufferViews[0]: needs buffer");
  refuse_without("/bufferViews/1", "byteLength", "bufferViews[1]: needs byteLength");
  refuse_without("/accessors/0", "componentType", "accessors[0]: needs componentType");
  refuse_without("/accessors/1", "count", "accessors[1]: needs count");
  refuse_without("/accessors/1", "type", "accessors[1]: type is not SCALAR");
  refuse_without("/asset", "version", "asset: does not say version 2");
  refuse_without("", "asset", "asset: does not say version 2");
  Document d = tetrahedron_document();
  d.json["buffers"].push_back({{"byteLength", 1}});
  d.json["bufferViews"][0]["buffer"] = 1;
  expect_refused(glb(d), "buffers[1]: no bytes are there");
  for (const char* list : {"buffers", "bufferViews", "accessors", "meshes", "nodes", "scenes"}) {
    expect_refused(std::string("/") + list + "/0", 7, std::string(list) + "[0]: no object");
  }
}

TEST(GltfReader, refuses_hostile_documents) {
  const std::size_t huge = std::size_t{1} << 53U;
  expect_refused("/accessors/0/count", huge, "accessors[0]: 9007199254740992 elements are not in");
  expect_refused("/accessors/0/count", huge + 1, "count is no count");
  expect_refused("/accessors/0/count", 5, "elements are not in");
  expect_refused("/accessors/0/count", -1, "count is no count");
  expect_refused("/accessors/0/count", 1.5, "count is no count");
  expect_refused("/accessors/0/byteOffset", 1, "elements are not in");
  expect_refused("/accessors/0/byteOffset", huge, "elements are not in");
  expect_refused("/accessors/0/byteOffset", 47, "elements are not in");
  expect_refused("/accessors/0/componentType", 5125, "componentType 5125 is not read");
  expect_refused("/accessors/0/componentType", 5124, "componentType 5124 is not read");
  expect_refused("/accessors/0/type", "VEC2", "type is not VEC3");
  expect_refused("/accessors/0/sparse", Json::object(), "sparse needs indices and values");
  expect_refused("/accessors/0/sparse", 7, "sparse is no object");
  expect_refused("/accessors/0/bufferView", 2, "bufferViews[2]: there is none");
  expect_refused("/accessors/1/componentType", 5122, "componentType 5122");
  expect_refused("/accessors/1/count", 11, "11 corners");
  expect_refused("/bufferViews/0/byteStride", 4, "less than an element");
  expect_refused("/bufferViews/0/byteLength", huge, "longer than its buffer");
  expect_refused("/bufferViews/0/byteOffset", huge, "longer than its buffer");
  expect_refused("/bufferViews/0/buffer", 1, "buffers[1]: there is none");
  expect_refused("/buffers/0/byteLength", huge, "bytes are announced");
  expect_refused("/buffers/0/uri", 7, "uri is no text");
  expect_refused("/buffers/0/uri", "data:text/plain,abc", "not base64");
  expect_refused("/buffers/0/uri", "data:;base64,a", "not base64");
  expect_refused("/buffers/0/uri", "data:;base64,!!!!", "not base64");
  expect_refused("/meshes/0/primitives/0/mode", 7, "no such mode");
  expect_refused("/meshes/0/primitives/0", 7, "no object");
  expect_refused("/meshes/0/primitives/0/indices", 0, "type is not SCALAR");
  expect_refused("/nodes/0/mesh", 1, "meshes[1]: there is none");
  expect_refused("/nodes/0/rotation", {0, 0, 0, 0}, "no rotation");
  expect_refused("/nodes/0/rotation", {0, 0, 1}, "has not 4 numbers");
  expect_refused("/nodes/0/scale", {1, 1, "1"}, "no number");
  expect_refused("/nodes/0/matrix", {1e308, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e308, 0, 0, 1},
                 "not finite");
  expect_refused("/nodes/0/children", {0}, "nodes[0]: hangs in two places");
  expect_refused("/nodes/0/children", {1}, "a node that there is not");
  expect_refused("/nodes/0/children", 1, "children is no list");
  expect_refused("/scene", 1, "scenes[1]: there is none");
  expect_refused("/scenes/0/nodes", {0, 0}, "hangs in two places");
  expect_refused("/extensionsRequired", {"x" + std::string(100000, 'y')}, "xyyyyyyy");
  expect_refused("/extensionsRequired", {"KHR\x1b[2Jx"}, "'KHR...'");
  expect_refused("/extensionsRequired", {7}, "cannot be read: ''");
  expect_refused("/extensionsRequired", {"CESIUM_RTC"}, "export the file without it");
  expect_refused("/asset/version", "1.0", "asset: does not say version 2");
  expect_refused("/asset/version", 2, "asset: does not say version 2");
  expect_refused("/asset", "2.0", "asset: does not say version 2");
  expect_refused("/nodes/0", Json::object(), "no triangles");
}

TEST(GltfReader, other_json_is_no_empty_solid) {
  expect_refused("{}", "asset: does not say version 2");
  expect_refused(R"({"type": "FeatureCollection", "features": []})", "does not say version 2");
  expect_refused(R"({"asset": {"version": "2.0"}})", "no triangles");
}

TEST(GltfReader, refuses_hostile_bytes) {
  const std::string good = glb(tetrahedron_document());
  for (std::size_t size = 4; size < good.size(); size += 7) {
    EXPECT_THROW(read(good.substr(0, size)), Error) << size;
  }
  const auto with = [&](std::size_t at, std::uint32_t value) {
    std::string bytes = good;
    testing::place(bytes, at, value);
    return bytes;
  };
  expect_refused(with(4, 1), "at byte 4: not version 2");
  expect_refused(with(8, ~0U), "at byte 8: 4294967295 bytes are announced");
  expect_refused(with(8, 12), "at byte 8: no chunk");
  expect_refused(with(12, ~0U), "at byte 12: a chunk is longer");
  expect_refused(with(16, 7), "at byte 12: the first chunk");
  expect_refused(with(20, 7), "at byte 20: not JSON");
  Document d = tetrahedron_document();
  const std::uint16_t far = 4;
  testing::place(d.buffer, 48, far);
  expect_refused(glb(d), "no vertex 4");
  d = tetrahedron_document();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t at : {12U, 16U, 20U}) {
    d = tetrahedron_document();
    testing::place(d.buffer, at, nan);
    expect_refused(glb(d), "vertex 1 has a coordinate that is not finite");
  }
}

TEST(GltfReader, refuses_hostile_texts_with_their_place) {
  testing::expect_refusals(
      {{"empty", "", 1, 1, "no content"},
       {"a list", "[]", 1, 1, "expected an object"},
       {"cut off", "{\n\"nodes\": [", 2, 11, "not JSON"},
       {"no text", "{\n\xff: 1}", 2, 1, "not JSON"},
       {"number", "{\"x\": 1e999}", 1, 11, "too large"},
       {"zero byte", testing::bytes_with_nul("{}\n \0{", 6), 2, 2, "not JSON"}},
      [](const std::string& text) { read(text); });
  const std::string deep(100000, '[');
  expect_refused(deep, "not JSON");
  const std::string good = text(tetrahedron_document());
  EXPECT_TRUE(is_same(read(good + std::string(3, '\0')).mesh, expected()));  // as some pad chunks
  const std::string passed = "{\"x\": " + deep + std::string(100000, ']') + ", " + good.substr(1);
  EXPECT_TRUE(is_same(read(passed).mesh, expected()));
  Limits limits;
  limits.max_memory_bytes = 1U << 20;
  EXPECT_THROW(read(passed, limits), Error);
}

// A mesh of many bytes, placed by many nodes: quadratic, so it is charged.
TEST(GltfReader, keeps_to_its_limits) {
  Document d = tetrahedron_document();
  d.json["nodes"] = Json::array();
  d.json["scenes"][0]["nodes"] = Json::array();
  for (int i = 0; i < 5000; ++i) {
    d.json["nodes"].push_back({{"mesh", 0}});
    d.json["scenes"][0]["nodes"].push_back(i);
  }
  for (int i = 0; i < 100; ++i) {
    d.json["meshes"][0]["primitives"].push_back(d.json["meshes"][0]["primitives"][0]);
  }
  Limits limits;
  limits.max_memory_bytes = 16U << 20;
  EXPECT_THROW(read(glb(d), limits), Error);
}

// Nodes that place a mesh of many parts without triangles cost what a part costs once.
TEST(GltfReader, parts_without_triangles_are_looked_at_once) {
  Document d = tetrahedron_document();
  d.json["meshes"].push_back({{"primitives", Json::array()}});
  for (int i = 1; i < 10000; ++i) {
    d.json["nodes"].push_back({{"mesh", 1}});
    d.json["scenes"][0]["nodes"].push_back(i);
    d.json["meshes"][1]["primitives"].push_back(Json::object());
  }
  Limits limits;
  limits.max_seconds = 3;
  EXPECT_TRUE(is_same(read(glb(d), limits).mesh, expected()));
}

// A file with a large buffer in its text is charged a few times its size, and only while it is
// read.
TEST(GltfReader, gives_back_what_it_needs_to_read) {
  Document d = tetrahedron_document();
  d.buffer += std::string(4U << 20, 'x');
  const std::string bytes = text(d);
  Limits limits;
  limits.max_memory_bytes = 48U << 20;
  Context context(limits);
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(is_same(read_gltf(bytes, {}, {"some.file"}, context).mesh, expected()));
  }
}

TEST(GltfReader, stops_within_json_and_base64) {
  std::stop_source stop;
  stop.request_stop();
  const auto is_cancelled = [&](auto work) {
    Context context({}, stop.get_token());
    try {
      work(context);
    } catch (const Error& error) {
      return error.code() == ErrorCode::Cancelled;
    }
    return false;
  };
  EXPECT_TRUE(is_cancelled([](Context& context) {
    read_gltf(std::string(100000, ' ') + "no JSON", {}, {"some.file"}, context);
  }));
  EXPECT_TRUE(is_cancelled([](Context& context) {
    bytes_of_uri("data:;base64," + std::string(100000, 'A') + "!!!!", {}, context);
  }));
}

// What we write for other programs, back: the same triangles, as exact as floats are.
TEST(GltfReader, reads_what_pictures_write) {
  Scene scene;
  scene.points = {{0, 0, 0}, {.5, 0, 0}, {0, .25, 0}, {0, 0, -.5}};
  scene.patches = {{{0, 0, 1}, Paint::Surface, 0}};
  scene.triangles = {{{0, 2, 1}, 0}, {{0, 1, 3}, 0}, {{0, 3, 2}, 0}, {{1, 2, 3}, 0}};
  scene.quarter_scale = .25;
  std::ostringstream out;
  write_scene_glb(out, scene, "title");
  const PolygonMesh mesh = read(out.str()).mesh;
  EXPECT_EQ(mesh.face_count(), 4U);
  EXPECT_EQ(mesh.points, (std::vector<Point3>{{0, 0, 0}, {0, 0, -.25}, {.5, 0, 0}, {0, -.5, 0}}));
}

TEST(GltfReader, is_told_by_extension_and_by_its_first_bytes) {
  EXPECT_EQ(mesh_format_of("a.glb"), MeshFormat::Gltf);
  EXPECT_EQ(mesh_format_of("a.gltf"), MeshFormat::Gltf);
  EXPECT_EQ(guess_mesh_format(glb(tetrahedron_document())), MeshFormat::Gltf);
  EXPECT_EQ(guess_mesh_format(text(tetrahedron_document())), MeshFormat::Gltf);
}

// ---------------------------------------------------------------- channels

MeshFile read_channels(const Document& d, Limits limits = {}) {
  Context context(limits);
  ReadOptions options{"some.file"};
  options.attributes = true;
  return read_gltf(glb(d), {}, options, context);
}

const MeshChannel* channel_named(const MeshFile& file, const std::string& name) {
  for (const MeshChannel& channel : file.attributes.channels) {
    if (channel.name == name) return &channel;
  }
  return nullptr;
}

/// The four triangles of the tetrahedron without common vertices.
std::vector<float> loose_corners() {
  std::vector<float> points;
  for (const int v : kFaces) {
    for (int k = 0; k < 3; ++k) points.push_back(kCorners[static_cast<std::size_t>(3 * v + k)]);
  }
  return points;
}

TEST(GltfChannels, TextureCoordinatesStayAtTheirCornersInAllModesAndUnderMirrors) {
  const std::vector<float> points = loose_corners();
  std::vector<float> uv;
  for (std::size_t v = 0; v < points.size() / 3; ++v) {
    uv.push_back(points[3 * v] + 2 * points[3 * v + 1]);
    uv.push_back(1 - points[3 * v + 2]);  // v points down in the file.
  }
  for (const int mode : {4, 5, 6}) {
    for (const double x : {1.0, -2.0}) {
      SCOPED_TRACE(mode);
      Document d = tetrahedron_document();
      Json& primitive = d.json["meshes"][0]["primitives"][0];
      primitive.erase("indices");
      primitive["mode"] = mode;
      primitive["attributes"]["POSITION"] = add_accessor(d, points, 5126, "VEC3", 3);
      primitive["attributes"]["TEXCOORD_0"] = add_accessor(d, uv, 5126, "VEC2", 2);
      d.json["nodes"][0]["scale"] = {x, 3, 5};
      const MeshFile file = read_channels(d);
      const MeshChannel* const channel = channel_named(file, "texcoord_0");
      ASSERT_NE(channel, nullptr);
      ASSERT_EQ(channel->values.size(), 2 * file.mesh.corners.size());
      for (std::size_t c = 0; c < file.mesh.corners.size(); ++c) {
        const Point3& p = file.mesh.points[file.mesh.corners[c]];
        EXPECT_DOUBLE_EQ(channel->values[2 * c], p.x / x + 2 * p.y / 3);
        EXPECT_DOUBLE_EQ(channel->values[2 * c + 1], p.z / 5);
      }
    }
  }
}

TEST(GltfChannels, NormalsStayOrthogonalAndOutside) {
  const std::vector<float> points = loose_corners();
  const auto s = static_cast<float>(1 / std::sqrt(3.0));
  const std::vector<std::array<float, 3>> of_face{{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}, {s, s, s}};
  std::vector<float> normals;
  for (std::size_t v = 0; v < 12; ++v) {
    normals.insert(normals.end(), of_face[v / 3].begin(), of_face[v / 3].end());
  }
  for (const double x : {1.0, -1.0}) {
    Document d = tetrahedron_document();
    Json& primitive = d.json["meshes"][0]["primitives"][0];
    primitive.erase("indices");
    primitive["attributes"]["POSITION"] = add_accessor(d, points, 5126, "VEC3", 3);
    primitive["attributes"]["NORMAL"] = add_accessor(d, normals, 5126, "VEC3", 3);
    d.json["nodes"][0]["matrix"] = {2 * x, 0, 0, 0, 1, 1, 0, 0, 0, -3, 5, 0, 7, 8, 9, 1};
    const MeshFile file = read_channels(d);
    const MeshChannel* const channel = channel_named(file, "normal");
    ASSERT_NE(channel, nullptr);
    ASSERT_EQ(file.mesh.face_count(), 4U);
    for (std::size_t f = 0; f < 4; ++f) {
      const auto corners = file.mesh.face(f);
      const Point3 &a = file.mesh.points[corners[0]], &b = file.mesh.points[corners[1]];
      const Point3& c = file.mesh.points[corners[2]];
      const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z};
      const std::array<double, 3> v{c.x - a.x, c.y - a.y, c.z - a.z};
      const double* const n = channel->values.data() + 9 * f;
      EXPECT_NEAR(n[0] * u[0] + n[1] * u[1] + n[2] * u[2], 0, 1e-6);
      EXPECT_NEAR(n[0] * v[0] + n[1] * v[1] + n[2] * v[2], 0, 1e-6);
      EXPECT_GT(n[0] * (u[1] * v[2] - u[2] * v[1]) + n[1] * (u[2] * v[0] - u[0] * v[2]) +
                    n[2] * (u[0] * v[1] - u[1] * v[0]),
                0);
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-6);
    }
  }
}

TEST(GltfChannels, ColoursAreFloatsOrFractionsAndOtherPrimitivesAreWhite) {
  Document d = tetrahedron_document();
  Json& primitives = d.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives.push_back(primitives[0]);
  const std::vector<std::uint8_t> bytes{255, 0, 51, 102, 255, 0, 51, 102,
                                        255, 0, 51, 102, 255, 0, 51, 102};
  const std::size_t of_bytes = add_accessor(d, bytes, 5121, "VEC4", 4);
  d.json["accessors"][of_bytes]["normalized"] = true;
  primitives[1]["attributes"]["COLOR_0"] = of_bytes;
  const std::vector<float> floats{2, 0.5, -1, 2, 0.5, -1, 2, 0.5, -1, 2, 0.5, -1};
  primitives[2]["attributes"]["COLOR_0"] = add_accessor(d, floats, 5126, "VEC3", 3);
  const MeshFile file = read_channels(d);
  const MeshChannel* const channel = channel_named(file, "color");
  ASSERT_NE(channel, nullptr);
  ASSERT_EQ(channel->width, 4U);
  ASSERT_EQ(channel->values.size(), 3 * 12 * 4U);
  const std::vector<std::vector<double>> expected{{1, 1, 1, 1}, {1, 0, 0.2, 0.4}, {1, 0.5, 0, 1}};
  for (std::size_t c = 0; c < 36; ++c) {
    const std::vector<double> at(channel->values.begin() + static_cast<std::ptrdiff_t>(4 * c),
                                 channel->values.begin() + static_cast<std::ptrdiff_t>(4 * c + 4));
    EXPECT_EQ(at, expected[c / 12]) << c;
  }
  EXPECT_TRUE(read(glb(d)).attributes.empty());
}

TEST(GltfChannels, DamagedOnesAreNamedAndNumbersThatAreNotFiniteAreZero) {
  const auto expect_left_out = [](const Document& d) {
    const MeshFile file = read_channels(d);
    EXPECT_EQ(file.mesh.face_count(), 4U);
    EXPECT_TRUE(file.attributes.channels.empty());
    ASSERT_EQ(file.notes.size(), 1U);
    EXPECT_NE(file.notes[0].find("that cannot be read"), std::string::npos) << file.notes[0];
  };
  const auto with = [](const std::string& member, const char* type, std::size_t parts,
                       std::size_t count, int component = 5126) {
    Document d = tetrahedron_document();
    const std::size_t accessor =
        add_accessor(d, std::vector<float>(parts * count, 0.5F), component, type, parts);
    d.json["meshes"][0]["primitives"][0]["attributes"][member] = accessor;
    return d;
  };
  EXPECT_EQ(read_channels(with("TEXCOORD_0", "VEC2", 2, 4)).attributes.channels.size(), 1U);
  expect_left_out(with("TEXCOORD_0", "VEC2", 2, 3));
  expect_left_out(with("COLOR_0", "VEC3", 3, 5));
  expect_left_out(with("NORMAL", "VEC2", 2, 4));
  expect_left_out(with("COLOR_0", "SCALAR", 1, 4));
  expect_left_out(with("NORMAL", "VEC3", 3, 4, 5125));
  Document d = with("COLOR_0", "VEC3", 3, 4);
  d.json["accessors"].back()["count"] = 1 << 30;
  expect_left_out(d);
  d = with("COLOR_0", "VEC3", 3, 4);
  d.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 99;
  expect_left_out(d);
  d = tetrahedron_document();
  std::vector<float> odd(12, 0.25F);
  odd[5] = std::numeric_limits<float>::quiet_NaN();
  odd[7] = std::numeric_limits<float>::infinity();
  d.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      add_accessor(d, odd, 5126, "VEC3", 3);
  const MeshFile file = read_channels(d);
  for (const double value : channel_named(file, "normal")->values) {
    EXPECT_TRUE(std::isfinite(value));
  }
  ASSERT_FALSE(file.notes.empty());
  EXPECT_NE(file.notes.back().find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace plumb::gltf_test
