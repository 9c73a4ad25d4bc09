#include "plumb/io/mesh/glb.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/stl.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint64_t kGlbHeaderBytes = 12, kGlbChunkBytes = 8;
constexpr std::uint64_t kGlbRecordBytes = 12;  // Three floats of a vertex, or three corners.

void put_array(TextOutput& out, const std::array<double, 3>& numbers) {
  out << '[' << numbers[0] << ',' << numbers[1] << ',' << numbers[2] << ']';
}

/// Writes the bounds of the vertices, which glTF requires of positions.
void put_bounds(TextOutput& out, const PolygonMesh& mesh) {
  const Point3& first = mesh.points.front();
  std::array<double, 3> low{first.x, first.y, first.z};
  std::array<double, 3> high = low;
  for (const Point3& p : mesh.points) {
    const std::array<double, 3> parts{p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], parts[i]);
      high[i] = std::max(high[i], parts[i]);
    }
  }
  out << R"("min":)";
  put_array(out, low);
  out << R"(,"max":)";
  put_array(out, high);
}

/// The triangles of one material, as a range of all triangles.
struct GlbPart {
  std::uint32_t material;  ///< MeshAttributes::kNone if there is none.
  std::uint64_t first, count;
};

/// The triangles in the order of their materials.
struct GlbOrder {
  std::vector<std::uint32_t> faces;
  std::vector<GlbPart> parts;
};

/// Sorts triangles by their materials; those without one come last.
GlbOrder order_by_material(const PolygonMesh& mesh, const MeshAttributes& attributes) {
  GlbOrder order;
  order.faces.resize(mesh.face_count());
  std::iota(order.faces.begin(), order.faces.end(), 0U);
  const std::vector<std::uint32_t>& material = attributes.face_material;
  if (material.empty()) {
    order.parts.push_back({MeshAttributes::kNone, 0, mesh.face_count()});
    return order;
  }
  std::stable_sort(order.faces.begin(), order.faces.end(),
                   [&](std::uint32_t f, std::uint32_t g) { return material[f] < material[g]; });
  for (std::uint64_t i = 0; i < order.faces.size(); ++i) {
    const std::uint32_t own = material[order.faces[i]];
    if (i == 0 || own != order.parts.back().material) order.parts.push_back({own, i, 0});
    ++order.parts.back().count;
  }
  return order;
}

/// Writes a list, with a comma between its members.
template <class List, class Put>
void put_list(TextOutput& out, const List& list, Put put) {
  bool is_first = true;
  for (const auto& member : list) {
    if (!std::exchange(is_first, false)) out << ',';
    put(member);
  }
}

/// Returns a text as JSON.
std::string json_string(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Writes names and colours of materials. Textures would need the coordinates of corners.
void put_materials(TextOutput& out, const MeshAttributes& attributes) {
  if (attributes.face_material.empty() || attributes.materials.empty()) return;
  out << R"("materials":[)";
  put_list(out, attributes.materials, [&](const MeshMaterial& material) {
    out << '{';
    if (!material.name.empty()) out << R"("name":)" << json_string(material.name) << ',';
    out << R"("pbrMetallicRoughness":{)";
    if (material.color) {
      const auto& [r, g, b, a] = *material.color;
      out << R"("baseColorFactor":[)" << r << ',' << g << ',' << b << ',' << a << "],";
    }
    out << R"("metallicFactor":0})";
    if (material.color && (*material.color)[3] < 1) out << R"(,"alphaMode":"BLEND")";
    out << '}';
  });
  out << "],";
}

/// Returns the document, with blanks that make its length a multiple of four. Accessor 0 has the
/// vertices, accessor i + 1 the corners of part i.
std::string glb_document(const PolygonMesh& mesh, const MeshAttributes& attributes,
                         const GlbOrder& order, std::uint64_t vertex_bytes,
                         std::uint64_t corner_bytes) {
  std::ostringstream text;
  TextOutput out(text);
  out << R"({"asset":{"version":"2.0","generator":"plumb"},"scene":0,"scenes":[{"nodes":[0]}],)"
      << R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[)";
  std::uint64_t accessor = 1;
  put_list(out, order.parts, [&](const GlbPart& part) {
    out << R"({"attributes":{"POSITION":0},"indices":)" << accessor++;
    if (part.material != MeshAttributes::kNone) out << R"(,"material":)" << part.material;
    out << '}';
  });
  out << "]}],";
  put_materials(out, attributes);
  out << R"("buffers":[{"byteLength":)" << vertex_bytes + corner_bytes
      << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << vertex_bytes
      << R"(,"target":34962},{"buffer":0,"byteOffset":)" << vertex_bytes << R"(,"byteLength":)"
      << corner_bytes << R"(,"target":34963}],"accessors":[{"bufferView":0,"componentType":5126,)"
      << R"("count":)" << std::uint64_t{mesh.points.size()} << R"(,"type":"VEC3",)";
  put_bounds(out, mesh);
  out << "},";
  put_list(out, order.parts, [&](const GlbPart& part) {
    out << R"({"bufferView":1,)";
    if (part.first > 0) out << R"("byteOffset":)" << kGlbRecordBytes * part.first << ',';
    out << R"("componentType":5125,"count":)" << 3 * part.count << R"(,"type":"SCALAR"})";
  });
  out << "]}";
  out.flush();
  std::string document = text.str();
  document.resize((document.size() + 3) / 4 * 4, ' ');
  return document;
}

}  // namespace

void require_faces(const PolygonMesh& mesh) {
  if (mesh.face_count() == 0) {
    throw Error(ErrorCode::BadArgument, "the mesh has no faces, and glTF cannot hold such a mesh");
  }
}

void write_glb(std::ostream& stream, const PolygonMesh& mesh, const MeshAttributes& attributes) {
  require_faces(mesh);
  require_triangles(mesh);
  const PolygonMesh floats = rounded_to_floats(mesh);
  const std::uint64_t vertex_bytes = kGlbRecordBytes * floats.points.size();
  const std::uint64_t corner_bytes = kGlbRecordBytes * floats.face_count();
  const std::uint64_t data_bytes = vertex_bytes + corner_bytes;
  const GlbOrder order = order_by_material(floats, attributes);
  const std::string document = glb_document(floats, attributes, order, vertex_bytes, corner_bytes);
  const std::uint64_t bytes = kGlbHeaderBytes + 2 * kGlbChunkBytes + document.size() + data_bytes;
  if (bytes > UINT32_MAX) {
    throw Error(ErrorCode::CannotWrite, "binary glTF cannot hold 2^32 bytes or more");
  }
  TextOutput out(stream);
  out << "glTF";
  put_little_endian(out, std::uint32_t{2});
  put_little_endian(out, static_cast<std::uint32_t>(bytes));
  put_little_endian(out, static_cast<std::uint32_t>(document.size()));
  out << "JSON" << document;
  put_little_endian(out, static_cast<std::uint32_t>(data_bytes));
  out << std::string_view("BIN\0", 4);
  for (const Point3& p : floats.points) {
    for (const double value : {p.x, p.y, p.z}) put_little_endian(out, static_cast<float>(value));
  }
  for (const std::uint32_t f : order.faces) {
    for (const std::uint32_t corner : floats.face(f)) put_little_endian(out, corner);
  }
  out.flush();
}

}  // namespace plumb
