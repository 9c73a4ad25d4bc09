// Materials, colours and names of parts in 3MF: how a model part states them, and how they are
// written.
//
// A part lists groups of entries: base materials (a name and a colour) and colours. A triangle
// names three entries of a group, one for each corner. If they are the same entry, it is the
// material of the face. If they differ, the face has colours at its corners.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/io/mesh/attribute_builder.h"
#include "plumb/io/text/text_output.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// A base material or a colour.
struct ThreeMfEntry {
  std::string name;  ///< Empty for colours.
  std::optional<std::array<double, 4>> color;
};

/// The entries of a group: entries[first], ..., entries[end - 1].
struct ThreeMfGroup {
  std::uint32_t first = 0, end = 0;
};

/// The look of a face.
struct ThreeMfLook {
  static constexpr std::uint32_t kNone = MeshAttributes::kNone;
  std::array<std::uint32_t, 3> entry{kNone, kNone, kNone};  ///< Of each corner, or kNone.
  std::uint32_t name = kNone;  ///< The name of its set of triangles, or kNone.
};

/// What the parts of a file state of materials and names. The arrays of faces are empty or belong
/// to the first faces of ThreeMfScene::source; the other faces have nothing.
struct ThreeMfLooks {
  bool is_kept = false;  ///< Whether anything is collected.
  std::vector<ThreeMfEntry> entries;
  std::map<std::pair<std::uint32_t, std::uint32_t>, ThreeMfGroup> groups;  ///< By part and id.
  std::vector<std::string> names;                                          ///< Of objects and sets.
  std::vector<ThreeMfLook> faces;
};

/// Returns the colour that #RRGGBB or #RRGGBBAA states, or nothing for any other text.
std::optional<std::array<double, 4>> threemf_color(std::string_view text);

/// Collects the looks of placed faces.
class ThreeMfPainter {
 public:
  ThreeMfPainter(const ThreeMfLooks& looks, Context& context)
      : looks_(looks), charge_(context), builder_(context) {}

  /// Adds a placed face that comes from face `source` and whose object has a name, or kNone. If
  /// `turns` is set, its second and third corner are exchanged.
  void add_face(std::uint32_t source, std::uint32_t object_name, bool turns);
  /// Returns the attributes of the mesh, which has the faces that were added.
  MeshAttributes take(const PolygonMesh& mesh);

 private:
  std::uint32_t material_of(std::uint32_t entry);

  const ThreeMfLooks& looks_;
  MemoryCharge charge_;
  AttributeBuilder builder_;
  std::map<std::uint32_t, std::uint32_t> material_;  // By entry.
  std::uint32_t faces_ = 0;
  std::vector<double> corner_colors_;  // Four for each corner, with gaps at the end.
};

/// What a model part says of the looks of a mesh: its resources, and the attributes of its
/// elements.
class ThreeMfResources {
 public:
  /// Requires complete attributes of a mesh of triangles. The attributes must outlive it.
  ThreeMfResources(const PolygonMesh& mesh, const MeshAttributes& attributes);

  /// Whether the part needs the name space of colours, or of sets of triangles.
  bool has_colors() const { return !colors_.empty(); }
  bool has_sets() const { return !sets_.empty(); }
  /// Writes the groups of materials and colours.
  void write_groups(TextOutput& out) const;
  /// Writes the attributes of the object, each after a blank.
  void write_object(TextOutput& out) const;
  /// Writes the attributes of a triangle, each after a blank.
  void write_triangle(TextOutput& out, std::uint32_t face) const;
  /// Writes the sets of triangles of a mesh.
  void write_sets(TextOutput& out) const;

 private:
  static constexpr std::uint32_t kNone = MeshAttributes::kNone;
  /// The group and the entries of a face. The group is kNone if the face has no look.
  struct Property {
    std::uint32_t group = kNone;
    std::array<std::uint32_t, 3> entry{};
  };

  void find_names();
  Property property_of(std::uint32_t face);
  std::uint32_t number_of_material(std::uint32_t material);
  std::uint32_t number_of_color(const std::array<double, 4>& color);

  const MeshAttributes& attributes_;
  const MeshChannel* channel_;
  std::vector<std::uint32_t> materials_;                    // Those with names that are used.
  std::map<std::uint32_t, std::uint32_t> material_number_;  // Their numbers.
  std::vector<std::uint32_t> colors_;                       // As 0xRRGGBBAA.
  std::map<std::uint32_t, std::uint32_t> color_number_;     // Their numbers.
  std::vector<Property> properties_;                        // Of faces.
  std::string name_;                                        // Of the object.
  std::vector<std::pair<std::string, std::vector<std::uint32_t>>> sets_;  // Names and faces.
};

}  // namespace plumb
