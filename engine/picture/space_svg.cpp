#include "plumb/picture/space_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plumb/io/text_output.h"
#include "plumb/picture/base64.h"
#include "plumb/picture/map_style.h"
#include "plumb/picture/sheet.h"
#include "plumb/picture/svg_text.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/space_measure.h"

namespace plumb {
namespace {

constexpr double kWidth = 600;  // text stays legible on a telephone
constexpr double kAxis = 30;
constexpr std::size_t kLongNumber = 24;

constexpr const char* kStyle = R"(.axis{stroke:#5b6672;stroke-width:2;stroke-linecap:round}
.letter{font-size:14px;fill:#5b6672;text-anchor:middle}
.middle{text-anchor:middle;fill:#5b6672}
)";

std::string volume_text(const Nef3& set) {
  const std::optional<Rational> volume = marked_volume(set.complex());
  if (!volume) return "infinite volume";
  const std::string exact = format_exact(*volume);
  constexpr int kDigits = 6;
  return exact.size() <= kLongNumber
             ? "volume " + exact
             : "volume \xE2\x89\x88\xC2\xA0" + decimal_text(*volume, kDigits);
}

/// The directions of the axes, in the lower left corner.
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
  if (paint <= Paint::Cut) {
    symbol = "<rect x=\"-11\" y=\"-8\" width=\"22\" height=\"16\" fill=\"" + colour + "\"/>";
  } else if (paint <= Paint::FreeEdge) {
    symbol = "<path stroke-width=\"3\" stroke=\"" + colour + "\" d=\"M-11 0H11\"/>";
  } else {
    const bool is_hollow = paint == Paint::OpenPoint;
    symbol = "<circle r=\"5\" stroke-width=\"2\" stroke=\"" + colour + "\" fill=\"" +
             (is_hollow ? "#fff" : colour) + "\"/>";
  }
  sheet.write_item(symbol, std::string(style.name), std::string(style.meaning));
}

void write_legend(Sheet& sheet, const Scene& scene) {
  std::array<bool, kPaints> occurs = scene.paints();
  occurs[static_cast<std::size_t>(Paint::Cut)] = scene.fades;
  for (std::size_t i = 0; i < kPaints; ++i) {
    if (occurs[i] && !style_of(static_cast<Paint>(i)).name.empty()) {
      write_symbol(sheet, static_cast<Paint>(i));
    }
  }
  sheet.end_legend();
}

}  // namespace

std::string facts_of(const Nef3& set) {
  const SpaceCounts n = set.counts();
  return counted(n.vertices, "vertex", "vertices") + ", " + counted(n.edges, "edge") + ", " +
         counted(n.facets, "facet") + ", " + counted(n.volumes, "volume") + ", " + volume_text(set);
}

std::string kind_of(const Nef3& set) {
  if (set.is_empty()) return "empty set";
  if (set.is_space()) return "whole space";
  const char* facets = set.is_closed() ? "closed" : set.is_open() ? "open" : "partly open";
  return std::string(set.is_bounded() ? "bounded, " : "unbounded, ") + facets;
}

void write_space_svg(std::ostream& out, const Nef3& set, const Scene& scene, std::string_view png,
                     const std::string& title) {
  Sheet sheet{{.width = kWidth}};
  const std::string heading = title.empty() ? "set" : title;
  sheet.write_header(heading, {kind_of(set), kPlainBadge}, facts_of(set));
  const double height = sheet.column() * kPageImage.height / kPageImage.width;
  const Rectangle frame{Sheet::kMargin, sheet.y(), sheet.right(), sheet.y() + height};
  sheet.body() << "<image " << svg_box(frame) << " href=\"data:image/png;base64," << base64(png)
               << "\"/>\n<rect class=\"panel\" " << svg_box(frame) << "/>\n";
  write_axes(sheet, scene, frame);
  if (set.is_empty() || set.is_space()) {
    sheet.body() << "<text class=\"middle\" x=\"" << svg_number(frame.centre().x) << "\" y=\""
                 << svg_number(frame.centre().y) << "\">"
                 << (set.is_empty() ? "no point at all" : "every point") << "</text>\n";
  }
  sheet.set_y(frame.bottom + 6);
  write_legend(sheet, scene);
  sheet.write(out, heading + ": " + kind_of(set), kStyle);
}

}  // namespace plumb
