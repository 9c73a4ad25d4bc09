// Results of Booleans are input again: the same set, whatever the mesh, the expression and the
// rule.
#include "plumb/surface/cells/surface_labels.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "divided.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/cells/surface_cells.h"
#include "plumb/surface/surface.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::surface_labels_test {
namespace {

constexpr WindingRule kRules[] = {WindingRule::EvenOdd, WindingRule::NonZero,
                                  WindingRule::Positive};

/// The scene with a result's shape beside its own.
SurfaceScene both(const SurfaceScene& scene, const SurfaceScene& result) {
  SurfaceScene sum = scene;
  if (!sum.shapes) {
    sum.shapes.emplace();
    for (std::uint32_t p = 0; p < scene.polygons.size(); ++p) sum.shapes->push_back({p});
  }
  const auto shape = static_cast<std::uint32_t>(sum.shapes->size());
  if (scene.outside.is_valid()) {
    for (std::uint32_t s = 0; s < shape; ++s) sum.levels.push_back({s, scene.outside, 0});
    sum.outside = {};
  }
  auto& loops = sum.shapes->emplace_back();
  for (std::size_t p = 0; p < result.polygons.size(); ++p) {
    loops.push_back(static_cast<std::uint32_t>(sum.polygons.size()));
    for (std::uint32_t i = result.polygons.begin[p]; i < result.polygons.begin[p + 1]; ++i) {
      const FaceId f = result.polygons.face[i];
      const RationalPoint2 at = result.polygons.points.exact_in(result.polygons.point[i], f);
      sum.polygons.add_segment(sum.polygons.points.add_in_face(f, at.x, at.y), f,
                               SegmentStart::ControlPoint);
    }
    sum.polygons.close();
  }
  if (result.outside.is_valid()) sum.levels.push_back({shape, result.outside, 0});
  for (const SurfaceLevel& l : result.levels) sum.levels.push_back({shape, l.face, l.label});
  return sum;
}

/// Empty, or how the result as a scene is another set.
std::string difference_of_result(const SurfaceDivision& d, const std::string& text,
                                 WindingRule rule) {
  const SurfaceResult result = d.evaluate(parse_set_expression(text), rule);
  const SurfaceScene scene = result_scene(d, result);
  Context context;
  const SurfaceDivision alone(scene, context);
  if (const auto flaw = audit(alone)) return *flaw;
  for (const WindingRule again : kRules) {
    const double area = alone.select(parse_set_expression("A"), again).area;
    if (std::fabs(area - result.region.area) > 1e-9 * (1 + area)) return text + ": another area";
  }
  const SurfaceResult twice = alone.evaluate(parse_set_expression("A"), rule);
  if (twice.borders.size() != result.borders.size()) return text + ": other loops";
  const SurfaceDivision beside(both(d.scene(), scene), context);
  const std::string difference = "(" + text + ") ^ s" + std::to_string(d.shape_count());
  const bool is_same = beside.select(parse_set_expression(difference), rule).cells == 0;
  return is_same ? "" : text + ": another set";
}

TEST(SurfaceResult, IsTheSameSetAgain) {
  const MeshPointer disk = grid_mesh(5, 4, 9), tube = cylinder_mesh(7, 5), ball = sphere_mesh(2),
                    ring = torus_mesh(6, 5);
  const MeshPointer parts[] = {disk, ball, tube, disk};
  const MeshPointer meshes[] = {disk, tube, ball, ring, joined_meshes(parts)};
  using Walks = std::vector<std::vector<std::uint8_t>>;
  EXPECT_TRUE(rc::check("the same set", [&](std::uint8_t number, Walks walks, std::uint8_t rule,
                                            std::uint16_t outside) {
    const MeshPointer& mesh = meshes[number % 5];
    walks.resize(3);
    SurfaceDrawing s(mesh);
    for (const auto& walk : walks) s.add_vertex_polygon(closed_walk(*mesh, walk));
    if (outside % 3 == 1) s.scene.outside = FaceId(outside % mesh->face_count());
    Context context;
    const SurfaceDivision d(s.scene, context);
    RC_PRE(d.shape_separation(0).over_z && d.shape_separation(1).over_z &&
           d.shape_separation(2).over_z);
    for (const char* text : {"A", "!A", "A + B * !C", "!(A ^ B)", "A - A", "!(A - A)", "!B - C"}) {
      RC_ASSERT(difference_of_result(d, text, kRules[rule % 3]) == "");
    }
  }));
}

// No face has its first corner outside: that takes a level.
TEST(SurfaceResult, ComplementOfASpeck) {
  SurfaceDrawing s(grid_mesh(2, 2));
  s.add_box({Rational(5) / 10, Rational(1) / 10}, {Rational(6) / 10, Rational(2) / 10});
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(difference_of_result(d, "!A", WindingRule::EvenOdd), "");
  const SurfaceScene scene =
      result_scene(d, d.evaluate(parse_set_expression("!A"), WindingRule::EvenOdd));
  EXPECT_FALSE(scene.outside.is_valid());
  ASSERT_EQ(scene.levels.size(), 1U);
  EXPECT_EQ(scene.levels[0].label, 1);
}

TEST(SurfaceResult, LevelsAreWhatIsSaid) {
  SurfaceDrawing s(torus_mesh(6, 5));
  std::vector<std::uint32_t> meridian, other;
  for (std::uint32_t j = 0; j < 5; ++j) {
    meridian.push_back(j);
    other.push_back(15 + j);
  }
  s.add_vertex_polygon(meridian);
  s.add_vertex_polygon(other);
  s.scene.shapes = {{0, 1}};
  for (const std::int32_t level : {0, 1, 2, -3}) {
    s.scene.levels = {{0, FaceId(7), level}};
    const SurfaceDivision d = divide(s);
    ASSERT_FALSE(d.shape_separation(0).over_z);
    ASSERT_TRUE(d.shape_separation(0).mod_2);
    const auto label = d.labels(cell_at_corner(d.arrangement(), d.cells(), FaceId(7)));
    EXPECT_EQ(label.empty(), level % 2 == 0);
  }
  Context context;
  s.scene.levels = {{0, FaceId(7), 0}, {0, FaceId(8), 0}};
  EXPECT_THROW(SurfaceDivision(s.scene, context), Error);
  s.scene.levels = {{1, FaceId(7), 0}};
  EXPECT_THROW(SurfaceDivision(s.scene, context), Error);
}

TEST(SurfaceResult, NoShapesAreNone) {
  SurfaceDrawing s(grid_mesh(2, 2));
  s.add_box({Rational(5) / 10, Rational(1) / 10}, {Rational(6) / 10, Rational(2) / 10});
  s.scene.shapes.emplace();
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.shape_count(), 0U);
  EXPECT_EQ(d.cell_count(), 2U);
  EXPECT_THROW(d.select(parse_set_expression("A"), WindingRule::EvenOdd), Error);
}

// ---------------------------------------------------------------- certificates

// Around the handle one way the labels miss by 2, around the other by 1: only that proves it modulo
// 2.
TEST(SurfaceSeparation, CyclesProveWhatIsSaid) {
  std::size_t odd = 0;
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SurfaceDrawing s(torus_mesh(6, 5));
    const auto add = [&](std::uint32_t from, std::uint32_t step, std::uint32_t count) {
      std::vector<std::uint32_t> loop;
      for (std::uint32_t i = 0; i < count; ++i) loop.push_back(from + i * step);
      s.add_vertex_polygon(loop);
    };
    std::vector<std::uint32_t> shape;
    const int polygons = 3 + static_cast<int>(seed % 5);
    for (int p = 0; p < polygons; ++p) {
      if (dice.between(0, 2) == 0) {
        add(dice.below(5), 5, 6);
      } else {
        add(5 * dice.below(6), 1, 5);
      }
      shape.push_back(static_cast<std::uint32_t>(p));
    }
    s.scene.shapes = {shape};
    odd += divide(s).shape_separation(0).mod_2 ? 0U : 1U;
  }
  EXPECT_GT(odd, 10U);
}

// ---------------------------------------------------------------- areas

/// 3 x 3 squares of that side.
MeshPointer scaled_grid(double scale) {
  const MeshPointer unit = grid_mesh(3, 3);
  std::vector<Point3> points;
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t v = 0; v < unit->vertex_count(); ++v) {
    const Point3& p = unit->point(VertexId(v));
    points.push_back({scale * p.x, scale * p.y, 0});
  }
  for (std::uint32_t f = 0; f < unit->face_count(); ++f) {
    triangles.push_back(unit->corners(FaceId(f)));
  }
  return std::make_shared<const SurfaceMesh>(points, triangles);
}

TEST(SurfaceDivision, AreasAtTheEndsOfDoubles) {
  for (const double scale : {0x1p-500, 0x1p-333, 1., 0x1p333, 0x1p500}) {
    SurfaceDrawing s(scaled_grid(scale));
    s.add_vertex_polygon(std::vector<std::uint32_t>{0, 1, 5, 4});
    const SurfaceDivision d = divide(s);
    const double area = d.select(parse_set_expression("A"), WindingRule::EvenOdd).area;
    EXPECT_DOUBLE_EQ(area / scale / scale, 1) << scale;
  }
}

// Every triangle has an area that is a double, all together have none: sums end at the largest.
TEST(SurfaceDivision, AreasBeyondTheLargestDouble) {
  SurfaceDrawing s(scaled_grid(0x1p511));
  s.add_vertex_polygon(std::vector<std::uint32_t>{0, 1, 5, 4});
  s.add_vertex_polygon(std::vector<std::uint32_t>{0, 1, 2, 6, 10, 9, 8, 4});
  const SurfaceDivision d = divide(s);
  ASSERT_EQ(d.cell_count(), 3U);
  double largest = 0;
  for (std::uint32_t c = 0; c < 3; ++c) largest = std::max(largest, d.area(CellId(c)));
  EXPECT_EQ(largest, std::numeric_limits<double>::max());
  const auto area = [&](const char* set) {
    return d.select(parse_set_expression(set), WindingRule::EvenOdd).area;
  };
  EXPECT_DOUBLE_EQ(area("A"), 0x1p1022);
  EXPECT_EQ(area("A + !B"), std::numeric_limits<double>::max());
}

// ---------------------------------------------------------------- nesting

// A point of side 0 whose nearest double is its corner stands before that corner all the same.
TEST(SurfaceDivision, AnIslandBesideACornerLiesAboveTheSideBelowIt) {
  const std::vector<Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  SurfaceDrawing s(
      std::make_shared<const SurfaceMesh>(corners, std::vector<SurfaceTriangle>{{0, 1, 2}}));
  const Rational hair = 1 / exact_rational(0x1p70);
  const auto at = [&](const Rational& hairs, const Rational& up) {
    return s.scene.polygons.points.add_in_face(FaceId(0), Rational(1 - hairs * hair),
                                               Rational(up * hair));
  };
  s.add_polygon(std::vector{at(1, 0), at(0, 0), at(2, 2)});
  s.add_polygon(std::vector{at(Rational(1) / 2, Rational(1) / 8),
                            at(Rational(1) / 4, Rational(1) / 8),
                            at(Rational(1) / 2, Rational(1) / 4)});
  const SurfaceDivision d = divide(s);
  ASSERT_EQ(d.cell_count(), 3U);
  const auto cells = [&](const char* set) {
    return d.select(parse_set_expression(set), WindingRule::EvenOdd).cells;
  };
  EXPECT_EQ(cells("A * B"), 1U);
  EXPECT_EQ(cells("A - B"), 1U);
  EXPECT_EQ(cells("B - A"), 0U);
}

// ---------------------------------------------------------------- cost

// Thousands of islands above each other in one face: quadratic if each looks at all below it.
TEST(SurfaceDivision, ManyIslandsAboveEachOther) {
  SurfaceDrawing s(grid_mesh(1, 1));
  constexpr int kCount = 3000;
  for (int i = 1; i <= kCount; ++i) {
    const Rational y = Rational(i) / (2 * kCount), h = Rational(1) / (8 * kCount);
    const Rational x = Rational(3) / 4 + Rational(i % 7) / 1000;
    const RationalPoint2 corners[] = {{x, y}, {x + Rational(1) / 5, y + h}, {x, y + 2 * h}};
    s.add_flat_polygon(corners);
  }
  Context context;
  const SurfaceDivision d(s.scene, context);
  EXPECT_EQ(d.cell_count(), kCount + 1U);
  Limits limits;
  limits.max_seconds = 1e-3;
  Context hasty(limits);
  EXPECT_THROW(SurfaceDivision(s.scene, hasty), Error);
}

// Islands within islands in one face, too many to look at one by one: nested as in the plane, where
// areas tell.
TEST(SurfaceDivision, ManyNestedIslands) {
  SurfaceDrawing s(grid_mesh(1, 1));
  constexpr int kDeep = 30;
  std::vector<double> expected;
  for (int i = 0; i < kDeep; ++i) {
    const Rational r = Rational(kDeep - i) / (8 * kDeep);
    s.add_box({Rational(3) / 4 - r, Rational(1) / 4 - r},
              {Rational(3) / 4 + r, Rational(1) / 4 + r});
  }
  const SurfaceDivision d = divide(s);
  ASSERT_EQ(d.cell_count(), kDeep + 1U);
  for (std::uint32_t c = 0; c < d.cell_count(); ++c) {
    const auto depth = static_cast<double>(d.labels(CellId(c)).size());
    const double r = (kDeep - depth + 1) / (8. * kDeep), inner = (kDeep - depth) / (8. * kDeep);
    if (depth > 0) {
      EXPECT_NEAR(d.area(CellId(c)), 4 * (r * r - inner * inner), 1e-12);
    }
  }
}

// A long shape list over one edge, runs along an edge that many polygons share: small scenes, large
// tables.
TEST(SurfaceDivision, ChargesWhatGrowsFaster) {
  Limits limits;
  limits.max_memory_bytes = 4U << 20;
  SurfaceDrawing runs(grid_mesh(1, 1));
  for (int i = 0; i < 600; ++i) {
    const Rational x = Rational(i + 1) / 700;
    runs.add_flat_polygon(std::vector<RationalPoint2>{{0, 0}, {x, 0}, {1, 0}, {1, 1}});
  }
  Context small(limits);
  EXPECT_THROW(SurfaceDivision(runs.scene, small), Error);
  SurfaceDrawing jumps(grid_mesh(1, 1));
  jumps.add_vertex_polygon(std::vector<std::uint32_t>{0, 1, 3});
  jumps.scene.shapes.emplace(200000, std::vector<std::uint32_t>{0});
  Context other(limits);
  EXPECT_THROW(SurfaceDivision(jumps.scene, other), Error);
}

// What shapes do across edges stays charged for as long as it lives, and no longer.
TEST(SurfaceDivision, JumpsAreChargedWhileTheyLive) {
  SurfaceDrawing s(grid_mesh(1, 1));
  s.add_vertex_polygon(std::vector<std::uint32_t>{0, 1, 3});
  Limits limits;
  limits.max_memory_bytes = 32U << 20;
  Context context(limits);
  const SurfaceArrangement arrangement = slice(s.scene.polygons, context);
  const SurfaceCells cells = make_cells(*s.scene.mesh, arrangement, context);
  const CellJumps jumps = jumps_of_polygons(arrangement, cells, context);
  const std::vector<std::vector<std::uint32_t>> shapes(200000, {0});
  constexpr std::uint64_t kMost = 31U << 20;
  {
    const CellJumps sums = jumps_of_shapes(jumps, shapes, context);
    EXPECT_GE(sums.entries.size(), shapes.size());
    EXPECT_THROW(context.charge_memory(kMost, "more"), Error);
  }
  EXPECT_NO_THROW(context.charge_memory(kMost, "more"));
}

}  // namespace
}  // namespace plumb::testing::surface_labels_test
