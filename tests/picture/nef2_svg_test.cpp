// Pictures of sets: what is filled, solid, dashed, dotted; laws between a set and its complement.
#include "plumb/picture/nef2_svg.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <stop_token>

#include "plumb/convex/plane_partition.h"
#include "plumb/picture/plane/plane_view.h"
#include "plumb/picture/plane_scene.h"
#include "plumb/predicates/error.h"
#include "svg_checks.h"

namespace plumb::nef2_svg_test {
namespace {

using namespace testing;

RationalPoint2 at(Rational x, Rational y) { return {std::move(x), std::move(y)}; }

Nef2 half_plane(int a, int b, int c, Boundary boundary) {
  return Nef2::half_plane(Line2::from_coefficients(a, b, c), boundary);
}

Nef2 triangle(Boundary boundary) {
  return Nef2::polygon(std::vector<Point2>{{0, 0}, {5, 0}, {0, 5}}, boundary);
}

/// What a picture consists of.
struct Seen {
  double filled = 0;  ///< area, picture units; rings that lie in others count negative
  double solid = 0;   ///< length
  double dashed = 0;
  std::size_t dots = 0;
  std::size_t hollow = 0;
  double frame_width = 0, frame_height = 0;
};

double area(const std::vector<Point2>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 p = ring[i], q = ring[(i + 1) % ring.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum / 2;
}

double length(const std::string& data) {
  double sum = 0;
  for (const auto& path : read_path(data)) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      sum += std::hypot(path[i].x - path[i + 1].x, path[i].y - path[i + 1].y);
  }
  return sum;
}

bool is_in_legend(const Xml& group) { return attribute(group, "transform").starts_with("trans"); }

void see(const Xml& tree, Seen& seen) {
  for (const auto& [name, e] : tree) {
    const std::string css = attribute(e, "class");
    if (name == "g" && is_in_legend(e)) continue;
    if (css == "inside") {
      for (const auto& ring : read_path(attribute(e, "d"))) seen.filled -= area(ring);  // y down
    }
    if (css == "edge") seen.solid += length(attribute(e, "d"));
    if (css == "edge open") seen.dashed += length(attribute(e, "d"));
    seen.dots += css == "dot" ? 1 : 0;
    seen.hollow += css == "hollow" ? 1 : 0;
    if (css == "panel") {
      seen.frame_width = std::stod(attribute(e, "width"));
      seen.frame_height = std::stod(attribute(e, "height"));
    }
    see(e, seen);
  }
}

std::string drawn(const Nef2& set, const Nef2SvgOptions& options = {}) {
  std::ostringstream out;
  write_nef2_svg(out, set, options);
  return out.str();
}

Seen seen(const Nef2& set) {
  const std::string svg = drawn(set);
  expect_sound(svg);
  Seen seen;
  see(parsed(svg), seen);
  return seen;
}

TEST(Nef2Svg, SimpleSetsShowWhatTheyAre) {
  const Nef2 origin = Nef2::point(at(0, 0));
  struct Case {
    const char* name;
    Nef2 set;
    bool is_filled, has_solid, has_dashed;
    std::size_t dots, hollow;
  };
  const Case cases[] = {
      {"empty", Nef2::empty(), false, false, false, 0, 0},
      {"plane", Nef2::whole(), true, false, false, 0, 0},
      {"line", Nef2::line({at(0, 0), at(1, 2)}), false, true, false, 0, 0},
      {"plane without a line", !Nef2::line({at(0, 0), at(1, 2)}), true, false, true, 0, 0},
      {"closed half-plane", half_plane(1, 0, -3, Boundary::Closed), true, true, false, 0, 0},
      {"open half-plane", half_plane(1, 0, -3, Boundary::Open), true, false, true, 0, 0},
      {"point", origin, false, false, false, 1, 0},
      {"plane without a point", !origin, true, false, false, 0, 1},
      {"closed ray", Nef2::ray({at(0, 0), at(1, 1)}, Boundary::Closed), false, true, false, 1, 0},
      {"open ray", Nef2::ray({at(0, 0), at(1, 1)}, Boundary::Open), false, true, false, 0, 1},
      {"closed triangle", triangle(Boundary::Closed), true, true, false, 0, 0},
      {"open triangle", triangle(Boundary::Open), true, false, true, 0, 3},
      {"triangle without a corner", triangle(Boundary::Closed) - origin, true, true, false, 0, 1},
      {"open triangle with a corner", triangle(Boundary::Open) + origin, true, false, true, 1, 2},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Seen s = seen(c.set);
    EXPECT_EQ(s.filled > 1, c.is_filled);
    EXPECT_EQ(s.solid > 1, c.has_solid);
    EXPECT_EQ(s.dashed > 1, c.has_dashed);
    EXPECT_EQ(s.dots, c.dots);
    EXPECT_EQ(s.hollow, c.hollow);
  }
}

TEST(Nef2Svg, ASetAndItsComplementFillTheFrame) {
  const Nef2 wedge = half_plane(1, 0, 0, Boundary::Closed) * half_plane(1, 3, -2, Boundary::Open);
  const Nef2 strip =
      half_plane(2, -1, 0, Boundary::Closed) - half_plane(2, -1, 7, Boundary::Closed);
  for (const Nef2& set : {wedge, strip, wedge + triangle(Boundary::Open), strip ^ wedge}) {
    const Seen a = seen(set), b = seen(!set);
    const double frame = a.frame_width * a.frame_height;
    EXPECT_NEAR(a.filled + b.filled, frame, 1e-3 * frame);
    EXPECT_NEAR(a.solid, b.dashed, 1);
    EXPECT_NEAR(a.dashed, b.solid, 1);
    EXPECT_EQ(a.dots, b.hollow);
  }
}

TEST(Nef2Svg, AreasAreToScale) {
  const std::vector<Point2> outer = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
  const std::vector<Point2> inner = {{2, 2}, {4, 2}, {4, 3}, {2, 3}};
  const double whole = seen(Nef2::polygon(outer)).filled;
  const double hollow = seen(Nef2::polygon(outer) - Nef2::polygon(inner)).filled;
  EXPECT_NEAR(hollow / whole, 58.0 / 60.0, 1e-3);
}

TEST(Nef2Svg, LargePolygonsGetNoDots) {
  std::vector<Point2> star;
  for (int i = 0; i < 20000; ++i) {
    const double angle = i * std::numbers::pi / 10000, r = i % 2 == 0 ? 1 : 0.97;
    star.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  for (const Boundary boundary : {Boundary::Closed, Boundary::Open}) {
    const Nef2 set = Nef2::polygon(star, boundary);
    const Seen s = seen(set);
    EXPECT_EQ(s.dots + s.hollow, 0U);
    EXPECT_GT(s.solid + s.dashed, 1000);
    EXPECT_LT(drawn(set).size(), 1U << 20U);
  }
}

TEST(Nef2Svg, ManyPointsStayBoundedAndSaySo) {
  PointTable2 points;
  for (int i = 0; i < 20000; ++i) points.push_back({1.0 * (i % 141), 1.0 * (i / 141)});
  Context context;
  const std::string svg = drawn(Nef2::points(points, context));
  expect_sound(svg);
  EXPECT_LT(svg.size(), 1U << 20U);
  EXPECT_NE(svg.find("15000 parts left out"), std::string::npos);
}

TEST(Nef2Svg, AnyCoordinates) {
  constexpr double kMax = std::numeric_limits<double>::max();
  const Rational huge = Rational(pow(Integer(10), 400));
  const std::vector<std::pair<const char*, Nef2>> cases = {
      {"whole range", Nef2::polygon(std::vector<Point2>{{-kMax, -kMax}, {kMax, 0}, {0, kMax}})},
      {"subnormal", Nef2::polygon(std::vector<Point2>{{0, 0}, {5e-324, 0}, {0, 5e-324}})},
      {"far off", Nef2::polygon(std::vector<Point2>{
                      {0x1p52, 0x1p52}, {0x1p52 + 1, 0x1p52}, {0x1p52, 0x1p52 + 1}})},
      {"beyond the doubles", Nef2::point(at(huge, 0)) + Nef2::point(at(0, -huge))},
      {"thin strip",
       half_plane(1, 0, -1, Boundary::Closed) -
           Nef2::half_plane({at(1 - 1 / huge, 0), at(1 - 1 / huge, 1)}, Boundary::Closed)},
  };
  for (const auto& [name, set] : cases) {
    SCOPED_TRACE(name);
    const Seen s = seen(set);
    EXPECT_GT(s.filled + s.solid + s.dashed + static_cast<double>(s.dots), 1);
  }
  const Seen far = seen(cases[2].second);  // as large as anywhere else
  EXPECT_NEAR(far.filled, seen(triangle(Boundary::Closed)).filled, 0.01 * far.filled);
}

/// Areas of all pieces, by their colours.
void see_pieces(const Xml& tree, std::map<std::string, double>& area_of) {
  for (const auto& [name, e] : tree) {
    if (attribute(e, "class") == "piece") {
      for (const auto& ring : read_path(attribute(e, "d"))) {
        area_of[attribute(e, "fill")] -= area(ring);
      }
    }
    see_pieces(e, area_of);
  }
}

TEST(Nef2Svg, PiecesFillTheSet) {
  Context context;
  const Nef2 square = Nef2::polygon(std::vector<Point2>{{0, 0}, {6, 0}, {6, 6}, {0, 6}});
  const Nef2 hole = Nef2::polygon(std::vector<Point2>{{1, 1}, {3, 2}, {2, 4}});
  for (const Nef2& set : {square - hole, (square - hole).interior(), !hole}) {
    const PlanePieces pieces = decompose(set, {}, context);
    const std::string svg = drawn(set, {.pieces = pieces.pieces});
    expect_sound(svg);
    std::map<std::string, double> area_of;
    see_pieces(parsed(svg), area_of);
    EXPECT_EQ(area_of.size(), pieces.pieces.size());
    double sum = 0;
    for (const auto& [colour, filled] : area_of) {
      EXPECT_GT(filled, 1);
      sum += filled;
    }
    Seen with;
    see(parsed(svg), with);
    const Seen without = seen(set);
    EXPECT_NEAR(sum, without.filled, 1e-3 * without.filled);
    EXPECT_EQ(with.solid, without.solid);
    EXPECT_EQ(with.dashed, without.dashed);
    EXPECT_EQ(with.hollow, without.hollow);
  }
}

TEST(Nef2Svg, TitlesAreEscaped) {
  const std::string svg = drawn(Nef2::whole(), {.title = "<a href=\"x\">&\xFF</a>"});
  expect_sound(svg);
  EXPECT_EQ(svg.find("<a "), std::string::npos);
}

TEST(Nef2Svg, SameSetSameBytes) {
  const Nef2 a = triangle(Boundary::Open), b = half_plane(1, 1, -3, Boundary::Closed);
  EXPECT_EQ(drawn(a + b), drawn(b + a));
}

TEST(PlaneWindow, HoldsEveryVertexAndLine) {
  const std::vector<Nef2> sets = {
      Nef2::polygon(std::vector<Point2>{{1e6, 1e6}, {1e6, 1e6 + 3}}),
      Nef2::point(at(Rational(1, 3), 7)),
      Nef2::line({at(5, 5), at(6, 9)}) + Nef2::line({at(100, 5), at(101, 9)}),
      half_plane(1, 7, 2, Boundary::Open) * half_plane(-3, 1, 5, Boundary::Closed),
  };
  for (const Nef2& set : sets) {
    const PlaneComplex& complex = set.complex();
    const PlaneWindow window(complex, 0.1);
    EXPECT_GE(window.aspect(), 0.44);
    EXPECT_LE(window.aspect(), 1.16);
    for (const std::uint32_t i : complex.vertex_point) {
      const Point2 p = window.at(complex.points, i);
      EXPECT_LT(std::abs(p.x), 0.95);
      EXPECT_LT(std::abs(p.y), 0.95 * window.aspect());
      EXPECT_EQ(window.borders(complex.points, i), 0U);
    }
    for (const PlaneLine& line :
         complex.line) {  // passes through the window: corners on both sides
      const PointTable2 corners = window.corners();
      bool left = false, right = false;
      for (std::uint32_t k = 0; k < 4; ++k) {
        PointTable2 three;
        for (const std::uint32_t i : {line.a, line.b}) {
          const RationalPoint2 p = complex.points.inputs.exact(i);
          three.push_back(p.x, p.y);
        }
        const RationalPoint2 corner = corners.exact(k);
        three.push_back(corner.x, corner.y);
        const Sign side = orient2d(three, 0, 1, 2);
        left |= side == Sign::Positive;
        right |= side == Sign::Negative;
      }
      EXPECT_TRUE(left && right);
    }
  }
}

// The context bounds the cut, the area and the drawing, not only the convex parts.
TEST(Nef2Svg, keeps_the_limits_of_its_context) {
  const Nef2 set = triangle(Boundary::Closed);
  std::stop_source stop;
  stop.request_stop();
  Context stopped({}, stop.get_token());
  std::ostringstream out;
  EXPECT_THROW(write_nef2_svg(out, set, {.context = &stopped}), Error);
  EXPECT_EQ(out.str(), "");
  EXPECT_THROW((void)scene_of(set, stopped), Error);
  Context narrow(Limits{.max_memory_bytes = 64});
  EXPECT_THROW(write_nef2_svg(out, set, {.context = &narrow}), Error);
  EXPECT_THROW((void)scene_of(set, narrow), Error);
  Context free;
  EXPECT_NO_THROW(write_nef2_svg(out, set, {.context = &free}));
}

}  // namespace
}  // namespace plumb::nef2_svg_test
