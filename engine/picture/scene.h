// What every picture in space is drawn from: facets cut into triangles, lines and dots, in doubles, each
// with the paint that says what it is. Drawing may round; the engine never does.
//
// Flow from a set to a file:
//  1. scene_of           (space_scene.h, plane_scene.h) the boundary of a set, cut at a window if it is unbounded
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
};
inline constexpr std::size_t kPaints = 16;

using Colour = std::array<std::uint8_t, 3>;

struct PaintStyle {
  Colour colour;
  std::string_view name;     ///< for a legend; empty: not in it
  std::string_view meaning;  ///< a few words
};
const PaintStyle& style_of(Paint paint);
/// "#a9c8e6".
std::string hex(Colour colour);

struct Scene {
  struct Patch {
    Point3 normal;  ///< of length 1
    Paint paint;
  };
  struct Triangle {
    std::array<std::uint32_t, 3> corners;  ///< counter-clockwise seen against the normal
    std::uint32_t patch;
  };
  struct Line {
    std::array<std::uint32_t, 2> ends;
    Paint paint;
    std::array<std::uint32_t, 2> patches;  ///< two of those beside it; kNoPatch
  };
  struct Dot {
    std::uint32_t at;
    Paint paint;
  };
  static constexpr std::uint32_t kNoPatch = ~std::uint32_t{0};

  std::vector<Point3> points;  ///< within [-1, 1]^3
  std::vector<Patch> patches;
  std::vector<Triangle> triangles;
  std::vector<Line> lines;
  std::vector<Dot> dots;

  bool is_flat = false;     ///< in the plane z = 0: looked at from above
  bool fades = false;       ///< towards the sides of the box +-half
  Point3 half = {1, 1, 1};  ///< half the extents of the box around all points
  /// Scene coordinates p stand for centre + scale p, in quarters: no difference of doubles overflows.
  Point3 quarter_centre = {0, 0, 0};
  double quarter_scale = .25;

  /// Which paints occur.
  std::array<bool, kPaints> paints() const;
  /// 1 well inside the box, 0 at its sides when the scene fades.
  double strength(const Point3& p) const;
};

}  // namespace plumb
