// Writing of binary glTF: positions, corners by material, and the channels of vertices.
//
// The channels of glTF belong to vertices, so a vertex is written once for each combination of
// numbers that its corners have. Normals must have the length 1: interpolated normals are scaled,
// and a corner without a normal gets the normal of its triangle. In glTF, v of a texture points
// down, elsewhere up. A texture needs texture coordinates; without them, only the colour of a
// material is written.
//
// Tested by tests/io/mesh_attributes_test.cpp and tests/io/mesh_io_test.cpp.
#include "plumb/io/mesh/glb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/mesh/mesh_formats.h"
#include "plumb/io/mesh/stl.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint64_t kGlbHeaderBytes = 12, kGlbChunkBytes = 8;
// A vertex has three floats, and a triangle has three corners.
constexpr std::uint64_t kGlbRecordBytes = 12;

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

/// Sorts triangles by their materials. Triangles without a material come last.
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

/// Returns the name of a file as a uri.
std::string uri_of(const std::string& name) {
  static constexpr std::string_view kDigits = "0123456789ABCDEF";
  static constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/:+,()";
  std::string uri;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (kPlain.find(c) != kPlain.npos) {
      uri += c;
    } else {
      uri += {'%', kDigits[byte >> 4U], kDigits[byte & 0xfU]};
    }
  }
  return uri;
}

/// Returns the names of the textures of materials, each once.
std::vector<std::string> textures_of(const MeshAttributes& attributes) {
  std::vector<std::string> names;
  for (const MeshMaterial& material : attributes.materials) {
    if (!material.texture.empty()) names.push_back(material.texture);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

/// Writes textures, each with an image that is a file.
void put_textures(TextOutput& out, const std::vector<std::string>& textures) {
  if (textures.empty()) return;
  std::uint64_t source = 0;
  out << R"("textures":[)";
  put_list(out, textures, [&](const std::string&) { out << R"({"source":)" << source++ << '}'; });
  out << R"(],"images":[)";
  put_list(out, textures,
           [&](const std::string& name) { out << R"({"uri":")" << uri_of(name) << "\"}"; });
  out << "],";
}

/// Writes names, colours and textures of materials.
void put_materials(TextOutput& out, const MeshAttributes& attributes, bool has_texcoords) {
  if (attributes.face_material.empty() || attributes.materials.empty()) return;
  const std::vector<std::string> textures =
      has_texcoords ? textures_of(attributes) : std::vector<std::string>();
  put_textures(out, textures);
  out << R"("materials":[)";
  put_list(out, attributes.materials, [&](const MeshMaterial& material) {
    out << '{';
    if (!material.name.empty()) out << R"("name":)" << json_string(material.name) << ',';
    out << R"("pbrMetallicRoughness":{)";
    if (material.color) {
      const auto& [r, g, b, a] = *material.color;
      out << R"("baseColorFactor":[)" << r << ',' << g << ',' << b << ',' << a << "],";
    }
    const auto texture = std::lower_bound(textures.begin(), textures.end(), material.texture);
    if (texture != textures.end() && *texture == material.texture) {
      out << R"("baseColorTexture":{"index":)"
          << static_cast<std::uint64_t>(texture - textures.begin()) << "},";
    }
    out << R"("metallicFactor":0})";
    if (material.color && (*material.color)[3] < 1) out << R"(,"alphaMode":"BLEND")";
    out << '}';
  });
  out << "],";
}

/// A channel of vertices.
struct GlbChannel {
  std::string member;  ///< Its name in a primitive.
  const MeshChannel* channel;
};

/// Writes the views or the accessors of channels, each after a comma.
void put_channel_views(TextOutput& out, const std::vector<GlbChannel>& channels,
                       std::uint64_t offset, std::uint64_t vertices) {
  for (const auto& [member, channel] : channels) {
    const std::uint64_t bytes = sizeof(float) * channel->width * vertices;
    out << R"(,{"buffer":0,"byteOffset":)" << offset << R"(,"byteLength":)" << bytes
        << R"(,"target":34962})";
    offset += bytes;
  }
}
void put_channel_accessors(TextOutput& out, const std::vector<GlbChannel>& channels,
                           std::uint64_t vertices) {
  std::uint64_t view = 2;
  for (const auto& [member, channel] : channels) {
    out << R"(,{"bufferView":)" << view++ << R"(,"componentType":5126,"count":)" << vertices
        << R"(,"type":"VEC)" << channel->width << "\"}";
  }
}

/// Returns the document, with blanks that make its length a multiple of four. Accessor 0 has the
/// vertices, and accessor i + 1 has the corners of part i. The accessors of the channels follow.
std::string glb_document(const PolygonMesh& mesh, const MeshAttributes& attributes,
                         const std::vector<GlbChannel>& channels, const GlbOrder& order,
                         std::uint64_t vertex_bytes, std::uint64_t corner_bytes,
                         std::uint64_t channel_bytes) {
  std::ostringstream text;
  TextOutput out(text);
  out << R"({"asset":{"version":"2.0","generator":"plumb"},"scene":0,"scenes":[{"nodes":[0]}],)"
      << R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[)";
  std::uint64_t accessor = 1;
  put_list(out, order.parts, [&](const GlbPart& part) {
    out << R"({"attributes":{"POSITION":0)";
    std::uint64_t number = 1 + order.parts.size();
    for (const GlbChannel& each : channels) out << ",\"" << each.member << "\":" << number++;
    out << R"(},"indices":)" << accessor++;
    if (part.material != MeshAttributes::kNone) out << R"(,"material":)" << part.material;
    out << '}';
  });
  out << "]}],";
  const bool has_texcoords = !channels.empty() && channels.back().member.starts_with("TEXCOORD");
  put_materials(out, attributes, has_texcoords);
  out << R"("buffers":[{"byteLength":)" << vertex_bytes + corner_bytes + channel_bytes
      << R"(}],"bufferViews":[{"buffer":0,"byteLength":)" << vertex_bytes
      << R"(,"target":34962},{"buffer":0,"byteOffset":)" << vertex_bytes << R"(,"byteLength":)"
      << corner_bytes << R"(,"target":34963})";
  put_channel_views(out, channels, vertex_bytes + corner_bytes, mesh.points.size());
  out << R"(],"accessors":[{"bufferView":0,"componentType":5126,)"
      << R"("count":)" << std::uint64_t{mesh.points.size()} << R"(,"type":"VEC3",)";
  put_bounds(out, mesh);
  out << "},";
  put_list(out, order.parts, [&](const GlbPart& part) {
    out << R"({"bufferView":1,)";
    if (part.first > 0) out << R"("byteOffset":)" << kGlbRecordBytes * part.first << ',';
    out << R"("componentType":5125,"count":)" << 3 * part.count << R"(,"type":"SCALAR"})";
  });
  put_channel_accessors(out, channels, mesh.points.size());
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

std::vector<const MeshChannel*> glb_channels(const MeshAttributes& attributes) {
  std::vector<const MeshChannel*> channels;
  const auto add = [&](const std::string& name, std::uint32_t least, std::uint32_t most) {
    const MeshChannel* const channel = channel_of(attributes, name, least, most);
    if (channel != nullptr) channels.push_back(channel);
    return channel != nullptr;
  };
  add("color", 3, 4);
  add("normal", 3, 3);
  for (int i = 0; add("texcoord_" + std::to_string(i), 2, 2);) ++i;
  return channels;
}

namespace {

/// Returns the normal of a triangle with the length 1, or the z axis if it has none.
std::array<double, 3> normal_of_triangle(const PolygonMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  const Point3 &a = mesh.points[corners[0]], &b = mesh.points[corners[1]];
  const Point3& c = mesh.points[corners[2]];
  const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z};
  const std::array<double, 3> v{c.x - a.x, c.y - a.y, c.z - a.z};
  std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                          u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0) || !std::isfinite(length)) return {0, 0, 1};
  for (double& part : n) part /= length;
  return n;
}

/// Returns a channel with the numbers that glTF requires.
MeshChannel as_in_gltf(const MeshChannel& from, const PolygonMesh& mesh) {
  MeshChannel to = from;
  const std::size_t width = to.width;
  if (to.name == "color") {
    for (double& part : to.values) part = std::clamp(part, 0.0, 1.0);
  }
  for (std::size_t at = 0; to.name == "normal" && at < to.values.size(); at += width) {
    double* const n = to.values.data() + at;
    const double length = std::hypot(n[0], n[1], n[2]);
    if (length > 0 && std::isfinite(length)) {
      for (std::size_t i = 0; i < 3; ++i) n[i] /= length;
    } else {
      const std::array<double, 3> own = normal_of_triangle(mesh, at / width / 3);
      std::copy(own.begin(), own.end(), n);
    }
  }
  if (to.name.starts_with("texcoord_")) {
    for (std::size_t at = 1; at < to.values.size(); at += width) to.values[at] = 1 - to.values[at];
  }
  return to;
}

/// Returns the name of a channel in a primitive.
std::string member_of(const MeshChannel& channel) {
  if (channel.name == "color") return "COLOR_0";
  if (channel.name == "normal") return "NORMAL";
  return "TEXCOORD_" + channel.name.substr(std::string_view("texcoord_").size());
}

/// Returns how many bytes the numbers of channels have.
std::uint64_t bytes_of(const std::vector<GlbChannel>& channels, std::uint64_t vertices) {
  std::uint64_t bytes = 0;
  for (const GlbChannel& each : channels) bytes += sizeof(float) * each.channel->width * vertices;
  return bytes;
}

/// Writes the numbers of all vertices, channel after channel.
void put_channels(TextOutput& out, const std::vector<GlbChannel>& channels,
                  const std::vector<std::uint32_t>& corner_of_vertex) {
  for (const GlbChannel& each : channels) {
    for (const std::uint32_t corner : corner_of_vertex) {
      std::vector<double> values = values_of_vertex(*each.channel, corner);
      const bool is_unused = corner == MeshAttributes::kNone;
      if (is_unused && each.member == "NORMAL") values = {0, 0, 1};
      for (const double value : values) put_little_endian(out, static_cast<float>(value));
    }
  }
}

}  // namespace

void require_glb_size(std::uint64_t bytes) {
  if (bytes <= UINT32_MAX) return;
  throw Error(ErrorCode::CannotWrite, "the file would have " + std::to_string(bytes) +
                                          " bytes, but binary glTF cannot have more than " +
                                          std::to_string(UINT32_MAX));
}

void write_glb(std::ostream& stream, const PolygonMesh& mesh, const MeshAttributes& attributes) {
  require_faces(mesh);
  require_triangles(mesh);
  SplitMesh split{rounded_to_floats(mesh), {}};
  std::vector<MeshChannel> values;
  for (const MeshChannel* const channel : glb_channels(attributes)) {
    values.push_back(as_in_gltf(*channel, split.mesh));
  }
  std::vector<const MeshChannel*> pointers;
  std::vector<GlbChannel> channels;
  for (const MeshChannel& channel : values) {
    pointers.push_back(&channel);
    channels.push_back({member_of(channel), &channel});
  }
  if (!channels.empty()) split = split_vertices(split.mesh, pointers);
  const PolygonMesh& floats = split.mesh;
  const std::uint64_t vertex_bytes = kGlbRecordBytes * floats.points.size();
  const std::uint64_t corner_bytes = kGlbRecordBytes * floats.face_count();
  const std::uint64_t channel_bytes = bytes_of(channels, floats.points.size());
  const std::uint64_t data_bytes = vertex_bytes + corner_bytes + channel_bytes;
  const GlbOrder order = order_by_material(floats, attributes);
  const std::string document =
      glb_document(floats, attributes, channels, order, vertex_bytes, corner_bytes, channel_bytes);
  const std::uint64_t bytes = kGlbHeaderBytes + 2 * kGlbChunkBytes + document.size() + data_bytes;
  require_glb_size(bytes);
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
  put_channels(out, channels, split.corner_of_vertex);
  out.flush();
}

}  // namespace plumb
