// Draws sets of space and of the plane, maps and surfaces, and returns each picture as the bytes of
// one file. The functions choose a scene, a page or a drawing that suits the object; callers who
// want to choose themselves use the headers that this one names.
//
// Main flow of picture_of:
//  1. scene    makes a scene of triangles, lines and points (space_scene.h, plane_scene.h,
//              surface_scene.h). SVG of flat objects needs no scene.
//  2. write    writes the scene as an image (render.h), as a page (space_svg.h, scene_html.h), as
//              a page around a drawing (plane_html.h, nef2_svg.h, map_svg.h) or as GLB
//              (scene_glb.h)
// Cost and errors are those of the headers named, plus those of the caller's encoder.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "plumb/base/context.h"
#include "plumb/picture/canvas.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"
#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The formats of pictures.
enum class PictureFormat : std::uint8_t {
  Png,   ///< An image.
  Svg,   ///< A page without scripts. Pages of sets of space and of surfaces contain an image.
  Html,  ///< A page in which the picture is turned or enlarged.
  Glb,   ///< The triangles, lines and points, for other programs.
};

/// How a picture is made.
struct PictureOptions {
  PictureFormat format = PictureFormat::Html;  ///< The format.
  std::string title = {};                      ///< The title. May be any bytes.
  /// Returns an image as the bytes of a PNG file. The libraries do not depend on a PNG encoder, so
  /// the caller names one. It is called for Png, and for Svg of sets of space and of surfaces;
  /// without one, these throw Error{BadArgument}.
  std::function<std::string(const Image&)> encode_png = {};
};

/// Returns a picture of a set of space, in the colours of its sources if it has any
/// (coloured_scene()).
std::string picture_of(const Nef3& set, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of several sets, each in a colour of its own. The sets are moved apart by
/// `apart` times the distances of their middles (exploded_scene()).
std::string picture_of(std::span<const Nef3> sets, double apart, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of a set of the plane.
std::string picture_of(const Nef2& set, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of a checked map.
std::string picture_of(const MapReport& report, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of a divided surface. An image shows the layer `shown`; a page has all layers,
/// and shows this one first. `result` may be null; the layer Result is empty then.
std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       SurfaceLayer shown, const PictureOptions& options,
                       Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
