// The picture of a checked map: the map with its defects, close-ups, a legend, and a list of the
// defects.
//
// The flow is described in svg/svg_text.h. Layout is decided before anything is drawn: the map's
// height follows its shape, close-ups are chosen on a draft of the view, and up to three stand
// below the map, further ones above it, sorted so that the lines that connect them with their
// places cross little. All text is broken to the width of the page, and everything that a limit
// left out is stated in the notes.
// Tested by tests/picture/map_svg_test.cpp.
#include "plumb/picture/map_svg.h"

#include <array>
#include <cmath>
#include <optional>
#include <ostream>
#include <sstream>

#include "plumb/io/map_report_io.h"
#include "plumb/picture/map/map_layers.h"
#include "plumb/picture/map/map_marks.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/picture/svg/svg_text.h"

namespace plumb {
namespace {

constexpr double kWidth = 1000;
constexpr double kMargin = Sheet::kMargin;
constexpr double kColumn = kWidth - 2 * kMargin;
constexpr double kLeastMapHeight = 0.42 * kColumn;
constexpr double kMostMapHeight = 1.05 * kColumn;
constexpr double kMapPadding = 22;
constexpr std::size_t kInsetsInRow = 3;
constexpr double kInsetGap = 18;
constexpr double kInsetAspect = 1.4;
// Half the width on the map of the region that a close-up shows.
constexpr double kLeastSource = 9;
constexpr double kCaption = 24;
constexpr double kFont = 17;
constexpr double kLine = 23;

constexpr PaintLimits kInsetLimits = {40000, 4000, false};

constexpr const char* kStyle = R"(.faces path{stroke-linejoin:round;fill-rule:evenodd}
.tiny{fill:#dfe3e8}
.halo{fill:none;stroke:#fff;stroke-linecap:round;stroke-opacity:.85}
.bad{fill:none;stroke-linecap:round;stroke-linejoin:round}
.marks polygon{stroke:#fff;stroke-width:1.2;stroke-linejoin:round}
.warning{fill:#fff;fill-opacity:.6;stroke:#5b6672;stroke-width:1.6}
.inferred{fill:none;stroke:#5b6672;stroke-width:2.4;stroke-dasharray:7 5}
.lead{stroke:#1f2933;stroke-width:1.2;fill:none}
.tag{stroke:#fff;stroke-width:1.5}
.number{font-size:16px;font-weight:bold;fill:#fff;text-anchor:middle}
.vertex{fill:#1f2933}
.vertex-number{font-size:14px;text-anchor:middle;stroke:#fff;stroke-width:3.5px;stroke-linejoin:round;paint-order:stroke}
.frame{fill:none;stroke:#1f2933;stroke-width:1.4}
)";

/// Returns the box of the whole map. If a few parts lie far away, returns the box of the core and
/// of all defects.
Rectangle main_window(const MapReport& report, const Plane& plane) {
  Rectangle core = plane.core();
  for (const MapDefect& d : report.defects) core.include(plane.at(d.near));
  return without_far_parts(core, plane.extent());
}

/// Returns a factor as text with two digits, such as "x90", "x9200" or "x3e9".
std::string zoom_text(double zoom) {
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // The stream throws if the memory limit is exceeded.
  text.precision(2);
  if (zoom < 1e6) {
    const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(zoom)) - 1));
    text.precision(7);
    zoom = zoom < 10 ? std::round(zoom * 10) / 10 : std::round(zoom / unit) * unit;
  }
  text << "\xC3\x97" << zoom;
  return text.str();
}

/// A close-up and its places in the picture.
struct Closeup {
  Inset inset;
  Rectangle frame;   ///< Frame of the close-up.
  Rectangle source;  ///< Its place on the map.
  bool is_above = false;
};

class MapSheet {
 public:
  MapSheet(const MapReport& report, const MapSvgOptions& options)
      : report_(report),
        options_(options),
        plane_(report.map),
        painter_(plane_),
        marks_(report, plane_),
        window_(main_window(report, plane_)) {}

  void write(std::ostream& out) {
    Context& context = options_.context != nullptr ? *options_.context : unlimited_context();
    write_header();
    lay_out_map();
    context.checkpoint("drawing", 0, closeups_.size() + 1);
    write_map();
    for (std::size_t i = 0; i < closeups_.size(); ++i) {
      context.checkpoint("drawing", i + 1, closeups_.size() + 1);
      write_closeup(i);
    }
    write_legend();
    write_list();
    sheet_.write(out, heading(), style());
  }

 private:
  std::string heading() const {
    return (options_.title.empty() ? "" : options_.title + ": ") +
           std::string(headline(report_.verdict));
  }
  std::string style() const;

  void write_header();
  void lay_out_map();
  std::size_t order_closeups(const std::vector<Inset>& insets, const View& draft);
  void place_closeups(const std::vector<Inset>& insets, const View& draft);
  void write_map();
  void write_sources(LabelPlacer& room);
  void write_leader(const Closeup& c);
  void write_closeup(std::size_t i);
  void write_legend();
  void write_warning_legend();
  void write_list();
  void write_defect(std::size_t i);

  const MapReport& report_;
  const MapSvgOptions& options_;
  Plane plane_;
  Painter painter_;
  MapMarks marks_;
  Rectangle window_;
  Sheet sheet_{{.width = kWidth}};
  std::vector<Closeup> closeups_;
  std::optional<View> view_;
};

std::string MapSheet::style() const {
  std::string style = kStyle;
  for (std::size_t i = 0; i < kTints; ++i) {
    style += ".t" + std::to_string(i) + "{fill:" + tint(i) + "}";
  }
  return style + ".t" + std::to_string(kTints) + "{fill:" + kPaper + "}\n";
}

void MapSheet::write_header() {
  const bool is_valid = report_.verdict == MapVerdict::Valid;
  sheet_.write_header(options_.title.empty() ? "map" : options_.title,
                      {std::string(headline(report_.verdict)), is_valid ? kGoodBadge : kBadBadge},
                      counted(report_.vertices, "vertex", "vertices") + ", " +
                          counted(report_.edges, "edge") + ", " +
                          counted(report_.cycles, "listed face") + ", " +
                          counted(report_.components, "component"));
}

// ------------------------------------------------------------------ layout

/// Decides the height of the map by its shape, and then the number of close-ups and their places.
void MapSheet::lay_out_map() {
  const Rectangle e = window_;
  const double inside = kColumn - 2 * kMapPadding;
  const double natural = e.width() > 0 ? inside * (e.height() / e.width()) : kMostMapHeight;
  const double height = std::clamp(natural + 2 * kMapPadding, kLeastMapHeight, kMostMapHeight);
  const Rectangle panel = {kMargin, sheet_.y(), kWidth - kMargin, sheet_.y() + height};
  view_.emplace(panel.grown(-kMapPadding), e);
  const View draft(panel.grown(-kMapPadding), e);
  place_closeups(choose_insets(report_, plane_, draft, kInsetAspect,
                               std::min<std::size_t>(options_.max_insets, 2 * kInsetsInRow)),
                 draft);
}

/// Orders close-ups. Up to three stand below the map. If there are more, the upper places are above
/// the map. In each row, they are sorted from left to right, so that few leaders cross.
std::size_t MapSheet::order_closeups(const std::vector<Inset>& insets, const View& draft) {
  for (const Inset& i : insets) closeups_.push_back({i, {}, {}, false});
  const auto at = [&draft](const Closeup& c) { return draft.place(c.inset.window.centre()); };
  std::stable_sort(closeups_.begin(), closeups_.end(),
                   [&at](const Closeup& a, const Closeup& b) { return at(a).y < at(b).y; });
  const std::size_t above = closeups_.size() > kInsetsInRow ? closeups_.size() / 2 : 0;
  for (std::size_t i = 0; i < above; ++i) closeups_[i].is_above = true;
  std::stable_sort(closeups_.begin(), closeups_.end(), [&at](const Closeup& a, const Closeup& b) {
    return a.is_above != b.is_above ? a.is_above : at(a).x < at(b).x;
  });
  return above;
}

void MapSheet::place_closeups(const std::vector<Inset>& insets, const View& draft) {
  const std::size_t above = order_closeups(insets, draft);
  const std::size_t n = closeups_.size();
  const double columns = n <= 2 || n == 4 ? 2 : 3;
  const double width = (kColumn - (columns - 1) * kInsetGap) / columns;
  const double height = width / kInsetAspect;
  const double row = height + kCaption + kInsetGap;
  const double shift = above > 0 ? row : 0;
  const Rectangle map = draft.frame();
  view_.emplace(Rectangle{map.left, map.top + shift, map.right, map.bottom + shift}, window_);
  const double bottom = view_->frame().bottom + kMapPadding;
  for (std::size_t i = 0; i < n; ++i) {
    Closeup& c = closeups_[i];
    const auto column = static_cast<double>(c.is_above ? i : i - above);
    const double left = kMargin + column * (width + kInsetGap);
    const double top = c.is_above ? sheet_.y() : bottom + kInsetGap;
    c.frame = {left, top, left + width, top + height};
    const double half = width / 2 * view_->scale() / View(c.frame, c.inset.window).scale();
    const double shown = std::max(half, kLeastSource);
    c.source = Rectangle::around(view_->place(c.inset.window.centre()), shown, shown / kInsetAspect)
                   .within(view_->frame().grown(kMapPadding - 2));
  }
  sheet_.set_y(bottom + (n == 0 ? 18 : row + 6));
}

// ------------------------------------------------------------------ map and close-ups

void MapSheet::write_map() {
  const Rectangle panel = view_->frame().grown(kMapPadding);
  sheet_.body() << "<rect class=\"panel\" " << svg_box(panel) << " rx=\"6\"/>\n";
  sheet_.begin_clip(panel);
  const PaintCounts counts = painter_.paint(*view_, {}, sheet_.body());
  sheet_.body() << "</g>\n";
  if (counts.tiny + counts.left_out > 0) {
    sheet_.note(counted(counts.tiny + counts.left_out, "face") +
                " too small or too many to be drawn one by one: grey tint.");
  }
  if (counts.outside > 0) {
    sheet_.note("Far from the rest and outside this picture: " + counted(counts.outside, "face") +
                ".");
  }
  LabelPlacer room(panel.grown(-3));
  write_sources(room);
  if (const std::size_t left_out = marks_.paint(*view_, Detail::Overview, room, sheet_.body());
      left_out > 0) {
    sheet_.note("No room for the numbers of " + counted(left_out, "more place") + " on the map.");
  }
}

/// Leaders are drawn first, so that marks lie over them.
void MapSheet::write_sources(LabelPlacer& room) {
  for (const Closeup& c : closeups_) write_leader(c);
  for (const Closeup& c : closeups_) {
    sheet_.body() << "<rect class=\"frame\" " << svg_box(c.source) << "/>\n";
    room.avoid(c.source);
  }
}

void MapSheet::write_leader(const Closeup& c) {
  const double from = c.is_above ? c.source.top : c.source.bottom;
  const double to = c.is_above ? c.frame.bottom + kCaption : c.frame.top;
  const double x = std::clamp(c.source.centre().x, c.frame.left + 20, c.frame.right - 20);
  sheet_.body() << "<path class=\"frame\" stroke-opacity=\".55\" d=\"M"
                << svg_number(c.source.centre().x) << ' ' << svg_number(from) << 'L'
                << svg_number(x) << ' ' << svg_number(to) << "\"/>\n";
}

void MapSheet::write_closeup(std::size_t i) {
  const Closeup& c = closeups_[i];
  const View view(c.frame, c.inset.window);
  sheet_.body() << "<rect " << svg_box(c.frame) << " fill=\"" << kPaper << "\"/>\n";
  sheet_.begin_clip(c.frame);
  painter_.paint(view, kInsetLimits, sheet_.body());
  LabelPlacer room(c.frame.grown(-3));
  marks_.paint(view, Detail::Closeup, room, sheet_.body());
  sheet_.body() << "</g>\n<rect class=\"frame\" " << svg_box(c.frame) << "/>\n";
  sheet_.body() << "<text class=\"note\" x=\"" << svg_number(c.frame.left) << "\" y=\""
                << svg_number(c.frame.bottom + 18) << "\">"
                << zoom_text(view.scale() / view_->scale()) << ", "
                << counted(marks_.count_in(c.inset.window), "defect") << "</text>\n";
}

// ------------------------------------------------------------------ legend and list

void MapSheet::write_legend() {
  const MapDefectCounts& n = report_.counts;
  const std::array<std::uint64_t, 6> counts = {n.duplicate,         n.open,  n.crossing, n.twin,
                                               n.mixed.value_or(0), n.nested};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const DefectStyle& style = defect_styles()[k];
    if (counts[k] == 0) continue;
    sheet_.write_item(symbol(style, {}, 8), std::to_string(counts[k]) + " " + style.name,
                      style.meaning);
  }
  write_warning_legend();
  if (!n.mixed && report_.verdict != MapVerdict::Valid)
    sheet_.note(
        "Mixed regions are looked for only when there is no duplicate, open or crossing edge.");
  sheet_.end_legend();
}

void MapSheet::write_warning_legend() {
  constexpr std::array<const char*, 4> names = {"pinch", "isolated vertex",
                                                "inferred outer boundary", "merged vertex"};
  constexpr std::array<const char*, 4> plural = {"pinches", "isolated vertices",
                                                 "inferred outer boundaries", "merged vertices"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto count = static_cast<std::uint64_t>(
        std::count_if(report_.warnings.begin(), report_.warnings.end(),
                      [k](const MapWarning& w) { return static_cast<std::size_t>(w.kind) == k; }));
    if (count == 0) continue;
    const bool is_line = k == static_cast<std::size_t>(WarningKind::InferredOuter);
    sheet_.write_item(is_line ? "<path class=\"inferred\" d=\"M-9 0H10\"/>"
                              : "<circle class=\"warning\" r=\"5\"/>",
                      counted(count, names[k], plural[k]), "warning, no defect");
  }
}

void MapSheet::write_defect(std::size_t i) {
  const MapDefect& defect = report_.defects[i];
  const DefectStyle& style = style_of(defect.kind);
  const std::string number = std::to_string(i + 1);
  const double width = std::max(34.0, text_width(number, 16) + 14);
  const Rectangle box = {kMargin, sheet_.y() - 18, kMargin + width, sheet_.y() + 6};
  sheet_.body() << "<rect " << svg_box(box) << " rx=\"6\" fill=\"" << style.colour
                << "\"/><text class=\"number\" x=\"" << svg_number(box.centre().x) << "\" y=\""
                << svg_number(sheet_.y()) << "\">" << number << "</text>\n"
                << symbol(style, {box.right + 16, sheet_.y() - 6}, 7) << '\n';
  const double x = kMargin + 76;
  std::string lead = std::string("<tspan class=\"kind\">") + style.name + "</tspan> ";
  // The name is bold, and therefore wide.
  const std::string room(std::string_view(style.name).size(), 'm');
  auto lines = wrapped(room + " " + defect.hint, kFont, kWidth - kMargin - x, 3);
  lines.front().erase(0, room.size() + 1);
  for (const std::string& line : lines) {
    sheet_.body() << "<text x=\"" << svg_number(x) << "\" y=\"" << svg_number(sheet_.y()) << "\">"
                  << std::exchange(lead, "") << xml_escaped(line) << "</text>\n";
    sheet_.move_down(kLine);
  }
  sheet_.move_down(8);
}

void MapSheet::write_list() {
  const std::size_t listed = std::min(options_.max_listed, report_.defects.size());
  if (listed == 0) return;
  sheet_.move_down(26);
  for (std::size_t i = 0; i < listed; ++i) write_defect(i);
  const MapDefectCounts& n = report_.counts;
  const std::uint64_t all =
      n.duplicate + n.open + n.crossing + n.twin + n.mixed.value_or(0) + n.nested;
  if (listed < all)
    sheet_.note("The list shows the first " + std::to_string(listed) + " of " +
                counted(all, "defect") + ".");
  if (marks_.drawn() < all)
    sheet_.note("The map marks the first " + std::to_string(marks_.drawn()) + " of " +
                counted(all, "defect") + ".");
}

}  // namespace

void write_map_svg(std::ostream& out, const MapReport& report, const MapSvgOptions& options) {
  MapSheet(report, options).write(out);
}

}  // namespace plumb
