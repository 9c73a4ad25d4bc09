// The picture of a layer. A view maps a window of the plane to a frame of the picture; the overview
// and all close-ups are drawn by the same function, which clips rings to the window of its view.
// Boxes of rings keep close-ups cheap. The number of points is bounded, and a note names the parts
// that are left out.
// Tested by tests/picture/layer_svg_test.cpp.
#include "plumb/picture/layer_svg.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <sstream>
#include <vector>

#include "plumb/base/internal/message_text.h"
#include "plumb/io/layer_io.h"
#include "plumb/picture/plane/outlines.h"
#include "plumb/picture/plane/plane_view.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/picture/svg/svg_text.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr double kLayerWidth = 1000;
constexpr double kLayerMargin = 0.03;
constexpr double kLeastLayerAspect = 0.4;
constexpr double kMostLayerAspect = 1.2;
constexpr double kSeen = 6;  // A region with a smaller box is marked with a circle.
// The margin around a region, as a part of the box of the region.
constexpr double kCloseUpMargin = 0.6;
// The size of the close-up of a crossing, as a part of the map.
constexpr double kCrossingPart = 0.05;
constexpr std::size_t kMostLayerPoints = 500000;
constexpr std::size_t kMostCloseUpPoints = 20000;
constexpr Rectangle kCloseUpFrame{0, 0, 600, 380};

constexpr const char* kLayerStyle = R"(.feature{stroke:#5b6672;stroke-width:8;fill-rule:evenodd}
.overlap{fill:#a32020;stroke:#a32020;fill-rule:evenodd;stroke-width:14}
.gap{fill:#6a2fa0;stroke:#6a2fa0;fill-rule:evenodd;stroke-width:14}
.hole{fill:#d8e9f7;stroke:#2b6cb0;fill-rule:evenodd;stroke-width:6}
.ring{fill:none;stroke-width:2.5}
.ring.overlap{stroke:#a32020}
.ring.gap{stroke:#6a2fa0}
.crossing{fill:#b45309;stroke:#b45309}
.ring.crossing{fill:none;stroke:#b45309}
.nesting{fill:#0f766e;stroke:#0f766e}
.ring.nesting{fill:none;stroke:#0f766e}
)";

// The texts of the page. The page has the size of the screen, so they are not a part of the
// picture.
constexpr const char* kPageStyle =
    "body{margin:1em auto;max-width:1000px;padding:0 12px;font:16px/1.4 sans-serif;color:#1f2933}"
    "h1{font-size:1.4em;overflow-wrap:anywhere}"
    "#verdict{padding:2px 8px;border-radius:4px;color:#fff;font-weight:bold}"
    "ul{padding:0;list-style:none;display:flex;flex-wrap:wrap;gap:4px 24px}"
    "li i{display:inline-block;width:14px;height:14px;margin-right:8px}"
    "svg{max-width:100%;height:auto}details{margin:.4em 0}"
    "summary{cursor:pointer;overflow-wrap:anywhere}details svg{border:1px solid #9aa5b1}";

/// The meanings of the colours of regions.
struct LayerLegendItem {
  const char* css;  ///< The class, and the name.
  const char* colour;
  const char* meaning;
};
constexpr LayerLegendItem kLayerLegend[] = {
    {"overlap", "#a32020", "several features cover it"},
    {"gap", "#6a2fa0", "a narrow region without a feature"},
    {"hole", "#d8e9f7", "a wide one, such as a lake; no defect"},
    {"crossing", "#b45309", "the border of a feature crosses itself"},
    {"nesting", "#0f766e", "a hole that does not lie in its polygon"},
};

std::vector<Point2> ring_of(const Layer& layer, std::size_t r) {
  std::vector<Point2> points;
  for (const std::uint32_t c : layer.ring(r)) points.push_back(layer.points.approx(c));
  return points;
}

/// A layer with the boxes of its rings.
struct BoxedLayer {
  explicit BoxedLayer(const Layer& of) : layer(of) {
    for (std::size_t r = 0; r < of.ring_count(); ++r) box.push_back(box_of(ring_of(of, r)));
  }
  const Layer& layer;
  std::vector<Rectangle> box;
};

/// Returns the box of the rings of a feature. Requires that the feature has polygons.
Rectangle box_of_feature(const BoxedLayer& boxed, std::size_t f) {
  const Layer& layer = boxed.layer;
  const std::uint32_t first = layer.polygon_begin[layer.feature_begin[f]];
  Rectangle all = boxed.box[first];
  for (std::size_t r = first; r < layer.polygon_begin[layer.feature_begin[f + 1]]; ++r) {
    const Rectangle& box = boxed.box[r];
    all.include({box.left, box.top});
    all.include({box.right, box.bottom});
  }
  return all;
}

bool has_polygons(const Layer& layer, std::size_t f) {
  return layer.feature_begin[f] != layer.feature_begin[f + 1];
}

/// Returns the part of a feature in the window of a view.
PathData path_in(const View& view, const BoxedLayer& boxed, std::size_t f) {
  PathData path;
  const Layer& layer = boxed.layer;
  for (std::size_t p = layer.feature_begin[f]; p < layer.feature_begin[f + 1]; ++p) {
    for (std::size_t r = layer.polygon_begin[p]; r < layer.polygon_begin[p + 1]; ++r) {
      const Rectangle& box = boxed.box[r];
      const Rectangle& window = view.window();
      if (box.right < window.left || window.right < box.left || box.bottom < window.top ||
          window.bottom < box.top) {
        continue;
      }
      const std::vector<Point2> seen = placed(view, view.clipped(ring_of(layer, r)));
      if (!seen.empty()) append_ring(seen, path);
    }
  }
  return path;
}

/// Draws features and regions in a view. Returns the number of features that are left out.
std::size_t draw(const View& view, const BoxedLayer& features, const BoxedLayer& shapes,
                 const LayerReport& report, std::size_t most_points, std::ostream& out) {
  std::size_t points = 0, left_out = 0;
  out << "<g transform=\"scale(.1)\">\n";
  for (std::size_t f = 0; f < features.layer.feature_count(); ++f) {
    const PathData path = path_in(view, features, f);
    if (path.empty()) continue;
    points += path.points();
    if (points > most_points) {
      ++left_out;
      continue;
    }
    out << "<path class=\"feature\" fill=\"" << tint(f % kTints) << "\" fill-opacity=\".7\" d=\""
        << path.data() << "\"/>\n";
  }
  for (const bool is_hole : {true, false}) {
    for (std::size_t i = 0; i < report.regions.size(); ++i) {
      if ((report.regions[i].kind == LayerRegionKind::Hole) != is_hole) continue;
      const PathData path = path_in(view, shapes, i);
      points += path.points();
      if (path.empty() || points > 2 * most_points) continue;
      out << "<path class=\"" << name_of(report.regions[i].kind) << "\" d=\"" << path.data()
          << "\"/>\n";
    }
  }
  out << "</g>\n";
  return left_out;
}

/// Whether a region has a place in doubles.
bool is_drawn(const LayerReport& report, std::size_t i) {
  return report.regions[i].at || has_polygons(report.shapes, i);
}

/// Returns the box of a region. Requires is_drawn().
Rectangle box_of_region(const BoxedLayer& shapes, const LayerReport& report, std::size_t i) {
  const std::optional<Point2> at = report.regions[i].at;
  return at ? Rectangle{at->x, at->y, at->x, at->y} : box_of_feature(shapes, i);
}

/// Draws a circle around each defect that is too small to be visible. The circle is a link to its
/// close-up.
void draw_circles(const View& view, const BoxedLayer& shapes, const LayerReport& report,
                  bool has_links, std::ostream& out) {
  constexpr std::size_t kMostCircles = 5000;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < report.regions.size() && drawn < kMostCircles; ++i) {
    const LayerRegion& region = report.regions[i];
    if (region.kind == LayerRegionKind::Hole || !is_drawn(report, i)) continue;
    const Rectangle box = box_of_region(shapes, report, i);
    if (std::max(box.width(), box.height()) * view.scale() >= kSeen && !has_links) continue;
    const Point2 at = view.place(box.centre());
    if (has_links) out << "<a href=\"#r" << i + 1 << "\">";
    out << "<circle class=\"ring " << name_of(region.kind) << "\" cx=\"" << svg_number(at.x)
        << "\" cy=\"" << svg_number(at.y) << "\" r=\"8\"/>" << (has_links ? "</a>" : "") << '\n';
    ++drawn;
  }
}

/// Returns the description of a region for the list.
std::string sentence(const Layer& layer, const LayerReport& report, std::size_t i) {
  constexpr std::size_t kMostNames = 4;
  const LayerRegion& region = report.regions[i];
  const bool is_of_features = region.at || region.kind == LayerRegionKind::Overlap;
  std::string text = name_of(region.kind);
  const bool has_one_feature = report.features_of(region).size() == 1;
  text += is_of_features ? " of " : has_one_feature ? " in " : " between ";
  std::size_t named = 0;
  for (const std::uint32_t f : report.features_of(region)) {
    if (named == kMostNames) {
      text += ", ...";
      break;
    }
    text += (named++ == 0 ? "" : ", ") + feature_title(layer, f);
  }
  if (region.kind == LayerRegionKind::Nesting) {
    text += ": a hole lies outside of its outer ring, or in another hole";
  } else if (is_of_features && has_one_feature) {
    text += " with itself";
  }
  if (region.at) {
    return text + ", at " + format_double(region.at->x) + ' ' + format_double(region.at->y);
  }
  text += ": area " + format_double(nearest_double(region.area));
  return text + ", width " + format_double(region.width);
}

/// Returns the numbers of the regions, holes last.
std::vector<std::size_t> listed(const LayerReport& report) {
  std::vector<std::size_t> order;
  for (const bool is_hole : {false, true}) {
    for (std::size_t i = 0; i < report.regions.size(); ++i) {
      if ((report.regions[i].kind == LayerRegionKind::Hole) == is_hole) order.push_back(i);
    }
  }
  return order;
}

Rectangle window_of(const BoxedLayer& features) {
  bool is_first = true;
  Rectangle window{0, 0, 1, 1};
  for (std::size_t f = 0; f < features.layer.feature_count(); ++f) {
    if (!has_polygons(features.layer, f)) continue;
    const Rectangle box = box_of_feature(features, f);
    if (is_first) window = box;
    is_first = false;
    window.include({box.left, box.top});
    window.include({box.right, box.bottom});
  }
  const double size = std::max(window.width(), window.height());
  return window.grown(size > 0 ? kLayerMargin * size : 1);
}

std::string facts(const Layer& layer, const LayerReport& report) {
  return counted(layer.feature_count(), "feature") + ", " +
         counted(report.count(LayerRegionKind::Overlap), "overlap") + ", " +
         counted(report.count(LayerRegionKind::Gap), "gap") + ", " +
         counted(report.count(LayerRegionKind::Hole), "hole") + ", " +
         counted(report.count(LayerRegionKind::Crossing), "crossing") + ", " +
         counted(report.count(LayerRegionKind::Nesting), "nesting");
}

/// Draws the map. Returns how many features were left out.
std::size_t draw_map(Sheet& sheet, const BoxedLayer& features, const BoxedLayer& shapes,
                     const LayerReport& report, bool has_links) {
  const Rectangle window = window_of(features);
  const double aspect =
      std::clamp(window.height() / window.width(), kLeastLayerAspect, kMostLayerAspect);
  const Rectangle frame{Sheet::kMargin, sheet.y(), sheet.right(),
                        sheet.y() + sheet.column() * aspect};
  const View view(frame, window);
  sheet.begin_clip(frame);
  const std::size_t left_out = draw(view, features, shapes, report, kMostLayerPoints, sheet.body());
  draw_circles(view, shapes, report, has_links, sheet.body());
  sheet.body() << "</g>\n";
  sheet.set_y(frame.bottom + 12);
  return left_out;
}

/// Draws the map with its title and its legend.
void draw_sheet(Sheet& sheet, const BoxedLayer& features, const BoxedLayer& shapes,
                const LayerReport& report, const LayerSvgOptions& options) {
  const bool is_bad = report.has_defects();
  sheet.write_header(options.title,
                     {is_bad ? "defects" : "coverage", is_bad ? kBadBadge : kGoodBadge},
                     facts(features.layer, report));
  const std::size_t left_out = draw_map(sheet, features, shapes, report, false);
  for (const LayerLegendItem& item : kLayerLegend) {
    sheet.write_item(
        "<rect class=\"" + std::string(item.css) +
            "\" style=\"stroke-width:1.5\" x=\"-7\" y=\"-7\" width=\"14\" height=\"14\"/>",
        item.css, item.meaning);
  }
  sheet.end_legend();
  if (left_out > 0) sheet.note(counted(left_out, "feature") + " not drawn");
}

/// Writes the map of a page with its title and its legend.
void write_page_map(std::ostream& out, const BoxedLayer& features, const BoxedLayer& shapes,
                    const LayerReport& report, const LayerSvgOptions& options) {
  const bool is_bad = report.has_defects();
  Sheet sheet({.width = kLayerWidth});
  const std::size_t left_out = draw_map(sheet, features, shapes, report, true);
  out << "<h1>" << xml_escaped(options.title)
      << "</h1>\n<p><span id=\"verdict\" style=\"background:" << (is_bad ? kBadBadge : kGoodBadge)
      << "\">" << (is_bad ? "defects" : "coverage") << "</span> " << facts(features.layer, report)
      << "</p>\n";
  sheet.write(out, options.title, kLayerStyle);
  out << "<ul>\n";
  for (const LayerLegendItem& item : kLayerLegend) {
    out << "<li><i style=\"background:" << item.colour << "\"></i><b>" << item.css << "</b> "
        << item.meaning << "</li>\n";
  }
  out << "</ul>\n";
  if (left_out > 0) out << "<p>" << counted(left_out, "feature") << " not drawn</p>\n";
  if (!report.regions.empty()) {
    out << "<p>Each region below opens to a close-up, and so does each circle. Pinch to enlarge."
           "</p>\n";
  }
}

}  // namespace

void write_layer_svg(std::ostream& out, const Layer& layer, const LayerReport& report,
                     const LayerSvgOptions& options) {
  const BoxedLayer features(layer), shapes(report.shapes);
  Sheet sheet({.width = kLayerWidth});
  draw_sheet(sheet, features, shapes, report, options);
  const std::vector<std::size_t> order = listed(report);
  for (std::size_t k = 0; k < order.size() && k < options.max_listed; ++k) {
    const std::string text = std::to_string(k + 1) + ". " + sentence(layer, report, order[k]);
    for (const std::string& line : wrapped(text, sheet.text(17), sheet.column(), 3)) {
      sheet.move_down(sheet.text(22));
      sheet.write_line("sub", Sheet::kMargin, line);
    }
  }
  if (order.size() > options.max_listed) {
    sheet.note(counted(order.size() - options.max_listed, "region") + " not listed");
  }
  sheet.write(out, options.title, kLayerStyle);
}

void write_layer_html(std::ostream& out, const Layer& layer, const LayerReport& report,
                      const LayerSvgOptions& options) {
  const BoxedLayer features(layer), shapes(report.shapes);
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<link rel=\"icon\" href=\"data:,\">\n<title>"
      << xml_escaped(options.title) << "</title>\n<style>" << kPageStyle
      << "</style>\n</head>\n<body>\n";
  write_page_map(out, features, shapes, report, options);
  const std::vector<std::size_t> order = listed(report);
  const std::size_t shown = std::min(order.size(), options.max_close_ups);
  const Rectangle window = window_of(features);
  const double width = std::max(window.width(), window.height());
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t i = order[k];
    out << "<details id=\"r" << i + 1 << "\"><summary>" << xml_escaped(sentence(layer, report, i))
        << "</summary>\n";
    if (is_drawn(report, i)) {
      const Rectangle box = box_of_region(shapes, report, i);
      const double size =
          report.regions[i].at ? kCrossingPart * width : std::max(box.width(), box.height());
      const View view(kCloseUpFrame, box.grown(kCloseUpMargin * size));
      out << "<svg viewBox=\"0 0 600 380\" width=\"600\" height=\"380\">\n";
      draw(view, features, shapes, report, kMostCloseUpPoints, out);
      if (report.regions[i].at) {
        const Point2 at = view.place(*report.regions[i].at);
        out << "<circle class=\"ring " << name_of(report.regions[i].kind) << "\" cx=\""
            << svg_number(at.x) << "\" cy=\"" << svg_number(at.y) << "\" r=\"8\"/>\n";
      }
      out << "</svg>\n";
    } else {
      out << "<p>Nothing of this region is left in doubles.</p>\n";
    }
    out << "</details>\n";
  }
  if (shown < order.size()) {
    out << "<p>" << counted(order.size() - shown, "region") << " not listed</p>\n";
  }
  out << "<script>\nfunction show(){const e=document.getElementById(location.hash.slice(1));"
         "if(e){e.open=true;e.scrollIntoView();}}\naddEventListener('hashchange',show);show();\n"
         "</script>\n</body>\n</html>\n";
}

}  // namespace plumb
