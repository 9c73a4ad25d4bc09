// Scenes as a page of HTML that draws them with WebGL, without any other file.
//
// The scene is written as JSON with arrays of numbers in base64, which the page reads as typed
// arrays; the program of the page is text in scene/scene_page.h. The images of textures are written
// as data URIs with the bytes of their files, which the browser decodes. The first view is the one
// of an image (picture/render.h), and the legend lists the paints and layers that occur.
// Tested by tests/picture/space_scene_test.cpp and tests/picture/surface_scene_test.cpp.
#include "plumb/picture/scene_html.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>
#include <type_traits>

#include "plumb/io/text/byte_order.h"
#include "plumb/picture/render.h"
#include "plumb/picture/scene/scene_page.h"
#include "plumb/picture/svg/svg_text.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

/// The numbers of a list, as the typed array of the page reads them. They are little-endian, like
/// the processors on which browsers run.
class Numbers {
 public:
  template <class Number>
  void add(Number value) {
    const auto raw = to_bytes(value, std::endian::little);
    bytes_.append(raw.data(), raw.size());
  }
  void add(const Point3& p) {
    for (const double x : {p.x, p.y, p.z}) add(static_cast<float>(x));
  }
  std::string text() const { return base64(bytes_); }

 private:
  std::string bytes_;
};

template <class List, class Add>
std::string numbers(const List& list, const Add& add) {
  Numbers out;
  for (const auto& item : list) add(out, item);
  return out.text();
}

std::uint8_t code(Paint paint) { return static_cast<std::uint8_t>(paint); }

Json colours() {
  Json list = Json::array();
  for (std::size_t i = 0; i < kPaints; ++i) {
    Json colour = Json::array();
    for (const std::uint8_t part : style_of(static_cast<Paint>(i)).colour) {
      colour.push_back(std::round(part / 255. * 1000) / 1000);
    }
    list.push_back(colour);
  }
  return list;
}

Json line_widths() {
  Json list = Json::array();
  for (std::size_t i = 0; i < kPaints; ++i) {
    const auto paint = static_cast<Paint>(i);
    list.push_back(paint == Paint::FreeEdge || paint == Paint::Defect || is_curve(paint) ? 3.2
                   : paint == Paint::Wire                                                ? 1.4
                                                                                         : 2);
  }
  return list;
}

/// Returns the first view, which is the view of an image. WebGL expects the columns one after the
/// other.
Json first_turn(const Scene& scene) {
  const Camera camera(scene, 1, 1);
  Json columns = Json::array();
  for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
    for (const Point3& row : {camera.right(), camera.up(), camera.viewer()}) {
      columns.push_back(row.*axis);
    }
  }
  return columns;
}

double reach_of(const Scene& scene) {
  double reach = 0;
  for (const Point3& p : scene.points) reach = std::max(reach, std::hypot(p.x, p.y, p.z));
  return reach > 0 ? reach : 1;
}

Json layers_json(const Scene& scene) {
  Json list = Json::array();
  for (const Scene::Layer& layer : scene.layers) {
    list.push_back({{"name", layer.name},
                    {"text", layer.has_text},
                    {"tints", numbers(layer.tints, [](Numbers& out, const Colour& colour) {
                       for (const std::uint8_t part : colour) out.add(part);
                     })}});
  }
  return list;
}

Json groups_json(const Scene& scene) {
  Json list = Json::array();
  for (const Scene::Group& group : scene.groups) {
    Json entry = {{"text", group.text}};
    if (group.texture != Scene::kNoTexture) entry["texture"] = group.texture;
    list.push_back(std::move(entry));
  }
  return list;
}

Json textures_json(const Scene& scene) {
  Json list = Json::array();
  for (const TextureImage& image : scene.textures) {
    list.push_back("data:" + image.type + ";base64," + base64(image.bytes));
  }
  return list;
}

Json scene_json(const Scene& scene) {
  Json json = {{"flat", scene.is_flat},
               {"fades", scene.fades},
               {"half", {scene.half.x, scene.half.y, scene.half.z}},
               {"turn", first_turn(scene)},
               {"reach", reach_of(scene)},
               {"curve", code(Paint::Curve)},
               {"cut", code(Paint::Cut)},
               {"hollow", code(Paint::OpenPoint)},
               {"colours", colours()},
               {"wide", line_widths()},
               {"shown", scene.shown},
               {"layers", layers_json(scene)},
               {"groups", groups_json(scene)},
               {"textures", textures_json(scene)}};
  if (!scene.textures.empty()) {
    json["texcoords"] = numbers(scene.texcoords, [](Numbers& out, const auto& triangle) {
      for (const float number : triangle) out.add(number);
    });
  }
  json["points"] = numbers(scene.points, [](Numbers& out, const Point3& p) { out.add(p); });
  json["normals"] = numbers(scene.patches, [](Numbers& out, const auto& p) { out.add(p.normal); });
  json["patchPaint"] =
      numbers(scene.patches, [](Numbers& out, const auto& p) { out.add(code(p.paint)); });
  if (!scene.layers.empty()) {
    json["patchGroup"] =
        numbers(scene.patches, [](Numbers& out, const auto& p) { out.add(p.group); });
    json["lineLayers"] =
        numbers(scene.lines, [](Numbers& out, const auto& l) { out.add(l.layers); });
    json["dotLayers"] = numbers(scene.dots, [](Numbers& out, const auto& d) { out.add(d.layers); });
  }
  json["corners"] = numbers(scene.triangles, [](Numbers& out, const auto& t) {
    for (const std::uint32_t c : t.corners) out.add(c);
  });
  json["patch"] = numbers(scene.triangles, [](Numbers& out, const auto& t) { out.add(t.patch); });
  json["ends"] = numbers(scene.lines, [](Numbers& out, const auto& l) {
    for (const std::uint32_t e : l.ends) out.add(e);
  });
  json["linePaint"] =
      numbers(scene.lines, [](Numbers& out, const auto& l) { out.add(code(l.paint)); });
  json["dots"] = numbers(scene.dots, [](Numbers& out, const auto& d) { out.add(d.at); });
  json["dotPaint"] =
      numbers(scene.dots, [](Numbers& out, const auto& d) { out.add(code(d.paint)); });
  return json;
}

void write_legend(std::ostream& out, const Scene& scene) {
  const std::array<bool, kPaints> explained = scene.legend();
  out << "<ul>\n";
  for (std::size_t i = 0; i < kPaints; ++i) {
    const auto paint = static_cast<Paint>(i);
    const PaintStyle& style = style_of(paint);
    if (!explained[i]) continue;
    out << "<li><i class=\""
        << (is_dot(paint) || paint == Paint::Defect ? "dot"
            : is_line(paint)                        ? "line"
                                                    : "")
        << "\" style=\"background:" << (paint == Paint::OpenPoint ? "#fff" : hex(style.colour))
        << ";border-color:" << hex(style.colour) << "\"></i><b>" << style.name << "</b> "
        << style.meaning << "</li>\n";
  }
  out << "</ul>\n";
}

}  // namespace

void write_scene_html(std::ostream& out, const Scene& scene, const SceneText& text) {
  const std::string title = xml_escaped(text.title);
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>"
      << title << "</title>\n"
      << kScenePageStyle << "</head>\n<body>\n<header><h1>" << title
      << "</h1> <span class=\"kind\">" << xml_escaped(text.kind) << "</span><p class=\"facts\">"
      << xml_escaped(text.facts)
      << "</p></header>\n<div id=\"view\"><canvas tabindex=\"0\" role=\"img\" aria-label=\""
      << title << ": " << xml_escaped(text.kind)
      << "\"></canvas><p id=\"none\" hidden>This browser has no WebGL, which the picture needs."
         "</p></div>\n<footer>\n";
  write_legend(out, scene);
  if (!scene.layers.empty()) out << "<div id=\"layers\"></div>\n";
  out << "<p class=\"help\">Drag to " << (scene.is_flat ? "move" : "turn")
      << ", wheel or two fingers to enlarge, " << (scene.is_flat ? "" : "shift-drag to move, ")
      << "double-click to go back.</p>\n</footer>\n<script>\n'use strict';\nconst scene = "
      << scene_json(scene).dump() << ";" << kScenePageProgram << "</script>\n</body>\n</html>\n";
}

}  // namespace plumb
