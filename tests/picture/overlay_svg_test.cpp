// Pictures of overlaid maps: colours, labels, borders.
#include "plumb/picture/overlay_svg.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "plumb/picture/plane/outlines.h"
#include "plumb/picture/svg/sheet.h"
#include "svg_checks.h"

namespace plumb::overlay_svg_test {
namespace {

using namespace testing;

/// n x n squares from (x, y) on, and their outer cycle.
MapReport grid(std::uint32_t n, double x, double y, double step) {
  Map map;
  const auto at = [n](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) map.points.push_back({x + i * step, y + j * step});
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      map.add_cycle(std::vector{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  Context context;
  return check_map(std::move(map), {.outer = OuterRule::Infer}, context);
}

MapOverlay overlaid(const MapReport& first, const MapReport& second) {
  Context context;
  return overlay_maps(first, second, context);
}

std::string drawn(const MapOverlay& overlay, const OverlaySvgOptions& options = {}) {
  std::ostringstream out;
  write_overlay_svg(out, overlay, options);
  return out.str();
}

TEST(OverlaySvg, NeighboursOfOneRegionDiffer) {
  const MapOverlay overlay = overlaid(grid(3, 0, 0, 8), grid(9, 1, 1, 3));
  const std::vector<OverlayColour> colours = colour_cells(overlay);
  ASSERT_EQ(colours.size(), overlay.complex.face_count());
  std::size_t compared = 0;
  for (std::size_t e = 0; e < overlay.complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const FaceId left = overlay.complex.dcel.face(h), right = overlay.complex.dcel.face(twin(h));
    if (left == FaceId(0) || right == FaceId(0)) continue;
    EXPECT_NE(colours[left.value()], colours[right.value()]) << e;
    ++compared;
  }
  EXPECT_GT(compared, 100U);
  std::map<std::pair<std::uint32_t, std::uint32_t>, OverlayColour> of_pair;
  for (std::size_t f = 1; f < colours.size(); ++f) {
    const auto [first, second] = overlay.origin[f];
    const auto [place, is_new] = of_pair.try_emplace({first, second}, colours[f]);
    EXPECT_TRUE(is_new || place->second == colours[f]);
    EXPECT_EQ(colours[f].tint == kTints, first == 0);
  }
}

TEST(OverlaySvg, EveryCellIsThereWithItsPair) {
  const MapOverlay overlay = overlaid(grid(2, 0, 0, 2), grid(2, 1, 1, 2));
  // Names are regions of the report: 1 .. 4 in both.
  const std::string svg = drawn(overlay, {.title = "a <b>", .first = "one & only"});
  expect_sound(svg);
  std::multiset<std::string> titles, labels;
  visit(parsed(svg), [&](const std::string& name, const Xml& e) {
    if (name == "title" && e.data().find('/') != std::string::npos) titles.insert(e.data());
    if (attribute(e, "class") == "label" && e.data() != "a/b") labels.insert(e.data());
  });
  EXPECT_EQ(titles.size(), overlay.complex.face_count() - 1);
  EXPECT_EQ(titles, labels) << "every cell of this one has room";
  for (const auto& o : overlay.origin) {
    if (o.first == 0 || o.second == 0) continue;
    EXPECT_EQ(titles.count(std::to_string(o.first) + " / " + std::to_string(o.second)), 1U);
  }
  EXPECT_NE(svg.find("one &amp; only"), std::string::npos);
}

TEST(OverlaySvg, BordersAreOfOneMapOrBoth) {
  const auto classes = [](const MapOverlay& overlay) {
    std::set<std::string> seen;
    visit(parsed(drawn(overlay)), [&seen](const std::string&, const Xml& e) {
      const std::string css = attribute(e, "class");
      if (css.starts_with("border ")) seen.insert(css.substr(7));
    });
    return seen;
  };
  using Set = std::set<std::string>;
  const MapReport coarse = grid(2, 0, 0, 4), fine = grid(4, 0, 0, 2);
  EXPECT_EQ(classes(overlaid(coarse, coarse)), Set{"both"});
  EXPECT_EQ(classes(overlaid(coarse, fine)), (Set{"both", "second"}));
  EXPECT_EQ(classes(overlaid(fine, coarse)), (Set{"both", "first"}));
  EXPECT_EQ(classes(overlaid(coarse, grid(1, 1, 1, 1))), (Set{"first", "second"}));
}

TEST(OverlaySvg, ManyCellsStayBounded) {
  const std::string svg = drawn(overlaid(grid(150, 0, 0, 2), grid(150, 1, 1, 2)));
  expect_sound(svg);
  EXPECT_LT(svg.size(), 20U << 20U);
}

/// Even-odd.
bool is_inside(const std::vector<Point2>& ring, Point2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y < p.y) != (b.y < p.y) && a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y) < p.x)
      inside = !inside;
  }
  return inside;
}

TEST(CellLabel, LiesInsideThePolygon) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(20, 100);
  std::size_t found = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Point2> star;
    for (int i = 0; i < 15; ++i) {
      const double a = i * M_PI / 7.5, r = radius(random);
      star.push_back({r * std::cos(a), r * std::sin(a)});
    }
    const auto box = room_inside({star}, 70, 40);
    if (!box) continue;
    ++found;
    EXPECT_NEAR(box->width(), 70, 1e-9);
    for (int k = 1; k < 40; ++k) {  // all around it, a hair inside
      const double t = k / 40.0;
      for (const double s : {0.001, 0.999}) {
        EXPECT_TRUE(is_inside(star, {box->left + t * 70, box->top + s * 40}));
        EXPECT_TRUE(is_inside(star, {box->left + s * 70, box->top + t * 40}));
      }
    }
  }
  EXPECT_GT(found, 50U);
  EXPECT_LT(found, 200U);
  const std::vector<Point2> square = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  const std::vector<Point2> hole = {{20, 45}, {20, 55}, {80, 55}, {80, 45}};
  ASSERT_TRUE(room_inside({square, hole}, 90, 20));
  EXPECT_FALSE(room_inside({square, hole}, 90, 20)->overlaps({20, 45, 80, 55}));
  EXPECT_FALSE(room_inside({square, hole}, 90, 50));
  EXPECT_FALSE(room_inside({}, 1, 1));
}

}  // namespace
}  // namespace plumb::overlay_svg_test
