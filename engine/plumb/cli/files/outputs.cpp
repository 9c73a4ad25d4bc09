// Results as files, and pictures as bytes.
//
// SetOutput opens its file before the work and prepares all bytes that can fail before any are
// written, so a run either leaves a complete file or none. Pictures are made from scenes: an image
// or a page with triangles always, SVG with text for sets of the plane and maps. PNG is encoded
// here, with a library that only the program needs.
// Tested by tests/cli/view_command_test.cpp, tests/cli/plane_command_test.cpp and
// tests/cli/solid_command_test.cpp.
#include "plumb/cli/files/outputs.h"

#include <png.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

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
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

std::string SetOutput::title() const {
  return path_ == "-" ? "" : std::filesystem::path(path_).filename().string();
}

/// A device or a pipe has no file beside it, and a mesh that is called .mtl has none of its own.
std::string SetOutput::library() const {
  std::error_code error;
  const std::filesystem::path path(path_);
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  const bool is_other =
      std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (path.extension() == ".mtl" || is_other) return "";
  return title().empty() ? "" : std::filesystem::path(title()).replace_extension(".mtl").string();
}

void SetOutput::open_streams(Session& session) {
  const CommonOptions& common = session.options();
  if (!common.out.empty() || !common.format.empty() || !common.json) {
    path_ = common.out.empty() ? "-" : common.out;
    session.outputs().add(path_, [this](std::ostream& out) { file_.write(out); });
  }
  if (common.json) {
    session.outputs().add("-", [this](std::ostream& out) { out << json_.dump() << '\n'; });
  }
}

void SetOutput::prepare(const std::function<nlohmann::ordered_json()>& info,
                        const std::function<ReadyFile()>& make, bool strict, Session& session) {
  if (session.options().json) json_ = info();
  if (path_.empty()) return;
  try {
    file_ = make();
  } catch (const Error& error) {
    const bool names_place = !error.place().file.empty();
    if (names_place ||
        (error.code() != ErrorCode::CannotWrite && error.code() != ErrorCode::NumberOutOfRange)) {
      throw;
    }
    throw Error(error.code(), error.message(), {name()});
  }
  if (file_.write_library && !library().empty()) {
    const auto path = std::filesystem::path(path_).replace_extension(".mtl");
    session.outputs().add(path.string(), file_.write_library);
  }
  if (!strict) return;
  for (const std::vector<std::string>* const told : {&file_.losses, &file_.changes}) {
    if (told->empty()) continue;
    throw Error(ErrorCode::CannotWrite, "--strict: " + told->front(), {name()});
  }
}

void SetOutput::deliver(Session& session) {
  session.deliver();
  for (const std::string& loss : file_.losses) session.note(name() + ": warning: " + loss);
  if (!file_.dropped.empty()) session.note(name() + ": " + file_.dropped);
}

// Images as PNG. Only the program needs a library for it.

std::string png_bytes(const Image& image);

std::string png_bytes(const Image& image) {
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

namespace {

template <class Write>
std::string written(const Write& write) {
  std::ostringstream out;
  write(out);
  return std::move(out).str();
}

/// Returns a picture of something flat: a page with text is drawn as SVG; triangles and images come
/// from the scene.
template <class Result>
std::string flat_picture(const Result& result, const std::string& svg, Picture picture,
                         const std::string& title, Context& context) {
  return written([&](std::ostream& out) {
    switch (picture) {
      case Picture::Png:
        out << png_bytes(rendered(scene_of(result, context)));
        break;
      case Picture::Svg:
        out << svg;
        break;
      case Picture::Html:
        write_plane_html(out, svg, title);
        break;
      case Picture::Glb:
        write_scene_glb(out, scene_of(result, context), title);
        break;
    }
  });
}

/// Returns a picture of a scene in layers.
std::string picture_of(const Scene& scene, const SceneText& text, Picture picture) {
  return written([&](std::ostream& out) {
    switch (picture) {
      case Picture::Png:
        out << png_bytes(rendered(scene));
        break;
      case Picture::Svg: {
        const Rendering rendering = rendered_without_text(scene, kPageImage);
        const std::string png = png_bytes(rendering.image);
        write_scene_svg(out, scene, {text, png, rendering.texts, ""});
        break;
      }
      case Picture::Html:
        write_scene_html(out, scene, text);
        break;
      case Picture::Glb:
        write_scene_glb(out, scene, text.title);
        break;
    }
  });
}

}  // namespace

std::string picture_of(const Nef3& set, Picture picture, const std::string& title,
                       Context& context) {
  const Scene scene = scene_of(set, context);
  return written([&](std::ostream& out) {
    switch (picture) {
      case Picture::Png:
        out << png_bytes(rendered(scene));
        break;
      case Picture::Svg:
        write_space_svg(out, set, scene, png_bytes(rendered(scene, kPageImage)), title, context);
        break;
      case Picture::Html:
        write_scene_html(out, scene, {title, kind_of(set), facts_of(set, context)});
        break;
      case Picture::Glb:
        write_scene_glb(out, scene, title);
        break;
    }
  });
}

std::string picture_of(std::span<const Nef3> sets, double apart, Picture picture,
                       const std::string& title, Context& context) {
  SpaceCounts sum;
  for (const Nef3& set : sets) {
    const SpaceCounts counts = set.counts();
    sum.vertices += counts.vertices;
    sum.edges += counts.edges;
    sum.facets += counts.facets;
  }
  const Scene scene = exploded_scene(sets, apart, context);
  const bool has_walls = std::ranges::any_of(scene.patches, &Scene::Patch::is_hatched);
  const SceneText text{title, counted(sets.size(), "set") + (has_walls ? ", cuts hatched" : ""),
                       "in all " + counted(sum.vertices, "vertex", "vertices") + ", " +
                           counted(sum.edges, "edge") + ", " + counted(sum.facets, "facet")};
  return picture_of(scene, text, picture);
}

std::string picture_of(const SurfaceDivision& division, const SurfaceResult* result,
                       SurfaceLayer shown, Picture picture, const std::string& title,
                       Context& context) {
  const SurfaceTriangulation triangles = triangulate_surface(division, context);
  Scene scene = scene_of(division, triangles, result);
  scene.shown = bit(shown);
  return picture_of(scene,
                    {title, scene.layers[static_cast<std::size_t>(shown)].name, facts_of(division)},
                    picture);
}

std::string picture_of(const Nef2& set, Picture picture, const std::string& title,
                       Context& context) {
  const bool has_text = picture == Picture::Svg || picture == Picture::Html;
  std::ostringstream svg;
  if (has_text) write_nef2_svg(svg, set, {.title = title, .context = &context});
  return flat_picture(set, svg.str(), picture, title, context);
}

std::string picture_of(const MapReport& report, Picture picture, const std::string& title,
                       Context& context) {
  const bool has_text = picture == Picture::Svg || picture == Picture::Html;
  std::ostringstream svg;
  if (has_text) write_map_svg(svg, report, {.title = title, .context = &context});
  return flat_picture(report, svg.str(), picture, title, context);
}

}  // namespace plumb::cli
