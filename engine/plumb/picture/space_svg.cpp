#include "plumb/picture/space_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <ostream>

#include "plumb/io/text/text_output.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/picture/svg/svg_text.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/space_measure.h"

namespace plumb {
namespace {

constexpr double kWidth = 600;  // The text remains legible on a phone.
constexpr double kAxis = 30;
constexpr std::size_t kLongNumber = 24;
// The size of a font, as a multiple of the height of its capital letters.
constexpr double kCapital = 1.4;

constexpr const char* kStyle = R"(.axis{stroke:#5b6672;stroke-width:2;stroke-linecap:round}
.letter{font-size:14px;fill:#5b6672;text-anchor:middle}
.middle{text-anchor:middle;fill:#5b6672}
.label{text-anchor:middle;font-weight:600;fill:#121a24;stroke:#fff;stroke-width:.3em;stroke-linejoin:round;paint-order:stroke}
)";

std::string volume_text(const Nef3& set, Context& context) {
  const std::optional<Rational> volume = marked_volume(set.complex(), context);
  if (!volume) return "infinite volume";
  const std::string exact = format_exact(*volume);
  constexpr int kDigits = 6;
  return exact.size() <= kLongNumber
             ? "volume " + exact
             : "volume \xE2\x89\x88\xC2\xA0" + decimal_text(*volume, kDigits);
}

/// Draws the directions of the axes in the lower left corner.
void write_axes(Sheet& sheet, const Scene& scene, const Rectangle& frame) {
  const Camera camera(scene, frame.width(), frame.height());
  const Point2 origin{frame.left + 52, frame.bottom - 40};
  const std::array<double Point3::*, 3> axes{&Point3::x, &Point3::y, &Point3::z};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = kAxis * (camera.right().*axes[i]), y = -kAxis * (camera.up().*axes[i]);
    const double letter = 1 + 11 / std::max(std::hypot(x, y), 1.);
    sheet.body() << "<path class=\"axis\" d=\"M" << svg_number(origin.x) << ' '
                 << svg_number(origin.y) << 'l' << svg_number(x) << ' ' << svg_number(y)
                 << "\"/><text class=\"letter\" x=\"" << svg_number(origin.x + letter * x)
                 << "\" y=\"" << svg_number(origin.y + letter * y + 5) << "\">"
                 << "xyz"[i] << "</text>\n";
  }
}

void write_symbol(Sheet& sheet, Paint paint) {
  const PaintStyle& style = style_of(paint);
  const std::string colour = hex(style.colour);
  std::string symbol;
  if (!is_line(paint) && !is_dot(paint)) {
    symbol = "<rect x=\"-11\" y=\"-8\" width=\"22\" height=\"16\" fill=\"" + colour + "\"/>";
  } else if (is_line(paint)) {
    symbol = "<path stroke-width=\"3\" stroke=\"" + colour + "\" d=\"M-11 0H11\"/>";
  } else {
    const bool is_hollow = paint == Paint::OpenPoint;
    symbol = "<circle r=\"5\" stroke-width=\"2\" stroke=\"" + colour + "\" fill=\"" +
             (is_hollow ? "#fff" : colour) + "\"/>";
  }
  sheet.write_item(symbol, std::string(style.name), std::string(style.meaning));
}

void write_legend(Sheet& sheet, const Scene& scene) {
  const std::array<bool, kPaints> explained = scene.legend(scene.shown);
  for (std::size_t i = 0; i < kPaints; ++i) {
    if (explained[i]) write_symbol(sheet, static_cast<Paint>(i));
  }
  sheet.end_legend();
}

}  // namespace

std::string facts_of(const Nef3& set, Context& context) {
  const SpaceCounts n = set.counts();
  return counted(n.vertices, "vertex", "vertices") + ", " + counted(n.edges, "edge") + ", " +
         counted(n.facets, "facet") + ", " + counted(n.volumes, "volume") + ", " +
         volume_text(set, context);
}

std::string kind_of(const Nef3& set) {
  if (set.is_empty()) return "empty set";
  if (set.is_whole()) return "whole space";
  const char* facets = set.is_closed() ? "closed" : set.is_open() ? "open" : "partly open";
  return std::string(set.is_bounded() ? "bounded, " : "unbounded, ") + facets;
}

void write_space_svg(std::ostream& out, const Nef3& set, const Scene& scene, std::string_view png,
                     const std::string& title, Context& context) {
  ScenePage page{
      {title.empty() ? "set" : title, kind_of(set), facts_of(set, context)}, png, {}, ""};
  if (set.is_empty()) page.middle = "no point at all";
  if (set.is_whole()) page.middle = "every point";
  write_scene_svg(out, scene, page);
}

void write_scene_svg(std::ostream& out, const Scene& scene, const ScenePage& page) {
  Sheet sheet{{.width = kWidth}};
  sheet.write_header(page.text.title, {page.text.kind, kPlainBadge}, page.text.facts);
  const double scale = sheet.column() / kPageImage.width;
  const Rectangle frame{Sheet::kMargin, sheet.y(), sheet.right(),
                        sheet.y() + scale * kPageImage.height};
  sheet.body() << "<image " << svg_box(frame) << " href=\"data:image/png;base64,"
               << base64(page.png) << "\"/>\n<rect class=\"panel\" " << svg_box(frame) << "/>\n";
  write_axes(sheet, scene, frame);
  for (const PlacedText& text : page.texts) {
    const double size = kCapital * scale * text.height;
    sheet.body() << "<text class=\"label\" font-size=\"" << svg_number(size) << "\" x=\""
                 << svg_number(frame.left + scale * text.middle.x) << "\" y=\""
                 << svg_number(frame.top + scale * (text.middle.y + text.height / 2)) << "\">"
                 << xml_escaped(text.text) << "</text>\n";
  }
  if (!page.middle.empty()) {
    sheet.body() << "<text class=\"middle\" x=\"" << svg_number(frame.centre().x) << "\" y=\""
                 << svg_number(frame.centre().y) << "\">" << page.middle << "</text>\n";
  }
  sheet.set_y(frame.bottom + 6);
  write_legend(sheet, scene);
  sheet.write(out, page.text.title + ": " + page.text.kind, kStyle);
}

}  // namespace plumb
