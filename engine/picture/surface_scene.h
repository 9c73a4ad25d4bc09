// Divided surfaces as scenes, in the five layers of pictures that can be made of them.
//
//   polygons   the surface with its polygons, their control points, and the points where they meet
//   slices     the triangles it is cut into along the polygons
//   cells      each in a colour of its own
//   labels     written on the cells; equal labels in equal colours
//   result     the cells that an expression selects, their borders, the control points of these
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "plumb/picture/scene.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/triangulation.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What a picture of a division can show.
enum class SurfaceLayer : std::uint8_t { Polygons, Slices, Cells, Labels, Result };
/// Of a layer in Scene::shown.
inline constexpr std::uint8_t bit(SurfaceLayer layer) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(layer));
}

/// By layer.
inline constexpr std::array<std::string_view, 5> kSurfaceLayerNames{"polygons", "slices", "cells",
                                                                    "labels", "result"};
/// "polygons", "slices" and so on.
std::string layer_name(SurfaceLayer layer);

/// All layers; that of a result only if there is one. What is shown is left to the caller. Patches are grouped
/// by cells. O(n log n).
Scene scene_of(const SurfaceDivision& division, const SurfaceTriangulation& triangles,
               const SurfaceResult* result);

/// "3456 triangles, 12 segments, 4 cells".
std::string facts_of(const SurfaceDivision& division);
/// "A", "B", .. "Z", "s26", ...: shapes as expressions name them.
std::string shape_name(std::uint32_t shape);
/// "A+2B-C"; "0".
std::string label_text(std::span<const SignedEntry> label);

}  // namespace plumb
#pragma GCC visibility pop
