// The table of extensions, from the registry of Khronos and from files that exporters write.
// Tested by tests/io/gltf_test.cpp.
#include "plumb/io/mesh/gltf_extensions.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/text_output.h"

namespace plumb {
namespace {

struct Family {
  std::string_view prefix;  ///< The prefix of the names of its extensions.
  GltfEffect effect;
  std::string_view what = {};  ///< The part that is missing from the shape.
};

constexpr std::array kFamilies{
    Family{"EXT_mesh_gpu_instancing", GltfEffect::Read},
    Family{"EXT_meshopt_compression", GltfEffect::Read},
    Family{"KHR_draco_mesh_compression", GltfEffect::Read},
    Family{"KHR_mesh_quantization", GltfEffect::Read},
    Family{"KHR_meshopt_compression", GltfEffect::Read},
    Family{"KHR_node_visibility", GltfEffect::Read},

    Family{"AGI_articulations", GltfEffect::Shape, "movable parts stay where they are"},
    Family{"CESIUM_RTC", GltfEffect::Shape, "the model is not moved to its place"},
    Family{"EXT_mesh_primitive_restart", GltfEffect::Shape, "strips that begin anew"},
    Family{"EXT_primitive_voxels", GltfEffect::Shape, "voxels"},
    Family{"KHR_accessor_float64", GltfEffect::Shape, "coordinates of 8 bytes"},
    Family{"KHR_gaussian_splatting", GltfEffect::Shape, "splats"},
    Family{"KHR_mesh_primitive_restart", GltfEffect::Shape, "strips that begin anew"},
    Family{"MPEG_mesh_linking", GltfEffect::Shape, "meshes that follow others"},
    Family{"MSFT_lod", GltfEffect::Shape, "only the finest level of detail"},

    Family{"ADOBE_materials_", GltfEffect::None},
    Family{"AGI_stk_metadata", GltfEffect::None},
    Family{"ASOBO_material_", GltfEffect::None},
    Family{"ASOBO_normal_map_convention", GltfEffect::None},
    Family{"ASOBO_tags", GltfEffect::None},
    Family{"ASOBO_unique_id", GltfEffect::None},
    Family{"BENTLEY_materials_", GltfEffect::None},
    Family{"CESIUM_primitive_outline", GltfEffect::None},
    Family{"EXT_feature_metadata", GltfEffect::None},
    Family{"EXT_instance_features", GltfEffect::None},
    Family{"EXT_lights_", GltfEffect::None},
    Family{"EXT_materials_", GltfEffect::None},
    Family{"EXT_mesh_features", GltfEffect::None},
    Family{"EXT_mesh_manifold", GltfEffect::None},
    Family{"EXT_mesh_primitive_edge_visibility", GltfEffect::None},
    Family{"EXT_structural_metadata", GltfEffect::None},
    Family{"EXT_texture_", GltfEffect::None},
    Family{"FB_geometry_metadata", GltfEffect::None},
    Family{"FB_materials_", GltfEffect::None},
    Family{"FB_ngon_encoding", GltfEffect::None},
    Family{"GODOT_single_root", GltfEffect::None},
    Family{"GRIFFEL_bim_data", GltfEffect::None},
    Family{"KHR_animation_", GltfEffect::None},
    Family{"KHR_audio", GltfEffect::None},
    Family{"KHR_blend", GltfEffect::None},
    Family{"KHR_environment_map", GltfEffect::None},
    Family{"KHR_implicit_shapes", GltfEffect::None},
    Family{"KHR_interactivity", GltfEffect::None},
    Family{"KHR_lights_", GltfEffect::None},
    Family{"KHR_materials_", GltfEffect::None},
    Family{"KHR_node_hoverability", GltfEffect::None},
    Family{"KHR_node_selectability", GltfEffect::None},
    Family{"KHR_physics_rigid_bodies", GltfEffect::None},
    Family{"KHR_techniques_webgl", GltfEffect::None},
    Family{"KHR_texture_", GltfEffect::None},
    Family{"KHR_xmp", GltfEffect::None},
    Family{"MOZ_hubs_components", GltfEffect::None},
    Family{"MSFT_audio_emitter", GltfEffect::None},
    Family{"MSFT_packing_", GltfEffect::None},
    Family{"MSFT_texture_dds", GltfEffect::None},
    Family{"NV_materials_", GltfEffect::None},
    Family{"OMI_", GltfEffect::None},
    Family{"VRM", GltfEffect::None},
};

Family family_of(std::string_view name) {
  const auto* const found = std::find_if(kFamilies.begin(), kFamilies.end(), [&](const Family& f) {
    return name.starts_with(f.prefix);
  });
  return found == kFamilies.end() ? Family{name, GltfEffect::Unknown} : *found;
}

/// Calls visit(name) for each entry of a list of extensions.
template <class Visit>
void for_each_extension(const GltfDocument& document, const char* list, Context& context,
                        Visit visit) {
  std::size_t count = 0;
  for (const GltfDocument::Id each : document.list(GltfDocument::kDocument, list, "the document")) {
    if (++count % kItemsPerCheckpoint == 0) context.checkpoint("read", 0, 1);
    visit(document.json().is_text(each) ? document.json().text(each) : std::string());
  }
}

bool is_followed(GltfEffect effect) {
  return effect == GltfEffect::None || effect == GltfEffect::Read;
}

void add_once(std::vector<std::string>& list, std::string text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(std::move(text));
}

}  // namespace

GltfEffect effect_of_extension(std::string_view name) { return family_of(name).effect; }

GltfExtensions check_extensions(const GltfDocument& document, Context& context) {
  for_each_extension(document, "extensionsRequired", context, [&](const std::string& name) {
    if (is_followed(effect_of_extension(name))) return;
    document.fail(ErrorCode::UnknownFormat, "extensionsRequired",
                  "cannot be read: " + plumb::quoted(name) +
                      " may change the shape; export the file without it");
  });
  // There are only few known extensions. Of the others, only the first ones are named.
  constexpr std::size_t kMostNamed = 64;
  std::vector<std::string> known, unknown;
  for_each_extension(document, "extensionsUsed", context, [&](const std::string& name) {
    const Family family = family_of(name);
    if (family.effect == GltfEffect::Shape) {
      add_once(known, std::string(family.prefix) + " (" + std::string(family.what) + ')');
    } else if (family.effect == GltfEffect::Unknown && unknown.size() < kMostNamed) {
      add_once(unknown, plumb::quoted(name));
    }
  });
  GltfExtensions found;
  if (!known.empty()) {
    found.warnings.push_back("extensions that change the shape, passed over: " + listed(known));
  }
  if (!unknown.empty()) {
    found.notes.push_back("extensions that are not known, passed over: " + listed(unknown));
  }
  return found;
}

}  // namespace plumb
