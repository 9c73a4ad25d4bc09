// Makes scenes of divided surfaces. A scene has up to five layers:
//
//   polygons   shows the surface with its polygons, the control points of the polygons, and the
//              points where polygons meet
//   slices     shows the triangles into which the polygons cut the surface
//   cells      shows the cells, each in a colour of its own
//   labels     shows the labels, which are written on the cells. Cells with equal labels have equal
//              colours.
//   result     shows the cells that an expression selects, the borders of these cells, and the
//              control points on these borders
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/picture/scene.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/triangulation.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The layers of the scene of a divided surface.
enum class SurfaceLayer : std::uint8_t { Polygons, Slices, Cells, Labels, Result };
/// Returns the bit that stands for a layer in Scene::shown.
inline constexpr std::uint8_t bit(SurfaceLayer layer) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(layer));
}

/// The names of the layers, indexed by layer.
inline constexpr std::array<std::string_view, 5> kSurfaceLayerNames{"polygons", "slices", "cells",
                                                                    "labels", "result"};
/// Returns the name of a layer, such as "polygons".
std::string layer_name(SurfaceLayer layer);

/// Returns the scene of a divided surface with all its layers. The layer SurfaceLayer::Result
/// exists only if `result` is not null. The patches of a cell form a group. The caller sets
/// Scene::shown to select the layers that are shown. Cost: O(n log n) for n triangles.
Scene scene_of(const SurfaceDivision& division, const SurfaceTriangulation& triangles,
               const SurfaceResult* result);
/// Returns the scene of a division in which cells with equal labels have equal colours. If `result`
/// is not a null pointer, the scene contains only the selected cells and the borders of the result.
/// Cost: O(n log n) for n triangles.
Scene labelled_scene(const SurfaceDivision& division, const SurfaceResult* result,
                     Context& context = unlimited_context());

/// Returns facts about a divided surface in one line, such as "3456 triangles, 12 segments, 4
/// cells".
std::string facts_of(const SurfaceDivision& division);
/// Returns the name of a shape in expressions. Shapes 0 to 25 are called "A" to "Z". The following
/// shapes are called "s26", "s27" and so on.
std::string shape_name(std::uint32_t shape);
/// Returns a label as text, such as "A+2B-C", or "0" for the empty label.
std::string label_text(std::span<const SignedEntry> label);

}  // namespace plumb
#pragma GCC visibility pop
