// The page around a picture, and the style of maps.
//
// A Sheet collects the body of the picture while its height is not yet known; write() then puts
// title, styles and notes around it and states the size. Text is measured by an upper estimate of
// its width, so nothing overlaps without a font at hand. Cycles are coloured greedily in their
// order: each takes the first tint that no neighbour with an earlier number has.
// Tested by tests/picture/map_svg_test.cpp and tests/picture/plane_view_test.cpp.
#include "plumb/picture/svg/sheet.h"

#include <array>

#include "plumb/picture/svg/svg_text.h"

namespace plumb {
namespace {

constexpr std::array<const char*, kTints> kTintColours = {"#cfe2f3", "#fbe3c8", "#d4ecd2",
                                                          "#f5d6dc", "#e2dbf1", "#fbf3c4",
                                                          "#cdeae8", "#eaddd0", "#dde3ea"};

const std::vector<Point2> kSquare = {{-.85, -.85}, {.85, -.85}, {.85, .85}, {-.85, .85}};
const std::vector<Point2> kCross = {{-.95, -.55}, {-.55, -.95}, {0, -.4},    {.55, -.95},
                                    {.95, -.55},  {.4, 0},      {.95, .55},  {.55, .95},
                                    {0, .4},      {-.55, .95},  {-.95, .55}, {-.4, 0}};
const std::vector<Point2> kTriangle = {{0, -1}, {1, .8}, {-1, .8}};
const std::vector<Point2> kDiamond = {{0, -1.1}, {1.1, 0}, {0, 1.1}, {-1.1, 0}};
const std::vector<Point2> kBars = {{-1, -.9}, {1, -.9}, {1, -.3}, {-.4, -.3},
                                   {-.4, .3}, {1, .3},  {1, .9},  {-1, .9}};

std::vector<Point2> circle() {
  // The cosine and sine of multiples of 30 degrees.
  constexpr double c = 0.866, s = 0.5;
  return {{1, 0},  {c, s},   {s, c},   {0, 1},  {-s, c}, {-c, s},
          {-1, 0}, {-c, -s}, {-s, -c}, {0, -1}, {s, -c}, {c, -s}};
}

}  // namespace

const std::vector<DefectStyle>& defect_styles() {
  static const std::vector<DefectStyle> styles = {
      {DefectKind::Duplicate, "duplicate", "directed edge used again", "#c14700", kSquare},
      {DefectKind::Open, "open", "edge without another side", "#0065a4", circle()},
      {DefectKind::Crossing, "crossing", "edges meet off a vertex", "#a3125f", kCross},
      {DefectKind::Twin, "twin", "one face on both sides", "#00705a", kTriangle},
      {DefectKind::Mixed, "mixed", "several faces in one region", "#7d5700", kDiamond},
      {DefectKind::Nested, "nested", "island without its hole", "#56309b", kBars},
  };
  return styles;
}

const DefectStyle& style_of(DefectKind kind) {
  return defect_styles()[static_cast<std::size_t>(kind)];
}

std::string symbol(const DefectStyle& style, Point2 at, double radius) {
  std::string points;
  for (const Point2& p : style.outline) {
    points += svg_number(at.x + p.x * radius) + "," + svg_number(at.y + p.y * radius) + " ";
  }
  points.pop_back();
  return "<polygon points=\"" + points + "\" fill=\"" + style.colour + "\"/>";
}

const char* tint(std::size_t colour) { return kTintColours[colour % kTints]; }

std::uint8_t free_colour(std::uint32_t taken, std::size_t wish, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t colour = (wish + i) % count;
    if ((taken >> colour & 1U) == 0) return static_cast<std::uint8_t>(colour);
  }
  return static_cast<std::uint8_t>(wish % count);
}

// The tint of a neighbour is found at both ends of the common edge. A tint that is found only at
// one end belongs to a face that touches at a vertex, and may be used again.
std::vector<std::uint8_t> colour_cycles(const Map& map) {
  std::vector<std::uint16_t> seen(map.vertex_count());
  std::vector<std::uint8_t> colours(map.cycle_count());
  for (std::size_t c = 0; c < colours.size(); ++c) {
    const auto cycle = map.cycle(c);
    std::uint32_t taken = 0;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      taken |= seen[cycle[i]] & seen[cycle[i + 1 < cycle.size() ? i + 1 : 0]];
    }
    colours[c] = free_colour(taken, c, kTints);
    for (const std::uint32_t v : cycle) {
      seen[v] = static_cast<std::uint16_t>(seen[v] | (1U << colours[c]));
    }
  }
  return colours;
}

namespace {

constexpr double kTitleSize = 30;
constexpr double kBold = 1.15;  // Bold letters may be wider by this factor.
constexpr double kBadgeSize = 22;
constexpr double kFactsSize = 17;
constexpr double kNoteSize = 15;
constexpr double kLine = 23;  // The distance between the lines of a text of size 17.
// The least width for two columns, for text that is not scaled.
constexpr double kTwoColumns = 900;

}  // namespace

std::string counted(std::uint64_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

void Sheet::write_line(const char* css, double x, const std::string& text) {
  body_ << "<text class=\"" << css << "\" x=\"" << svg_number(x) << "\" y=\"" << svg_number(y_)
        << "\">" << xml_escaped(text) << "</text>\n";
}

void Sheet::write_badge(const Badge& badge) {
  const double width = text_width(badge.text, text(kBadgeSize)) + text(36);
  const Rectangle box = {kMargin, y_, kMargin + width, y_ + text(40)};
  body_ << "<rect " << svg_box(box) << " rx=\"8\" fill=\"" << badge.colour
        << "\"/><text class=\"verdict\" x=\"" << svg_number(box.centre().x) << "\" y=\""
        << svg_number(y_ + text(28)) << "\">" << xml_escaped(badge.text) << "</text>\n";
}

/// Writes the header. The facts stand beside the badge if there is enough space; otherwise below
/// it.
void Sheet::write_header(const std::string& title, const Badge& badge, const std::string& facts) {
  for (const std::string& line : wrapped(title, text(kBold * kTitleSize), column(), 2)) {
    y_ += text(kTitleSize - 2);
    write_line("title", kMargin, line);
    y_ += text(6);
  }
  y_ += text(12);
  write_badge(badge);
  const double beside = kMargin + text_width(badge.text, text(kBadgeSize)) + text(54);
  if (beside + text_width(facts, text(kFactsSize)) <= right()) {
    y_ += text(27);
    write_line("sub", beside, facts);
  } else {
    y_ += text(45);
    for (const std::string& line : wrapped(facts, text(kFactsSize), column(), 4)) {
      y_ += text(kLine);
      write_line("sub", kMargin, line);
    }
    y_ -= text(10);
  }
  y_ += text(30);
}

void Sheet::begin_clip(const Rectangle& frame) {
  ++clips_;
  body_ << "<clipPath id=\"c" << clips_ << "\"><rect " << svg_box(frame)
        << "/></clipPath><g clip-path=\"url(#c" << clips_ << ")\">\n";
}

void Sheet::write_item(const std::string& symbol, const std::string& name,
                       const std::string& meaning) {
  const bool has_columns = options_.width / options_.text_scale >= kTwoColumns;
  const bool is_right = has_columns && items_ % 2 != 0;
  if (!is_right) y_ += text(kLine + 3);
  const double x = kMargin + (is_right ? column() / 2 : 0);
  ++items_;
  body_ << "<g transform=\"translate(" << svg_number(x + text(10)) << ' '
        << svg_number(y_ - text(6)) << ")\">" << symbol << "</g><text x=\""
        << svg_number(x + text(30)) << "\" y=\"" << svg_number(y_) << "\"><tspan class=\"kind\">"
        << xml_escaped(name) << "</tspan> <tspan class=\"sub\">" << xml_escaped(meaning)
        << "</tspan></text>\n";
}

void Sheet::end_legend() { y_ += items_ > 0 ? text(14) : 0; }

std::string Sheet::common_style() const {
  const auto size = [this](double n) { return svg_number(text(n)) + "px"; };
  return R"(text{font-family:Helvetica,Arial,"Liberation Sans","DejaVu Sans",sans-serif;font-size:)" +
         size(kFactsSize) + ";fill:" + kInk + "}\n.title{font-size:" + size(kTitleSize) +
         ";font-weight:bold}\n.verdict{font-size:" + size(kBadgeSize) +
         ";font-weight:bold;fill:#fff;text-anchor:middle}\n.sub{fill:" + kQuietInk +
         "}\n.note{font-size:" + size(kNoteSize) + ";fill:" + kQuietInk +
         "}\n.kind{font-weight:bold}\n.panel{fill:none;stroke:#c3c9d0;stroke-width:1}\n";
}

void Sheet::write(std::ostream& out, const std::string& heading, const std::string& style) {
  for (const std::string& note : notes_) {
    for (const std::string& line : wrapped(note, text(kNoteSize), column(), 3)) {
      y_ += text(21);
      write_line("note", kMargin, line);
    }
  }
  const std::string width = svg_number(options_.width);
  const std::string height = svg_number(y_ + kMargin - 6);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
      << "\" width=\"" << width << "\" height=\"" << height << "\" role=\"img\">\n<title>"
      << xml_escaped(heading) << "</title>\n<style>\n"
      << common_style() << style << "</style>\n<rect width=\"" << width << "\" height=\"" << height
      << "\" fill=\"" << kPaper << "\"/>\n"
      << body_.str() << "</svg>\n";
}

}  // namespace plumb
