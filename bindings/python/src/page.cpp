// Pages of sets, maps and surfaces.
#include "page.h"

#include "plumb/picture/map_svg.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/plane_html.h"
#include "plumb/picture/scene_html.h"
#include "plumb/picture/space_scene.h"
#include "plumb/picture/space_svg.h"
#include "plumb/picture/surface_scene.h"
#include "plumb/surface/triangulation.h"

namespace plumb::python {
namespace {

std::string flat_page(const std::string& svg, const std::string& title) {
  return written([&](std::ostream& out) { write_plane_html(out, svg, title); });
}

}  // namespace

std::string page_of(Context& context, const Nef3& set, const std::string& title) {
  const Scene scene = scene_of(set, context);
  return written([&](std::ostream& out) {
    write_scene_html(out, scene, {title, kind_of(set), facts_of(set, context)});
  });
}

std::string page_of(Context& context, const Nef2& set, const std::string& title) {
  Nef2SvgOptions options;
  options.title = title;
  options.context = &context;
  const auto svg = written([&](std::ostream& out) { write_nef2_svg(out, set, options); });
  return flat_page(svg, title);
}

std::string page_of(Context&, const MapReport& report, const std::string& title) {
  MapSvgOptions options;
  options.title = title;
  const auto svg = written([&](std::ostream& out) { write_map_svg(out, report, options); });
  return flat_page(svg, title);
}

std::string page_of(Context& context, const SurfaceDivision& division, const std::string& title) {
  const SurfaceTriangulation triangles = triangulate_surface(division, context);
  Scene scene = scene_of(division, triangles, nullptr);
  scene.shown = static_cast<std::uint8_t>(bit(SurfaceLayer::Cells) | bit(SurfaceLayer::Polygons));
  return written([&](std::ostream& out) {
    write_scene_html(out, scene, {title, "divided surface", facts_of(division)});
  });
}

std::string frame_of(const std::string& page) {
  constexpr std::size_t kMostBytes = std::size_t{16} << 20;
  if (page.size() > kMostBytes) {
    return "<p>This object is too large for a notebook. to_html() returns its page.</p>";
  }
  std::string escaped;
  escaped.reserve(page.size() + page.size() / 8);
  for (const char c : page) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else {
      escaped += c;
    }
  }
  return R"(<iframe sandbox="allow-scripts" style="width:100%;height:480px;border:0" srcdoc=")" +
         escaped + R"("></iframe>)";
}

}  // namespace plumb::python
