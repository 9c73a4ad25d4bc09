// Scenes as binary glTF 2.0.
//
// Buffers are appended to one chunk, each with a view and an accessor; every paint becomes a mesh
// with a material, and every group of patches a mesh of its own, so viewers can select it.
// Positions are floats in scene coordinates; the node carries the transform to the coordinates of
// the set, if floats can hold it, and turns z up to y up, as glTF has it. Colours are converted
// from sRGB to linear light. Format: glTF 2.0 Specification (Khronos Group).
// Tested by tests/picture/space_scene_test.cpp.
#include "plumb/picture/scene_glb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <unordered_map>
#include <utility>

#include "plumb/io/mesh/glb.h"
#include "plumb/io/text/byte_order.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsigned = 5125;      // The values of componentType.
constexpr int kVertices = 34962, kIndices = 34963;  // The values of target.
constexpr int kTriangles = 4, kLines = 1;           // The values of mode.

template <class Number>
void append(std::string& bytes, Number value) {
  const auto raw = to_bytes(value, std::endian::little);
  bytes.append(raw.data(), raw.size());
}

/// Returns a channel of sRGB in linear light, as glTF requires.
double linear(std::uint8_t channel) {
  const double c = channel / 255.;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

class GlbWriter {
 public:
  explicit GlbWriter(const Scene& scene) : scene_(scene) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "plumb"}};
    primitives_ = Json::array();
    for (const char* list : {"bufferViews", "accessors", "materials"}) json_[list] = Json::array();
  }

  void write(std::ostream& out, const std::string& title) {
    if (scene_.groups.empty()) {
      for (std::size_t i = 0; i < kPaints; ++i) add_triangles(static_cast<Paint>(i));
    } else {
      add_groups();
    }
    for (std::size_t i = 0; i < kPaints; ++i) add_lines(static_cast<Paint>(i));
    if (!primitives_.empty()) end_mesh(title);
    finish(title);
    const auto padded = [](std::string bytes, char pad) {
      bytes.resize((bytes.size() + 3) / 4 * 4, pad);
      return bytes;
    };
    const std::string text = padded(json_.dump(-1, ' ', true, Json::error_handler_t::replace), ' ');
    const std::string data = padded(bytes_, '\0');
    const std::size_t data_size = data.empty() ? 0 : 8 + data.size();
    const std::uint64_t size = 12 + 8 + text.size() + data_size;
    require_glb_size(size);
    std::string head = "glTF";
    append(head, std::uint32_t{2});
    append(head, static_cast<std::uint32_t>(size));
    append(head, static_cast<std::uint32_t>(text.size()));
    out << head << "JSON" << text;
    if (data.empty()) return;
    std::string chunk;
    append(chunk, static_cast<std::uint32_t>(data.size()));
    out << chunk << std::string_view("BIN\0", 4) << data;
  }

 private:
  std::size_t add_view(const std::string& bytes, std::optional<int> target) {
    Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (target) view["target"] = *target;
    json_["bufferViews"].push_back(std::move(view));
    bytes_ += bytes;
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');  // Numbers begin at multiples of four.
    return json_["bufferViews"].size() - 1;
  }

  std::size_t add_accessor(const std::string& bytes, int target, Json accessor) {
    accessor["bufferView"] = add_view(bytes, target);
    json_["accessors"].push_back(std::move(accessor));
    return json_["accessors"].size() - 1;
  }

  std::size_t add_vectors(const std::vector<Point3>& vectors, bool has_bounds) {
    std::string bytes;
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const Point3& v : vectors) {
      const std::array<double, 3> parts{v.x, v.y, v.z};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto part = static_cast<float>(parts[i]);
        append(bytes, part);
        low[i] = std::min(low[i], part);
        high[i] = std::max(high[i], part);
      }
    }
    Json accessor = {{"componentType", kFloat}, {"count", vectors.size()}, {"type", "VEC3"}};
    if (has_bounds) {
      accessor["min"] = low;
      accessor["max"] = high;
    }
    return add_accessor(bytes, kVertices, std::move(accessor));
  }

  std::size_t add_indices(const std::vector<std::uint32_t>& indices) {
    std::string bytes;
    for (const std::uint32_t i : indices) append(bytes, i);
    return add_accessor(
        bytes, kIndices,
        {{"componentType", kUnsigned}, {"count", indices.size()}, {"type", "SCALAR"}});
  }

  std::size_t add_material(Paint paint, bool is_line) {
    return add_material(style_of(paint).colour, std::string(style_of(paint).name), is_line);
  }

  std::size_t add_material(Colour tint, const std::string& name, bool is_line) {
    Json colour = Json::array();
    for (const std::uint8_t c : tint) colour.push_back(linear(c));
    colour.push_back(1);
    Json material = {
        {"name", name},
        {"doubleSided", true},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", colour}, {"metallicFactor", 0}, {"roughnessFactor", 0.9}}}};
    if (is_line) material["extensions"]["KHR_materials_unlit"] = Json::object();
    json_["materials"].push_back(std::move(material));
    return json_["materials"].size() - 1;
  }

  /// Writes the images, each in a view of its own, and a texture for each of them.
  void add_textures() {
    if (scene_.textures.empty()) return;
    for (const TextureImage& image : scene_.textures) {
      json_["textures"].push_back({{"source", json_["textures"].size()}});
      json_["images"].push_back(
          {{"bufferView", add_view(image.bytes, {})}, {"mimeType", image.type}});
    }
  }

  void add_triangles(Paint paint) {
    if (paint == Paint::Cut) return;
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t t = 0; t < scene_.triangles.size(); ++t) {
      if (scene_.patches[scene_.triangles[t].patch].paint == paint) chosen.push_back(t);
    }
    if (!chosen.empty()) add_triangles(chosen, add_material(paint, false), false);
  }

  /// Writes a mesh for each group, with one material for each colour and texture.
  void add_groups() {
    add_textures();
    std::vector<std::vector<std::uint32_t>> chosen(scene_.groups.size());
    for (std::uint32_t t = 0; t < scene_.triangles.size(); ++t) {
      chosen[scene_.patches[scene_.triangles[t].patch].group].push_back(t);
    }
    std::map<std::pair<Colour, std::uint32_t>, std::size_t> materials;
    for (std::size_t g = 0; g < chosen.size(); ++g) {
      if (chosen[g].empty()) continue;
      const Scene::Patch& patch = scene_.patches[scene_.triangles[chosen[g].front()].patch];
      const Colour colour = scene_.colour_of(patch);
      const std::uint32_t texture =
          scene_.tinted() != nullptr ? scene_.groups[g].texture : Scene::kNoTexture;
      const bool has_texture = texture != Scene::kNoTexture;
      const auto [place, is_new] = materials.emplace(std::pair(colour, texture), 0);
      if (is_new) {
        place->second = add_material(colour, hex(colour), false);
        Json& material = json_["materials"].back();
        if (has_texture) material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = texture;
      }
      add_triangles(chosen[g], place->second, has_texture);
      end_mesh(scene_.groups[g].name);
    }
  }

  /// Writes a vertex for each patch and corner. The triangles of a patch with a texture have the
  /// same texture coordinates at a common corner.
  void add_triangles(const std::vector<std::uint32_t>& chosen, std::size_t material,
                     bool has_texture) {
    std::vector<Point3> points, normals;
    std::string texcoords;
    std::vector<std::uint32_t> indices;
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    for (const std::uint32_t triangle : chosen) {
      const Scene::Triangle& t = scene_.triangles[triangle];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t corner = t.corners[i];
        const auto next = static_cast<std::uint32_t>(points.size());
        const auto [place, is_new] = numbers.emplace(std::uint64_t{t.patch} << 32U | corner, next);
        if (is_new) {
          points.push_back(scene_.points[corner]);
          normals.push_back(scene_.patches[t.patch].normal);
          if (has_texture) {
            append(texcoords, scene_.texcoords[triangle][2 * i]);
            // In glTF, this axis points down.
            append(texcoords, 1 - scene_.texcoords[triangle][2 * i + 1]);
          }
        }
        indices.push_back(place->second);
      }
    }
    const std::size_t position = add_vectors(points, true), normal = add_vectors(normals, false);
    Json attributes = {{"POSITION", position}, {"NORMAL", normal}};
    if (has_texture) {
      attributes["TEXCOORD_0"] =
          add_accessor(texcoords, kVertices,
                       {{"componentType", kFloat}, {"count", points.size()}, {"type", "VEC2"}});
    }
    primitives_.push_back({{"mode", kTriangles},
                           {"attributes", std::move(attributes)},
                           {"indices", add_indices(indices)},
                           {"material", material}});
  }

  void add_lines(Paint paint) {
    std::vector<Point3> points;
    std::vector<std::uint32_t> indices;
    for (const Scene::Line& line : scene_.lines) {
      if (line.paint != paint || !scene_.is_shown(line)) continue;
      for (const std::uint32_t end : line.ends) {
        indices.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(scene_.points[end]);
      }
    }
    if (indices.empty()) return;
    has_lines_ = true;
    primitives_.push_back({{"mode", kLines},
                           {"attributes", {{"POSITION", add_vectors(points, true)}}},
                           {"indices", add_indices(indices)},
                           {"material", add_material(paint, true)}});
  }

  void end_mesh(const std::string& name) {
    Json mesh = named(name);
    mesh["primitives"] = std::exchange(primitives_, Json::array());
    meshes_.push_back(std::move(mesh));
  }

  /// Returns the transform of the node. Positions are floats in scene coordinates. The node
  /// transforms them to the coordinates of the set, if floats can hold these.
  Json node() const {
    const double scale = 4 * scene_.quarter_scale;
    const Point3& c = scene_.quarter_centre;
    const double most = 4 * std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
    const double turned = std::sqrt(.5);
    // The axis z points up, and becomes the axis y.
    Json node = {{"rotation", {-turned, 0, 0, turned}}};
    if (scale > 1e-30 && scale < 1e30 && most < 1e30) {
      node["scale"] = {scale, scale, scale};
      node["translation"] = {4 * c.x, 4 * c.z, -4 * c.y};
    }
    return node;
  }

  /// Returns one node if there is one mesh. If there are several meshes, returns a node for each of
  /// them below a common node.
  Json nodes(const std::string& title) const {
    Json root = node();
    if (meshes_.size() == 1) {
      root["mesh"] = 0;
      return Json::array({std::move(root)});
    }
    root["name"] = title;
    Json list = Json::array({Json::object()});
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      root["children"].push_back(i + 1);
      list.push_back({{"name", meshes_[i]["name"]}, {"mesh", i}});
    }
    list[0] = std::move(root);
    return list;
  }

  static Json named(const std::string& title) {
    Json item = Json::object();
    item["name"] = title;
    return item;
  }

  void finish(const std::string& title) {
    json_["scene"] = 0;
    if (has_lines_) json_["extensionsUsed"] = Json::array({"KHR_materials_unlit"});
    if (meshes_.empty()) {  // In glTF, lists must not be empty.
      for (const char* list : {"bufferViews", "accessors", "materials"}) json_.erase(list);
      json_["nodes"] = Json::array({named(title)});
    } else {
      json_["nodes"] = nodes(title);
      json_["meshes"] = std::move(meshes_);
      Json buffer = Json::object();
      buffer["byteLength"] = bytes_.size();
      json_["buffers"] = Json::array({std::move(buffer)});
    }
    Json scene = Json::object();
    scene["nodes"] = Json::array({0});
    json_["scenes"] = Json::array({std::move(scene)});
  }

  const Scene& scene_;
  Json json_;
  Json primitives_;
  Json meshes_ = Json::array();
  std::string bytes_;
  bool has_lines_ = false;
};

}  // namespace

void write_scene_glb(std::ostream& out, const Scene& scene, const std::string& title) {
  GlbWriter(scene).write(out, title);
}

}  // namespace plumb
