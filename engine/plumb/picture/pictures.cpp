// Pictures as bytes: a scene or a drawing, and the writer that suits the format.
// Tested by tests/cli/view_command_test.cpp and tests/c/interface_test.c.
#include "plumb/picture/pictures.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "plumb/picture/map_svg.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/plane_html.h"
#include "plumb/picture/plane_scene.h"
#include "plumb/picture/render.h"
#include "plumb/picture/scene_glb.h"
#include "plumb/picture/scene_html.h"
#include "plumb/picture/space_scene.h"
#include "plumb/picture/space_svg.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/triangulation.h"

namespace plumb {
namespace {

template <class Write>
std::string written(const Write& write) {
  std::ostringstream out;
  // A failed allocation must not be taken for the end of the text.
  out.exceptions(std::ios::badbit);
  write(out);
  return std::move(out).str();
}

std::string encoded(const PictureOptions& options, const Image& image) {
  if (!options.encode_png) throw Error(ErrorCode::BadArgument, "no encoder of PNG is given");
  return options.encode_png(image);
}

/// Returns a picture of a planar drawing. A page with text is drawn as SVG. Triangles and images
/// are made from the scene.
template <class Flat, class Draw>
std::string flat_picture(const Flat& flat, const PictureOptions& options, Context& context,
                         const Draw& draw_svg) {
  switch (options.format) {
    case PictureFormat::Png:
      return encoded(options, rendered(scene_of(flat, context)));
    case PictureFormat::Svg:
      return written(draw_svg);
    case PictureFormat::Html: {
      const std::string svg = written(draw_svg);
      return written([&](std::ostream& out) { write_plane_html(out, svg, options.title); });
    }
    case PictureFormat::Glb:
      break;
  }
  const Scene scene = scene_of(flat, context);
  return written([&](std::ostream& out) { write_scene_glb(out, scene, options.title); });
}

/// Returns a picture of a scene. `write_svg` writes the page of the scene as SVG. `text` makes the
/// texts of a page, which may take more time than the scene.
template <class WriteSvg, class Text>
std::string scene_picture(const Scene& scene, const PictureOptions& options,
                          const WriteSvg& write_svg, const Text& text) {
  switch (options.format) {
    case PictureFormat::Png:
      return encoded(options, rendered(scene));
    case PictureFormat::Svg:
      return written(write_svg);
    case PictureFormat::Html:
      return written([&](std::ostream& out) { write_scene_html(out, scene, text()); });
    case PictureFormat::Glb:
      break;
  }
  return written([&](std::ostream& out) { write_scene_glb(out, scene, options.title); });
}

std::string scene_picture(const Scene& scene, const SceneText& text,
                          const PictureOptions& options) {
  const auto write_svg = [&](std::ostream& out) {
    const Rendering rendering = rendered_without_text(scene, kPageImage);
    const std::string png = encoded(options, rendering.image);
    write_scene_svg(out, scene, {text, png, rendering.texts, ""});
  };
  return scene_picture(scene, options, write_svg, [&] { return text; });
}

}  // namespace

std::string picture_of(const Nef3& set, const PictureOptions& options, Context& context) {
  const bool shows_textures =
      options.format == PictureFormat::Html || options.format == PictureFormat::Glb;
  const Scene scene =
      coloured_scene(set, context, shows_textures ? options.load_texture : TextureLoader());
  const auto write_svg = [&](std::ostream& out) {
    const std::string png = encoded(options, rendered(scene, kPageImage));
    write_space_svg(out, set, scene, png, options.title, context);
  };
  const auto text = [&] { return SceneText{options.title, kind_of(set), facts_of(set, context)}; };
  return scene_picture(scene, options, write_svg, text);
}

std::string picture_of(std::span<const Nef3> sets, double apart, const PictureOptions& options,
                       Context& context) {
  SpaceCounts sum;
  for (const Nef3& set : sets) {
    const SpaceCounts counts = set.counts();
    sum.vertices += counts.vertices;
    sum.edges += counts.edges;
    sum.facets += counts.facets;
  }
  const Scene scene = exploded_scene(sets, apart, context);
  const bool has_walls = std::ranges::any_of(scene.patches, &Scene::Patch::is_hatched);
  const SceneText text{options.title,
                       counted(sets.size(), "set") + (has_walls ? ", cuts hatched" : ""),
                       "in all " + counted(sum.vertices, "vertex", "vertices") + ", " +
                           counted(sum.edges, "edge") + ", " + counted(sum.facets, "facet")};
  return scene_picture(scene, text, options);
}

std::string picture_of(const Nef2& set, const PictureOptions& options, Context& context) {
  return flat_picture(set, options, context, [&](std::ostream& out) {
    write_nef2_svg(out, set, {.title = options.title, .pieces = {}, .context = &context});
  });
}

std::string picture_of(const MapReport& report, const PictureOptions& options, Context& context) {
  return flat_picture(report, options, context, [&](std::ostream& out) {
    write_map_svg(out, report, {.title = options.title, .context = &context});
  });
}

std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       SurfaceLayer shown, const PictureOptions& options, Context& context) {
  Scene scene = scene_of(division, triangulate_surface(division, context), result);
  scene.shown = bit(shown);
  const std::string layer = scene.layers[static_cast<std::size_t>(shown)].name;
  return scene_picture(scene, {options.title, layer, facts_of(division)}, options);
}

}  // namespace plumb
