// Reading of glTF 2.0 (Khronos Group, glTF 2.0 Specification; ISO/IEC 12113:2022).
//
// GltfDocument is a lazy view of the JSON: lists of entries, buffers, accessors and views are found
// on first use, kept, and charged to the context. Nodes are visited depth first with a stack of its
// own, so deep hierarchies cost no recursion; a transform is kept as long as a child still needs
// it. A node is placed once: a second placement means a cycle or a shared child, and is refused.
//
// Every number from the file is checked against what it is used for, such as offsets against
// buffers and indices against counts, before any byte is read by it. What is wrong is reported with
// its place in the document.
// Tested by tests/io/gltf_test.cpp.
#include "plumb/io/mesh/gltf.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/mesh/gltf_parts.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

using Id = JsonValues::Id;

constexpr std::uint64_t kMostCount = std::uint64_t{1} << 53U;

/// Members of the JSON. Errors say where they are: "buffers[2]: ...".
class GltfDocument {
 public:
  GltfDocument(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
               Context& context)
      : container_(open_gltf(bytes, options.name)),
        loader_(loader),
        context_(context),
        charge_(context),
        json_(
            container_.json, options.name,
            [this](std::size_t byte, ErrorCode code, const std::string& what) {
              container_.fail(byte, code, what);
            },
            context) {
    if (!json_.is_object(kDocument)) container_.fail(0, ErrorCode::Syntax, "expected an object");
    require_version();
  }
  /// Releases the memory of buffers.
  ~GltfDocument() {
    for (const auto& [index, bytes] : loaded_) context_.release_memory(bytes.size());
  }
  GltfDocument(const GltfDocument&) = delete;
  GltfDocument& operator=(const GltfDocument&) = delete;

  static constexpr Id kDocument = JsonValues::kDocument;
  const JsonValues& json() const { return json_; }

  [[noreturn]] void fail(ErrorCode code, const std::string& where, const std::string& what) const {
    throw Error(code, where + ": " + what, {container_.name});
  }

  /// Whether the object has the member.
  bool has(Id object, const char* member) const { return json_.find(object, member).has_value(); }

  /// Returns the list that a member is; an empty one if it is missing.
  JsonValues::Items list(Id object, const char* member, const std::string& where) const {
    const auto found = json_.find(object, member);
    if (!found) return {&json_, 0, 0};
    if (!json_.is_list(*found)) {
      fail(ErrorCode::Syntax, where, std::string(member) + " is no list");
    }
    return json_.items(*found);
  }

  /// Returns the entries of a list of the document, for access by number.
  const std::vector<Id>& entries(const char* list_name) {
    const auto [at, is_new] = entries_.try_emplace(list_name);
    if (!is_new) return at->second;
    const JsonValues::Items all = list(kDocument, list_name, "the document");
    const std::size_t count = all.size();
    charge_.add(count * sizeof(Id), "the JSON");
    at->second.reserve(count);
    for (const Id each : all) at->second.push_back(each);
    return at->second;
  }

  /// Returns an entry of a list of the document. Throws unless it is an object.
  Id item(const char* list_name, std::size_t index) {
    const std::vector<Id>& all = entries(list_name);
    if (index >= all.size()) fail(ErrorCode::BadIndex, entry(list_name, index), "there is none");
    if (!json_.is_object(all[index])) {
      fail(ErrorCode::Syntax, entry(list_name, index), "no object");
    }
    return all[index];
  }

  /// Returns a member that is a whole number and fits a size. A missing member counts as
  /// `otherwise`; if there is none, that is an error.
  std::size_t count(Id object, const char* member, std::optional<std::size_t> otherwise,
                    const std::string& where) const {
    const auto found = json_.find(object, member);
    if (!found) {
      if (!otherwise) fail(ErrorCode::Syntax, where, std::string("needs ") + member);
      return *otherwise;
    }
    const auto count = json_.count(*found);
    if (!count || *count > kMostCount) {
      fail(ErrorCode::Syntax, where, std::string(member) + " is no count");
    }
    return static_cast<std::size_t>(*count);
  }

  /// Returns as many numbers as `otherwise` has, or `otherwise` if the member is missing.
  template <std::size_t N>
  std::array<double, N> numbers(Id object, const char* member, std::array<double, N> otherwise,
                                const std::string& where) const {
    if (!has(object, member)) return otherwise;
    const JsonValues::Items all = list(object, member, where);
    if (all.size() != N) {
      fail(ErrorCode::CountMismatch, where,
           std::string(member) + " has not " + std::to_string(N) + " numbers");
    }
    std::size_t i = 0;
    for (const Id each : all) {
      if (!json_.is_number(each)) {
        fail(ErrorCode::Syntax, where, std::string(member) + ": no number");
      }
      otherwise[i++] = json_.number(each);
    }
    return otherwise;
  }

  /// Returns as many bytes as the buffer says. Files are read on first use.
  std::string_view buffer(std::size_t index) {
    const auto [at, is_new] = buffers_.try_emplace(index);
    if (is_new) at->second = found_buffer(index);
    return at->second;
  }

  static std::string entry(const char* list, std::size_t index) {
    return std::string(list) + '[' + std::to_string(index) + ']';
  }

 private:
  std::string_view found_buffer(std::size_t index) {
    const Id object = item("buffers", index);
    const std::string where = entry("buffers", index);
    const std::size_t length = count(object, "byteLength", {}, where);
    const auto uri = json_.find(object, "uri");
    std::string_view bytes;
    if (!uri) {
      if (index != 0 || !container_.chunk) fail(ErrorCode::Syntax, where, "no bytes are there");
      bytes = *container_.chunk;
    } else {
      if (!json_.is_text(*uri)) fail(ErrorCode::Syntax, where, "uri is no text");
      bytes = loaded(index, *uri, where);
    }
    if (length > bytes.size()) {
      fail(ErrorCode::CountMismatch, where,
           std::to_string(length) + " bytes are announced, " + std::to_string(bytes.size()) +
               " are there");
    }
    return bytes.substr(0, length);
  }

  /// Requires version 2. Any other JSON, such as GeoJSON, would otherwise be an empty document.
  void require_version() const {
    const auto asset = json_.find(kDocument, "asset");
    const auto version =
        asset && json_.is_object(*asset) ? json_.find(*asset, "version") : std::nullopt;
    if (version && json_.is_text(*version) && json_.text(*version).starts_with("2.")) return;
    fail(ErrorCode::UnknownFormat, "asset", "does not say version 2 of glTF");
  }

  std::string_view loaded(std::size_t index, Id uri, const std::string& where) {
    try {
      const auto plain = json_.plain_text(uri);
      std::string bytes = plain ? bytes_of_uri(*plain, loader_, context_)
                                : bytes_of_uri(json_.text(uri), loader_, context_);
      return loaded_.emplace(index, std::move(bytes)).first->second;
    } catch (const Error& error) {
      if (!error.place().file.empty() || error.code() == ErrorCode::ResourceLimit) throw;
      fail(error.code(), where, error.message());
    }
  }

  GltfContainer container_;
  const GltfLoader& loader_;
  Context& context_;
  MemoryCharge charge_;  // Of lists of entries.
  JsonValues json_;
  std::map<std::string_view, std::vector<Id>> entries_;  // Per list that was used.
  std::map<std::size_t, std::string> loaded_;            // Buffers that are no chunk.
  std::map<std::size_t, std::string_view> buffers_;
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
    above_.push_back(kGltfIdentity);
    find_roots();
    end_children(0);
    while (!open_.empty()) {
      const Placed top = open_.back();
      open_.pop_back();
      const GltfTransform above = above_.back();
      if (top.is_last) above_.pop_back();
      place(top.node, above);
    }
    MeshFile file = triangles_.take();
    if (file.mesh.face_count() == 0) {
      in_.fail(ErrorCode::CountMismatch, "meshes", "no triangles are placed");
    }
    return file;
  }

 private:
  static constexpr Id kDocument = GltfDocument::kDocument;

  /// A node that is to be placed by the topmost transform of above_. That transform is dropped
  /// after the last of its nodes.
  struct Placed {
    std::uint32_t node;
    bool is_last;
  };

  /// The members of an accessor.
  struct Accessor {
    std::string type;
    std::size_t component, count, offset, view;
  };

  // ---------------------------------------------------------------- nodes

  /// Accepts required extensions that change colours only.
  void check_extensions() const {
    for (const Id name : in_.list(kDocument, "extensionsRequired", "the document")) {
      watch();
      const std::string text = in_.json().is_text(name) ? in_.json().text(name) : "";
      bool is_harmless = false;
      for (const char* prefix : {"KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_"}) {
        is_harmless = is_harmless || text.starts_with(prefix);
      }
      if (is_harmless) continue;
      in_.fail(ErrorCode::UnknownFormat, "extensionsRequired",
               "cannot be read: " + plumb::quoted(text));
    }
  }

  /// Counts steps of loops over what the document lists; asks the context now and then.
  void watch() const {
    if (++watched_ % kItemsPerCheckpoint == 0) context_.checkpoint("read", 0, 1);
  }

  void find_roots() {
    const std::size_t nodes = in_.entries("nodes").size();
    charge_.add((2 + sizeof(Placed)) * nodes, "nodes");
    is_placed_.resize(nodes);
    open_.reserve(nodes);
    if (!in_.entries("scenes").empty() || in_.has(kDocument, "scene")) {
      const std::size_t scene = in_.count(kDocument, "scene", 0, "the document");
      const std::string where = GltfDocument::entry("scenes", scene);
      open_all(in_.list(in_.item("scenes", scene), "nodes", where), where);
      return;
    }
    std::vector<std::uint8_t> is_child(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
      watch();
      for (const Id child :
           in_.list(in_.item("nodes", n), "children", GltfDocument::entry("nodes", n))) {
        watch();
        const auto index = in_.json().count(child);
        if (index && *index < nodes) is_child[*index] = 1;
      }
    }
    for (std::size_t n = 0; n < nodes; ++n) {
      watch();
      if (is_child[n] == 0) open(n);
    }
  }

  void open_all(const JsonValues::Items& nodes, const std::string& where) {
    for (const Id node : nodes) {
      watch();
      const auto index = in_.json().count(node);
      if (!index || *index >= is_placed_.size()) {
        in_.fail(ErrorCode::BadIndex, where, "a node that there is not");
      }
      open(*index);
    }
  }

  void open(std::size_t node) {
    if (std::exchange(is_placed_[node], std::uint8_t{1}) != 0) {
      in_.fail(ErrorCode::BadShape, GltfDocument::entry("nodes", node), "hangs in two places");
    }
    open_.push_back({static_cast<std::uint32_t>(node), false});
  }

  /// Ends the children opened since there were `first`. They are taken from the end. If there are
  /// none, their transform is dropped at once.
  void end_children(std::size_t first) {
    if (open_.size() == first) {
      above_.pop_back();
      return;
    }
    std::reverse(open_.begin() + static_cast<std::ptrdiff_t>(first), open_.end());
    open_[first].is_last = true;
  }

  void place(std::size_t index, const GltfTransform& above) {
    const std::string where = GltfDocument::entry("nodes", index);
    context_.checkpoint("read", 0, 1);
    const Id node = in_.item("nodes", index);
    const GltfTransform here = product(above, transform_of(node, where));
    const std::size_t first = open_.size();
    above_.push_back(here);
    open_all(in_.list(node, "children", where), where);
    end_children(first);
    if (in_.has(node, "skin")) triangles_.pass_over("skins");
    if (!in_.has(node, "mesh")) return;
    const std::size_t mesh = in_.count(node, "mesh", {}, where);
    for (const GltfPrimitive& p : primitives_of(mesh))
      triangles_.add(p, here, place_of(mesh, p.number));
  }

  GltfTransform transform_of(Id node, const std::string& where) const {
    if (in_.has(node, "matrix")) {
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

  /// Returns the primitives of a mesh, listed once, however many nodes place it.
  const std::vector<GltfPrimitive>& primitives_of(std::size_t mesh) {
    const auto [at, is_new] = primitives_.try_emplace(mesh);
    if (!is_new) return at->second;
    const JsonValues::Items listed =
        in_.list(in_.item("meshes", mesh), "primitives", GltfDocument::entry("meshes", mesh));
    const std::size_t count = listed.size();
    charge_.add(count * sizeof(GltfPrimitive), "parts of meshes");
    at->second.reserve(count);
    std::size_t p = 0;
    for (const Id each : listed) {
      watch();
      const std::string where = place_of(mesh, p);
      if (!in_.json().is_object(each)) in_.fail(ErrorCode::Syntax, where, "no object");
      const std::optional<GltfPrimitive> primitive = primitive_of(each, p++, where);
      if (primitive) at->second.push_back(*primitive);
    }
    return at->second;
  }

  /// Returns a primitive, or no value if it has no triangles.
  std::optional<GltfPrimitive> primitive_of(Id primitive, std::size_t number,
                                            const std::string& where) {
    const std::size_t mode = in_.count(primitive, "mode", GltfMode::kTriangles, where);
    if (in_.has(primitive, "targets")) triangles_.pass_over("morph targets");
    if (mode != GltfMode::kTriangles && mode != GltfMode::kStrip && mode != GltfMode::kFan) {
      if (mode > GltfMode::kFan) in_.fail(ErrorCode::Syntax, where, "no such mode");
      triangles_.pass_over("lines and points");
      return {};
    }
    const auto attributes = in_.json().find(primitive, "attributes");
    if (!attributes || !in_.json().is_object(*attributes) || !in_.has(*attributes, "POSITION")) {
      return {};  // glTF says that there is nothing to draw.
    }
    GltfPrimitive p{number, mode, {}, {}};
    p.positions =
        elements(in_.count(*attributes, "POSITION", {}, where), "VEC3", 3, {GltfComponent::kFloat});
    if (in_.has(primitive, "indices")) {
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

  /// Returns the elements of an accessor, all of whose bytes exist.
  GltfElements elements(std::size_t accessor, const char* type, std::size_t parts,
                        std::initializer_list<std::size_t> components) {
    const std::string where = GltfDocument::entry("accessors", accessor);
    const Accessor& a = accessor_of(accessor, where);
    if (a.type != type) in_.fail(ErrorCode::Syntax, where, std::string("type is not ") + type);
    GltfElements e;
    e.component = a.component;
    if (std::find(components.begin(), components.end(), e.component) == components.end()) {
      in_.fail(ErrorCode::UnknownFormat, where,
               "componentType " + std::to_string(e.component) + " is not read here");
    }
    e.count = a.count;
    const std::size_t offset = a.offset;
    const std::size_t bytes =
        parts * (e.component == GltfComponent::kByte
                     ? 1
                     : (e.component == GltfComponent::kShort ? 2 : std::size_t{4}));
    const auto [data, stride] = view_bytes(a.view);
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

  /// Returns an accessor, read once, however many primitives name it.
  const Accessor& accessor_of(std::size_t accessor, const std::string& where) {
    if (const auto known = accessors_.find(accessor); known != accessors_.end()) {
      return known->second;
    }
    const Id object = in_.item("accessors", accessor);
    if (in_.has(object, "sparse")) {
      in_.fail(ErrorCode::UnknownFormat, where, "sparse accessors are not read");
    }
    const auto type = in_.json().find(object, "type");
    Accessor a{};
    if (type && in_.json().is_text(*type)) a.type = in_.json().text(*type);
    a.component = in_.count(object, "componentType", {}, where);
    a.count = in_.count(object, "count", {}, where);
    a.offset = in_.count(object, "byteOffset", 0, where);
    a.view = in_.count(object, "bufferView", {}, where);
    charge_.add(sizeof(Accessor) + a.type.size(), "accessors");
    return accessors_.emplace(accessor, std::move(a)).first->second;
  }

  using ViewBytes = std::pair<std::string_view, std::size_t>;

  /// Returns the bytes of a view and its stride, which is 0 if it names none.
  const ViewBytes& view_bytes(std::size_t view) {
    const auto [at, is_new] = views_.try_emplace(view);
    if (is_new) {
      charge_.add(sizeof(ViewBytes), "views of buffers");
      at->second = found_view(view);
    }
    return at->second;
  }
  ViewBytes found_view(std::size_t view) {
    const std::string where = GltfDocument::entry("bufferViews", view);
    const Id object = in_.item("bufferViews", view);
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
  MemoryCharge charge_;  // Of lists of primitives.
  mutable std::size_t watched_ = 0;
  std::vector<Placed> open_;
  std::deque<GltfTransform> above_;                               // Of open nodes.
  std::vector<std::uint8_t> is_placed_;                           // Per node.
  std::map<std::size_t, std::vector<GltfPrimitive>> primitives_;  // Per mesh that is placed.
  std::map<std::size_t, Accessor> accessors_;                     // Accessors that are named.
  std::map<std::size_t, ViewBytes> views_;
};

}  // namespace

MeshFile read_gltf(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
                   Context& context) {
  const RoundToNearest rounding;
  return with_place(WholeFile{options.name},
                    [&] { return GltfReader(bytes, loader, options, context).read(); });
}

}  // namespace plumb
