// Reading of glTF 2.0 (Khronos Group, glTF 2.0 Specification; ISO/IEC 12113:2022).
//
// Nodes are visited depth first with a stack of its own, so deep hierarchies cost no recursion; a
// transform is kept as long as a child still needs it. A node is placed once: a second placement
// means a cycle or a shared child, and is refused. A node may place copies of its mesh
// (EXT_mesh_gpu_instancing), or be hidden with all below it (KHR_node_visibility).
//
// Every number from the file is checked before it is used: offsets are compared with buffers, and
// indices with counts. Errors name the place in the document.
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

#include "plumb/io/mesh/gltf_accessors.h"
#include "plumb/io/mesh/gltf_document.h"
#include "plumb/io/mesh/gltf_extensions.h"
#include "plumb/io/mesh/gltf_parts.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
             Context& context)
      : in_(bytes, loader, options, context),
        accessors_(in_, context),
        triangles_(options.name, context),
        context_(context),
        charge_(context),
        keeps_attributes_(options.attributes) {
    if (keeps_attributes_) triangles_.keep_materials();
  }

  MeshFile read() {
    auto [notes, warnings] = check_extensions(in_, context_);
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
    if (!hidden_.empty()) {
      notes.push_back("hidden nodes, left out with all below them: " + listed(hidden_));
    }
    if (const std::size_t zeros = accessors_.accessors_of_zeros(); zeros > 0) {
      notes.push_back("accessors without a bufferView, whose elements are zeros: " +
                      std::to_string(zeros));
    }
    if (!in_.replaced().is_none()) notes.push_back(in_.replaced().note());
    note_nodes_outside();
    return finished(notes, warnings);
  }

 private:
  using Id = GltfDocument::Id;
  static constexpr Id kDocument = GltfDocument::kDocument;
  static constexpr std::size_t kMostTexcoords = 8;

  /// A node that waits to be placed by the topmost transform of above_. The transform is dropped
  /// after the last of its nodes.
  struct Placed {
    std::uint32_t node;
    bool is_last;
  };

  /// Returns the mesh with these notes and warnings. A file without triangles is refused, and the
  /// notes and warnings are the reason.
  MeshFile finished(const std::vector<std::string>& notes,
                    const std::vector<std::string>& warnings) {
    const bool is_empty = triangles_.triangle_count() == 0;
    MeshFile file = triangles_.take();
    file.notes.insert(file.notes.end(), notes.begin(), notes.end());
    file.warnings.insert(file.warnings.end(), warnings.begin(), warnings.end());
    if (!is_empty) {
      if (keeps_attributes_) add_materials(file.attributes);
      if (has_own_images_) {
        file.notes.emplace_back("passed over: textures whose images are inside of the file");
      }
      return file;
    }
    std::string why;
    for (const auto* sentences : {&file.notes, &file.warnings}) {
      for (const std::string& sentence : *sentences) why += "; " + sentence;
    }
    in_.fail(ErrorCode::CountMismatch, "meshes", "no triangles are placed" + why);
  }

  // ---------------------------------------------------------------- nodes

  /// Counts steps of loops over the lists of the document, and checks the context from time to
  /// time.
  void watch() const {
    if (++watched_ % kItemsPerCheckpoint == 0) context_.checkpoint("read", 0, 1);
  }

  void find_roots() {
    const std::size_t nodes = in_.entries("nodes").size();
    charge_.add((2 + sizeof(Placed)) * nodes, "nodes");
    is_placed_.resize(nodes);
    open_.reserve(nodes);
    const std::size_t scenes = in_.entries("scenes").size();
    if (scenes > 1) triangles_.pass_over("other scenes");
    if (scenes > 0 || in_.has(kDocument, "scene")) {
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

  /// Ends the list of children that were opened since there were `first`. They are processed from
  /// the end. If there are none, their transform is dropped immediately.
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
    const auto visibility = in_.extension(node, "KHR_node_visibility");
    if (visibility && in_.is_false(*visibility, "visible")) {
      hidden_.push_back(index);
      return;
    }
    const GltfTransform here = product(above, transform_of(node, where));
    const std::size_t first = open_.size();
    above_.push_back(here);
    open_all(in_.list(node, "children", where), where);
    end_children(first);
    if (!in_.has(node, "mesh")) return;
    if (const auto skin = in_.json().find(node, "skin"); skin && in_.json().count(*skin))
      triangles_.leave_out("skins, which move vertices");
    if (has_weights(node)) note_targets(true);
    const std::size_t mesh = in_.count(node, "mesh", {}, where);
    if (has_weights(in_.item("meshes", mesh)) && !in_.has(node, "weights")) note_targets(true);
    const auto copies = in_.extension(node, "EXT_mesh_gpu_instancing");
    if (copies) return place_copies(mesh, instances_of(*copies, where), here, where);
    for (const GltfPrimitive& p : primitives_of(mesh)) {
      triangles_.add(p, here, place_of(mesh, p.number));
    }
  }

  /// Whether an object has weights of morph targets other than 0. In this case, the vertices are at
  /// other places.
  bool has_weights(Id object) const {
    const auto weights = in_.json().find(object, "weights");
    if (!weights || !in_.json().is_list(*weights)) return false;
    const JsonValues::Items all = in_.json().items(*weights);
    return std::any_of(all.begin(), all.end(), [&](Id weight) {
      watch();
      return in_.json().is_number(weight) && in_.json().number(weight) != 0;
    });
  }

  void note_targets(bool move_vertices) {
    if (move_vertices) {
      triangles_.leave_out("morph targets, which move vertices");
    } else {
      triangles_.pass_over("morph targets");
    }
  }

  /// Notes meshes of nodes that the scene does not place. If there are several scenes or hidden
  /// nodes, other notes name them.
  void note_nodes_outside() {
    if (in_.entries("scenes").size() != 1 || !hidden_.empty()) return;
    for (std::size_t n = 0; n < is_placed_.size(); ++n) {
      watch();
      if (is_placed_[n] == 0 && in_.has(in_.item("nodes", n), "mesh")) {
        return triangles_.pass_over("nodes that are not in the scene");
      }
    }
  }

  /// Adds the copies of a mesh that a node places.
  void place_copies(std::size_t mesh, const GltfInstances& copies, const GltfTransform& here,
                    const std::string& where) {
    for (const GltfPrimitive& p : primitives_of(mesh)) {
      const std::string place = place_of(mesh, p.number);
      for (std::size_t i = 0; i < copies.count; ++i) {
        if (copies.lacks_turn(i)) {
          in_.fail(ErrorCode::BadShape, where, "no rotation of instance " + std::to_string(i));
        }
        triangles_.add(p, product(here, copies.transform(i)), place);
      }
    }
  }

  /// Reads the attributes of instances. Attributes that do not move the mesh are not read. If a
  /// node has only such attributes, it places its mesh once.
  GltfInstances instances_of(Id extension, const std::string& where) {
    GltfInstances copies;
    const auto attributes = in_.object(extension, "attributes");
    if (!attributes) return copies;
    const auto read = [&](const char* name, std::string_view type) -> std::optional<GltfElements> {
      if (!in_.has(*attributes, name)) return {};
      return accessors_.vectors(in_.count(*attributes, name, {}, where), type);
    };
    copies.moves = read("TRANSLATION", "VEC3");
    copies.turns = read("ROTATION", "VEC4");
    copies.scales = read("SCALE", "VEC3");
    std::optional<std::size_t> count;
    for (const auto* each : {&copies.moves, &copies.turns, &copies.scales}) {
      if (!*each) continue;
      if (count && *count != (*each)->count) {
        in_.fail(ErrorCode::CountMismatch, where, "attributes of instances differ in number");
      }
      count = (*each)->count;
    }
    copies.count = count.value_or(1);
    return copies;
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

  // ---------------------------------------------------------------- materials

  /// Adds the materials of the document, if a triangle has one. Colours are the numbers of the
  /// file, which are linear.
  void add_materials(MeshAttributes& attributes) {
    const auto has_material = [](std::uint32_t m) { return m != MeshAttributes::kNone; };
    if (std::none_of(attributes.face_material.begin(), attributes.face_material.end(),
                     has_material)) {
      attributes.face_material.clear();
      return;
    }
    const std::size_t count = in_.entries("materials").size();
    for (std::size_t i = 0; i < count; ++i) {
      watch();
      charge_.add(sizeof(MeshMaterial), "materials");
      attributes.materials.push_back(material(i));
    }
  }
  MeshMaterial material(std::size_t index) {
    const std::string where = GltfDocument::entry("materials", index);
    const Id entry = in_.item("materials", index);
    MeshMaterial result{in_.text(entry, "name"), std::array<double, 4>{1, 1, 1, 1}, ""};
    const auto look = in_.object(entry, "pbrMetallicRoughness");
    if (!look) return result;
    result.color = in_.numbers<4>(*look, "baseColorFactor", {1, 1, 1, 1}, where);
    for (double& part : *result.color) part = std::clamp(part, 0.0, 1.0);
    if (const auto texture = in_.object(*look, "baseColorTexture")) {
      result.texture = name_of_texture(in_.count(*texture, "index", {}, where));
      if (result.texture.empty()) has_own_images_ = true;
      charge_.add(2 * result.texture.size(), "materials");
    }
    return result;
  }
  /// Returns the file of a texture. Returns an empty text if the image is in the document, or if
  /// there is no image.
  std::string name_of_texture(std::size_t index) {
    const Id texture = in_.item("textures", index);
    if (!in_.has(texture, "source")) return {};
    const std::size_t source =
        in_.count(texture, "source", {}, GltfDocument::entry("textures", index));
    std::string uri = in_.text(in_.item("images", source), "uri");
    return uri.starts_with("data:") ? std::string() : decoded_uri(uri);
  }

  // ---------------------------------------------------------------- triangles

  static std::string place_of(std::size_t mesh, std::size_t primitive) {
    return GltfDocument::entry("meshes", mesh) + '.' + GltfDocument::entry("primitives", primitive);
  }

  /// Returns the primitives of a mesh. They are listed once, even if several nodes place the mesh.
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
    if (in_.has(primitive, "targets")) note_targets(false);
    if (mode != GltfMode::kTriangles && mode != GltfMode::kStrip && mode != GltfMode::kFan) {
      if (mode > GltfMode::kFan) in_.fail(ErrorCode::Syntax, where, "no such mode");
      triangles_.pass_over("lines and points");
      return {};
    }
    const auto attributes = in_.object(primitive, "attributes");
    if (!attributes || !in_.has(*attributes, "POSITION")) {
      return {};  // In glTF, this means that there is nothing to draw.
    }
    const std::size_t positions = in_.count(*attributes, "POSITION", {}, where);
    std::optional<std::size_t> indices;
    if (in_.has(primitive, "indices")) indices = in_.count(primitive, "indices", {}, where);
    GltfPrimitive p{number, mode, {}, {}};
    const auto draco = in_.extension(primitive, "KHR_draco_mesh_compression");
    if (draco && !(accessors_.can_open(positions) && (!indices || accessors_.can_open(*indices)))) {
      decompress(*draco, *attributes, positions, where, p);
    } else {
      p.positions = accessors_.vectors(positions, "VEC3");
      if (indices) p.indices = accessors_.indices(*indices);
    }
    const std::size_t count = p.corner_count();
    if (p.mode == GltfMode::kTriangles && count % 3 != 0) {
      in_.fail(ErrorCode::CountMismatch, where, std::to_string(count) + " corners of triangles");
    }
    if (count < 3) return {};
    if (keeps_attributes_ && in_.has(primitive, "material")) {
      const std::size_t material = in_.count(primitive, "material", {}, where);
      if (material >= in_.entries("materials").size()) {
        in_.fail(ErrorCode::BadIndex, where, "a material that there is not");
      }
      p.material = static_cast<std::uint32_t>(material);
    }
    if (keeps_attributes_) add_channels(*attributes, where, p);
    return p;
  }

  /// For each channel that is read, calls visit(member, name) with the member of the primitive and
  /// the name of the channel.
  template <class Visit>
  static void for_each_channel(const Visit& visit) {
    visit("COLOR_0", "color");
    visit("NORMAL", "normal");
    for (std::size_t i = 0; i < kMostTexcoords; ++i) {
      const std::string number = std::to_string(i);
      visit("TEXCOORD_" + number, "texcoord_" + number);
    }
  }

  /// Reads the colours, normals and texture coordinates of a primitive.
  void add_channels(Id attributes, const std::string& where, GltfPrimitive& p) {
    for_each_channel([&](const std::string& member, const std::string& name) {
      add_channel(attributes, member, name, where, p);
    });
  }

  /// Reads a channel. As in other formats, a part of the appearance that cannot be read is named in
  /// a note, and the file is not refused.
  void add_channel(Id attributes, const std::string& member, const std::string& name,
                   const std::string& where, GltfPrimitive& p) {
    if (!in_.has(attributes, member)) return;
    const bool is_read = is_sound([&] { read_channel(attributes, member, name, where, p); });
    if (!is_read) {
      triangles_.pass_over("colours, normals or texture coordinates that cannot be read");
    }
  }

  /// Returns whether read() throws no error about the file.
  template <class Read>
  static bool is_sound(const Read& read) {
    try {
      read();
    } catch (const Error& error) {
      const bool is_stop =
          error.code() == ErrorCode::ResourceLimit || error.code() == ErrorCode::Cancelled;
      if (is_stop) throw;
      return false;
    }
    return true;
  }

  void read_channel(Id attributes, const std::string& member, const std::string& name,
                    const std::string& where, GltfPrimitive& p) {
    const std::size_t accessor = in_.count(attributes, member.c_str(), {}, where);
    const std::string type = type_of_channel(name, accessor);
    const auto compressed = p.decompressed.find(member);
    const bool is_missing = p.is_compressed && compressed == p.decompressed.end();
    if (is_missing && !accessors_.can_open(accessor)) {
      in_.fail(ErrorCode::BadIndex, where, member + " is not in the compressed data");
    }
    GltfChannel channel{name, static_cast<std::uint32_t>(type.back() - '0'),
                        compressed != p.decompressed.end() ? compressed->second
                                                           : accessors_.vectors(accessor, type)};
    if (channel.values.count != p.positions.count) {
      in_.fail(ErrorCode::CountMismatch, where,
               member + " has " + std::to_string(channel.values.count) + " elements, POSITION " +
                   std::to_string(p.positions.count));
    }
    charge_.add(sizeof(GltfChannel) + name.size(), "parts of meshes");
    p.channels.push_back(std::move(channel));
  }

  /// Returns the type of the vectors of a channel.
  std::string type_of_channel(const std::string& name, std::size_t accessor) {
    if (name != "color") return name == "normal" ? "VEC3" : "VEC2";
    return accessors_.type_of(accessor) == "VEC4" ? "VEC4" : "VEC3";
  }

  /// Reads the triangles of a compressed primitive, and its channels if they are kept. Triangles of
  /// strips are listed one by one, too.
  void decompress(Id draco, Id attributes, std::size_t positions, const std::string& where,
                  GltfPrimitive& p) {
    const auto ids = in_.object(draco, "attributes");
    if (!ids) in_.fail(ErrorCode::Syntax, where, "compressed without attributes");
    std::vector<std::string> members;
    std::vector<GltfAccessors::CompressedVectors> channels;
    for_each_channel([&](const std::string& member, const std::string& name) {
      if (!keeps_attributes_ || !in_.has(attributes, member) || !in_.has(*ids, member)) return;
      is_sound([&] {
        const std::size_t accessor = in_.count(attributes, member.c_str(), {}, where);
        const std::string type = type_of_channel(name, accessor);
        accessors_.require_vectors(accessor, type);
        channels.push_back({in_.count(*ids, member.c_str(), {}, where), accessor, type});
        members.push_back(member);
      });
    });
    const auto compressed = accessors_.compressed(
        in_.count(draco, "bufferView", {}, where),
        {in_.count(*ids, "POSITION", {}, where), positions, "VEC3"}, channels);
    p.mode = GltfMode::kTriangles;
    p.is_compressed = true;
    p.positions = compressed.positions;
    p.indices = compressed.corners;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (compressed.others[i]) {
        p.decompressed.emplace(members[i], *compressed.others[i]);
      }
    }
  }

  GltfDocument in_;
  GltfAccessors accessors_;
  GltfTriangles triangles_;
  Context& context_;
  MemoryCharge charge_;  // The memory of lists of primitives and materials.
  const bool keeps_attributes_;
  bool has_own_images_ = false;  // Whether a texture of a material has no file of its own.
  mutable std::size_t watched_ = 0;
  std::vector<Placed> open_;
  std::deque<GltfTransform> above_;                               // The transforms of open nodes.
  std::vector<std::uint8_t> is_placed_;                           // For each node.
  std::vector<std::size_t> hidden_;                               // The nodes that are not placed.
  std::map<std::size_t, std::vector<GltfPrimitive>> primitives_;  // For each mesh that is placed.
};

}  // namespace

MeshFile read_gltf(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
                   Context& context) {
  const RoundToNearest rounding;
  return with_place(WholeFile{options.name},
                    [&] { return GltfReader(bytes, loader, options, context).read(); });
}

}  // namespace plumb
