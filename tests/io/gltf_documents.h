// glTF documents of a tetrahedron, to be changed by tests, and what readers make of them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "little_endian.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/gltf.h"
#include "plumb/io/mesh_io.h"
#include "plumb/picture/svg/svg_text.h"

namespace plumb::gltf_documents {

using Json = nlohmann::ordered_json;
using testing::is_same;

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    testing::place(bytes, i * sizeof(Number), numbers[i]);
  }
  return bytes;
}

/// A tetrahedron: 4 vertices of floats, then indices.
inline const std::vector<float> kCorners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::vector<int> kFaces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

struct Document {
  Json json;
  std::string buffer;
};

template <class Index>
Document tetrahedron_document(int component) {
  const std::string points = bytes_of(kCorners);
  const std::string indices = bytes_of(std::vector<Index>(kFaces.begin(), kFaces.end()));
  Document d;
  d.buffer = points + indices;
  d.json = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "buffers": [{}], "bufferViews": [{"buffer": 0}, {"buffer": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "count": 12, "type": "SCALAR"}]})");
  d.json["buffers"][0]["byteLength"] = d.buffer.size();
  d.json["bufferViews"][0]["byteLength"] = points.size();
  d.json["bufferViews"][1]["byteOffset"] = points.size();
  d.json["bufferViews"][1]["byteLength"] = indices.size();
  d.json["accessors"][1]["componentType"] = component;
  return d;
}
inline Document tetrahedron_document() { return tetrahedron_document<std::uint16_t>(5123); }

inline std::string chunk(const std::string& kind, const std::string& bytes) {
  return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())}) + kind + bytes;
}
inline std::string glb(const Document& d) {
  const std::string chunks =
      chunk("JSON", d.json.dump()) + chunk(std::string("BIN\0", 4), d.buffer);
  return "glTF" + bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(12 + chunks.size())}) +
         chunks;
}
inline std::string text(Document d) {
  d.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(d.buffer);
  return d.json.dump();
}

inline MeshFile read(const std::string& bytes, Limits limits = {}) {
  Context context(limits);
  return read_gltf(bytes, {}, {"some.file"}, context);
}

inline PolygonMesh expected() {
  PolygonMesh mesh = testing::tetrahedron();
  Context context;
  weld_vertices(mesh, context);
  return mesh;
}

inline void expect_refused(const std::string& bytes, const std::string& message) {
  try {
    read(bytes);
    ADD_FAILURE() << message << ": was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.place().file, "some.file");
    EXPECT_NE(error.message().find(message), std::string::npos) << error.what();
    EXPECT_LT(error.message().size(), 200U);
    EXPECT_EQ(error.message().find('\x1b'), std::string::npos);
  }
}
/// With a member changed, as JSON: by its path, "/accessors/0/count".
inline void expect_refused(const std::string& path, const Json& value, const std::string& message) {
  Document d = tetrahedron_document();
  d.json[Json::json_pointer(path)] = value;
  SCOPED_TRACE(path);
  expect_refused(glb(d), message);
}

/// Appends bytes to the buffer as a view of their own, and returns its number.
inline std::size_t add_view(Document& d, const std::string& bytes) {
  d.json["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", d.buffer.size()}, {"byteLength", bytes.size()}});
  d.buffer += bytes;
  d.json["buffers"][0]["byteLength"] = d.buffer.size();
  return d.json["bufferViews"].size() - 1;
}
/// Appends numbers as an accessor, and returns its number.
template <class Number>
std::size_t add_accessor(Document& d, const std::vector<Number>& numbers, int component,
                         const char* type, std::size_t parts) {
  const std::size_t view = add_view(d, bytes_of(numbers));
  d.json["accessors"].push_back({{"bufferView", view},
                                 {"componentType", component},
                                 {"count", numbers.size() / parts},
                                 {"type", type}});
  return d.json["accessors"].size() - 1;
}

/// What the specification says that a component stands for.
template <class Number>
double meant(Number c, bool is_normalized) {
  if (!is_normalized) return c;
  const double value = static_cast<double>(c) / std::numeric_limits<Number>::max();
  return value < -1 ? -1 : value;
}

}  // namespace plumb::gltf_documents
