// What is made of divided surfaces: triangles for output, and loops that repair what does not
// separate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stop_token>

#include "generate/surface_scenes.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/surface_audit.h"
#include "plumb/surface/surface_homology.h"
#include "plumb/surface/triangulation.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

// ---------------------------------------------------------------- triangles

double area_of(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  return std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z) / 2;
}

/// Adjacency is complete and mutual; cells change across arcs only; areas are those of the cells.
void expect_triangulation(const SurfaceDivision& d, const SurfaceTriangulation& t) {
  const auto corner = [&](std::uint32_t s) { return t.triangles[s / 3][s % 3]; };
  const auto next = [](std::uint32_t s) { return s % 3 == 2 ? s - 2 : s + 1; };
  std::size_t border = 0;
  for (std::uint32_t s = 0; s < 3 * t.triangles.size(); ++s) {
    const std::uint32_t o = t.across[s];
    if (o == kNone) {
      ++border;
      continue;
    }
    ASSERT_EQ(t.across[o], s);
    EXPECT_EQ(corner(s), corner(next(o)));
    EXPECT_EQ(corner(next(s)), corner(o));
    EXPECT_EQ(t.arc[s], t.arc[o]);
    if (!t.arc[s].is_valid()) {
      EXPECT_EQ(t.cell[s / 3], t.cell[o / 3]);
    }
  }
  std::size_t expected_border = 0;
  for (std::uint32_t h = 0; h < 3 * d.mesh().face_count(); ++h) {
    if (d.mesh().is_border(HalfedgeId(h))) ++expected_border;
  }
  EXPECT_EQ(border == 0, expected_border == 0);
  EXPECT_GE(border, expected_border);
  std::vector<double> area(d.cell_count());
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    const SurfaceTriangle& c = t.triangles[i];
    area[t.cell[i].value()] += area_of(t.points[c[0]], t.points[c[1]], t.points[c[2]]);
  }
  for (std::uint32_t c = 0; c < d.cell_count(); ++c) {
    EXPECT_NEAR(area[c], d.area(CellId(c)), 1e-9);
  }
}

/// Within faces no corner across an edge without polygon lies inside a circle. Exact, for flat
/// meshes.
void expect_delaunay(const SurfaceDivision& d, const SurfaceTriangulation& t) {
  const SurfacePointTable& points = d.scene().polygons.points;
  const auto place = [&](std::uint32_t p, FaceId f) {
    if (!t.node[p].is_valid()) {
      const Point3& q = t.points[p];
      return RationalPoint2{exact_rational(q.x), exact_rational(q.y)};
    }
    const RationalPoint2 uv = exact_node(d.arrangement(), points, t.node[p], f);
    const auto at = [&](std::size_t i) {
      const Point3& q = d.mesh().point(d.mesh().corner(f, i));
      return RationalPoint2{exact_rational(q.x), exact_rational(q.y)};
    };
    const RationalPoint2 a = at(0), b = at(1), c = at(2);
    return RationalPoint2{a.x + uv.x * (b.x - a.x) + uv.y * (c.x - a.x),
                          a.y + uv.x * (b.y - a.y) + uv.y * (c.y - a.y)};
  };
  for (std::uint32_t s = 0; s < 3 * t.triangles.size(); ++s) {
    const std::uint32_t o = t.across[s];
    if (o == kNone || t.arc[s].is_valid()) continue;
    const FaceId f = t.face[s / 3];
    if (t.face[o / 3] != f) continue;
    const SurfaceTriangle& c = t.triangles[s / 3];
    const RationalPoint2 x = place(c[0], f), y = place(c[1], f), z = place(c[2], f);
    EXPECT_EQ(orient2d(x, y, z), Sign::Positive);
    EXPECT_NE(incircle(x, y, z, place(t.triangles[o / 3][(o + 2) % 3], f)), Sign::Positive);
  }
}

TEST(SurfaceTriangulation, FlatScenes) {
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SurfaceDrawing s(grid_mesh(3, 2, seed));
    const std::int64_t unit = seed % 2 == 0 ? 4 : 97;
    for (int p = 0; p < 3; ++p) {
      std::vector<RationalPoint2> corners;
      for (int i = 0; i < 5; ++i) {
        const Rational x = Rational(dice.between(0, 3 * unit)) / unit;
        const Rational y = Rational(dice.between(0, 2 * unit)) / unit;
        corners.push_back({x, y});
      }
      s.add_flat_polygon(corners);
    }
    Context context;
    const SurfaceDivision d(s.scene, context);
    const SurfaceTriangulation t = triangulate_surface(d, context);
    expect_triangulation(d, t);
    expect_delaunay(d, t);
  }
}

TEST(SurfaceTriangulation, WithIslandsAndHoles) {
  SurfaceDrawing s(grid_mesh(1, 1));
  const auto box = [&](int low, int high) {
    s.add_box({Rational(1) / 2 + Rational(low) / 40, Rational(low) / 40},
              {Rational(1) / 2 + Rational(high) / 40, Rational(high) / 40});
  };
  box(2, 9);
  box(3, 8);
  box(4, 5);
  box(6, 7);
  Context context;
  const SurfaceDivision d(s.scene, context);
  EXPECT_EQ(d.cell_count(), 5U);
  const SurfaceTriangulation t = triangulate_surface(d, context);
  expect_triangulation(d, t);
  expect_delaunay(d, t);
}

// ---------------------------------------------------------------- homology

std::vector<std::uint32_t> loop_on(const SurfaceMesh& mesh, Dice& dice, const SurfaceHomology& h) {
  // A generator, with a detour around a random vertex of the mesh that it may or may not run
  // through.
  std::vector<std::uint32_t> loop;
  for (const VertexId v : h.generator(dice.below(h.generator_count()))) loop.push_back(v.value());
  const std::size_t at = dice.below(loop.size());
  const HalfedgeId out = mesh.halfedge(VertexId(loop[at]));
  const std::uint32_t detour[] = {mesh.target(out).value(),
                                  mesh.target(SurfaceMesh::next(out)).value(), loop[at]};
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::begin(detour),
              std::end(detour));
  return loop;
}

TEST(SurfaceHomology, GeneratorsAreTwiceTheGenus) {
  const std::pair<MeshPointer, std::size_t> cases[] = {
      {sphere_mesh(2), 0},         {torus_mesh(7, 5), 2},    {chain_of_tori(2, 6, 4), 4},
      {chain_of_tori(3, 6, 4), 6}, {cylinder_mesh(6, 3), 0}, {grid_mesh(3, 3), 0},
  };
  for (const auto& [mesh, count] : cases) {
    Context context;
    const SurfaceHomology h(*mesh, context);
    ASSERT_EQ(h.generator_count(), count);
    SurfacePolygons polygons(*mesh);
    for (std::size_t i = 0; i < count; ++i) h.add_generator(i, i % 2 == 1, polygons);
    require_valid(polygons);
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::int64_t> expected(count);
      expected[i] = i % 2 == 1 ? -1 : 1;
      EXPECT_EQ(h.class_of(polygons, i, context), expected);
    }
  }
}

TEST(SurfaceHomology, RepairedShapesSeparate) {
  const MeshPointer meshes[] = {torus_mesh(7, 5), chain_of_tori(2, 6, 4), chain_of_tori(3, 6, 4)};
  for (std::uint64_t seed = 0; seed < 30 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SurfaceDrawing s(meshes[seed % 3]);
    Context context;
    const SurfaceHomology h(*s.scene.mesh, context);
    for (int p = 0; p < 3; ++p) s.add_vertex_polygon(loop_on(*s.scene.mesh, dice, h));
    std::vector<std::uint32_t> shape = {0, 1, 2, 1};
    const std::vector<std::int64_t> before = h.class_of(s.scene.polygons, shape, context);
    s.scene.shapes = {shape};
    {
      const SurfaceDivision d(s.scene, context);
      EXPECT_EQ(audit(d).value_or(""), "");
      const bool is_zero = std::ranges::all_of(before, [](std::int64_t k) { return k == 0; });
      EXPECT_EQ(d.shape_separation(0).over_z, is_zero);
      const bool is_even = std::ranges::all_of(before, [](std::int64_t k) { return k % 2 == 0; });
      EXPECT_EQ(d.shape_separation(0).mod_2, is_even);
    }
    const std::vector<std::uint32_t> added = h.add_repair(shape, s.scene.polygons, context);
    shape.insert(shape.end(), added.begin(), added.end());
    s.scene.shapes = {shape};
    const SurfaceDivision d(s.scene, context);
    EXPECT_TRUE(d.shape_separation(0).over_z);
    EXPECT_EQ(audit(d).value_or(""), "");
  }
}

// However often a shape names a polygon, it is looked at once; and it can be stopped.
TEST(SurfaceHomology, ShapesThatNameOnePolygonOften) {
  SurfaceDrawing s(torus_mesh(7, 5));
  Context context;
  const SurfaceHomology h(*s.scene.mesh, context);
  std::vector<std::uint32_t> loop;
  for (const VertexId v : h.generator(0)) loop.push_back(v.value());
  const std::uint32_t there = loop[0], back = loop[1];
  for (int i = 0; i < 20000; ++i) loop.insert(loop.end(), {there, back});
  s.add_vertex_polygon(loop);
  const std::vector<std::uint32_t> shape(1000000, 0);
  Limits limits;
  limits.max_seconds = 5;
  Context timed(limits);
  std::vector<std::int64_t> expected = h.class_of(s.scene.polygons, 0, context);
  EXPECT_NE(expected, std::vector<std::int64_t>(2));
  for (std::int64_t& k : expected) k *= 1000000;
  EXPECT_EQ(h.class_of(s.scene.polygons, shape, timed), expected);
  std::stop_source stop;
  stop.request_stop();
  Context stopped({}, stop.get_token());
  EXPECT_THROW(h.class_of(s.scene.polygons, shape, stopped), Error);
}

// Paths across faces, not along edges: what separates is what has class zero.
TEST(SurfaceHomology, ClassesOfPathsAcrossFaces) {
  for (std::uint64_t seed = 0; seed < 30 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SurfaceDrawing s(chain_of_tori(2, 5, 4));
    const SurfaceMesh& m = *s.scene.mesh;
    FaceId f(dice.below(m.face_count()));
    const FaceId start = f;
    std::vector<SurfacePointId> points;
    for (int step = 0; step < 3000 && (step < 4 || f != start); ++step) {
      const HalfedgeId side = SurfaceMesh::halfedge(f, dice.below(3));
      const Rational t = Rational(dice.between(1, 999)) / 1000;
      points.push_back(s.scene.polygons.points.add_on_edge(m.edge(side), t));
      f = SurfaceMesh::face(m.twin(side));
    }
    if (f != start) continue;
    s.add_polygon(points);
    Context context;
    const SurfaceDivision d(s.scene, context);
    EXPECT_EQ(audit(d).value_or(""), "");
    const SurfaceHomology h(m, context);
    const auto times = h.class_of(s.scene.polygons, 0, context);
    const bool is_zero = std::ranges::all_of(times, [](std::int64_t k) { return k == 0; });
    const bool is_even = std::ranges::all_of(times, [](std::int64_t k) { return k % 2 == 0; });
    EXPECT_EQ(d.polygon_separation(0).over_z, is_zero);
    EXPECT_EQ(d.polygon_separation(0).mod_2, is_even);
  }
}

}  // namespace
}  // namespace plumb::testing
