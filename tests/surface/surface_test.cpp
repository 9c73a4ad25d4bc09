// Polygons on surfaces of every kind: known answers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "divided.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::surface_test {
namespace {

struct Answer {
  const char* expression;
  double area;
  std::size_t loops;
};

void expect_answers(const SurfaceDivision& d, std::initializer_list<Answer> answers,
                    WindingRule rule = WindingRule::EvenOdd) {
  for (const Answer& a : answers) {
    SCOPED_TRACE(a.expression);
    const SurfaceResult r = d.evaluate(parse_set_expression(a.expression), rule);
    EXPECT_NEAR(r.region.area, a.area, 1e-9);
    EXPECT_EQ(r.borders.size(), a.loops);
    require_valid(r.borders);
  }
}

Rational tenth(std::int64_t n) { return Rational(n) / 10; }
RationalPoint2 tenths(std::int64_t x, std::int64_t y) { return {tenth(x), tenth(y)}; }

// ---------------------------------------------------------------- disks

TEST(SurfaceDivision, TwoBoxes) {
  SurfaceDrawing s(grid_mesh(20, 20, 5));
  s.add_box(tenths(23, 22), tenths(103, 102));
  s.add_box(tenths(64, 63), tenths(144, 143));
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.cell_count(), 4U);
  EXPECT_EQ(d.counts().crossings, 2U);
  expect_answers(
      d, {{"A + B", 112.79, 1}, {"A * B", 15.21, 1}, {"A - B", 48.79, 1}, {"A ^ B", 97.58, 2}});
}

TEST(SurfaceDivision, BoxesEqualReversedNestedSharing) {
  struct Case {
    const char* name;
    RationalPoint2 low, high;  // of the second box
    bool is_reversed;
    std::size_t cells;
    std::array<Answer, 4> answers;
  };
  const Case cases[] = {
      {"nested",
       tenths(42, 42),
       tenths(82, 82),
       false,
       3,
       {{{"A + B", 64, 1}, {"A * B", 16, 1}, {"A - B", 48, 2}, {"A ^ B", 48, 2}}}},
      {"equal",
       tenths(22, 22),
       tenths(102, 102),
       false,
       2,
       {{{"A + B", 64, 1}, {"A * B", 64, 1}, {"A - B", 0, 0}, {"A ^ B", 0, 0}}}},
      {"reversed",
       tenths(22, 22),
       tenths(102, 102),
       true,
       2,
       {{{"A + B", 64, 1}, {"A * B", 64, 1}, {"A - B", 0, 0}, {"A ^ B", 0, 0}}}},
      {"a side",
       tenths(102, 22),
       tenths(142, 102),
       false,
       3,
       {{{"A + B", 96, 1}, {"A * B", 0, 0}, {"A - B", 64, 1}, {"A ^ B", 96, 1}}}},
      {"half a side",
       tenths(102, 42),
       tenths(142, 142),
       false,
       3,
       {{{"A + B", 104, 1}, {"A * B", 0, 0}, {"A - B", 64, 1}, {"A ^ B", 104, 1}}}},
      {"a corner",
       tenths(102, 102),
       tenths(142, 142),
       false,
       3,
       {{{"A + B", 80, 2}, {"A * B", 0, 0}, {"A - B", 64, 1}, {"A ^ B", 80, 2}}}},
      {"a touching corner inside",
       tenths(22, 42),
       tenths(62, 82),
       false,
       3,
       {{{"A + B", 64, 1}, {"A * B", 16, 1}, {"A - B", 48, 1}, {"A ^ B", 48, 1}}}},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    SurfaceDrawing s(grid_mesh(20, 20));
    s.add_box(tenths(22, 22), tenths(102, 102));
    if (c.is_reversed) {
      const RationalPoint2 back[] = {c.low, {c.low.x, c.high.y}, c.high, {c.high.x, c.low.y}};
      s.add_flat_polygon(back);
    } else {
      s.add_box(c.low, c.high);
    }
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), c.cells);
    for (const Answer& a : c.answers) expect_answers(d, {a});
  }
}

TEST(SurfaceDivision, OnMeshLinesInOneTriangleAndBarelyOverAnEdge) {
  {
    SurfaceDrawing s(grid_mesh(8, 8));
    s.add_box({1, 1}, {4, 4});
    s.add_box({2, 2}, {6, 6});
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), 4U);
    expect_answers(d, {{"A + B", 21, 1}, {"A * B", 4, 1}, {"A ^ B", 17, 2}});
  }
  {
    SurfaceDrawing s(grid_mesh(2, 2));
    s.add_box(tenths(5, 1), tenths(7, 3));
    s.add_box(tenths(6, 2), tenths(8, 4));
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), 4U);
    expect_answers(d, {{"A + B", 0.07, 1}, {"A * B", 0.01, 1}});
  }
  {
    SurfaceDrawing s(grid_mesh(4, 4));
    const Rational tiny = Rational(1) / 100000000;
    s.add_box({tenth(12), tenth(12)}, {2 + tiny, tenth(18)});
    s.add_box({2 - tiny, tenth(12)}, {tenth(28), tenth(18)});
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), 4U);
    EXPECT_NEAR(d.select(parse_set_expression("A * B"), WindingRule::EvenOdd).area, 2e-8 * 0.6,
                1e-15);
  }
}

/// More nodes in one part of one face than a byte counts.
TEST(SurfaceDivision, ManyCornersInOneTriangle) {
  for (const std::int64_t n : {300, 513}) {
    SurfaceDrawing s(grid_mesh(1, 1));
    std::vector<RationalPoint2> ring;  // of a parabola, within the lower triangle
    for (std::int64_t k = 0; k < n; ++k) {
      const Rational part = Rational(k) / n;
      ring.push_back({(2 + part) / 4, (1 + 2 * part * part) / 16});
    }
    s.add_flat_polygon(ring);
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), 2U);
    EXPECT_EQ(d.counts().crossings, 0U);
  }
}

TEST(SurfaceDivision, FigureEight) {
  SurfaceDrawing s(grid_mesh(20, 20));
  const RationalPoint2 eight[] = {tenths(32, 32), tenths(122, 122), tenths(122, 32),
                                  tenths(32, 122)};
  s.add_flat_polygon(eight);
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.cell_count(), 3U);
  EXPECT_EQ(d.counts().crossings, 1U);
  std::vector<std::int32_t> values;
  for (std::uint32_t c = 0; c < 3; ++c) {
    const auto label = d.labels(CellId(c));
    values.push_back(label.empty() ? 0 : label[0].value);
  }
  std::sort(values.begin(), values.end());
  EXPECT_EQ(values, (std::vector<std::int32_t>{-1, 0, 1}));
  expect_answers(d, {{"A", 40.5, 2}});
  expect_answers(d, {{"A", 20.25, 1}}, WindingRule::Positive);
  expect_answers(d, {{"A", 40.5, 2}}, WindingRule::NonZero);
}

TEST(SurfaceDivision, SpikesAndPointsAreNotThere) {
  SurfaceDrawing s(grid_mesh(6, 6));
  const RationalPoint2 spiked[] = {{1, 1}, tenths(45, 10), tenths(45, 52), tenths(45, 10),
                                   {5, 1}, {5, 1},         {5, 5},         {1, 5}};
  s.add_flat_polygon(spiked);
  const RationalPoint2 point[] = {tenths(22, 23)};
  s.add_flat_polygon(point);
  s.add_flat_polygon({});
  const RationalPoint2 back_and_forth[] = {tenths(2, 3), tenths(57, 48)};
  s.add_flat_polygon(back_and_forth);
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.cell_count(), 2U);
  EXPECT_EQ(d.counts().crossings, 0U);
  expect_answers(d, {{"A", 16, 1}, {"A + B + C + D", 16, 1}, {"!A", 20, 1}});
}

// ---------------------------------------------------------------- tori and other surfaces

std::vector<std::uint32_t> meridian(std::uint32_t i, std::uint32_t minor,
                                    bool is_reversed = false) {
  std::vector<std::uint32_t> v(minor);
  std::iota(v.begin(), v.end(), i * minor);
  if (is_reversed) std::reverse(v.begin(), v.end());
  return v;
}
std::vector<std::uint32_t> longitude(std::uint32_t j, std::uint32_t major, std::uint32_t minor) {
  std::vector<std::uint32_t> v;
  for (std::uint32_t i = 0; i < major; ++i) v.push_back(i * minor + j);
  return v;
}

TEST(SurfaceDivision, MeridiansOfATorus) {
  struct Case {
    const char* name;
    std::vector<int> meridians;  // negative: reversed
    bool is_one_shape;
    std::size_t cells;
    bool over_z, mod_2;
  };
  const Case cases[] = {
      {"one", {3}, true, 1, false, false},
      {"two opposite", {3, -9}, true, 2, true, true},
      {"two equal", {3, 9}, true, 2, false, true},
      {"three equal", {3, 9, 12}, true, 3, false, false},
      {"two", {3, 9}, false, 2, false, false},
      {"one there and back", {3, -3}, true, 1, true, true},
      {"the same twice", {3, 3}, true, 1, false, true},
  };
  constexpr std::uint32_t kMajor = 16, kMinor = 8;
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    SurfaceDrawing s(torus_mesh(kMajor, kMinor));
    for (const int m : c.meridians) {
      s.add_vertex_polygon(meridian(static_cast<std::uint32_t>(std::abs(m)), kMinor, m < 0));
    }
    if (c.is_one_shape) {
      std::vector<std::uint32_t> all(c.meridians.size());
      std::iota(all.begin(), all.end(), 0U);
      s.scene.shapes = {all};
    }
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), c.cells);
    EXPECT_EQ(d.shape_separation(0).over_z, c.over_z);
    EXPECT_EQ(d.shape_separation(0).mod_2, c.mod_2);
    EXPECT_FALSE(d.polygon_separation(0).over_z);
    EXPECT_EQ(d.shape_separation(0).cycle.empty(), c.over_z);
  }
}

TEST(SurfaceDivision, AreasBetweenOppositeMeridians) {
  SurfaceDrawing s(torus_mesh(48, 24));
  s.add_vertex_polygon(meridian(10, 24));
  s.add_vertex_polygon(meridian(25, 24, true));
  s.scene.shapes = {{0, 1}};
  const SurfaceDivision d = divide(s);
  const double whole = d.area(CellId(0)) + d.area(CellId(1));
  const SurfaceResult r = d.evaluate(parse_set_expression("A"), WindingRule::NonZero);
  EXPECT_TRUE(std::abs(r.region.area / whole - 15.0 / 48) < 1e-9 ||
              std::abs(r.region.area / whole - 33.0 / 48) < 1e-9);
  EXPECT_EQ(r.borders.size(), 2U);
}

TEST(SurfaceDivision, MeridianAndLongitude) {
  SurfaceDrawing s(torus_mesh(9, 6));
  s.add_vertex_polygon(meridian(4, 6));
  s.add_vertex_polygon(longitude(2, 9, 6));
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.cell_count(), 1U);
  EXPECT_EQ(d.counts().cell_edges, 2U);
  for (std::uint32_t p : {0U, 1U}) {
    EXPECT_FALSE(d.polygon_separation(p).mod_2);
    EXPECT_EQ(d.polygon_separation(p).cycle, std::vector<CellId>{CellId(0)});
  }
  EXPECT_THROW(d.select(parse_set_expression("A"), WindingRule::EvenOdd), Error);
}

TEST(SurfaceDivision, HandlesOfGenusTwo) {
  constexpr std::uint32_t kMajor = 12, kMinor = 6;
  const MeshPointer mesh = chain_of_tori(2, kMajor, kMinor);
  EXPECT_EQ(static_cast<long>(mesh->vertex_count()) - static_cast<long>(mesh->edge_count()) +
                static_cast<long>(mesh->face_count()),
            -2);
  // Two loops around the first handle: together they cut off the rest, where the second handle is.
  for (const bool is_opposite : {true, false}) {
    SurfaceDrawing s(mesh);
    s.add_vertex_polygon(meridian(3, kMinor));
    s.add_vertex_polygon(meridian(9, kMinor, is_opposite));
    s.scene.shapes = {{0, 1}, {0}, {1}};
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), 2U);
    EXPECT_EQ(d.shape_separation(0).over_z, is_opposite);
    EXPECT_TRUE(d.shape_separation(0).mod_2);
    EXPECT_FALSE(d.shape_separation(1).mod_2);
    EXPECT_FALSE(d.shape_separation(2).mod_2);
  }
}

TEST(SurfaceDivision, CoresOfACylinder) {
  SurfaceDrawing s(cylinder_mesh(10, 25));
  for (const std::uint32_t up : {6U, 16U}) {
    std::vector<std::uint32_t> ring(10);
    std::iota(ring.begin(), ring.end(), up * 10);
    s.add_vertex_polygon(ring);
  }
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.cell_count(), 3U);
  EXPECT_TRUE(d.shape_separation(0).over_z);
  double whole = 0;
  for (std::uint32_t c = 0; c < 3; ++c) whole += d.area(CellId(c));
  // Inside is above: both run counter-clockwise seen from there.
  expect_answers(d, {{"A + B", .76 * whole, 1},
                     {"A * B", .36 * whole, 1},
                     {"A - B", .4 * whole, 2},
                     {"A ^ B", .4 * whole, 2}});
}

/// All around cube_mesh() where a coordinate has that value.
void add_belt(SurfaceDrawing& s, std::size_t axis, const Rational& height) {
  const SurfaceMesh& mesh = *s.scene.mesh;
  const auto corner = [&](const std::array<double, 2>& uv, double h) {
    std::array<double, 3> p{};
    p[axis] = h;
    p[(axis + 1) % 3] = uv[0];
    p[(axis + 2) % 3] = uv[1];
    std::uint32_t v = 0;
    while (mesh.point(VertexId(v)) != Point3{p[0], p[1], p[2]}) ++v;
    return v;
  };
  const std::array<std::array<double, 2>, 4> ring = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::vector<SurfacePointId> points;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &here = ring[i], &next = ring[(i + 1) % 4];
    points.push_back(s.on_edge(corner(here, 0), corner(here, 1), height));
    try {
      points.push_back(s.on_edge(corner(here, 0), corner(next, 1), height));
    } catch (const Error&) {  // the other diagonal
      points.push_back(s.on_edge(corner(next, 0), corner(here, 1), height));
    }
  }
  s.add_polygon(points);
}

std::vector<double> sorted_areas(const SurfaceDivision& d) {
  std::vector<double> areas;
  for (std::uint32_t c = 0; c < d.cell_count(); ++c) areas.push_back(d.area(CellId(c)));
  std::sort(areas.begin(), areas.end());
  return areas;
}

TEST(SurfaceDivision, BeltsOfACube) {
  SurfaceDrawing s(cube_mesh());
  add_belt(s, 2, tenth(4));
  add_belt(s, 0, tenth(3));
  const SurfaceDivision d = divide(s);
  ASSERT_EQ(d.cell_count(), 4U);
  EXPECT_EQ(d.counts().crossings, 2U);
  const double expected[] = {.94, 1.26, 1.66, 2.14};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sorted_areas(d)[i], expected[i], 1e-12);
  // Inside is z > .4 and x > .3.
  expect_answers(d,
                 {{"A + B", 5.06, 1}, {"A * B", 2.14, 1}, {"A - B", 1.26, 1}, {"A ^ B", 2.92, 2}});
}

// They cross in the middles of faces, on diagonals of the mesh.
TEST(SurfaceDivision, BeltsThroughDiagonals) {
  SurfaceDrawing s(cube_mesh());
  for (const std::size_t belts : {2U, 3U}) {
    if (belts == 2) add_belt(s, 0, tenth(5));
    add_belt(s, belts - 1, tenth(5));
    const SurfaceDivision d = divide(s);
    EXPECT_EQ(d.cell_count(), belts == 2 ? 4U : 8U);
    EXPECT_EQ(d.counts().crossings, belts == 2 ? 2U : 6U);
    for (const double area : sorted_areas(d)) EXPECT_NEAR(area, belts == 2 ? 1.5 : 0.75, 1e-12);
  }
}

TEST(SurfaceDivision, TwoComponents) {
  const MeshPointer parts[] = {grid_mesh(6, 6), torus_mesh(8, 6)};
  SurfaceDrawing s(joined_meshes(parts));
  s.add_box({1, 1}, {3, 3});
  // Around a vertex of the torus.
  const std::uint32_t first = 49, i = 3, j = 2, minor = 6;
  const auto id = [&](std::uint32_t a, std::uint32_t b) { return first + a * minor + b; };
  const std::uint32_t ring[] = {id(i + 1, j), id(i + 1, j + 1), id(i, j + 1),
                                id(i - 1, j), id(i - 1, j - 1), id(i, j - 1)};
  s.add_vertex_polygon(ring);
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.cell_count(), 4U);
  EXPECT_TRUE(d.shape_separation(0).over_z && d.shape_separation(1).over_z);
  const double b = d.select(parse_set_expression("B"), WindingRule::EvenOdd).area;
  expect_answers(d, {{"A + B", 4 + b, 2}, {"A * B", 0, 0}, {"A - B", 4, 1}, {"A ^ B", 4 + b, 2}});
}

// ---------------------------------------------------------------- limits and refusals

TEST(SurfaceDivision, OutsideIsWhereItIsSaid) {
  SurfaceDrawing s(grid_mesh(6, 6));
  s.add_box({1, 1}, {5, 5});
  s.add_box({2, 2}, {4, 4});
  const SurfacePointId inner = s.at(Rational(31) / 10, Rational(32) / 10);
  s.scene.outside = s.scene.polygons.points.face(inner);
  const SurfaceDivision d = divide(s);
  expect_answers(d, {{"A", 20, 1}, {"B", 32, 1}}, WindingRule::NonZero);
}

// Borders of regions that end at the mesh border follow it; those that are nothing else are no
// loops.
TEST(SurfaceDivision, RegionsAtTheMeshBorder) {
  SurfaceDrawing s(grid_mesh(6, 6, 3));
  s.add_box({0, 1}, {3, 4});
  s.add_box({2, 0}, {6, 3});
  const RationalPoint2 all[] = {{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  s.add_flat_polygon(all);
  const SurfaceDivision d = divide(s);
  EXPECT_EQ(d.cell_count(), 5U);
  const Answer answers[] = {{"A", 9, 1},     {"!A", 27, 1},       {"A + B", 19, 1}, {"A * B", 2, 1},
                            {"A - B", 7, 1}, {"!(A + B)", 17, 2}, {"C", 0, 0},      {"!C", 36, 0}};
  for (const Answer& a : answers) {
    SCOPED_TRACE(a.expression);
    expect_answers(d, {a});
    // The loops as polygons: around the region they have its area.
    SurfaceScene again{s.scene.mesh,
                       d.evaluate(parse_set_expression(a.expression), WindingRule::EvenOdd).borders,
                       {},
                       FaceId{}};
    if (again.polygons.size() == 0) continue;
    std::vector<std::uint32_t> loops(again.polygons.size());
    std::iota(loops.begin(), loops.end(), 0U);
    again.shapes = {loops};
    Context context;
    const SurfaceDivision second(again, context);
    EXPECT_EQ(audit(second).value_or(""), "");
    const double in = second.select(parse_set_expression("A"), WindingRule::NonZero).area;
    EXPECT_TRUE(std::abs(in - a.area) < 1e-9 || std::abs(36 - in - a.area) < 1e-9) << in;
  }
}

TEST(SurfaceDivision, StopsAtLimits) {
  SurfaceDrawing s(grid_mesh(3, 3));
  for (int i = 1; i < 60; ++i) {
    s.add_box({Rational(i) / 100, Rational(1) / 100}, {1 + Rational(i) / 70, Rational(1 + i) / 40});
  }
  Limits limits;
  limits.max_memory_bytes = 1U << 16;
  Context small(limits);
  EXPECT_THROW(SurfaceDivision(s.scene, small), Error);
  std::stop_source stop;
  stop.request_stop();
  Context stopped({}, stop.get_token());
  EXPECT_THROW(SurfaceDivision(s.scene, stopped), Error);
  divide(s);
}

TEST(SurfaceDivision, RefusesToWindBeyondItsNumbers) {
  SurfaceDrawing s(grid_mesh(2, 2));
  std::vector<RationalPoint2> round;
  for (int i = 0; i < 1 << 9; ++i) {
    for (const RationalPoint2& p : {tenths(5, 1), tenths(7, 1), tenths(6, 2)}) round.push_back(p);
  }
  s.add_flat_polygon(round);
  s.scene.shapes = {std::vector<std::uint32_t>(1 << 22, 0)};
  Context context;
  EXPECT_THROW(SurfaceDivision(s.scene, context), Error);
  s.scene.shapes = {std::vector<std::uint32_t>((1 << 22) - 1, 0)};
  const SurfaceDivision d(s.scene, context);
  EXPECT_EQ(d.cell_count(), 2U);
}

TEST(SurfaceDivision, RefusesWhatIsNoScene) {
  SurfaceDrawing s(grid_mesh(2, 2));
  s.add_box(tenths(1, 1), tenths(5, 2));
  Context context;
  SurfaceScene broken = s.scene;
  broken.shapes = {{0, 7}};
  EXPECT_THROW(SurfaceDivision(broken, context), Error);
  broken = s.scene;
  broken.polygons.face[1] = FaceId(7);
  EXPECT_THROW(SurfaceDivision(broken, context), Error);
  broken = s.scene;
  broken.outside = FaceId(99);
  EXPECT_THROW(SurfaceDivision(broken, context), Error);
  const SurfaceDivision d = divide(s);
  EXPECT_THROW(d.select(parse_set_expression("A + B"), WindingRule::EvenOdd), Error);
  EXPECT_THROW(d.select(parse_set_expression("s1x"), WindingRule::EvenOdd), Error);
  EXPECT_EQ(d.select(parse_set_expression("s0"), WindingRule::EvenOdd).generators,
            std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace plumb::testing::surface_test
