#include "plumb/io/gltf_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/io/gltf_transform.h"
#include "plumb/io/gltf_triangles.h"
#include "plumb/io/json_text.h"
#include "plumb/io/text_cursor.h"
#include "plumb/io/with_place.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kItemsPerCheckpoint = 4096;
constexpr std::uint64_t kMostCount = std::uint64_t{1} << 53U;

/// Members of the JSON. What is wrong is told with where it is: "buffers[2]: ...".
class GltfDocument {
 public:
  GltfDocument(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
               Context& context)
      : container_(open_gltf(bytes, options.name)),
        loader_(loader),
        context_(context),
        charge_(context) {
    charge_.add(bytes_of_json_tree(container_.json), "the JSON");
    parse();
    if (!json_.is_object()) container_.fail(0, ErrorCode::Syntax, "expected an object");
    require_version();
  }
  /// Gives the memory of buffers back.
  ~GltfDocument() {
    for (const auto& [index, bytes] : loaded_) context_.release_memory(bytes.size());
  }
  GltfDocument(const GltfDocument&) = delete;
  GltfDocument& operator=(const GltfDocument&) = delete;

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
  void parse() {
    try {
      const std::string_view text = container_.json;
      const CheckpointSteps steps{text.data(), text.size(), &context_};
      using Text = SteppedText<CheckpointSteps>;
      json_ = Json::parse(Text{text.data(), steps}, Text{text.data() + text.size(), steps});
    } catch (const Json::parse_error& error) {
      container_.fail(error.byte == 0 ? 0 : error.byte - 1, ErrorCode::Syntax, "not JSON");
    } catch (const Json::exception&) {
      container_.fail(0, ErrorCode::NumberOutOfRange, "a number too large");
    }
  }

  /// Any JSON, GeoJSON say, is an empty document but for this.
  void require_version() const {
    const auto asset = json_.find("asset");
    const bool is_there = asset != json_.end() && asset->is_object() &&
                          asset->contains("version") && (*asset)["version"].is_string();
    if (is_there && (*asset)["version"].get_ref<const std::string&>().starts_with("2.")) return;
    fail(ErrorCode::UnknownFormat, "asset", "does not say version 2 of glTF");
  }

  std::string_view loaded(std::size_t index, const std::string& uri, const std::string& where) {
    if (const auto found = loaded_.find(index); found != loaded_.end()) return found->second;
    try {
      return loaded_.emplace(index, bytes_of_uri(uri, loader_, context_)).first->second;
    } catch (const Error& error) {
      if (!error.place().file.empty() || error.code() == ErrorCode::ResourceLimit) throw;
      fail(error.code(), where, error.message());
    }
  }

  GltfContainer container_;
  const GltfLoader& loader_;
  Context& context_;
  MemoryCharge charge_;  // of the JSON
  Json json_;
  std::map<std::size_t, std::string> loaded_;  // buffers
};

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
             Context& context)
      : in_(bytes, loader, options, context),
        triangles_(options.name, context),
        context_(context),
        charge_(context) {}

  MeshFile read() {
    check_extensions();
    find_roots();
    std::reverse(open_.begin(), open_.end());
    while (!open_.empty()) {
      const Placed top = open_.back();
      open_.pop_back();
      place(top);
    }
    MeshFile file = triangles_.take();
    if (file.mesh.face_count() == 0) {
      in_.fail(ErrorCode::CountMismatch, "meshes", "no triangles are placed");
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
      watch();
      const std::string text = name.is_string() ? name.get<std::string>() : "";
      bool is_harmless = false;
      for (const char* prefix : {"KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_"}) {
        is_harmless = is_harmless || text.starts_with(prefix);
      }
      if (is_harmless) continue;
      in_.fail(ErrorCode::UnknownFormat, "extensionsRequired",
               "cannot be read: " + plumb::quoted(text));
    }
  }

  /// For loops over what the document lists.
  void watch() const {
    if (++watched_ % kItemsPerCheckpoint == 0) context_.checkpoint("read", 0, 1);
  }

  void find_roots() {
    const std::size_t nodes = in_.list("nodes").size();
    is_placed_.resize(nodes);
    if (!in_.list("scenes").empty() || in_.json().contains("scene")) {
      const std::size_t scene = in_.count(in_.json(), "scene", 0, "the document");
      const std::string where = GltfDocument::entry("scenes", scene);
      for (const Json& node : in_.list(in_.item("scenes", scene), "nodes", where)) {
        watch();
        open(node, kGltfIdentity, where);
      }
      return;
    }
    std::vector<std::uint8_t> is_child(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
      watch();
      for (const Json& child :
           in_.list(in_.item("nodes", n), "children", GltfDocument::entry("nodes", n))) {
        watch();
        if (child.is_number_unsigned() && child.get<std::uint64_t>() < nodes) {
          is_child[child.get<std::size_t>()] = 1;
        }
      }
    }
    for (std::size_t n = 0; n < nodes; ++n) {
      watch();
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
    for (const Json& child : in_.list(node, "children", where)) {
      watch();
      open(child, here, where);
    }
    std::reverse(open_.begin() + first, open_.end());  // the last is placed next
    if (node.contains("skin")) triangles_.pass_over("skins");
    if (!node.contains("mesh")) return;
    const std::size_t mesh = in_.count(node, "mesh", {}, where);
    for (const GltfPrimitive& p : primitives_of(mesh))
      triangles_.add(p, here, place_of(mesh, p.number));
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

  static std::string place_of(std::size_t mesh, std::size_t primitive) {
    return GltfDocument::entry("meshes", mesh) + '.' + GltfDocument::entry("primitives", primitive);
  }

  /// Listed once, however many nodes place the mesh.
  const std::vector<GltfPrimitive>& primitives_of(std::size_t mesh) {
    const auto [at, is_new] = primitives_.try_emplace(mesh);
    if (!is_new) return at->second;
    const Json& listed =
        in_.list(in_.item("meshes", mesh), "primitives", GltfDocument::entry("meshes", mesh));
    for (std::size_t p = 0; p < listed.size(); ++p) {
      watch();
      const std::string where = place_of(mesh, p);
      if (!listed[p].is_object()) in_.fail(ErrorCode::Syntax, where, "no object");
      const std::optional<GltfPrimitive> primitive = primitive_of(listed[p], p, where);
      if (!primitive) continue;
      charge_.add(2 * sizeof(GltfPrimitive), "parts of meshes");
      at->second.push_back(*primitive);
    }
    return at->second;
  }

  /// None if it has no triangles.
  std::optional<GltfPrimitive> primitive_of(const Json& primitive, std::size_t number,
                                            const std::string& where) {
    const std::size_t mode = in_.count(primitive, "mode", GltfMode::kTriangles, where);
    if (primitive.contains("targets")) triangles_.pass_over("morph targets");
    if (mode != GltfMode::kTriangles && mode != GltfMode::kStrip && mode != GltfMode::kFan) {
      if (mode > GltfMode::kFan) in_.fail(ErrorCode::Syntax, where, "no such mode");
      triangles_.pass_over("lines and points");
      return {};
    }
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object() ||
        !attributes->contains("POSITION")) {
      return {};  // as glTF has it: nothing to draw
    }
    GltfPrimitive p{number, mode, {}, {}};
    p.positions =
        elements(in_.count(*attributes, "POSITION", {}, where), "VEC3", 3, {GltfComponent::kFloat});
    if (primitive.contains("indices")) {
      p.indices = elements(in_.count(primitive, "indices", {}, where), "SCALAR", 1,
                           {GltfComponent::kByte, GltfComponent::kShort, GltfComponent::kInteger});
    }
    const std::size_t count = p.corner_count();
    if (mode == GltfMode::kTriangles && count % 3 != 0) {
      in_.fail(ErrorCode::CountMismatch, where, std::to_string(count) + " corners of triangles");
    }
    if (count < 3) return {};
    return p;
  }

  // ---------------------------------------------------------------- accessors

  /// All of its bytes are there.
  GltfElements elements(std::size_t accessor, const char* type, std::size_t parts,
                        std::initializer_list<std::size_t> components) {
    const std::string where = GltfDocument::entry("accessors", accessor);
    const Json& object = in_.item("accessors", accessor);
    if (object.contains("sparse")) {
      in_.fail(ErrorCode::UnknownFormat, where, "sparse accessors are not read");
    }
    if (!object.contains("type") || object["type"] != type) {
      in_.fail(ErrorCode::Syntax, where, std::string("type is not ") + type);
    }
    GltfElements e;
    e.component = in_.count(object, "componentType", {}, where);
    if (std::find(components.begin(), components.end(), e.component) == components.end()) {
      in_.fail(ErrorCode::UnknownFormat, where,
               "componentType " + std::to_string(e.component) + " is not read here");
    }
    e.count = in_.count(object, "count", {}, where);
    const std::size_t offset = in_.count(object, "byteOffset", 0, where);
    const std::size_t bytes =
        parts * (e.component == GltfComponent::kByte
                     ? 1
                     : (e.component == GltfComponent::kShort ? 2 : std::size_t{4}));
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
  GltfTriangles triangles_;
  Context& context_;
  MemoryCharge charge_;  // of lists of primitives
  mutable std::size_t watched_ = 0;
  std::vector<Placed> open_;
  std::vector<std::uint8_t> is_placed_;                           // per node
  std::map<std::size_t, std::vector<GltfPrimitive>> primitives_;  // per mesh that is placed
};

}  // namespace

MeshFile read_gltf(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
                   Context& context) {
  const RoundToNearest rounding;
  return with_place(WholeFile{options.name},
                    [&] { return GltfReader(bytes, loader, options, context).read(); });
}

}  // namespace plumb
