// Scenes are the input of every picture in space. A scene consists of facets (cut into triangles),
// lines and dots. Each facet, line and dot has a paint, which states its role. Coordinates are
// doubles. The exact coordinates of a set are rounded when the scene is made.
//
// Main flow from a set to a file:
//  1. scene_of makes a scene. The scene of a set shows the boundary of the set. An unbounded set is
//     first intersected with a window (space_scene.h, plane_scene.h). The scene of a divided
//     surface has layers (surface_scene.h).
//  2. One of these functions produces the output:
//       rendered          makes an image of the scene (render.h)
//       write_scene_glb   writes a file for other programs (scene_glb.h)
//       write_scene_html  writes a page on which the scene can be turned (scene_html.h)
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/picture/texture_image.h"
#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The role of a facet, a line or a dot.
enum class Paint : std::uint8_t {
  ClosedFacet,  ///< A facet in the set, with a marked volume behind it.
  OpenFacet,    ///< A facet not in the set, with a marked volume behind it.
  Sheet,        ///< A facet in the set, with no marked volume beside it.
  Cut,          ///< A facet where the window (space_scene.h) cuts a marked volume.
  Edge,         ///< An edge in the set.
  OpenEdge,     ///< An edge not in the set.
  FreeEdge,     ///< An edge in the set, with no facet beside it.
  Point,        ///< A point in the set.
  OpenPoint,    ///< A point not in the set, although the cells around it are in the set.
  Defect,       ///< A defect of a map.
  Region,       ///< A region of a map. Six paints serve to distinguish neighbouring regions.
  Region2,      ///< A region of a map.
  Region3,      ///< A region of a map.
  Region4,      ///< A region of a map.
  Region5,      ///< A region of a map.
  Region6,      ///< A region of a map.
  Surface,      ///< The mesh on which polygons lie. Used if no shown layer has tints.
  Wire,         ///< In the layer `slices` of a divided surface: a side of a triangle.
  Control,      ///< A control point of a polygon.
  Crossing,     ///< A point where polygons meet.
  Curve,        ///< A polygon on a surface. Six paints serve to distinguish shapes.
  Curve2,       ///< A polygon on a surface.
  Curve3,       ///< A polygon on a surface.
  Curve4,       ///< A polygon on a surface.
  Curve5,       ///< A polygon on a surface.
  Curve6,       ///< A polygon on a surface.
};
inline constexpr std::size_t kPaints = 26;  ///< Number of paints.
/// Whether a paint is used for polygons on a surface.
inline constexpr bool is_curve(Paint paint) { return paint >= Paint::Curve; }
/// Whether a paint is used for dots.
inline constexpr bool is_dot(Paint paint) {
  return paint == Paint::Point || paint == Paint::OpenPoint || paint == Paint::Control ||
         paint == Paint::Crossing;
}
/// Whether a paint is used for lines.
inline constexpr bool is_line(Paint paint) {
  return (paint >= Paint::Edge && paint <= Paint::FreeEdge) || paint == Paint::Defect ||
         paint == Paint::Wire || is_curve(paint);
}

using Colour = std::array<std::uint8_t, 3>;  ///< Red, green and blue.

/// The look and the name of a paint.
struct PaintStyle {
  Colour colour;             ///< The colour before lighting.
  std::string_view name;     ///< The name in a legend; empty if a legend omits the paint.
  std::string_view meaning;  ///< A few words that explain the paint.
};
const PaintStyle& style_of(Paint paint);  ///< Returns the style of a paint.
/// Returns a colour as a text such as "#a9c8e6".
std::string hex(Colour colour);

/// Triangles, lines and dots, each with its paint.
struct Scene {
  static constexpr std::uint8_t kAllLayers = 0xff;                ///< The bits of all layers.
  static constexpr std::uint32_t kNoTexture = ~std::uint32_t{0};  ///< No index into textures.

  /// A flat part: the triangles of one facet.
  struct Patch {
    Point3 normal;            ///< Unit normal.
    Paint paint;              ///< The role of the patch.
    std::uint32_t group = 0;  ///< Index into groups. Not used if the scene has no groups.
    /// Whether the patch is hatched in images. The patches of walls are hatched
    /// (convex/decompose.h).
    bool is_hatched = false;
  };
  /// A triangle of a patch.
  struct Triangle {
    /// Indices into points. The corners are in counter-clockwise order, seen from the side to which
    /// the normal points.
    std::array<std::uint32_t, 3> corners;
    std::uint32_t patch;  ///< Index into patches.
  };
  /// A straight part of an edge or curve.
  struct Line {
    std::array<std::uint32_t, 2> ends;     ///< Indices into points.
    Paint paint;                           ///< The role of the line.
    std::array<std::uint32_t, 2> patches;  ///< The two patches beside the line, or kNoPatch.
    std::uint8_t layers = kAllLayers;      ///< Bit i is 1 if layer i contains the line.
  };
  /// A visible point.
  struct Dot {
    std::uint32_t at;                  ///< Index into points.
    Paint paint;                       ///< The role of the dot.
    std::uint8_t layers = kAllLayers;  ///< Bit i is 1 if layer i contains the dot.
  };
  /// Patches that belong together.
  struct Group {
    std::string name;  ///< The name in a legend.
    std::string text;  ///< The text that is written on the group.
    /// Index into textures, or kNoTexture. The colours of an image are multiplied by the tint of
    /// the group.
    std::uint32_t texture = kNoTexture;
  };
  /// A part of the scene that can be shown or hidden. A layer may have tints, which replace the
  /// colours of the patches while the layer is shown. If several shown layers have tints, the tints
  /// of the last one are used.
  struct Layer {
    std::string name;           ///< The name of the switch that shows or hides the layer.
    std::vector<Colour> tints;  ///< One tint for each group. Empty if the layer has no tints.
    bool has_text = false;      ///< Whether the layer shows the texts of groups.
  };
  static constexpr std::uint32_t kNoPatch = ~std::uint32_t{0};  ///< The invalid index into patches.

  std::vector<Point3> points;          ///< Points within [-1, 1]^3.
  std::vector<Patch> patches;          ///< The flat parts of the scene.
  std::vector<Triangle> triangles;     ///< Triangles of all patches.
  std::vector<Line> lines;             ///< Edges and curves.
  std::vector<Dot> dots;               ///< Vertices and points.
  std::vector<Group> groups;           ///< Groups of patches. The scene of one set has no groups.
  std::vector<Layer> layers;           ///< Layers. The scene of one set has no layers.
  std::uint8_t shown = kAllLayers;     ///< Bit i is 1 if layer i is currently shown.
  std::vector<TextureImage> textures;  ///< Images that groups show in pages and GLB files.
  /// For each triangle, two texture coordinates at each corner. The first grows to the right of the
  /// image, the second upwards. Empty if there are no textures.
  std::vector<std::array<float, 6>> texcoords;

  bool is_flat = false;  ///< Whether the scene lies in the plane z = 0 and is seen from above.
  bool fades = false;    ///< Whether the scene fades out towards the sides of its box.
  /// Half the side lengths of the box around all points of the scene. The centre of the box is the
  /// origin.
  Point3 half = {1, 1, 1};
  /// A quarter of the vector `centre`. A point p of the scene represents the point
  /// `centre + scale * p` of the set. Instead of `centre` and `scale`, a quarter of each is stored,
  /// because differences of large doubles could overflow.
  Point3 quarter_centre = {0, 0, 0};
  double quarter_scale = .25;  ///< A quarter of the number `scale`.

  /// Whether a line or dot is in a layer that is shown.
  template <class Item>
  bool is_shown(const Item& item) const {
    return (item.layers & shown) != 0;
  }
  /// Whether a layer is shown.
  bool is_shown(std::size_t layer) const { return (shown >> layer & 1U) != 0; }
  /// Returns the layer whose tints are used, or nullptr if no shown layer has tints.
  const Layer* tinted() const;
  /// Returns the colour of a patch. If a shown layer has tints, the colour is the tint of the
  /// patch's group. Otherwise it is the colour of the patch's paint.
  Colour colour_of(const Patch& patch) const;
  bool shows_text() const;  ///< Whether a layer with text is shown.

  /// Returns, for each paint, whether the paint occurs. A paint occurs if a patch has it, or if a
  /// line or dot in one of the given layers has it.
  std::array<bool, kPaints> paints(std::uint8_t layers_seen = kAllLayers) const;
  /// Returns, for each paint, whether a legend explains it. A legend explains each paint that has a
  /// name and occurs (see paints()). There are two exceptions:
  ///   - A legend explains Paint::Cut if and only if the scene fades out.
  ///   - If a shown layer has tints, a legend does not explain the paints of patches.
  std::array<bool, kPaints> legend(std::uint8_t layers_seen = kAllLayers) const;
  /// Returns the opacity, from 0 to 1, with which the scene is drawn at a point. If the scene fades
  /// out, the opacity is 1 in the inner part of the scene's box, and it decreases to 0 towards the
  /// sides of the box. Otherwise the opacity is 1 everywhere.
  double strength(const Point3& p) const;
};

}  // namespace plumb
#pragma GCC visibility pop
