// Tracing: what the path passes through, that it is the same both ways, how long it is.

#include "plumb/surface/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "generate/surface_meshes.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::trace_test {
namespace {

/// A mesh with points on it, and the paths between them.
class Drawing {
 public:
  explicit Drawing(SurfaceMesh mesh)
      : mesh_(std::make_unique<SurfaceMesh>(std::move(mesh))), points(*mesh_), tracer_(*mesh_) {}

  const SurfaceMesh& mesh() const { return *mesh_; }
  SurfacePath traced(SurfacePointId a, SurfacePointId b) {
    std::optional<SurfacePath> path = tracer_.trace(points, a, b, context_);
    EXPECT_TRUE(path.has_value());
    if (path) check(*path, a, b);
    return path.value_or(SurfacePath{});
  }
  std::optional<SurfacePath> tried(SurfacePointId a, SurfacePointId b) {
    return tracer_.trace(points, a, b, context_);
  }
  double length(const SurfacePath& path) const {
    double sum = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const Point3 p = points.position(path.points[i - 1]), q = points.position(path.points[i]);
      sum += std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    }
    return sum;
  }
  /// "v3 e17:1/2 f4:1/3,1/4": what the path is, exactly.
  std::string text(const SurfacePath& path) const {
    std::string text;
    for (const SurfacePointId p : path.points) {
      const RationalPoint2 at = points.exact(p);
      switch (points.place(p)) {
        case SurfacePlace::Vertex:
          text += "v" + std::to_string(points.vertex(p).value()) + ' ';
          break;
        case SurfacePlace::Edge:
          text += "e" + std::to_string(points.edge(p).value()) + ':' + at.x.str() + ' ';
          break;
        case SurfacePlace::Face:
          text += "f" + std::to_string(points.face(p).value()) + ':' + at.x.str() + ',' +
                  at.y.str() + ' ';
      }
    }
    return text;
  }
  SurfacePointId some_point(Dice& dice) {
    const FaceId f(dice.below(mesh_->face_count()));
    const auto u = static_cast<double>(dice.between(0, 64)) / 64;
    const auto part = static_cast<double>(dice.between(0, 64)) / 64;
    const double v = std::floor((1 - u) * part * 64) / 64;
    return points.add_in_face(f, u, v);
  }

 private:
  /// Each segment lies in its face, and no point follows itself.
  void check(const SurfacePath& path, SurfacePointId a, SurfacePointId b) const {
    ASSERT_EQ(path.points.size(), path.faces.size() + 1);
    EXPECT_TRUE(points.is_same(path.points.front(), a));
    EXPECT_TRUE(points.is_same(path.points.back(), b));
    for (std::size_t i = 0; i < path.faces.size(); ++i) {
      EXPECT_TRUE(points.is_in(path.points[i], path.faces[i])) << text(path) << i;
      EXPECT_TRUE(points.is_in(path.points[i + 1], path.faces[i])) << text(path) << i;
      EXPECT_FALSE(points.is_same(path.points[i], path.points[i + 1])) << text(path) << i;
    }
  }

  std::unique_ptr<SurfaceMesh> mesh_;

 public:
  SurfacePointTable points;

 private:
  Tracer tracer_;
  Context context_;
};

constexpr std::uint32_t kGrid = 8;

SurfacePointId grid_vertex(Drawing& d, std::uint32_t x, std::uint32_t y) {
  return d.points.add_vertex(VertexId((kGrid + 1) * y + x));
}

/// How many points of the path are vertices.
std::size_t vertices_of(const Drawing& d, const SurfacePath& path) {
  return static_cast<std::size_t>(std::ranges::count_if(
      path.points, [&](SurfacePointId p) { return d.points.place(p) == SurfacePlace::Vertex; }));
}

// ---------------------------------------------------------------- flat

TEST(trace, along_edges_and_diagonals_through_every_vertex) {
  Drawing d(grid_surface(kGrid));
  const auto expect_vertices = [&](std::uint32_t x, std::uint32_t y, std::uint32_t x2,
                                   std::uint32_t y2, std::size_t vertices) {
    const SurfacePath path = d.traced(grid_vertex(d, x, y), grid_vertex(d, x2, y2));
    EXPECT_EQ(path.points.size(), vertices) << d.text(path);
    EXPECT_EQ(vertices_of(d, path), vertices) << d.text(path);
  };
  expect_vertices(1, 3, 7, 3, 7);
  expect_vertices(2, 0, 2, 8, 9);
  expect_vertices(0, 0, 8, 8, 9);
  expect_vertices(6, 7, 1, 2, 6);
}

/// A strip of two rows: the line between them passes a vertex at every step.
TEST(trace, along_a_line_of_many_vertices) {
  constexpr std::uint32_t kLong = 100000;
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t x = 0; x <= kLong; ++x) {
    for (std::uint32_t y = 0; y < 3; ++y) {
      points.push_back({static_cast<double>(x), static_cast<double>(y), 0});
      if (x == kLong || y == 2) continue;
      const std::uint32_t a = 3 * x + y;
      triangles.push_back({a, a + 3, a + 4});
      triangles.push_back({a, a + 4, a + 1});
    }
  }
  Drawing d(SurfaceMesh(points, triangles));
  const SurfacePath path =
      d.traced(d.points.add_vertex(VertexId(1)), d.points.add_vertex(VertexId(3 * kLong + 1)));
  EXPECT_GE(path.points.size(), kLong + 1);  // more where a strip as long is laid out with rounding
  EXPECT_NEAR(d.length(path), kLong, 1e-6);
}

TEST(trace, across_diagonals_through_vertices_and_middles) {
  Drawing d(grid_surface(kGrid));
  const SurfacePath path = d.traced(grid_vertex(d, 1, 7), grid_vertex(d, 7, 1));
  EXPECT_EQ(path.points.size(), 13U) << d.text(path);
  EXPECT_EQ(vertices_of(d, path), 7U) << d.text(path);
}

TEST(trace, straight_on_a_flat_mesh) {
  Drawing d(grid_surface(kGrid));
  Dice dice(1);
  for (int i = 0; i < 400; ++i) {
    const SurfacePointId a = d.some_point(dice), b = d.some_point(dice);
    const Point3 p = d.points.position(a), q = d.points.position(b);
    EXPECT_NEAR(d.length(d.traced(a, b)), std::hypot(p.x - q.x, p.y - q.y), 1e-12);
  }
}

/// The grid in a tilted plane; lattice points keep doubles.
SurfaceMesh tilted_grid(std::uint32_t n) {
  const SurfaceMesh grid = grid_surface(n);
  std::vector<Point3> points;
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t v = 0; v < grid.vertex_count(); ++v) {
    const Point3& p = grid.point(VertexId(v));
    points.push_back({p.x + 2 * p.y, p.x - p.y, 3 * p.x + p.y});
  }
  for (std::uint32_t f = 0; f < grid.face_count(); ++f)
    triangles.push_back(grid.corners(FaceId(f)));
  return {std::move(points), std::move(triangles)};
}

/// Where a point of a path lies on the grid.
RationalPoint2 grid_place(const SurfacePointTable& points, SurfacePointId p, FaceId f,
                          std::uint32_t n) {
  const RationalPoint2 w = points.exact_in(p, f);
  const Rational weights[3] = {1 - w.x - w.y, w.x, w.y};
  RationalPoint2 at{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = points.mesh().corner(f, k).value();
    at.x += weights[k] * (v % (n + 1));
    at.y += weights[k] * (v / (n + 1));
  }
  return at;
}

TEST(trace, exactly_straight_on_a_flat_mesh) {
  constexpr std::uint32_t kSide = 5;
  Dice dice(1);
  int crossings = 0;
  for (const bool is_tilted : {false, true}) {
    Drawing d(is_tilted ? tilted_grid(kSide) : grid_surface(kSide));
    for (int i = 0; i < 150; ++i) {
      const SurfacePointId a = d.some_point(dice), b = d.some_point(dice);
      if (d.points.is_same(a, b)) continue;
      const SurfacePath path = d.traced(a, b);
      const RationalPoint2 from = grid_place(d.points, a, path.faces.front(), kSide);
      const RationalPoint2 to = grid_place(d.points, b, path.faces.back(), kSide);
      for (std::size_t k = 0; k < path.faces.size(); ++k) {
        const RationalPoint2 at = grid_place(d.points, path.points[k], path.faces[k], kSide);
        EXPECT_EQ((to.x - from.x) * (at.y - from.y), (to.y - from.y) * (at.x - from.x))
            << d.text(path) << k;
        if (d.points.place(path.points[k]) == SurfacePlace::Edge) ++crossings;
      }
    }
  }
  EXPECT_GT(crossings, 500);
}

// Two triangles that lie upon each other: the line goes around their common side.
TEST(trace, folded_faces_are_not_flat) {
  Drawing d(SurfaceMesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {5, 1, 0}},
                        {{0, 1, 2}, {2, 1, 3}, {3, 1, 4}}));
  const SurfacePointId a = d.points.add_in_face(FaceId(0), 0.125, 0.25);
  const SurfacePointId b = d.points.add_in_face(FaceId(1), 0.25, 0.5);
  const SurfacePath path = d.traced(a, b);
  ASSERT_EQ(path.points.size(), 3U);
  // Mirrored in the side x + y = 4, b (1.5, 1.5) is (2.5, 2.5); a is (0.5, 1).
  EXPECT_NEAR(d.length(path), std::hypot(2, 1.5), 1e-12);
}

TEST(trace, a_few_faces_seen_from_each_other_are_joined_straight) {
  Drawing d(grid_surface(1));
  const SurfacePointId a = d.points.add_in_face(FaceId(0), .5, 0);
  const SurfacePointId b = d.points.add_in_face(FaceId(1), 0, .5);
  const SurfacePath path = d.traced(a, b);
  ASSERT_EQ(path.points.size(), 3U);
  EXPECT_EQ(d.points.exact(path.points[1]).x, Rational(1) / 4);
}

TEST(trace, ordinary_ties) {
  Drawing d(grid_surface(2));
  const SurfacePointId in_face = d.points.add_in_face(FaceId(0), .25, .25);
  const SurfacePointId same = d.points.add_in_face(FaceId(0), .25, .25);
  EXPECT_EQ(d.traced(in_face, same).points.size(), 1U);
  EXPECT_TRUE(d.traced(in_face, same).faces.empty());
  const SurfacePointId on_edge = d.points.add_on_edge(d.mesh().edge(HalfedgeId(0)), .25);
  const SurfacePointId further = d.points.add_on_edge(d.mesh().edge(HalfedgeId(0)), .75);
  EXPECT_EQ(d.traced(on_edge, further).points.size(), 2U);
  EXPECT_EQ(d.traced(in_face, on_edge).points.size(), 2U);
  const SurfacePointId corner = d.points.add_vertex(VertexId(0));
  EXPECT_EQ(d.traced(corner, on_edge).points.size(), 2U);
  EXPECT_EQ(d.traced(corner, d.points.add_vertex(VertexId(1))).points.size(), 2U);
  EXPECT_EQ(d.traced(corner, d.points.add_vertex(VertexId(4))).points.size(), 2U);
}

TEST(trace, a_hair_beside_a_vertex_is_not_through_it) {
  Drawing d(grid_surface(kGrid));
  constexpr double kHair = 1e-8;
  const EdgeId bottom = d.mesh().edge(HalfedgeId(6 * 3));  // (3, 0) to (4, 0)
  const SurfacePointId a = d.points.add_on_edge(bottom, kHair);
  const SurfacePointId b = grid_vertex(d, 3, 8);
  const SurfacePath path = d.traced(a, b);
  EXPECT_EQ(vertices_of(d, path), 1U) << d.text(path);
}

// ---------------------------------------------------------------- both ways

void expect_canonical(Drawing& d, SurfacePointId a, SurfacePointId b) {
  SurfacePath there = d.traced(a, b);
  const SurfacePath back = d.traced(b, a);
  std::ranges::reverse(there.points);
  std::ranges::reverse(there.faces);
  EXPECT_EQ(d.text(there), d.text(back));
  EXPECT_EQ(there.faces, back.faces);
}

TEST(trace, the_same_path_either_way) {
  std::vector<Drawing> drawings;
  drawings.emplace_back(grid_surface(kGrid));
  drawings.emplace_back(torus_surface(24, 12, .4));
  drawings.emplace_back(sphere_surface(3));
  drawings.emplace_back(cylinder_surface(12, 5));
  Dice dice(2);
  for (Drawing& d : drawings) {
    for (int i = 0; i < 60; ++i) {
      const SurfacePointId a = d.some_point(dice), b = d.some_point(dice);
      expect_canonical(d, a, b);
    }
  }
}

TEST(trace, the_same_point_given_in_another_face) {
  Drawing d(sphere_surface(2));
  const HalfedgeId h(17), t = d.mesh().twin(h);
  const auto on = [&](HalfedgeId side, const Rational& weight_of_target) {
    const std::size_t k = SurfaceMesh::side(side);
    const Rational w = weight_of_target, rest = 1 - weight_of_target;
    const FaceId f = SurfaceMesh::face(side);
    return k == 0   ? d.points.add_in_face(f, w, 0)
           : k == 1 ? d.points.add_in_face(f, rest, w)
                    : d.points.add_in_face(f, 0, rest);
  };
  const SurfacePointId a = on(h, Rational(3) / 10), b = on(t, Rational(7) / 10);
  EXPECT_TRUE(d.points.is_same(a, b));
  const SurfacePointId far = d.points.add_in_face(FaceId(200), .25, .5);
  EXPECT_EQ(d.text(d.traced(a, far)), d.text(d.traced(b, far)));
}

// ---------------------------------------------------------------- lengths

/// At each inner vertex of a locally shortest path there is half a turn or more on both sides, so
/// nothing near it is shorter; compared here with the closed form.
TEST(trace, great_circles_on_a_sphere) {
  Drawing d(sphere_surface(5));
  Dice dice(3);
  for (int i = 0; i < 100; ++i) {
    const SurfacePointId a = d.some_point(dice), b = d.some_point(dice);
    const Point3 p = d.points.position(a), q = d.points.position(b);
    const double cosine =
        (p.x * q.x + p.y * q.y + p.z * q.z) / std::hypot(p.x, p.y, p.z) / std::hypot(q.x, q.y, q.z);
    const double angle = std::acos(std::clamp(cosine, -1., 1.));
    if (angle > 2.8) continue;  // nearly opposite: shortest either way
    const double length = d.length(d.traced(a, b));
    EXPECT_NEAR(length, angle, 2e-3 * angle + 1e-4);
  }
}

TEST(trace, helices_on_a_cylinder) {
  constexpr std::uint32_t kRing = 40, kRows = 6;
  Drawing d(cylinder_surface(kRing, kRows));
  const double side = 2 * std::sin(std::numbers::pi / kRing);
  for (std::uint32_t around = 1; around < kRing / 2; ++around) {
    for (std::uint32_t up = 0; up <= kRows; ++up) {
      const SurfacePath path =
          d.traced(d.points.add_vertex(VertexId(0)),
                   d.points.add_vertex(VertexId(std::size_t{around} * (kRows + 1) + up)));
      EXPECT_NEAR(d.length(path), std::hypot(side * around, up), 1e-9);
    }
  }
}

TEST(trace, never_longer_than_along_meridian_and_parallel) {
  constexpr std::uint32_t kRing = 48, kTube = 24;
  Drawing d(torus_surface(kRing, kTube, .4));
  for (std::uint32_t i = 1; i < kRing / 2; ++i) {
    for (std::uint32_t j = 0; j < kTube / 2; ++j) {
      const SurfacePath path = d.traced(d.points.add_vertex(VertexId(0)),
                                        d.points.add_vertex(VertexId(std::size_t{i} * kTube + j)));
      const double radius = 1 + .4 * std::cos(2 * std::numbers::pi * j / kTube);
      const double bound = 2 * kRing * std::sin(std::numbers::pi / kRing) * radius * i / kRing +
                           2 * kTube * std::sin(std::numbers::pi / kTube) * .4 * j / kTube;
      EXPECT_LE(d.length(path), bound + 1e-9) << i << ' ' << j;
    }
  }
}

TEST(trace, around_a_notch_through_its_tip) {
  // The square [0, 2] x [0, 2] without the triangle (0, 2), (1, 1), (2, 2).
  const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}};
  Drawing d(SurfaceMesh(points, {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}}));
  const SurfacePath path =
      d.traced(d.points.add_in_face(FaceId(2), 0, .75), d.points.add_in_face(FaceId(1), .75, 0));
  EXPECT_EQ(vertices_of(d, path), 1U) << d.text(path);
  EXPECT_NE(d.text(path).find("v3 "), std::string::npos) << d.text(path);
}

// ---------------------------------------------------------------- what cannot be

TEST(trace, no_path_between_components_or_from_an_isolated_vertex) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0},
                                   {6, 0, 0}, {5, 1, 0}, {9, 9, 9}};
  Drawing d(SurfaceMesh(points, {{0, 1, 2}, {3, 4, 5}}));
  const SurfacePointId a = d.points.add_vertex(VertexId(0)), b = d.points.add_vertex(VertexId(3));
  EXPECT_FALSE(d.tried(a, b).has_value());
  EXPECT_FALSE(d.tried(a, d.points.add_vertex(VertexId(6))).has_value());
}

/// Huge, tiny and flat triangles: a path all the same.
TEST(trace, meshes_without_proportions) {
  for (const double size : {1e300, 1e-300, 0.}) {
    std::vector<Point3> points;
    const SurfaceMesh grid = grid_surface(4);
    std::vector<SurfaceTriangle> triangles;
    for (std::uint32_t v = 0; v < grid.vertex_count(); ++v) {
      const Point3 p = grid.point(VertexId(v));
      points.push_back({p.x * size, p.y * size * (v % 2), 0});
    }
    for (std::uint32_t f = 0; f < grid.face_count(); ++f) {
      triangles.push_back(grid.corners(FaceId(f)));
    }
    Drawing d(SurfaceMesh(points, triangles));
    Dice dice(4);
    for (int i = 0; i < 40; ++i) {
      const SurfacePointId a = d.some_point(dice), b = d.some_point(dice);
      expect_canonical(d, a, b);
    }
  }
}

}  // namespace
}  // namespace plumb::testing::trace_test
