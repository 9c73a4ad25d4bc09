// The names of pictures and layers. Tested by tests/c/interface_test.c.
#include "pictures.h"

#include <algorithm>
#include <utility>

#include "files.h"
#include "plumb/picture/png/encode_png.h"

namespace plumb::c {
namespace {

PictureFormat picture_format(const std::string& name) {
  if (name == "html") return PictureFormat::Html;
  if (name == "svg") return PictureFormat::Svg;
  if (name == "glb") return PictureFormat::Glb;
  if (name == "png") return PictureFormat::Png;
  fail_format(name, "html, svg, glb, png");
}

}  // namespace

PictureOptions picture(const std::string& format, std::string title) {
  return {picture_format(format), std::move(title), encode_png};
}

SurfaceLayer surface_layer(const std::string& name, bool has_result) {
  const auto* const found =
      std::find(kSurfaceLayerNames.begin(), kSurfaceLayerNames.end(), std::string_view(name));
  if (found == kSurfaceLayerNames.end()) {
    fail_argument("layer: '" + name + "' is none of polygons, slices, cells, labels, result");
  }
  const auto layer = static_cast<SurfaceLayer>(found - kSurfaceLayerNames.begin());
  if (layer == SurfaceLayer::Result && !has_result) {
    fail_argument("the layer result needs a region");
  }
  return layer;
}

}  // namespace plumb::c
