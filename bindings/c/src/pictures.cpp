// Pictures as bytes, from scenes (plumb/picture). PNG is encoded by libpng.
// Tested by tests/c/interface_test.c.
#include "pictures.h"

#include <png.h>

#include <stdexcept>

#include "files.h"
#include "plumb/picture/canvas.h"
#include "plumb/picture/map_svg.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/plane_html.h"
#include "plumb/picture/plane_scene.h"
#include "plumb/picture/render.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/scene_html.h"
#include "plumb/picture/space_scene.h"
#include "plumb/picture/space_svg.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/surface/triangulation.h"

namespace plumb::c {
namespace {

enum class PictureFormat : std::uint8_t { Html, Svg, Glb, Png };

PictureFormat picture_format(const std::string& name) {
  if (name == "html") return PictureFormat::Html;
  if (name == "svg") return PictureFormat::Svg;
  if (name == "glb") return PictureFormat::Glb;
  if (name == "png") return PictureFormat::Png;
  fail_format(name, "html, svg, glb, png");
}

std::string encoded(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error("libpng: " + std::string(header.message));
  }
  bytes.resize(size);
  return bytes;
}

/// Returns a picture of something flat, whose SVG shows more than its scene.
template <class Result>
std::string flat_picture(const Result& result, PictureFormat format, const std::string& title,
                         const std::string& svg) {
  switch (format) {
    case PictureFormat::Svg:
      return svg;
    case PictureFormat::Html:
      return written([&](std::ostream& out) { write_plane_html(out, svg, title); }).bytes;
    case PictureFormat::Glb:
      return written([&](std::ostream& out) { write_scene_glb(out, scene_of(result), title); })
          .bytes;
    default:
      return encoded(rendered(scene_of(result)));
  }
}

bool shows_text(PictureFormat format) {
  return format == PictureFormat::Svg || format == PictureFormat::Html;
}

std::string picture_of_scene(const Scene& scene, const SceneText& text, PictureFormat format) {
  if (format == PictureFormat::Png) return encoded(rendered(scene));
  return written([&](std::ostream& out) {
           if (format == PictureFormat::Html) return write_scene_html(out, scene, text);
           if (format == PictureFormat::Glb) return write_scene_glb(out, scene, text.title);
           const Rendering rendering = rendered_without_text(scene, kPageImage);
           const std::string png = encoded(rendering.image);
           write_scene_svg(out, scene, {text, png, rendering.texts, ""});
         })
      .bytes;
}

}  // namespace

std::string picture_of(const Nef3& set, const std::string& format, const std::string& title,
                       Context& context) {
  const PictureFormat kind = picture_format(format);
  const Scene scene = scene_of(set, context);
  if (kind != PictureFormat::Svg) {
    return picture_of_scene(scene, {title, kind_of(set), facts_of(set, context)}, kind);
  }
  const std::string png = encoded(rendered(scene, kPageImage));
  return written([&](std::ostream& out) { write_space_svg(out, set, scene, png, title, context); })
      .bytes;
}

std::string picture_of(std::span<const Nef3> sets, double apart, const std::string& format,
                       const std::string& title, Context& context) {
  const PictureFormat kind = picture_format(format);
  const Scene scene = exploded_scene(sets, apart, context);
  const std::string count = std::to_string(sets.size()) + (sets.size() == 1 ? " set" : " sets");
  return picture_of_scene(scene, {title, count, ""}, kind);
}

std::string picture_of(const Nef2& set, const std::string& format, const std::string& title,
                       Context& context) {
  const PictureFormat kind = picture_format(format);
  std::string svg;
  if (shows_text(kind)) {
    svg = written([&](std::ostream& out) {
            write_nef2_svg(out, set, {.title = title, .pieces = {}, .context = &context});
          }).bytes;
  }
  return flat_picture(set, kind, title, svg);
}

std::string picture_of(const MapReport& report, const std::string& format,
                       const std::string& title) {
  const PictureFormat kind = picture_format(format);
  std::string svg;
  if (shows_text(kind)) {
    svg = written([&](std::ostream& out) { write_map_svg(out, report, {.title = title}); }).bytes;
  }
  return flat_picture(report, kind, title, svg);
}

std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       const std::string& layer, const std::string& format,
                       const std::string& title, Context& context) {
  const PictureFormat kind = picture_format(format);
  const auto* const name =
      std::find(kSurfaceLayerNames.begin(), kSurfaceLayerNames.end(), std::string_view(layer));
  if (name == kSurfaceLayerNames.end()) {
    fail_argument("layer: '" + layer + "' is none of polygons, slices, cells, labels, result");
  }
  const auto shown = static_cast<SurfaceLayer>(name - kSurfaceLayerNames.begin());
  if (shown == SurfaceLayer::Result && result == nullptr) {
    fail_argument("the layer result needs a region");
  }
  Scene scene = scene_of(division, triangulate_surface(division, context), result);
  scene.shown = bit(shown);
  return picture_of_scene(scene, {title, layer, facts_of(division)}, kind);
}

}  // namespace plumb::c
