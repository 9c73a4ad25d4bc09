// Pictures of maps: well-formed, finite, bounded, and every defect in them.
#include "plumb/picture/map_svg.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "plumb/picture/svg/sheet.h"
#include "svg_checks.h"

namespace plumb::map_svg_test {
namespace {

using namespace testing;

/// start + count * step, without leaving the doubles where the product would.
double after(double start, double step, std::uint32_t count) {
  for (; count > 0; --count) start += step;
  return start;
}

/// n x n squares of side `step` with lower left corner (x, y), and their outer cycle.
Map grid(std::uint32_t n, double x = 0, double y = 0, double step = 1) {
  Map map;
  const auto at = [n](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      map.points.push_back({after(x, step, i), after(y, step, j)});
    }
  }
  std::vector<std::uint32_t> outer;
  for (std::uint32_t j = 0; j < n; ++j) outer.push_back(at(0, j));
  for (std::uint32_t i = 0; i < n; ++i) outer.push_back(at(i, n));
  for (std::uint32_t j = n; j > 0; --j) outer.push_back(at(n, j));
  for (std::uint32_t i = n; i > 0; --i) outer.push_back(at(i, 0));
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      map.add_cycle(std::vector{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  map.add_cycle(outer);
  return map;
}

/// (Assigning the braces directly makes g++ 12 warn about its own library.)
std::vector<MapEdge> edges(std::vector<MapEdge> list) { return list; }

MapReport judged(Map map) {
  Context context;
  return check_map(std::move(map), {}, context);
}

std::string drawn(const MapReport& report, const MapSvgOptions& options = {}) {
  std::ostringstream out;
  write_map_svg(out, report, options);
  return out.str();
}

/// Symbols drawn in a kind's colour, those of the legend and the list not counted.
std::size_t symbols(const std::string& svg, DefectKind kind) {
  std::size_t count = 0;
  visit(parsed(svg), [&](const std::string&, const Xml& group) {
    if (attribute(group, "class") != "marks") return;
    for (const auto& [name, child] : group) {
      if (name == "polygon" && attribute(child, "fill") == style_of(kind).colour) ++count;
    }
  });
  return count;
}

MapReport with_defects(std::size_t n) {
  MapReport report = judged(grid(20));
  report.verdict = MapVerdict::Superposed;
  for (std::size_t i = 0; i < n; ++i) {
    const auto v = static_cast<std::uint32_t>(i % 20 + 21 * (i / 20 % 20));
    MapDefect defect;
    defect.kind = static_cast<DefectKind>(i % 6);
    defect.edges = edges({{v, v + 1}, {v + 1, v + 22}});
    defect.near = report.map.points.approx(v);
    defect.hint = "what & why <" + std::to_string(i) + ">";
    report.defects.push_back(defect);
  }
  report.counts = {n, n, n, n, n, n};
  return report;
}

TEST(MapSvg, ValidMapsAreWellFormed) {
  const std::string svg = drawn(judged(grid(8)), {.title = "grid"});
  expect_sound(svg);
  EXPECT_NE(svg.find(">valid<"), std::string::npos);
  EXPECT_NE(svg.find("81 vertices, 144 edges, 65 listed faces, 1 component<"), std::string::npos);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("href"), std::string::npos);
}

TEST(MapSvg, EmptyMap) { expect_sound(drawn(MapReport{})); }

TEST(MapSvg, EveryDefectHasItsSymbolAndNumber) {
  const MapReport report = with_defects(40);
  const std::string svg = drawn(report, {.max_listed = 40, .max_insets = 0});
  expect_sound(svg);
  for (const DefectStyle& style : defect_styles()) {
    std::size_t expected = 0;
    for (const MapDefect& d : report.defects) expected += d.kind == style.kind ? 1 : 0;
    EXPECT_EQ(symbols(svg, style.kind), expected) << style.name;
  }
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_NE(svg.find(">" + std::to_string(i + 1) + "</text>"), std::string::npos) << i;
    EXPECT_NE(svg.find("why &lt;" + std::to_string(i) + "&gt;"), std::string::npos) << i;
  }
}

TEST(MapSvg, KindsAtOnePlaceStandSideBySide) {
  MapReport report = with_defects(6);
  for (MapDefect& d : report.defects) d.near = {10, 10};
  const std::string svg = drawn(report, {.max_insets = 0});
  for (const DefectStyle& style : defect_styles())
    EXPECT_EQ(symbols(svg, style.kind), 1U) << style.name;
}

TEST(MapSvg, DefectsFarOffTheMapStillHaveTheirSymbol) {
  MapReport report = with_defects(3);
  report.defects[0].near = {1e308, -1e308};
  report.defects[1].near = {std::numeric_limits<double>::infinity(), 0};
  const std::string svg = drawn(report, {.max_insets = 0});
  expect_sound(svg);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(symbols(svg, static_cast<DefectKind>(k)), 1U) << k;
}

TEST(MapSvg, SmallDefectsGetACloseup) {
  Map map = grid(200);
  const std::uint32_t v = 100 * 201 + 100;
  map.add_cycle(std::vector{v, v + 1, v + 202, v + 201});  // one square twice
  const std::string svg = drawn(judged(std::move(map)));
  expect_sound(svg);
  std::size_t closeups = 0;
  visit(parsed(svg), [&closeups](const std::string& name, const Xml& e) {
    if (name == "text" && e.data().find("\xC3\x97") == 0) ++closeups;
  });
  EXPECT_EQ(closeups, 1U);
  EXPECT_NE(svg.find(">" + std::to_string(v + 1) + "</text>"),
            std::string::npos);  // vertex numbers
}

TEST(MapSvg, TitlesAreEscaped) {
  const std::string svg = drawn(judged(grid(1)), {.title = "<a href=\"x\">&\xFF\x01'</a>"});
  expect_sound(svg);
  EXPECT_EQ(svg.find("<a "), std::string::npos);
  EXPECT_NE(svg.find("&lt;a href=&quot;x&quot;&gt;&amp;\xEF\xBF\xBD\xEF\xBF\xBD&#39;&lt;/a&gt;"),
            std::string::npos);
}

TEST(MapSvg, AnyFiniteCoordinates) {
  constexpr double kMax = std::numeric_limits<double>::max();
  struct Case {
    const char* name;
    Map map;
  };
  const Case cases[] = {
      {"whole range", grid(2, -kMax, -kMax, kMax)},
      {"huge", grid(3, 1e300, -1e300, 1e299)},
      {"subnormal", grid(3, 0, 0, 5e-324)},
      {"tiny", grid(3, 1e-310, 1e-310, 1e-312)},
      {"far from the origin", grid(3, 4503599627370496, 4503599627370496, 1)},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    MapReport report = judged(c.map);
    expect_sound(drawn(report));
    MapDefect defect;
    defect.kind = DefectKind::Crossing;
    defect.edges = edges({{0, 1}, {1, 2}});
    defect.near = c.map.points.approx(1);
    report.defects = {defect};
    const std::string svg = drawn(report);
    expect_sound(svg);
    EXPECT_GE(symbols(svg, DefectKind::Crossing), 1U);
  }
}

TEST(MapSvg, MapsWithoutWidthOrHeight) {
  for (const bool upright : {false, true}) {
    MapReport report;
    for (int i = 0; i < 4; ++i)
      report.map.points.push_back(upright ? Point2{7, 1.0 * i} : Point2{1.0 * i, 7});
    report.map.add_cycle(std::vector<std::uint32_t>{0, 1, 2, 3});
    expect_sound(drawn(report));
  }
  MapReport point;
  for (int i = 0; i < 3; ++i) point.map.points.push_back({1e-5, 3});
  point.map.add_cycle(std::vector<std::uint32_t>{0, 1, 2});
  MapDefect defect;
  defect.kind = DefectKind::Crossing;
  defect.edges = edges({{0, 1}});
  defect.near = {1e-5, 3};
  point.defects = {defect};
  expect_sound(drawn(point));
}

TEST(MapSvg, HolesShowTheBackgroundAlsoInDefectiveMaps) {
  MapReport report;  // a square with a square hole, the hole listed first and nothing in it
  for (const Point2 p : {Point2{0, 0}, {9, 0}, {9, 9}, {0, 9}, {3, 3}, {6, 3}, {6, 6}, {3, 6}})
    report.map.points.push_back(p);
  report.map.add_cycle(std::vector<std::uint32_t>{4, 7, 6, 5});
  report.map.add_cycle(std::vector<std::uint32_t>{0, 1, 2, 3});
  report.verdict = MapVerdict::Open;
  std::vector<std::string> fills;
  visit(parsed(drawn(report)), [&fills](const std::string&, const Xml& g) {
    if (attribute(g, "class") != "faces") return;
    for (const auto& [name, path] : g) {
      if (name == "path") fills.push_back(attribute(path, "class"));
    }
  });
  EXPECT_EQ(fills,
            (std::vector<std::string>{"t1", "t9"}));  // the hole over the face, in paper colour
}

TEST(MapSvg, ManyDefectsStayBounded) {
  const std::string svg = drawn(with_defects(20000));
  EXPECT_LT(svg.size(), 8U << 20U);
  EXPECT_NE(svg.find("The map marks the first 5000 of "), std::string::npos);
}

TEST(MapSvg, ManyFacesStayBoundedAndSaySo) {
  MapReport report;
  report.map = grid(700);
  const std::string svg = drawn(report);
  EXPECT_LT(svg.size(), 8U << 20U);
  EXPECT_NE(svg.find("490000 faces too small or too many"), std::string::npos)
      << svg.substr(svg.size() - 600);
}

TEST(MapSvg, SameInputSameBytes) { EXPECT_EQ(drawn(with_defects(300)), drawn(with_defects(300))); }

}  // namespace
}  // namespace plumb::map_svg_test
