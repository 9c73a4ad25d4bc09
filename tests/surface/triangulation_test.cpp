// Triangles for output that are made of divided surfaces.
#include "plumb/surface/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "generate/surface_scenes.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/surface/cells/surface_arrangement.h"
#include "plumb/surface/surface_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::triangulation_test {
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

}  // namespace
}  // namespace plumb::testing::triangulation_test
