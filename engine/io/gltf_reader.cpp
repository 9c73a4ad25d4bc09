#include "plumb/io/gltf_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/io/gltf_transform.h"
#include "plumb/io/mesh_collector.h"
#include "plumb/io/weld_vertices.h"
#include "plumb/io/with_place.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

constexpr std::size_t kFloat = 5126, kByte = 5121, kShort = 5123, kInteger = 5125;
constexpr std::size_t kTriangles = 4, kStrip = 5, kFan = 6;
constexpr std::uint64_t kBytesPerByte = 48;  // of JSON in memory: "{}," is the worst
constexpr std::uint64_t kMostCount = std::uint64_t{1} << 53U;
constexpr std::size_t kItemsPerCheckpoint = 4096;
constexpr std::uint64_t kMostVertices = 0xffff'0000;

/// Members of the JSON. What is wrong is told with where it is: "buffers[2]: ...".
class GltfDocument {
 public:
  GltfDocument(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
               Context& context)
      : container_(open_gltf(bytes, options.name)), loader_(loader), context_(context) {
    try {
      context.charge_memory(kBytesPerByte * container_.json.size(), "the JSON");
      json_ = Json::parse(container_.json);
    } catch (const Json::parse_error& error) {
      container_.fail(error.byte == 0 ? 0 : error.byte - 1, ErrorCode::Syntax, "not JSON");
    } catch (const Json::exception&) {
      container_.fail(0, ErrorCode::NumberOutOfRange, "a number too large");
    }
    if (!json_.is_object()) container_.fail(0, ErrorCode::Syntax, "expected an object");
  }

  const Json& json() const { return json_; }

  [[noreturn]] void fail(ErrorCode code, const std::string& where, const std::string& what) const {
    throw Error(code, where + ": " + what, {container_.name});
  }

  /// The list that a member is; empty where it is missing.
  const Json& list(const Json& object, const char* member, const std::string& where) const {
    static const Json kEmpty = Json::array();
    const auto found = object.find(member);
    if (found == object.end()) return kEmpty;
    if (!found->is_array()) fail(ErrorCode::Syntax, where, std::string(member) + " is no list");
    return *found;
  }
  const Json& list(const char* member) const { return list(json_, member, "the document"); }

  /// An entry of a list of the document: an object.
  const Json& item(const char* list_name, std::size_t index) const {
    const Json& all = list(list_name);
    if (index >= all.size()) fail(ErrorCode::BadIndex, entry(list_name, index), "there is none");
    if (!all[index].is_object()) fail(ErrorCode::Syntax, entry(list_name, index), "no object");
    return all[index];
  }

  /// A whole number that a size can be; `otherwise` where the member is missing, an error if there is none.
  std::size_t count(const Json& object, const char* member, std::optional<std::size_t> otherwise,
                    const std::string& where) const {
    const auto found = object.find(member);
    if (found == object.end()) {
      if (!otherwise) fail(ErrorCode::Syntax, where, std::string("needs ") + member);
      return *otherwise;
    }
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > kMostCount) {
      fail(ErrorCode::Syntax, where, std::string(member) + " is no count");
    }
    return static_cast<std::size_t>(found->get<std::uint64_t>());
  }

  /// As many numbers as `otherwise`, which they are where the member is missing.
  template <std::size_t N>
  std::array<double, N> numbers(const Json& object, const char* member,
                                std::array<double, N> otherwise, const std::string& where) const {
    if (!object.contains(member)) return otherwise;
    const Json& all = list(object, member, where);
    if (all.size() != N) {
      fail(ErrorCode::CountMismatch, where,
           std::string(member) + " has not " + std::to_string(N) + " numbers");
    }
    for (std::size_t i = 0; i < N; ++i) {
      if (!all[i].is_number()) fail(ErrorCode::Syntax, where, std::string(member) + ": no number");
      otherwise[i] = all[i].template get<double>();
    }
    return otherwise;
  }

  /// As many bytes as the buffer says. Files are read when they are first asked for.
  std::string_view buffer(std::size_t index) {
    const Json& object = item("buffers", index);
    const std::string where = entry("buffers", index);
    const std::size_t length = count(object, "byteLength", {}, where);
    const auto uri = object.find("uri");
    std::string_view bytes;
    if (uri == object.end()) {
      if (index != 0 || !container_.chunk) fail(ErrorCode::Syntax, where, "no bytes are there");
      bytes = *container_.chunk;
    } else {
      if (!uri->is_string()) fail(ErrorCode::Syntax, where, "uri is no text");
      bytes = loaded(index, uri->get_ref<const std::string&>(), where);
    }
    if (length > bytes.size()) {
      fail(ErrorCode::CountMismatch, where,
           std::to_string(length) + " bytes are announced, " + std::to_string(bytes.size()) +
               " are there");
    }
    return bytes.substr(0, length);
  }

  static std::string entry(const char* list, std::size_t index) {
    return std::string(list) + '[' + std::to_string(index) + ']';
  }

 private:
  std::string_view loaded(std::size_t index, const std::string& uri, const std::string& where) {
    if (const auto found = loaded_.find(index); found != loaded_.end()) return found->second;
    try {
      return loaded_.emplace(index, bytes_of_uri(uri, loader_, context_)).first->second;
    } catch (const Error& error) {
      if (!error.place().file.empty()) throw;
      fail(error.code(), where, error.message());
    }
  }

  GltfContainer container_;
  const GltfLoader& loader_;
  Context& context_;
  Json json_;
  std::map<std::size_t, std::string> loaded_;  // buffers
};

/// The parts of an accessor's elements, unchecked numbers.
struct Elements {
  std::string_view bytes;
  std::size_t stride = 0;
  std::size_t count = 0;
  std::size_t component = 0;

  template <class Number>
  Number at(std::size_t i, std::size_t part = 0) const {
    Number value;
    std::memcpy(&value, bytes.data() + i * stride + part * sizeof(Number), sizeof(Number));
    return value;
  }
  std::uint32_t index(std::size_t i) const {
    if (component == kByte) return at<std::uint8_t>(i);
    return component == kShort ? at<std::uint16_t>(i) : at<std::uint32_t>(i);
  }
};

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
             Context& context)
      : in_(bytes, loader, options, context), mesh_(context), context_(context) {}

  MeshFile read() {
    check_extensions();
    find_roots();
    std::reverse(open_.begin(), open_.end());
    while (!open_.empty()) {
      const Placed top = open_.back();
      open_.pop_back();
      place(top);
    }
    MeshFile file = mesh_.take();
    dropped_ += weld_vertices(file.mesh, context_);
    if (dropped_ > 0) {
      file.notes.push_back(std::to_string(dropped_) + (dropped_ == 1 ? " triangle" : " triangles") +
                           " with two equal corners left out");
    }
    return file;
  }

 private:
  struct Placed {
    std::size_t node;
    GltfTransform above;
  };

  // ---------------------------------------------------------------- nodes

  /// What changes colours only may be required.
  void check_extensions() const {
    for (const Json& name : in_.list("extensionsRequired")) {
      const std::string text = name.is_string() ? name.get<std::string>() : "";
      bool is_harmless = false;
      for (const char* prefix : {"KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_"}) {
        is_harmless = is_harmless || text.starts_with(prefix);
      }
      if (is_harmless) continue;
      in_.fail(ErrorCode::UnknownFormat, "extensionsRequired", "cannot be read: " + text);
    }
  }

  void find_roots() {
    const std::size_t nodes = in_.list("nodes").size();
    is_placed_.resize(nodes);
    if (!in_.list("scenes").empty() || in_.json().contains("scene")) {
      const std::size_t scene = in_.count(in_.json(), "scene", 0, "the document");
      const std::string where = GltfDocument::entry("scenes", scene);
      for (const Json& node : in_.list(in_.item("scenes", scene), "nodes", where)) {
        open(node, kGltfIdentity, where);
      }
      return;
    }
    std::vector<std::uint8_t> is_child(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
      for (const Json& child :
           in_.list(in_.item("nodes", n), "children", GltfDocument::entry("nodes", n))) {
        if (child.is_number_unsigned() && child.get<std::uint64_t>() < nodes) {
          is_child[child.get<std::size_t>()] = 1;
        }
      }
    }
    for (std::size_t n = 0; n < nodes; ++n) {
      if (is_child[n] == 0) open(n, kGltfIdentity, "nodes");
    }
  }

  void open(const Json& node, const GltfTransform& above, const std::string& where) {
    if (!node.is_number_unsigned() || node.get<std::uint64_t>() >= is_placed_.size()) {
      in_.fail(ErrorCode::BadIndex, where, "a node that there is not");
    }
    const auto index = node.get<std::size_t>();
    if (std::exchange(is_placed_[index], std::uint8_t{1}) != 0) {
      in_.fail(ErrorCode::BadShape, GltfDocument::entry("nodes", index), "hangs in two places");
    }
    open_.push_back({index, above});
  }

  void place(const Placed& top) {
    const std::string where = GltfDocument::entry("nodes", top.node);
    context_.checkpoint("read", 0, 1);
    const Json& node = in_.item("nodes", top.node);
    const GltfTransform here = product(top.above, transform_of(node, where));
    const auto first = static_cast<std::ptrdiff_t>(open_.size());
    for (const Json& child : in_.list(node, "children", where)) open(child, here, where);
    std::reverse(open_.begin() + first, open_.end());  // the last is placed next
    if (node.contains("skin")) mesh_.pass_over("skins");
    if (!node.contains("mesh")) return;
    const std::size_t mesh = in_.count(node, "mesh", {}, where);
    const std::string name = GltfDocument::entry("meshes", mesh);
    const Json& primitives = in_.list(in_.item("meshes", mesh), "primitives", name);
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const std::string part = name + ".primitives[" + std::to_string(p) + ']';
      if (!primitives[p].is_object()) in_.fail(ErrorCode::Syntax, part, "no object");
      add_primitive(primitives[p], here, part);
    }
  }

  GltfTransform transform_of(const Json& node, const std::string& where) const {
    if (node.contains("matrix")) {
      return from_matrix(in_.numbers<16>(node, "matrix", {}, where));
    }
    const auto turn = in_.numbers<4>(node, "rotation", {0, 0, 0, 1}, where);
    if (turn == std::array<double, 4>{}) in_.fail(ErrorCode::BadShape, where, "no rotation");
    return from_parts(turn, in_.numbers<3>(node, "scale", {1, 1, 1}, where),
                      in_.numbers<3>(node, "translation", {0, 0, 0}, where));
  }

  // ---------------------------------------------------------------- triangles

  void add_primitive(const Json& primitive, const GltfTransform& here, const std::string& where) {
    const std::size_t mode = in_.count(primitive, "mode", kTriangles, where);
    if (primitive.contains("targets")) mesh_.pass_over("morph targets");
    if (mode != kTriangles && mode != kStrip && mode != kFan) {
      if (mode > kFan) in_.fail(ErrorCode::Syntax, where, "no such mode");
      mesh_.pass_over("lines and points");
      return;
    }
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object() ||
        !attributes->contains("POSITION")) {
      return;  // as glTF has it: nothing to draw
    }
    const Elements positions =
        elements(in_.count(*attributes, "POSITION", {}, where), "VEC3", 3, {kFloat});
    const std::uint64_t first = add_points(positions, here, where);
    std::optional<Elements> indices;
    if (primitive.contains("indices")) {
      indices = elements(in_.count(primitive, "indices", {}, where), "SCALAR", 1,
                         {kByte, kShort, kInteger});
    }
    const std::size_t count = indices ? indices->count : positions.count;
    if (mode == kTriangles && count % 3 != 0) {
      in_.fail(ErrorCode::CountMismatch, where, std::to_string(count) + " corners of triangles");
    }
    const auto corner = [&](std::size_t i) {
      const std::size_t index = indices ? indices->index(i) : i;
      if (index < positions.count) return static_cast<std::uint32_t>(first + index);
      in_.fail(ErrorCode::BadIndex, where, "no vertex " + std::to_string(index));
    };
    const bool turns = mirrors(here);
    const std::size_t step = mode == kTriangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < count; i += step) {
      if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, count);
      const std::uint32_t a = corner(mode == kFan ? 0 : i);
      const std::uint32_t b = corner(i + 1), c = corner(i + 2);
      add_triangle(a, b, c, turns != (mode == kStrip && i % 2 == 1));
    }
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turns) {
    for (const std::uint32_t v : {a, turns ? c : b, turns ? b : c}) mesh_.add_corner(v);
    if (!mesh_.end_face().empty()) ++dropped_;
  }

  std::uint64_t add_points(const Elements& positions, const GltfTransform& m,
                           const std::string& where) {
    const std::uint64_t first = mesh_.point_count();
    if (positions.count > kMostVertices - first) {
      in_.fail(ErrorCode::ResourceLimit, where, "more than 2^32 vertices");
    }
    const bool moves = m != kGltfIdentity;
    for (std::size_t i = 0; i < positions.count; ++i) {
      if (i % kItemsPerCheckpoint == 0) context_.checkpoint("read", i, positions.count);
      std::array<double, 3> p{};
      for (std::size_t k = 0; k < 3; ++k) p[k] = positions.at<float>(i, k);
      const std::array<double, 3> q = moves ? applied(m, p) : p;
      if (!std::isfinite(q[0]) || !std::isfinite(q[1]) || !std::isfinite(q[2])) {
        in_.fail(ErrorCode::NumberOutOfRange, where,
                 "vertex " + std::to_string(i) + " has a coordinate that is not finite");
      }
      mesh_.add_point({q[0], q[1], q[2]});
    }
    return first;
  }

  // ---------------------------------------------------------------- accessors

  /// All of its bytes are there.
  Elements elements(std::size_t accessor, const char* type, std::size_t parts,
                    std::initializer_list<std::size_t> components) {
    const std::string where = GltfDocument::entry("accessors", accessor);
    const Json& object = in_.item("accessors", accessor);
    if (object.contains("sparse")) {
      in_.fail(ErrorCode::UnknownFormat, where, "sparse accessors are not read");
    }
    if (!object.contains("type") || object["type"] != type) {
      in_.fail(ErrorCode::Syntax, where, std::string("type is not ") + type);
    }
    Elements e;
    e.component = in_.count(object, "componentType", {}, where);
    if (std::find(components.begin(), components.end(), e.component) == components.end()) {
      in_.fail(ErrorCode::UnknownFormat, where,
               "componentType " + std::to_string(e.component) + " is not read here");
    }
    e.count = in_.count(object, "count", {}, where);
    const std::size_t offset = in_.count(object, "byteOffset", 0, where);
    const std::size_t bytes =
        parts * (e.component == kByte ? 1 : (e.component == kShort ? 2 : std::size_t{4}));
    const std::size_t view = in_.count(object, "bufferView", {}, where);
    const auto [data, stride] = view_bytes(view);
    e.stride = stride == 0 ? bytes : stride;
    if (e.stride < bytes) in_.fail(ErrorCode::Syntax, where, "byteStride is less than an element");
    const bool fits = e.count == 0 || (offset <= data.size() && bytes <= data.size() - offset &&
                                       e.count - 1 <= (data.size() - offset - bytes) / e.stride);
    if (!fits) {
      in_.fail(ErrorCode::CountMismatch, where,
               std::to_string(e.count) + " elements are not in its bufferView");
    }
    if (e.count > 0) e.bytes = data.substr(offset);
    return e;
  }

  /// And its stride, 0 if it says none.
  std::pair<std::string_view, std::size_t> view_bytes(std::size_t view) {
    const std::string where = GltfDocument::entry("bufferViews", view);
    const Json& object = in_.item("bufferViews", view);
    const std::string_view buffer = in_.buffer(in_.count(object, "buffer", {}, where));
    const std::size_t offset = in_.count(object, "byteOffset", 0, where);
    const std::size_t length = in_.count(object, "byteLength", {}, where);
    if (offset > buffer.size() || length > buffer.size() - offset) {
      in_.fail(ErrorCode::CountMismatch, where, "is longer than its buffer");
    }
    return {buffer.substr(offset, length), in_.count(object, "byteStride", 0, where)};
  }

  GltfDocument in_;
  MeshCollector mesh_;
  Context& context_;
  std::vector<Placed> open_;
  std::vector<std::uint8_t> is_placed_;  // per node
  std::size_t dropped_ = 0;
};

}  // namespace

MeshFile read_gltf(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
                   Context& context) {
  const RoundToNearest rounding;
  return with_place(WholeFile{options.name},
                    [&] { return GltfReader(bytes, loader, options, context).read(); });
}

}  // namespace plumb
