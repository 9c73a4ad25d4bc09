// Scenes of divided surfaces, and where their text goes.

#include "plumb/picture/surface_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "generate/surface_meshes.h"
#include "plumb/picture/render.h"
#include "plumb/picture/scene/stroke_font.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/trace.h"

namespace plumb::testing::surface_scene_test {
namespace {

constexpr std::uint32_t kGrid = 8;

/// Boxes on the grid, by their corners (x, y, x2, y2), in vertices.
SurfaceDivision divided(const std::vector<std::array<std::uint32_t, 4>>& boxes) {
  const auto mesh = std::make_shared<const SurfaceMesh>(grid_surface(kGrid));
  SurfaceScene scene{mesh, SurfacePolygons(*mesh), {}, {}};
  Tracer tracer(*mesh);
  Context context;
  for (const auto& [x, y, x2, y2] : boxes) {
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      return scene.polygons.points.add_vertex(VertexId((kGrid + 1) * j + i));
    };
    const std::vector<SurfacePointId> corners{at(x, y), at(x2, y), at(x2, y2), at(x, y2)};
    EXPECT_FALSE(add_traced_polygon(tracer, corners, scene.polygons, context).has_value());
  }
  return SurfaceDivision(std::move(scene), context);
}

Scene scene_of(const SurfaceDivision& division, const SurfaceResult* result = nullptr) {
  Context context;
  return plumb::scene_of(division, triangulate_surface(division, context), result);
}

TEST(SurfaceScene, equal_labels_have_equal_colours_and_cells_their_own) {
  const SurfaceDivision division =
      divided({{1, 1, 3, 3}, {5, 5, 7, 7}, {2, 2, 6, 6}, {1, 5, 2, 7}});
  const Scene scene = scene_of(division);
  ASSERT_EQ(scene.layers.size(), 4U);
  const auto& cells = scene.layers[2].tints;
  const auto& labels = scene.layers[3].tints;
  ASSERT_EQ(cells.size(), division.cell_count());
  EXPECT_EQ(std::set<Colour>(cells.begin(), cells.end()).size(), cells.size());
  for (std::size_t a = 0; a < labels.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_EQ(labels[a] == labels[b], scene.groups[a].text == scene.groups[b].text);
    }
  }
}

TEST(SurfaceScene, layers_show_what_they_are_for) {
  const SurfaceDivision division = divided({{1, 1, 5, 5}, {3, 3, 7, 7}});
  const SurfaceResult result =
      division.evaluate(parse_set_expression("A * B"), WindingRule::EvenOdd);
  const Scene scene = scene_of(division, &result);
  ASSERT_EQ(scene.layers.size(), 5U);
  const auto count = [&](SurfaceLayer layer, Paint paint) {
    const auto is = [&](const auto& item) {
      return item.paint == paint && (item.layers & bit(layer)) != 0;
    };
    return std::ranges::count_if(scene.lines, is) + std::ranges::count_if(scene.dots, is);
  };
  EXPECT_EQ(count(SurfaceLayer::Polygons, Paint::Wire), 0);
  EXPECT_GT(count(SurfaceLayer::Slices, Paint::Wire), 0);
  EXPECT_EQ(count(SurfaceLayer::Polygons, Paint::Control), 8);
  EXPECT_EQ(count(SurfaceLayer::Polygons, Paint::Crossing), 2);
  EXPECT_EQ(count(SurfaceLayer::Polygons, Paint::Curve), 16);
  EXPECT_EQ(count(SurfaceLayer::Polygons, Paint::Curve2), 16);
  EXPECT_EQ(count(SurfaceLayer::Result, Paint::Control), 4);
  EXPECT_EQ(count(SurfaceLayer::Result, Paint::Curve), 8);
}

// There and back: no polygon is left, and no triangle has a corner there, but control points are
// where they are.
TEST(SurfaceScene, control_points_of_what_cancels) {
  const auto mesh = std::make_shared<const SurfaceMesh>(grid_surface(kGrid));
  SurfaceScene scene{mesh, SurfacePolygons(*mesh), {}, {}};
  const FaceId f(10);
  for (const double v : {.25, .5}) {
    scene.polygons.add_segment(scene.polygons.points.add_in_face(f, .25, v), f,
                               SegmentStart::ControlPoint);
  }
  scene.polygons.close();
  const Point3 last = scene.polygons.points.position(scene.polygons.point[1]);
  Context context;
  const SurfaceDivision division(std::move(scene), context);
  const Scene drawn = scene_of(division);
  ASSERT_EQ(drawn.dots.size(), 2U);
  EXPECT_NE(drawn.points[drawn.dots[0].at], drawn.points[drawn.dots[1].at]);
  const Point3& corner = drawn.points[0];  // the vertex (0, 0)
  EXPECT_NE(drawn.points[drawn.dots[1].at], corner);
  EXPECT_NEAR((drawn.points[drawn.dots[1].at].x - corner.x) * 4 * drawn.quarter_scale, last.x,
              1e-9);
}

TEST(SurfaceScene, names_labels) {
  EXPECT_EQ(label_text({}), "0");
  const std::vector<SignedEntry> label{{0, 1}, {1, -1}, {2, 3}, {27, -2}};
  EXPECT_EQ(label_text(label), "A-B+3C-2s27");
}

/// How far a sample is from the nearest of another group, or from the side of the canvas.
double distance_to_others(const std::vector<std::uint32_t>& group, std::int64_t width,
                          std::int64_t height, std::int64_t x, std::int64_t y) {
  double best = static_cast<double>(std::min({x + 1, y + 1, width - x, height - y}));
  for (std::int64_t j = 0; j < height; ++j) {
    for (std::int64_t i = 0; i < width; ++i) {
      if (group[static_cast<std::size_t>(j * width + i)] ==
          group[static_cast<std::size_t>(y * width + x)]) {
        continue;
      }
      best = std::min(best, std::hypot(static_cast<double>(i - x), static_cast<double>(j - y)));
    }
  }
  return best;
}

/// Against all pairs of samples: as far inside its group as any place, but for what steps over
/// neighbours overestimate.
TEST(TextPlaces, are_the_widest) {
  Scene scene;
  scene.groups = {{"0", "A"}, {"1", "B"}, {"2", "C"}};
  for (std::uint32_t g = 0; g < 3; ++g) scene.patches.push_back({{0, 0, 1}, Paint::Surface, g});
  constexpr std::uint32_t kWidth = 48, kHeight = 36;
  Canvas canvas(kWidth, kHeight, {255, 255, 255});
  const auto fill = [&](Spot a, Spot b, Spot c, std::uint32_t patch) {
    canvas.for_triangle(a, b, c, [&](std::size_t sample, const Spot& spot) {
      canvas.put(sample, spot.z, patch, {0, 0, 0});
    });
  };
  fill({2, 2, 0}, {46, 3, 0}, {5, 34, 0}, 0);
  fill({20, 2, 1}, {40, 9, 1}, {22, 18, 1}, 1);
  fill({45, 34, 1}, {44, 20, 1}, {20, 34, 1}, 2);
  std::vector<std::uint32_t> group;
  for (const std::uint32_t p : canvas.patches()) {
    group.push_back(p == Scene::kNoPatch ? 99 : scene.patches[p].group);
  }
  const std::vector<PlacedText> texts = place_texts(scene, canvas, 1, 10);
  ASSERT_EQ(texts.size(), 3U);
  for (std::uint32_t g = 0; g < 3; ++g) {
    EXPECT_EQ(texts[g].text, scene.groups[g].text);
    double widest = 0;
    for (std::uint32_t y = 0; y < kHeight; ++y) {
      for (std::uint32_t x = 0; x < kWidth; ++x) {
        if (group[std::size_t{y} * kWidth + x] != g) continue;
        widest = std::max(widest, distance_to_others(group, kWidth, kHeight, x, y));
      }
    }
    const auto x = static_cast<std::uint32_t>(texts[g].middle.x);
    const auto y = static_cast<std::uint32_t>(texts[g].middle.y);
    ASSERT_EQ(group[std::size_t{y} * kWidth + x], g);
    EXPECT_GE(distance_to_others(group, kWidth, kHeight, x, y), .9 * widest - 1);
  }
}

TEST(StrokeFont, letters_fit_their_boxes_and_differ) {
  std::set<std::string> seen;
  for (const char c : std::string("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ+-.,()/:=*!^_")) {
    std::string shape;
    for (const auto& [a, b] : strokes_of({&c, 1})) {
      for (const Point2 p : {a, b}) {
        EXPECT_LE(std::fabs(p.x), stroked_width({&c, 1}) / 2 + 1e-9) << c;
        EXPECT_LE(std::fabs(p.y), .5 + 1e-9) << c;
        shape += std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ';
      }
    }
    EXPECT_FALSE(shape.empty()) << c;
    EXPECT_TRUE(seen.insert(shape).second) << c;
  }
  EXPECT_GT(stroked_width("AB"), stroked_width("A") + stroked_width("B"));
  EXPECT_TRUE(strokes_of(" ").empty());
}

TEST(SurfacePicture, writes_on_visible_cells) {
  const SurfaceDivision division = divided({{1, 1, 5, 5}, {3, 3, 7, 7}});
  Scene scene = scene_of(division);
  scene.shown = bit(SurfaceLayer::Labels);
  const Rendering rendering = rendered_without_text(scene, {400, 300});
  std::set<std::string> texts;
  for (const PlacedText& text : rendering.texts) texts.insert(text.text);
  EXPECT_EQ(texts, (std::set<std::string>{"0", "A", "B", "A+B"}));
  EXPECT_NE(rendered(scene, {400, 300}).rgb, rendering.image.rgb);
  scene.shown = bit(SurfaceLayer::Cells);
  EXPECT_TRUE(rendered_without_text(scene, {400, 300}).texts.empty());
}

}  // namespace
}  // namespace plumb::testing::surface_scene_test
