// Drawings: what SVG says, what of it is refused, and drawings on surfaces.

#include "plumb/io/svg_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "generate/surface_scenes.h"
#include "oracle/surface_oracle.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/surface/scene_parser.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/surface_audit.h"

namespace plumb::testing::svg_reader_test {
namespace {

const ReadOptions kOptions{"some.file", false};

SvgDrawing read(const std::string& text, std::optional<double> tolerance = {}) {
  Context context;
  return read_svg(text, kOptions, tolerance, context);
}

/// Its origin is that of the file; y is turned back.
SvgDrawing drawn(const std::string& body, std::optional<double> tolerance = .01) {
  SvgDrawing drawing =
      read("<svg xmlns='http://www.w3.org/2000/svg'>" + body + "</svg>", tolerance);
  for (Point2& p : drawing.points) p.y = -p.y;
  return drawing;
}
SvgDrawing path(const std::string& d) { return drawn("<path d='" + d + "'/>"); }

using Ring = std::vector<Point2>;
Ring ring(const SvgDrawing& drawing, std::size_t r) {
  return {drawing.ring(r).begin(), drawing.ring(r).end()};
}

void expect_near(const SvgDrawing& a, const SvgDrawing& b, const std::string& what) {
  EXPECT_EQ(a.shape_begin, b.shape_begin) << what;
  ASSERT_EQ(a.ring_begin, b.ring_begin) << what;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_NEAR(a.points[i].x, b.points[i].x, 1e-12) << what;
    EXPECT_NEAR(a.points[i].y, b.points[i].y, 1e-12) << what;
  }
}

TEST(svg_reader, straight_outlines) {
  const Ring square{{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  for (const char* body :
       {"<rect width='4' height='3'/>", "<polygon points='0,0 4,0 4,3 0,3'/>",
        "<polyline points=' 0 0,4 0,4,3,0 3 '/>", "<path d='M0 0H4V3H0Z'/>",
        "<path d='m0,0h4v3h-4'/>", "<path d='M0,0 4,0 4,3 0,3'/>", "<path d='M0 0L4 0l0 3-4 0z'/>",
        "<path d='M.0.0 4-0 4 3 0 3 0 0'/>", "<svg:rect width='4px' height='3'></svg:rect>",
        "<g><a><rect width='4' height='3' style='fill:red'/></a></g>",
        "<path d='M0e0 0e-5L+4,0\n4 3\t0 3z'/>", "<path d='m0 0 4 0 0 3-4 0z'/>",
        "<path d='M0E0\r\n0E+5 4 0 4 3 0 3z'/>", "<rect width='4' height='3' rx='2' ry='0'/>",
        "<rect width='4' height='3' rx='0' ry='2'/>"}) {
    const SvgDrawing drawing = drawn(body);
    ASSERT_EQ(drawing.ring_count(), 1U) << body;
    EXPECT_EQ(drawing.shape_count(), 1U) << body;
    EXPECT_EQ(ring(drawing, 0), square) << body;
  }
  EXPECT_EQ(ring(drawn("<line x1='1' y1='2' x2='3' y2='5'/>"), 0), (Ring{{1, 2}, {3, 5}}));
}

TEST(svg_reader, shapes_are_elements_and_rings_are_subpaths) {
  const SvgDrawing drawing = drawn(
      "<path d='M0 0h9v9zm1 1h2v2zh5v5z'/><path d=''/><rect width='0' height='2'/><g>"
      "<rect width='2' height='1'/></g><path d='M3 3'/><circle/><rect width='2' height='0'/>"
      "<ellipse rx='1'/><ellipse ry='1'/><polygon/><polyline/><path/>");
  EXPECT_EQ(drawing.shape_begin, (std::vector<std::uint32_t>{0, 3, 4}));
  EXPECT_EQ(ring(drawing, 0), (Ring{{0, 0}, {9, 0}, {9, 9}}));
  EXPECT_EQ(ring(drawing, 1), (Ring{{1, 1}, {3, 1}, {3, 3}}));  // m from where z went back to
  EXPECT_EQ(ring(drawing, 2), (Ring{{1, 1}, {6, 1}, {6, 6}}));  // and again without m
}

TEST(svg_reader, the_same_path_in_other_words) {
  const std::vector<std::array<const char*, 2>> pairs{
      {"M1 2C3 4 5 6 7 1", "m1 2c2 2 4 4 6-1"},
      {"M1 2C3 4 5 6 7 1C9-4 3 3 1 9", "M1 2C3 4 5 6 7 1S3 3 1 9"},
      {"M1 2C1 2 5 6 7 1", "M1 2S5 6 7 1"},
      {"M1 2Q3 9 7 1Q11-7 1 9", "M1 2Q3 9 7 1T1 9"},
      {"M1 2Q1 2 5 3", "M1 2T5 3z"},
      {"M1 2Q3 9 7 1", "m1 2q2 7 6-1"},
      {"M0 0A2 3 20 0 1 3 1", "M0 0a2,3,20,013,1"},
      {"M0 0A-2 3 20 1 0 3 1", "m0 0a2 3 20 10 3 1"},
      {"M0 0A0 3 20 1 0 3 1", "M0 0L3 1"},
      {"M0 0A3 0 20 1 0 3 1", "M0 0L3 1"},
      {"M0 0L3 1L4 2", "M0 0L3 1A1 1 0 0 0 3 1L4 2"},
      // After an arc, whatever its length, there is no control point to reflect.
      {"M0 0C1 2 2 2 3 0A1 1 0 0 0 3 0S4 4 6 0", "M0 0C1 2 2 2 3 0C3 0 4 4 6 0"},
      {"M0 0Q3 9 7 1A1 1 0 0 0 7 1T1 9", "M0 0Q3 9 7 1Q7 1 1 9"},
      // Arcs that are as good as straight.
      {"M0 0A1e9 1e9 0 0 1 3 1", "M0 0L3 1"},
      {"M0 0A1e200 1e200 0 0 1 3 1", "M0 0L3 1"},
      {"M0 0A1e200 1e200 0 0 0 3 1", "M0 0L3 1"},
      {"M0 0A1e300 1e300 0 0 1 1e-300 0 1 1 0 0 1 1e-300 0", "M0 0L1e-300 0"},
      {"M0 0C1 2 2 2 3 0C1 2 2 2 3 5", "M0 0C1 2 2 2 3 0 1 2 2 2 3 5"},
      // A quadratic curve is a cubic one.
      {"M0 0Q3 3 6 0", "M0 0C2 2 4 2 6 0"},
  };
  for (const auto& [a, b] : pairs) {
    const SvgDrawing p = path(a), q = path(b);
    if (std::string(b).find("C2 2 4 2") == std::string::npos) {
      expect_near(p, q, b);
    } else {
      EXPECT_EQ(ring(p, 0).back(), ring(q, 0).back());
    }
  }
}

TEST(svg_reader, transforms_follow_one_another) {
  const std::string in = "<path d='M1 2L7 3L4 9z'/>";
  const auto with = [&](const std::string& transform) {
    return drawn("<g transform='" + transform + "'>" + in + "</g>");
  };
  EXPECT_EQ(ring(with("translate(10, 20)"), 0), (Ring{{11, 22}, {17, 23}, {14, 29}}));
  EXPECT_EQ(ring(with("rotate(90)"), 0), (Ring{{-2, 1}, {-3, 7}, {-9, 4}}));
  EXPECT_EQ(ring(with("scale(2)"), 0), (Ring{{2, 4}, {14, 6}, {8, 18}}));
  EXPECT_EQ(ring(with("matrix(1 2 3 4 5 6)"), 0), (Ring{{12, 16}, {21, 32}, {36, 50}}));
  expect_near(with("rotate(30 5 6)"), with("translate(5,6) rotate(30),translate(-5-6)"), "about");
  expect_near(with("skewX(45)"), with("matrix(1 0 1 1 0 0)"), "skewX");
  expect_near(with("skewY(45)"), with("matrix(1 1 0 1 0 0)"), "skewY");
  expect_near(with("scale(2 3) rotate(20)"),
              drawn("<g transform='scale(2 3)'><g transform='rotate(20)'>" + in + "</g></g>"),
              "nested");
  expect_near(drawn("<g transform='scale(2)'>" + in + "</g>" + in),
              drawn("<path transform='scale(2)' d='M1 2L7 3L4 9z'/>" + in),
              "ended with their group");
}

TEST(svg_reader, the_middle_is_the_origin) {
  const std::string rect = "><rect x='1' y='2' width='4' height='3'/></svg>";
  EXPECT_EQ(ring(read("<svg viewBox='0 0 10 6'" + rect), 0),
            (Ring{{-4, 1}, {0, 1}, {0, -2}, {-4, -2}}));
  EXPECT_EQ(ring(read("<svg width='10' height='6px'" + rect), 0),
            ring(read("<svg viewBox='0 0 10 6' width='9'" + rect), 0));
  for (const char* size : {"width='100%' height='6'", "width='10' height='60%'", "width='10'",
                           "height='6'", "viewBox='0 0 0 0'"}) {
    EXPECT_EQ(ring(read(std::string("<svg ") + size + rect), 0),
              (Ring{{1, -2}, {5, -2}, {5, -5}, {1, -5}}))
        << size;
  }
  EXPECT_EQ(ring(read("<svg viewBox='1,2,4,3' x='9'" + rect), 0),
            (Ring{{-2, 1.5}, {2, 1.5}, {2, -1.5}, {-2, -1.5}}));
}

// ---------------------------------------------------------------- curves

double distance_to_line(Point2 p, Point2 a, Point2 b) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double t = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0., 1.);
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

double distance_to(Point2 p, const Ring& ring) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, distance_to_line(p, ring[i], ring[(i + 1) % ring.size()]));
  }
  return least;
}

/// No point of a curve is further from its chords than the tolerance, and not ten times as many
/// chords are used as that takes.
TEST(svg_reader, curves_keep_within_the_tolerance) {
  for (const double tolerance : {1., .1, .001}) {
    const Ring circle = ring(drawn("<circle cx='3' cy='4' r='20'/>", tolerance), 0);
    EXPECT_LT(circle.size(), 10 + 10 * std::sqrt(20 / tolerance));
    for (int i = 0; i < 1000; ++i) {
      const double t = 2 * std::numbers::pi * i / 1000;
      EXPECT_LT(distance_to({3 + 20 * std::cos(t), 4 + 20 * std::sin(t)}, circle), tolerance);
    }
    for (const Point2& p : circle) EXPECT_NEAR(std::hypot(p.x - 3, p.y - 4), 20, 1e-12);
    const Ring cubic = ring(drawn("<path d='M0 0C90 40-60 50 20-30z'/>", tolerance), 0);
    for (int i = 0; i <= 1000; ++i) {
      const double t = i / 1000., s = 1 - t;
      const Point2 p{270 * s * s * t - 180 * s * t * t + 20 * t * t * t,
                     120 * s * s * t + 150 * s * t * t - 30 * t * t * t};
      EXPECT_LT(distance_to(p, cubic), tolerance);
    }
  }
  // After the transform.
  const Ring large = ring(drawn("<circle r='1' transform='scale(1000)'/>", 1), 0);
  for (int i = 0; i < 1000; ++i) {
    const double t = 2 * std::numbers::pi * i / 1000;
    EXPECT_LT(distance_to({1000 * std::cos(t), 1000 * std::sin(t)}, large), 1);
  }
}

TEST(svg_reader, arcs_lie_on_their_ellipse) {
  for (const bool large : {false, true}) {
    for (const bool sweep : {false, true}) {
      const std::string d =
          std::string("M10 20A30 30 0 ") + (large ? "1 " : "0 ") + (sweep ? "1 " : "0 ") + "40 30";
      const Ring arc = ring(path(d), 0);
      double length = 0, area = 0;
      for (std::size_t i = 0; i < arc.size(); ++i) {
        const Point2 p = arc[i], q = arc[(i + 1) % arc.size()];
        if (i + 1 < arc.size()) length += std::hypot(p.x - q.x, p.y - q.y);
        area += (p.x * q.y - p.y * q.x) / 2;
      }
      const double half = std::asin(std::hypot(30, 10) / 60);
      EXPECT_NEAR(length, 60 * (large ? std::numbers::pi - half : half), .1) << d;
      EXPECT_EQ(area > 0, sweep) << d;  // y downwards: with sweep angles grow
      EXPECT_EQ(arc.front(), (Point2{10, 20}));
      EXPECT_EQ(arc.back(), (Point2{40, 30}));
    }
  }
  // Radii too small for the ends grow until they reach.
  for (const Point2& p : path("M0 0A1 1 0 0 1 20 0").points) {
    EXPECT_NEAR(std::hypot(p.x - 10, p.y), 10, 1e-12);
  }
  const Ring rounded = ring(drawn("<rect width='20' height='10' rx='3'/>"), 0);
  for (const Point2& p : rounded) {
    EXPECT_LT(distance_to(p, {{0, 0}, {20, 0}, {20, 10}, {0, 10}}), 1);
  }
  EXPECT_GT(rounded.size(), 20U);
}

// ---------------------------------------------------------------- what is no drawing

TEST(svg_reader, what_means_nothing) {
  const SvgDrawing drawing = read(
      "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" "
      "\"x.dtd\">"
      "<!-- <rect> --><svg><title>&amp; more</title><style><![CDATA[ <rect/> ]]></style>"
      "<defs><rect width='1' height='1'/></defs><use href='#x'/><text>A<tspan>b</tspan></text>"
      "<rect display='none' width='1' height='1'/>"
      "<other:rect width='1' height='1'/><rect a='&x;' width='1' height='1'/></svg>\n<!---->\n");
  EXPECT_EQ(drawing.shape_count(), 1U);
  EXPECT_EQ(drawing.notes, (std::vector<std::string>{"left out: text",
                                                     "left out: use of what is not in the file"}));
}

/// What cuts shapes, or adds to them, is named once.
TEST(svg_reader, effects_on_outlines_are_noted) {
  const std::string defs =
      "<defs><pattern id='p'><rect width='1' height='1'/></pattern><linearGradient id='l'/></defs>";
  const auto notes = [&](const std::string& attributes) {
    const std::string rect = "<rect width='3' height='4' " + attributes + "/>";
    const SvgDrawing drawing = read("<svg viewBox='0 0 9 9'>" + defs + rect + rect + "</svg>");
    EXPECT_EQ(drawing.shape_count(), 2U);
    return drawing.notes;
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(notes("clip-path='url(#c)'"), Notes{"left out: clip-path"});
  EXPECT_EQ(notes("style='fill:red;mask:url(#m)'"), Notes{"left out: mask"});
  EXPECT_EQ(notes("marker-end='url(#m)'"), Notes{"left out: markers"});
  EXPECT_EQ(notes("style='fill: url(#p)'"),
            Notes{"left out: patterns that fill shapes; the whole shapes are read"});
  EXPECT_EQ(notes("fill='url(#l)' clip-path='none'"), Notes{});
  EXPECT_EQ(notes("fill='url('"), Notes{});
}

/// A switch draws its first element without conditions, as Illustrator writes them.
TEST(svg_reader, a_switch_draws_one_element) {
  const auto points_in = [](const std::string& parts) {
    const SvgDrawing drawing =
        read("<svg viewBox='0 0 9 9'><switch>" + parts + "</switch><circle r='1'/></svg>");
    return std::pair(drawing.shape_count(), drawing.notes);
  };
  const std::string rect = "<rect width='1' height='1'/>";
  const std::string foreign = "<foreignObject requiredExtensions='&ns_ai;'><x/></foreignObject>";
  const std::vector<std::string> none;
  EXPECT_EQ(points_in(rect), std::pair(std::size_t{2}, none));
  EXPECT_EQ(points_in(rect + rect + rect), std::pair(std::size_t{2}, none));
  EXPECT_EQ(points_in(foreign + "<g>" + rect + rect + "</g>" + rect),
            std::pair(std::size_t{3}, none));
  EXPECT_EQ(points_in("<title>t</title>" + rect), std::pair(std::size_t{2}, none));
  EXPECT_EQ(points_in("<switch>" + foreign + rect + "</switch>" + rect),
            std::pair(std::size_t{2}, none));
  EXPECT_EQ(points_in("<rect systemLanguage='de'/>" + rect),
            std::pair(std::size_t{2},
                      std::vector<std::string>{"left out: parts of a switch for a language"}));
  EXPECT_EQ(points_in("<foreignObject/>" + rect),
            std::pair(std::size_t{1}, std::vector<std::string>{"left out: foreignObject"}));
}

/// A use draws what it names as if that stood there, in a group with the transform of the use.
TEST(svg_reader, a_use_places_what_it_names) {
  const auto expect_same = [](const std::string& uses, const std::string& plain) {
    const auto in_box = [](const std::string& shapes) {
      return read("<svg viewBox='0 0 100 100' xmlns:xlink='x'>" + shapes + "</svg>");
    };
    const SvgDrawing a = in_box(uses), b = in_box(plain);
    EXPECT_EQ(a.points, b.points) << uses;
    EXPECT_EQ(a.ring_begin, b.ring_begin) << uses;
    EXPECT_EQ(a.shape_begin, b.shape_begin) << uses;
    EXPECT_EQ(a.is_even_odd, b.is_even_odd) << uses;
    EXPECT_EQ(a.notes, b.notes) << uses;
  };
  const std::string rect = "<rect id='r' x='1' y='2' width='3' height='4'/>";
  const std::string defs = "<defs>" + rect + "<g id='g'>" + rect + "<circle r='5'/></g></defs>";
  const std::string plain_rect = "<rect x='1' y='2' width='3' height='4'/>";
  expect_same(defs + "<use href='#r'/>", plain_rect);
  expect_same(rect + "<use xlink:href='#r' x='10' y='20'/>",
              plain_rect + "<rect x='11' y='22' width='3' height='4'/>");
  expect_same("<use href='#r' transform='scale(2)' x='10' fill-rule='evenodd'/>" + defs,
              "<g transform='scale(2) translate(10 0)' fill-rule='evenodd'>" + plain_rect + "</g>");
  expect_same(defs + "<use id='u' href='#g' x='10'/><use href='#u' y='10'/>",
              "<g transform='translate(10)'>" + plain_rect +
                  "<circle r='5'/></g><g transform='translate(10 10)'>" + plain_rect +
                  "<circle r='5'/></g>");
  expect_same(defs + "<use href='#g' display='none'/><use href='#g' visibility='hidden'/>", "");
  // A symbol is drawn only where it is used; its viewBox fills the box of the use, in the middle.
  const std::string symbol = "<symbol id='s' viewBox='0 0 10 20'>" + rect + "</symbol>";
  expect_same(symbol, "");
  expect_same(symbol + "<use href='#s' x='50' y='50' width='40' height='40'/>",
              "<g transform='translate(60 50) scale(2)'>" + plain_rect + "</g>");
  expect_same(symbol + "<use href='#s'/>",
              "<g transform='translate(25 0) scale(5)'>" + plain_rect + "</g>");
  expect_same("<svg x='7' y='8'>" + rect + "</svg>",
              "<g transform='translate(7 8)'>" + plain_rect + "</g>");
  expect_same("<svg width='40' height='40' viewBox='0 0 10 20' preserveAspectRatio='none'>" + rect +
                  "</svg>",
              "<g transform='scale(4 2)'>" + plain_rect + "</g>");
  expect_same(
      "<svg width='40' height='40' viewBox='0 0 10 20' preserveAspectRatio='xMaxYMin slice'>"
      "<rect width='50%' height='50%'/></svg>",
      "<g transform='scale(4)'><rect width='5' height='10'/></g>");
}

/// Uses of uses are a bomb, and a use that contains itself never ends.
TEST(svg_reader, uses_are_bounded) {
  const auto expect_refused = [](const std::string& text, const std::string& what) {
    try {
      read(text);
      ADD_FAILURE() << what;
    } catch (const Error& error) {
      EXPECT_NE(error.message().find(what), std::string::npos) << error.what();
      EXPECT_GT(error.place().line, 0U);
    }
  };
  expect_refused("<svg><g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g></svg>",
                 "a use of an element that contains it");
  expect_refused("<svg><use id='a' href='#a'/></svg>", "a use of an element that contains it");
  // Each level has ten uses of the next one; the last one is empty, so no point is ever made.
  std::string bomb = "<svg><g id='g0'/>";
  for (int level = 1; level <= 12; ++level) {
    bomb += "<g id='g" + std::to_string(level) + "'>";
    for (int k = 0; k < 10; ++k) bomb += "<use href='#g" + std::to_string(level - 1) + "'/>";
    bomb += "</g>";
  }
  expect_refused(bomb + "</svg>", "uses that place too many elements");
  std::string deep = "<svg><g id='g0'/>";
  for (int level = 1; level <= 100; ++level) {
    deep += "<g id='g" + std::to_string(level) + "'><use href='#g" + std::to_string(level - 1) +
            "'/></g>";
  }
  expect_refused(deep + "</svg>", "uses nested more than 64 deep");
}

/// A drawing without a size has nothing that a percentage is a part of (hostile_drawings()).
TEST(svg_reader, percentages_are_parts_of_the_drawing) {
  const auto in_box = [](const std::string& shape) {
    return read("<svg width='100%' height='100%' viewBox='5 5 300 400'>" + shape + "</svg>");
  };
  const auto expect_same = [&](const std::string& a, const std::string& b) {
    EXPECT_EQ(ring(in_box(a), 0), ring(in_box(b), 0)) << a;
  };
  expect_same("<rect x='10%' y='10%' width='50%' height='25%'/>",
              "<rect x='30' y='40' width='150' height='100'/>");
  expect_same("<line x1='1%' y1='1%' x2='100%' y2='100%'/>",
              "<line x1='3' y1='4' x2='300' y2='400'/>");
  expect_same("<ellipse cx='50%' cy='50%' rx='10%' ry='10%'/>",
              "<ellipse cx='150' cy='200' rx='30' ry='40'/>");
  // The radius of a circle is a part of the diagonal, divided by the root of 2.
  const Ring circle = ring(in_box("<circle r='10%'/>"), 0);
  const auto [left, right] = std::ranges::minmax(circle, {}, &Point2::x);
  EXPECT_NEAR(right.x - left.x, 2 * 500 / std::sqrt(2.) / 10, 1);
}

TEST(svg_reader, hidden_shapes_are_left_out) {
  const std::string shape = "<rect width='1' height='1'/>";
  for (const std::string hides :
       {"display='none'", "style='display:none'", "style='fill:red; display : none ;'",
        "style='display:none !important'", "visibility='hidden'", "style='visibility:collapse'",
        "display='inline' style='display:none'"}) {
    EXPECT_EQ(drawn("<g " + hides + ">" + shape + "</g>" + shape).shape_count(), 1U) << hides;
    EXPECT_EQ(drawn("<g><rect width='1' height='1' " + hides + "/></g>").shape_count(), 0U);
  }
  for (const std::string shows :
       {"display='inline'", "style='display:inline'", "style='-x-display:none'",
        "display='none' style='display:inline'", "style='fill:url(#none)'"}) {
    EXPECT_EQ(drawn("<g " + shows + ">" + shape + "</g>").shape_count(), 1U) << shows;
  }
  // Visibility is inherited, and display is not.
  const std::string visible = "<rect style='visibility:visible' width='1' height='1'/>";
  EXPECT_EQ(drawn("<g visibility='hidden'><g>" + shape + visible + "</g></g>").shape_count(), 1U);
}

// Style sheets decide before attributes and after the attribute style, wherever they stand.
TEST(svg_reader, style_sheets_apply_to_the_whole_drawing) {
  const auto shapes = [](const std::string& attributes, const std::string& sheet) {
    const std::string rect = "<rect width='1' height='1' " + attributes + "/>";
    const std::size_t before =
        drawn("<defs><style>" + sheet + "</style></defs>" + rect).shape_count();
    EXPECT_EQ(drawn(rect + "<svg:style type='text/css'><![CDATA[" + sheet + "]]></svg:style>")
                  .shape_count(),
              before);
    return before;
  };
  EXPECT_EQ(shapes("class='a b'", ".b{display:none}"), 0U);
  EXPECT_EQ(shapes("class='a b'", ".c{display:none}"), 1U);
  EXPECT_EQ(shapes("id='x'", "#x{visibility:hidden}"), 0U);
  EXPECT_EQ(shapes("display='none'", "rect{display:inline}"), 1U);
  EXPECT_EQ(shapes("style='display:inline'", "rect{display:none}"), 1U);
  EXPECT_EQ(shapes("style='display:inline'", "rect{display:none !important}"), 0U);
  EXPECT_EQ(shapes("style='display:inline!important'", "rect{display:none!important}"), 1U);
  EXPECT_EQ(shapes("class='a'", ".A{display:none} .a{display:NONE}"), 0U);
  EXPECT_EQ(
      drawn("<style>svg{display:none}</style><g><rect width='1' height='1'/></g>").shape_count(),
      0U);
  const SvgDrawing drawing = drawn(
      "<style>.e{fill-rule:evenodd}</style><g class='e'><rect width='1' height='1'/></g>"
      "<rect width='1' height='1'/><style media='print'>rect{display:none}</style>");
  EXPECT_EQ(drawing.is_even_odd, (std::vector<std::uint8_t>{1, 0}));
  EXPECT_TRUE(drawing.notes.empty());
  for (const std::string child : {">", "&gt;", "&#62;", "&#x03E;"}) {
    const SvgDrawing kept =
        drawn("<style>.a{fill:red}</style><style>g " + child +
              " .b{display:none}</style><rect class='b' width='1' height='1'/>");
    EXPECT_EQ(kept.shape_count(), 1U) << child;
    EXPECT_EQ(kept.notes, (std::vector<std::string>{
                              "a rule of the style sheet is not applied: 'g > .b' sets display"}))
        << child;
  }
}

/// Old versions of Illustrator declare entities for name spaces.
TEST(svg_reader, declarations_of_entities_are_skipped) {
  const std::string type =
      "<!DOCTYPE svg PUBLIC 'a' 'b' [\n<!-- ]>' -->\n<!ENTITY ns_svg \"http://[x]>\">\n] >\n";
  const SvgDrawing drawing = read(type +
                                  "<svg xmlns='&ns_svg;'><title>&amp;&#65;</title>"
                                  "<rect width='1' height='1'/></svg>");
  EXPECT_EQ(drawing.shape_count(), 1U);
}

TEST(svg_reader, declared_encodings_of_single_bytes) {
  const std::string body =
      "<svg><!-- Gr\xF6\xDF"
      "e --><rect id='\xFC' width='1' height='1'/></svg>";
  for (const std::string encoding : {"ISO-8859-1", "iso-8859-15", "windows-1252"}) {
    EXPECT_EQ(read("<?xml version='1.0' encoding='" + encoding + "'?>" + body).shape_count(), 1U);
  }
  EXPECT_THROW(read("<?xml version='1.0' encoding='UTF-8'?>" + body), Error);
  EXPECT_THROW(read("<?xml version='1.0'?>" + body), Error);
}

std::vector<HostileText> hostile_drawings() {
  const std::string open = "<svg>\n", close = "</svg>";
  const auto element = [&](const std::string& text) { return open + text + close; };
  return {
      {"empty", "", 1, 1, "no content"},
      {"blank", "\n \n", 3, 1, "no content"},
      {"no markup", "hello", 1, 1, "text outside"},
      {"not text", std::string("<svg>\n \xff</svg>"), 2, 2, "no text"},
      {"utf-16", bytes_with_nul("<\0s\0", 4), 1, 2, "no text"},
      {"other root", "<html/>", 1, 1, "'html', not svg"},
      {"not ended", open, 2, 1, "'svg' is not ended"},
      {"cut off", "<svg", 1, 1, "without an end"},
      {"ended otherwise", element("<g></h>"), 2, 6, "expected the end of 'g'"},
      {"end without a start", "<svg/></g>", 1, 9, "end without a start"},
      {"two roots", "<svg/>\n<svg/>", 2, 1, "second root"},
      {"text after", "<svg/> x", 1, 8, "text outside"},
      {"no quotes", element("<rect x=1/>"), 2, 9, "quotes"},
      {"no value", element("<rect x/>"), 2, 8, "'='"},
      {"quote not closed", element("<rect x='1/>"), 2, 9, "closing quote"},
      {"no blank between", element("<rect x='1'y='2'/>"), 2, 12, "blank"},
      {"given twice", element("<rect x='1' x='2'/>"), 2, 13, "given twice"},
      {"comment not ended", element("<!-- "), 2, 1, "a comment without an end"},
      {"entities", "<!DOCTYPE svg [\n<!ENTITY a 'aaaa'>]><svg>&a;</svg>", 2, 26, "not expanded"},
      {"an entity as style", "<!DOCTYPE svg [<!ENTITY a ''>]>\n<svg>\n<g style='&a;'/></svg>", 3,
       11, "not expanded"},
      {"a type without an end", "<!DOCTYPE svg [<!ENTITY a ']>\n<svg/>", 1, 1, "without an end"},
      {"a type that goes on", "<!DOCTYPE svg [] x><svg/>", 1, 1, "without an end"},
      {"late type", "<svg><!DOCTYPE svg></svg>", 1, 6, "in the middle"},
      {"nested", repeated("<svg>", 257), 1, 5 * 256 + 1, "nested more than 256"},
      {"attributes", "<svg>\n<g " + repeated("a='' ", 4097) + "/></svg>", 2, 1, "4096 attributes"},
      {"skipped and nested", "<svg>" + repeated("<x>", 100000), 1, 5 + 3 * 255 + 1, "nested"},
      {"a reference in a number", element("<rect x='&#49;'/>"), 2, 10, "expected a number"},
      {"percent", element("<rect x='5%'/>"), 2, 11, "px, in, cm"},
      {"em", element("<rect x='5em'/>"), 2, 11, "px, in, cm"},
      {"no number", element("<rect\nx='five'/>"), 3, 4, "expected a number"},
      {"two numbers", element("<rect x='5 6'/>"), 2, 12, "end of the value"},
      {"a comma more", element("<polygon points='1,2,'/>"), 2, 22, "after the comma"},
      {"half a point", element("<polygon points='1,2 3'/>"), 2, 23, "expected a number"},
      {"negative", element("<rect width='-5' height='1'/>"), 2, 14, "negative"},
      {"negative radius", element("<circle r='-5'/>"), 2, 12, "negative"},
      {"negative box", "<svg viewBox='0 0 -1 1'/>", 1, 1, "negative size"},
      {"a box of negative height", "<svg viewBox='0 0 1 -1'/>", 1, 1, "negative size"},
      {"short box", "<svg viewBox='0 0 1'/>", 1, 20, "expected a number"},
      {"too large", element("<rect x='1e999'/>"), 2, 10, "1e999"},
      {"a whole number too large", element("<rect x='" + repeated("9", 400) + "'/>"), 2, 10,
       "beyond the largest double"},
      {"a length too large", element("<rect x='1e308in'/>"), 2, 17, "a length beyond"},
      {"a length and a comma", element("<rect x='5,'/>"), 2, 12, "after the comma"},
      {"an exponent alone", element("<polygon points='1,2e'/>"), 2, 21, "expected a number"},
      {"no name", element("<>"), 2, 2, "expected"},
      {"type not ended", "<!DOCTYPE svg", 1, 1, "a document type without an end"},
      {"too large together",
       element("<g transform='scale(1e200)'><rect x='1e200' width='1' height='1'/></g>"), 2, 29,
       "beyond the largest double"},
      {"too many digits", element("<rect x='" + repeated("9", 100000) + "'/>"), 2, 10, "digits"},
      {"no M", element("<path d='L1 2'/>"), 2, 10, "begin with M"},
      {"numbers first", element("<path d='1 2'/>"), 2, 10, "a command"},
      {"numbers after z", element("<path d='M1 2z3'/>"), 2, 15, "a command"},
      {"no such command", element("<path d='M1 2X3'/>"), 2, 14, "no command"},
      {"a bracket", element("<path d='M1 2[3'/>"), 2, 14, "expected a number"},
      {"a brace", element("<path d='M1 2{3'/>"), 2, 14, "expected a number"},
      {"a comma before a command", element("<path d='M1 2,L3 4'/>"), 2, 15,
       "a number after the comma"},
      {"an arc too large", element("<path d='M0 0A1e-300 1 0 0 1 1e300 0'/>"), 2, 14,
       "an arc beyond the largest double"},
      {"cut path", element("<path d='M1 2C3 4 5'/>"), 2, 20, "expected a number"},
      {"bad flag", element("<path d='M1 2A3 4 5 2 0 1 1'/>"), 2, 21, "a flag"},
      {"path in two lines", element("<path d='M1 2\nL3 x'/>"), 3, 4, "expected a number"},
      {"no such transform", element("<g transform='turn(3)'/>"), 2, 15, "expected matrix"},
      {"no word", element("<g transform='{3}'/>"), 2, 15, "expected"},
      {"no word again", element("<g transform='[3]'/>"), 2, 15, "expected"},
      {"a comma before numbers", element("<g transform='scale(,3)'/>"), 2, 22, "a number"},
      {"too few", element("<g transform='matrix(3)'/>"), 2, 15, "expected matrix"},
      {"too many", element("<g transform='matrix(1 2 3 4 5 6 7)'/>"), 2, 34, "expected ')'"},
      {"a comma after transforms", element("<g transform='scale(2),'/>"), 2, 24, "after the comma"},
      {"two commas", element("<g transform='scale(2),,scale(3)'/>"), 2, 24, "expected '('"},
      {"CDATA first", "<![CDATA[ ]]><svg/>", 1, 1, "outside of the root"},
      {"CDATA last", "<svg/>\n<![CDATA[]]>", 2, 1, "outside of the root"},
      {"not closed", element("<g transform='scale(3'/>"), 2, 22, "expected ')'"},
      {"a curve of what size", element("<circle r='3'/>"), 2, 1, "give a tolerance"},
      {"too many points", "<svg viewBox='0 0 1e-300 1'><circle r='1e300'/></svg>", 1, 29,
       "a larger tolerance"},
      {"points of 75 bytes",
       "<svg viewBox='0 0 1e-9 1e-9'>\n<path d='M0 0C9e3 9e3 9e3 9e3 9e3 0'/></svg>", 2, 35,
       "a larger tolerance"},
      {"points of many curves",
       "<svg viewBox='0 0 1 1'>\n<g>" + repeated("<path d='M0 0C2e7 2e7 2e7 2e7 2e7 0'/>", 100) +
           "</g></svg>",
       2, 38 * (1 + 7), "a larger tolerance"},
  };
}

TEST(svg_reader, refuses_with_places) {
  expect_refusals(hostile_drawings(), [](const std::string& text) { read(text); });
}

TEST(svg_reader, memory_is_limited) {
  Limits limits;
  limits.max_memory_bytes = 200'000;
  Context context(limits);
  try {
    read_svg("<svg>\n<circle r='1000'/></svg>", kOptions, 1e-6, context);
    ADD_FAILURE() << "read beyond the limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    EXPECT_EQ(error.place().line, 2U);
  }
}

/// How often the time is looked at.
int checkpoints(const std::string& text) {
  int count = 0;
  Context context({}, {}, [&](std::string_view, std::uint64_t done, std::uint64_t total) {
    count += done == total ? 1 : 0;
  });
  read_svg(text, kOptions, {}, context);
  return count;
}

/// A value may be as long as the file, and a file may have no tag for long.
TEST(svg_reader, time_is_limited_within_values) {
  const std::string open = "<svg viewBox='0 0 9 9'>", close = "</svg>";
  const int few = checkpoints(open + "<path d='M0 0h1v1'/>" + close);
  for (const std::string& text :
       {open + "<path d='M0 0" + repeated("h1", 5000) + "'/>" + close,
        open + "<path d='M0 0" + repeated("z", 5000) + "'/>" + close,
        open + "<path d='M0 0C9e5 9e5 9e5 9e5 9e5 0'/>" + close,
        open + "<polygon points='" + repeated("1 ", 10000) + "'/>" + close,
        open + "<g transform='" + repeated("scale(1)", 5000) + "'/>" + close,
        open + repeated("<!---->", 2000) + close, "<svg " + repeated("a='' ", 2000) + "/>"}) {
    EXPECT_GT(checkpoints(text), few) << text.substr(0, 60);
  }
}

/// Places where the text is looked at piece by piece fall into its characters.
TEST(svg_reader, characters_of_every_length_anywhere) {
  for (const std::string character : {"a", "\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "\n"}) {
    for (std::size_t shift = 0; shift < 6; ++shift) {
      const std::string text = std::string(shift, ' ') + "<svg>" + repeated(character, 70000);
      EXPECT_EQ(read(text + "</svg>").shape_count(), 0U);
      const std::size_t line = character == "\n" ? 70001 : 1;
      const std::size_t column = character == "\n" ? 1 : text.size() + 1;
      expect_refusals({{"cut", text + "\xF0\x9F", line, column, "no text"},
                       {"control", text + "\x01</svg>", line, column, "no text"}},
                      [](const std::string& t) { read(t); });
    }
  }
  for (std::size_t at = (1U << 16U) - 8; at < (1U << 16U) + 8; ++at) {
    const std::string text = "<svg>" + std::string(at - 5, ' ');
    expect_refusals({{"byte", text + "\xF0 </svg>", 1, at + 1, "no text"}},
                    [](const std::string& t) { read(t); });
  }
}

// ---------------------------------------------------------------- on surfaces

/// A grid of 8 x 8 squares with drawings on it, from files.
class DrawingScene : public ::testing::Test {
 protected:
  DrawingScene()
      : folder_(std::filesystem::temp_directory_path() /
                ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::create_directories(folder_);
    std::ofstream model(folder_ / "grid.off");
    model << "OFF\n81 128 0\n";
    for (int i = 0; i < 81; ++i) model << i % 9 << ' ' << i / 9 << " 0\n";
    for (int i = 0; i < 72; ++i) {
      if (i % 9 < 8)
        model << "3 " << i << ' ' << i + 1 << ' ' << i + 10 << "\n3 " << i << ' ' << i + 10 << ' '
              << i + 9 << '\n';
    }
  }
  ~DrawingScene() override { std::filesystem::remove_all(folder_); }

  SceneFile scene(const std::string& svg, const std::string& drawing,
                  const std::string& more = "") {
    std::ofstream(folder_ / "a.svg") << svg;
    std::ofstream(folder_ / "a.json")
        << R"({"model": "grid.off", )" + more + R"("svg": {"file": "a.svg", )" + drawing + "}}";
    return read_scene_file((folder_ / "a.json").string(), {}, context_);
  }

  std::filesystem::path folder_;
  Context context_;
};

/// Face 2 (8 * 3 + 4) at (.5, .25) is (4.5 + .25, 3.25).
constexpr const char* kPlace = R"("center": [56, 0.5, 0.25], "scale": 0.5)";

/// Where a point lies on a mesh in the plane.
RationalPoint2 exact_position(const SurfacePointTable& points, SurfacePointId p, FaceId f) {
  const SurfaceMesh& mesh = points.mesh();
  const Point3 &a = mesh.point(mesh.corner(f, 0)), &b = mesh.point(mesh.corner(f, 1)),
               &c = mesh.point(mesh.corner(f, 2));
  const RationalPoint2 w = points.exact_in(p, f);
  return {Rational(a.x) + w.x * Rational(b.x - a.x) + w.y * Rational(c.x - a.x),
          Rational(a.y) + w.x * Rational(b.y - a.y) + w.y * Rational(c.y - a.y)};
}

/// The corners lie exactly where the similarity puts them; with what is traced between them given,
/// the plane gives the same answers.
TEST_F(DrawingScene, OnFlatMeshesItIsASimilarity) {
  const SceneFile file = scene(
      "<svg viewBox='0 0 10 10'><path d='M1 1h4v3h-4z M2 2v1h2v-1z'/>"
      "<rect x='3' y='3' width='5' height='4'/><path d='M1 9L6 2 8 8z'/></svg>",
      kPlace);
  const std::vector<std::vector<Point2>> rings{{{1, 1}, {5, 1}, {5, 4}, {1, 4}},
                                               {{2, 2}, {2, 3}, {4, 3}, {4, 2}},
                                               {{3, 3}, {8, 3}, {8, 7}, {3, 7}},
                                               {{1, 9}, {6, 2}, {8, 8}}};
  const SurfacePolygons& polygons = file.scene.polygons;
  ASSERT_EQ(polygons.size(), rings.size());
  FlatScene flat{8, 8, {}};
  for (std::size_t p = 0; p < rings.size(); ++p) {
    auto& polygon = flat.polygons.emplace_back();
    std::size_t corner = 0;
    for (std::uint32_t i = polygons.begin[p]; i < polygons.begin[p + 1]; ++i) {
      polygon.push_back(exact_position(polygons.points, polygons.point[i], polygons.face[i]));
      if (polygons.is_control[i] == 0) continue;
      const Point2 at = rings[p][corner++];
      EXPECT_EQ(polygon.back().x, Rational(4.75 + (at.x - 5) / 2));
      EXPECT_EQ(polygon.back().y, Rational(3.25 - (at.y - 5) / 2));
    }
    EXPECT_EQ(corner, rings[p].size());
  }
  EXPECT_EQ(disagreement_on_plane(flat, 0), "");
  SurfaceDrawing expected(grid_mesh(8, 8));
  for (const auto& polygon : flat.polygons) expected.add_flat_polygon(polygon);
  expected.scene.shapes = {{0, 1}, {2}, {3}};
  ASSERT_EQ(file.scene.shapes, expected.scene.shapes);
  const SurfaceDivision a(file.scene, context_), b(expected.scene, context_);
  EXPECT_EQ(audit(a).value_or(""), "");
  EXPECT_EQ(a.cell_count(), b.cell_count());
  EXPECT_EQ(a.counts().crossings, b.counts().crossings);
  for (const char* text : {"A", "B", "C", "A + B - C", "A * B", "A - B", "A ^ B ^ C"}) {
    const SetExpression e = parse_set_expression(text);
    EXPECT_NEAR(a.evaluate(e, WindingRule::EvenOdd).region.area,
                b.evaluate(e, WindingRule::EvenOdd).region.area, 1e-12)
        << text;
  }
  EXPECT_NEAR(a.evaluate(parse_set_expression("A"), WindingRule::EvenOdd).region.area,
              (12 - 2) / 4., 1e-12);
}

/// Seen from outside the drawing is upright: clockwise in it, with y downwards, is clockwise on the
/// surface.
TEST_F(DrawingScene, IsNotMirrored) {
  const SceneFile file = scene("<svg><rect width='2' height='2'/></svg>", kPlace);
  const SurfaceDivision division(file.scene, context_);
  for (std::uint32_t c = 0; c < division.cell_count(); ++c) {
    if (division.area(CellId(c)) < 2) {
      EXPECT_EQ(division.labels(CellId(c))[0].value, -1);
    }
  }
  const Point3 corner = file.scene.polygons.points.position(file.scene.polygons.point[0]);
  EXPECT_EQ(corner, (Point3{4.75, 3.25, 0}));
}

/// On closed surfaces, too, the inside of a drawing is what lies within.
TEST(Drawings, InsideIsWithin) {
  const auto mesh = sphere_mesh(6);
  const std::string svg =
      "<svg viewBox='0 0 2 2'><rect width='1' height='1'/><path d='M0 0v1h1v-1z'/>"
      "<path d='M0 0h1v1h-2v1h1z'/></svg>";
  for (const std::string more : {"", R"(, "levels": [[0, 0, 0]])"}) {
    const std::string text =
        R"({"model": "m", "svg": {"file": "f", "center": [40, 0.2, 0.3], "scale": 0.2})" + more +
        "}";
    Context context;
    const DrawingFile drawing{"f", svg, read_svg(svg, kOptions, {}, context)};
    const SurfaceScene scene = make_scene(parse_scene(text, kOptions, context), mesh, text,
                                          kOptions, context, std::array{&drawing});
    const SurfaceDivision division(scene, context);
    for (const auto& [name, area] : {std::pair("A", .04), {"B", .04}, {"C", .04 + .04}}) {
      const double found =
          division.evaluate(parse_set_expression(name), WindingRule::EvenOdd).region.area;
      EXPECT_NEAR(found, area, .2 * area) << name << more;
    }
  }
}

TEST_F(DrawingScene, BesidePolygonsAndTwice) {
  SceneFile file = scene(
      "<svg><rect width='2' height='2'/><circle r='1'/></svg>",
      R"("center": [56, 0.5, 0.25], "scale": 0.5, "angle": 90, "tolerance": 0.01)",
      R"("points": [[0, 0.5, 0.1], [2, 0.5, 0.1], [40, 0.5, 0.1]], "polygons": [[0, 1, 2]], "levels": [[2, 0, 0]], )");
  EXPECT_EQ(file.scene.shapes, (std::vector<std::vector<std::uint32_t>>{{0}, {1}, {2}}));
  EXPECT_THROW(
      scene("<svg><use/><rect width='2' height='2'/></svg>", kPlace, R"("levels": [[1, 0, 0]], )"),
      Error);
  file =
      scene("<svg><use/><rect width='2' height='2'/></svg>", kPlace, R"("levels": [[0, 0, 0]], )");
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_NE(file.notes[0].find("a.svg: left out: use"), std::string::npos);
  std::ofstream(folder_ / "b.json")
      << R"({"svg": [{"scale": 1, "center": [0, 0.5, 0.25], "file": "a.svg"},
                     {"file": "a.svg", "x": [{}], "center": [56, "1/3", "1/3"], "scale": 1e-3}], "model": "grid.off"})";
  EXPECT_THROW(read_scene_file((folder_ / "b.json").string(), {}, context_),
               Error);  // beyond the border
  std::ofstream(folder_ / "b.json")
      << R"({"svg": [{"scale": 1, "center": [68, 0.5, 0.25], "file": "a.svg"},
                     {"file": "a.svg", "x": [{}], "center": [56, "1/3", "1/3"], "scale": 1e-3}], "model": "grid.off"})";
  file = read_scene_file((folder_ / "b.json").string(), {}, context_);
  EXPECT_EQ(file.scene.shapes->size(), 2U);
  EXPECT_EQ(file.notes.size(), 1U);  // read once
}

TEST_F(DrawingScene, RefusedAtPlacesOfTheDrawing) {
  const auto expect = [&](const std::string& svg, const std::string& how, ErrorCode code,
                          const std::string& name, std::size_t line, std::size_t column) {
    try {
      scene(svg, how);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      EXPECT_EQ(error.place().file, (folder_ / name).string()) << error.what();
      EXPECT_EQ(error.place().line, line) << error.what();
      EXPECT_EQ(error.place().column, column) << error.what();
    }
  };
  const std::string wide = "<svg>\n<path d='M0 0\nL 1 1 100 1 2 2'/></svg>";
  expect(wide, kPlace, ErrorCode::BadShape, "a.svg", 3, 11);
  const std::string far = "<svg>\n<path d='M0 0\nL 1 1 1e300 1 2 2'/></svg>";
  expect(far, kPlace, ErrorCode::ResourceLimit, "a.svg", 3, 13);
  expect("<svg>\n<g></svg>", kPlace, ErrorCode::Syntax, "a.svg", 2, 6);
  const std::string good = "<svg/>";
  const std::string head = R"({"model": "grid.off", "svg": {"file": "a.svg", )";
  const auto at = [&](const std::string& how) { return head.size() + how.find('@') + 1; };
  const auto bad = [&](std::string how, ErrorCode code) {
    const std::size_t column = at(how);
    how.erase(how.find('@'), 1);
    expect(good, how, code, "a.json", 1, column);
  };
  bad(R"("center": [56, 0.5, 0.25], "scale": @0)", ErrorCode::BadShape);
  bad(R"("center": [56, 0.5, 0.25], "scale": @"1")", ErrorCode::Syntax);
  bad(R"("center": [56, 0.5, 0.25], "scale": 1, "tolerance": @-1)", ErrorCode::BadShape);
  bad(R"("center": [56, 0.5, 0.25], "scale": 1, @"scale": 1)", ErrorCode::Syntax);
  bad(R"("center": @[56, 0.5, 0.75], "scale": 1)", ErrorCode::BadShape);
  bad(R"("center": @[999, 0.5, 0.25], "scale": 1)", ErrorCode::BadIndex);
  bad(R"("center": [56, 0.5@], "scale": 1)", ErrorCode::Syntax);
  bad(R"("center": @7, "scale": 1)", ErrorCode::Syntax);
  bad(R"("center": [@[1]], "scale": 1)", ErrorCode::Syntax);
  bad(R"("angle": @true)", ErrorCode::Syntax);
  bad(R"("angle": @{})", ErrorCode::Syntax);
  bad(R"("angle": @[1])", ErrorCode::Syntax);
  bad(R"("angle": @"x")", ErrorCode::Syntax);
  bad(R"("center": [56, 0.5, 0.25], "scale": @)" + std::string(400, '9'),
      ErrorCode::NumberOutOfRange);
  const auto refuse = [&](const std::string& drawings, std::size_t column) {
    std::ofstream(folder_ / "b.json") << R"({"model": "grid.off", "svg": )" << drawings << "}";
    try {
      read_scene_file((folder_ / "b.json").string(), {}, context_);
      ADD_FAILURE() << drawings;
    } catch (const Error& error) {
      EXPECT_EQ(error.place().column, column + 30) << error.what();
    }
  };
  refuse(R"(7)", 0);
  refuse(R"([7])", 1);
  refuse(R"([[]])", 1);
  refuse(R"("a.svg")", 0);
  refuse(R"({"file": 7})", 9);
  refuse(R"({"file": ["a.svg"]})", 9);
  refuse(R"({"file": ""})", 9);
  refuse(R"([{"file": "a.svg", "center": [56, 0.5, 0.25]}])", 1);
  refuse(R"({"file": "a.svg", "scale": 1})", 0);
  refuse(R"({"center": [56, 0.5, 0.25], "scale": 1})", 0);
}

/// Without a word of the scene the label is zero far from the drawing: with one for the component,
/// it is not said twice.
TEST_F(DrawingScene, ZeroIsFarAwayUnlessTheSceneSaysMore) {
  const std::string triangle = "<svg><path d='M0 0L1 0L0 1z'/></svg>";
  const SceneFile plain = scene(triangle, kPlace);
  ASSERT_EQ(plain.scene.levels.size(), 1U);
  EXPECT_EQ(plain.scene.levels[0].label, 0);
  const SceneFile outside = scene(triangle, kPlace, R"("outside": 3, )");
  EXPECT_EQ(outside.scene.levels.size(), 0U);
  EXPECT_EQ(outside.scene.outside, FaceId(3));
  const SceneFile level = scene(triangle, kPlace, R"("shapes": [[]], "levels": [[0, 3, 2]], )");
  EXPECT_EQ(level.scene.levels.size(), 2U) << "of the shape that is given, and of the drawing";
  for (const char* far : {R"("outside": 999, )", R"("shapes": [[]], "levels": [[0, 999, 2]], )"}) {
    EXPECT_THROW(scene(triangle, kPlace, far), Error) << far;
  }
}

}  // namespace
}  // namespace plumb::testing::svg_reader_test
