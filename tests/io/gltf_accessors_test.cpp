// Accessors of glTF that are sparse, quantised or without bytes.
#include "plumb/io/mesh/gltf_accessors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "gltf_documents.h"
#include "plumb/io/mesh/mesh_formats.h"

namespace plumb::gltf_accessors_test {
namespace {

using namespace gltf_documents;

template <class Index>
Json sparse(Document& d, const std::vector<Index>& indices, int component,
            const std::string& values) {
  const std::size_t at = add_view(d, bytes_of(indices)), to = add_view(d, values);
  return {{"count", indices.size()},
          {"indices", {{"bufferView", at}, {"componentType", component}}},
          {"values", {{"bufferView", to}}}};
}

// With and without elements below it, a sparse accessor has the elements that it lists.
TEST(GltfAccessors, sparse_accessors) {
  const auto expect_read = [](Document d, const Json& replaced) {
    d.json["accessors"][0]["sparse"] = replaced;
    EXPECT_TRUE(is_same(read(glb(d)).mesh, expected()));
    EXPECT_TRUE(read(glb(d)).notes.empty());
    d.json["accessors"][0].erase("bufferView");
    EXPECT_TRUE(is_same(read(glb(d)).mesh, expected()));
    EXPECT_TRUE(read(glb(d)).notes.empty());
  };
  const std::vector<float> moved(kCorners.begin() + 3, kCorners.end());
  Document d = tetrahedron_document();
  std::memset(d.buffer.data() + 12, 0x3f, 36);  // What is replaced is none of the corners.
  const Json bytes = sparse<std::uint8_t>(d, {1, 2, 3}, 5121, bytes_of(moved));
  expect_read(d, bytes);
  const Json shorts = sparse<std::uint16_t>(d, {1, 2, 3}, 5123, bytes_of(moved));
  expect_read(d, shorts);
  const Json ints = sparse<std::uint32_t>(d, {1, 2, 3}, 5125, bytes_of(moved));
  expect_read(d, ints);
  // Indices may be sparse, too.
  d = tetrahedron_document();
  std::memset(d.buffer.data() + 48, 1, 4);
  d.json["accessors"][1]["sparse"] =
      sparse<std::uint16_t>(d, {0, 1}, 5123, bytes_of<std::uint16_t>({0, 2}));
  EXPECT_TRUE(is_same(read(glb(d)).mesh, expected()));
}

TEST(GltfAccessors, refuses_hostile_sparse_accessors) {
  Document d = tetrahedron_document();
  d.json["accessors"][0]["sparse"] =
      sparse<std::uint16_t>(d, {1, 4}, 5123, bytes_of(std::vector<float>(6)));
  expect_refused(glb(d), "accessors[0]: sparse: no element 4");
  const auto refuse_with = [&](const char* path, const Json& value, const char* message) {
    Document other = d;
    other.json["accessors"][0]["sparse"][Json::json_pointer(path)] = value;
    SCOPED_TRACE(path);
    expect_refused(glb(other), message);
  };
  refuse_with("/count", 3, "3 elements are not in its bufferView");
  refuse_with("/count", std::size_t{1} << 53U, "elements are not in its bufferView");
  refuse_with("/count", "2", "count is no count");
  refuse_with("/indices/componentType", 5126, "componentType 5126");
  refuse_with("/indices/bufferView", 9, "bufferViews[9]: there is none");
  refuse_with("/indices/byteOffset", 1, "elements are not in its bufferView");
  refuse_with("/values/byteOffset", 1, "elements are not in its bufferView");
  refuse_with("/values", 7, "sparse needs indices and values");
  // Zeros cost memory: no more than what a file of its length may have.
  d.json["accessors"][0].erase("bufferView");
  for (const std::size_t count : {std::size_t{1} << 20U, std::size_t{1} << 53U}) {
    d.json["accessors"][0]["count"] = count;
    expect_refused(glb(d), std::to_string(count) + " elements without a bufferView");
  }
}

// As glTF says, elements without bytes are zeros; a note says so, because some extension may have
// meant others.
TEST(GltfAccessors, elements_without_bytes_are_zeros) {
  Document d = tetrahedron_document();
  d.json["accessors"][0].erase("bufferView");
  const MeshFile file = read(glb(d));
  EXPECT_EQ(file.mesh.face_count(), 0U);
  EXPECT_EQ(file.notes, (std::vector<std::string>{
                            "4 triangles with two equal corners left out",
                            "accessors without a bufferView, whose elements are zeros: 1"}));
}

template <class Number>
void expect_quantised(int component) {
  constexpr Number kLeast = std::numeric_limits<Number>::min();
  constexpr Number kMost = std::numeric_limits<Number>::max();
  const std::vector<Number> numbers{0, 1, 0, kMost, 0, 3, kLeast, kMost, 5, 77, 99, kMost};
  for (const bool is_normalized : {false, true}) {
    Document d = tetrahedron_document();
    std::vector<Number> rows;  // Elements begin at multiples of 4 bytes.
    const std::size_t stride = (3 * sizeof(Number) + 3) / 4 * 4;
    for (std::size_t v = 0; v < 4; ++v) {
      for (std::size_t k = 3 * v; k < 3 * v + 3; ++k) rows.push_back(numbers[k]);
      rows.resize((v + 1) * stride / sizeof(Number), 42);
    }
    const std::size_t accessor = add_accessor(d, rows, component, "VEC3", stride / sizeof(Number));
    d.json["bufferViews"][2]["byteStride"] = stride;
    d.json["accessors"][accessor]["normalized"] = is_normalized;
    d.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = accessor;
    d.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    d.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    PolygonMesh mesh;
    for (std::size_t v = 0; v < 4; ++v) {
      mesh.points.push_back({meant(numbers[3 * v], is_normalized),
                             meant(numbers[3 * v + 1], is_normalized),
                             meant(numbers[3 * v + 2], is_normalized)});
    }
    for (std::size_t i = 0; i < kFaces.size(); i += 3) {
      const auto first = kFaces.begin() + static_cast<std::ptrdiff_t>(i);
      mesh.add_face(std::vector<std::uint32_t>(first, first + 3));
    }
    Context context;
    weld_vertices(mesh, context);
    EXPECT_TRUE(is_same(read(glb(d)).mesh, mesh)) << component << is_normalized;
    EXPECT_TRUE(read(glb(d)).notes.empty());
  }
}

TEST(GltfAccessors, quantised_coordinates) {
  expect_quantised<std::int8_t>(5120);
  expect_quantised<std::uint8_t>(5121);
  expect_quantised<std::int16_t>(5122);
  expect_quantised<std::uint16_t>(5123);
}

}  // namespace
}  // namespace plumb::gltf_accessors_test
