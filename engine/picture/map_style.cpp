#include "plumb/picture/map_style.h"

#include <array>

#include "plumb/picture/svg_text.h"

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
  // cos and sin of multiples of 30 degrees
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

// A neighbour's tint is known at both ends of the common edge: tints seen at one end only belong to
// faces that touch at a vertex, and may be used again.
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

}  // namespace plumb
