// Draws sets of space, sets of the plane, maps and surfaces. Each function returns the bytes of one
// picture file. The function decides how its object is drawn. Callers who want to decide this
// themselves can use the headers named below.
//
// Main flow of picture_of:
//  1. scene    makes a scene of triangles, lines and points (space_scene.h, plane_scene.h,
//              surface_scene.h). Flat objects that are written as SVG need no scene.
//  2. write    writes the scene as an image (render.h), as an SVG or HTML page (space_svg.h,
//              scene_html.h) or as GLB (scene_glb.h). A flat object is written as an SVG drawing
//              (nef2_svg.h, map_svg.h), or as an HTML page that contains this drawing
//              (plane_html.h)
// For cost and errors, see these headers. In addition, exceptions of the caller's PNG encoder reach
// the caller.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "plumb/base/context.h"
#include "plumb/picture/canvas.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/picture/texture_image.h"
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
  Html,  ///< A page in which the user can turn or enlarge the picture.
  Glb,   ///< A binary glTF file with the triangles, lines and points, for other programs.
};

/// Options of picture_of().
struct PictureOptions {
  PictureFormat format = PictureFormat::Html;  ///< The format.
  std::string title = {};                      ///< The title. May be any bytes.
  /// A function that returns an image as the bytes of a PNG file. The caller passes it, because the
  /// libraries have no PNG encoder of their own. The function is called if the format is Png. It is
  /// also called if the format is Svg and the object is a set of space or a surface. In these
  /// cases, an empty function leads to Error{BadArgument}.
  std::function<std::string(const Image&)> encode_png = {};
  /// A function that returns the images of textures. It is called for sets of space if the format
  /// is Html or Glb. Images and SVG pages do not show textures.
  TextureLoader load_texture = {};
};

/// Returns a picture of a set of space. If the sources of the set have colours or textures, the
/// picture uses them (coloured_scene()).
std::string picture_of(const Nef3& set, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of several sets, each in a colour of its own. Each set is moved away from the
/// middle of all sets (exploded_scene()). The factor `apart` determines how far: if it is 0, no set
/// is moved.
std::string picture_of(std::span<const Nef3> sets, double apart, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of a set of the plane.
std::string picture_of(const Nef2& set, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of a checked map.
std::string picture_of(const MapReport& report, const PictureOptions& options,
                       Context& context = unlimited_context());
/// Returns a picture of a divided surface. An image shows the layer `shown`. An HTML page contains
/// all layers, and shows the layer `shown` first. If `result` is a null pointer, the layer Result
/// is empty.
std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       SurfaceLayer shown, const PictureOptions& options,
                       Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
