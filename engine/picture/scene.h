// What every picture in space is drawn from: facets cut into triangles, lines and dots, in doubles, each
// with the paint that says what it is. Drawing may round; the engine never does.
//
// Flow from a set to a file:
//  1. scene_of           (space_scene.h, plane_scene.h) the boundary of a set, cut at a window if it is unbounded;
//                        (surface_scene.h) a divided surface, in layers
//  2. rendered           (render.h) the scene seen from one side as an image, or
//     write_scene_glb    (scene_glb.h) for other programs, or
//     write_scene_html   (scene_html.h) to be turned around in a browser
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What a facet, a line or a dot is.
enum class Paint : std::uint8_t {
  ClosedFacet,  ///< part of the set, a marked volume behind it
  OpenFacet,    ///< not part of the set, a marked volume behind it
  Sheet,        ///< part of the set, no marked volume beside it
  Cut,          ///< where the window cuts a marked volume
  Edge,
  OpenEdge,  ///< not part of the set
  FreeEdge,  ///< part of the set, no facet beside it
  Point,
  OpenPoint,  ///< not part of the set, though what surrounds it is
  Defect,
  Region,  ///< of a map; with the next ones, so that neighbours differ
  Region2,
  Region3,
  Region4,
  Region5,
  Region6,
  Surface,   ///< of a mesh that is drawn on, where no layer says otherwise
  Wire,      ///< a side of a triangle
  Control,   ///< a control point of a polygon
  Crossing,  ///< where polygons meet
  Curve,     ///< of a polygon; with the next ones, so that shapes differ
  Curve2,
  Curve3,
  Curve4,
  Curve5,
  Curve6,
};
inline constexpr std::size_t kPaints = 26;  ///< how many paints there are
/// Is it of a polygon on a surface?
inline constexpr bool is_curve(Paint paint) { return paint >= Paint::Curve; }
/// Is it for dots?
inline constexpr bool is_dot(Paint paint) {
  return paint == Paint::Point || paint == Paint::OpenPoint || paint == Paint::Control ||
         paint == Paint::Crossing;
}
/// Is it for lines?
inline constexpr bool is_line(Paint paint) {
  return (paint >= Paint::Edge && paint <= Paint::FreeEdge) || paint == Paint::Defect ||
         paint == Paint::Wire || is_curve(paint);
}

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// How a paint looks and what it is called.
struct PaintStyle {
  Colour colour;             ///< before light falls on it
  std::string_view name;     ///< for a legend; empty: not in it
  std::string_view meaning;  ///< a few words
};
const PaintStyle& style_of(Paint paint);  ///< The style of a paint: one table for all pictures.
/// "#a9c8e6".
std::string hex(Colour colour);

/// Triangles, lines and dots, each with its paint.
struct Scene {
  static constexpr std::uint8_t kAllLayers = 0xff;  ///< a bit for each

  /// A flat part: triangles of one facet.
  struct Patch {
    Point3 normal;            ///< of length 1
    Paint paint;              ///< what it is
    std::uint32_t group = 0;  ///< index into groups, if there are any
    bool is_hatched = false;  ///< in images: a wall, made by a cut (convex/decompose.h)
  };
  /// A part of a patch.
  struct Triangle {
    std::array<std::uint32_t, 3> corners;  ///< counter-clockwise seen against the normal
    std::uint32_t patch;                   ///< index into patches
  };
  /// A straight piece of an edge or curve.
  struct Line {
    std::array<std::uint32_t, 2> ends;     ///< indices into points
    Paint paint;                           ///< what it is
    std::array<std::uint32_t, 2> patches;  ///< two of those beside it; kNoPatch
    std::uint8_t layers = kAllLayers;      ///< a bit for each layer it is in
  };
  /// A point to be seen.
  struct Dot {
    std::uint32_t at;                  ///< index into points
    Paint paint;                       ///< what it is
    std::uint8_t layers = kAllLayers;  ///< a bit for each layer it is in
  };
  /// Patches that belong together.
  struct Group {
    std::string name;  ///< for a legend
    std::string text;  ///< to be written on it
  };
  /// What can be shown or not. Colours of patches are those of the last layer shown that has any.
  struct Layer {
    std::string name;           ///< for its switch
    std::vector<Colour> tints;  ///< per group, or none
    bool has_text = false;      ///< are the texts of groups written?
  };
  static constexpr std::uint32_t kNoPatch = ~std::uint32_t{0};  ///< no index into patches

  std::vector<Point3> points;       ///< within [-1, 1]^3
  std::vector<Patch> patches;       ///< flat parts
  std::vector<Triangle> triangles;  ///< of all patches
  std::vector<Line> lines;          ///< edges and curves
  std::vector<Dot> dots;            ///< vertices and points
  std::vector<Group> groups;        ///< of sets: none
  std::vector<Layer> layers;        ///< of sets: none, all of it is shown
  std::uint8_t shown = kAllLayers;  ///< a bit for each layer

  bool is_flat = false;     ///< in the plane z = 0: looked at from above
  bool fades = false;       ///< towards the sides of the box +-half
  Point3 half = {1, 1, 1};  ///< half the extents of the box around all points
  /// Scene coordinates p stand for centre + scale p, in quarters: no difference of doubles overflows.
  Point3 quarter_centre = {0, 0, 0};
  double quarter_scale = .25;  ///< a quarter of the scale

  /// Is it in a layer that is shown?
  template <class Item>
  bool is_shown(const Item& item) const {
    return (item.layers & shown) != 0;
  }
  /// Is that layer shown?
  bool is_shown(std::size_t layer) const { return (shown >> layer & 1U) != 0; }
  /// The layer whose tints are shown, if any.
  const Layer* tinted() const;
  /// Its paint's, or the tint that a layer shown gives its group.
  Colour colour_of(const Patch& patch) const;
  bool shows_text() const;  ///< Is there a layer shown that has text?

  /// Which paints occur in some layers.
  std::array<bool, kPaints> paints(std::uint8_t layers_seen = kAllLayers) const;
  /// Which of them a legend explains: those with a name; of patches none while a layer gives them its own colours.
  std::array<bool, kPaints> legend(std::uint8_t layers_seen = kAllLayers) const;
  /// 1 well inside the box, 0 at its sides when the scene fades.
  double strength(const Point3& p) const;
};

}  // namespace plumb
#pragma GCC visibility pop
