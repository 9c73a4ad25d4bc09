// Straight lines from a point of a mesh: on flat meshes a similarity, elsewhere as long as they are
// said to be.

#include "plumb/surface/exponential_map.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "generate/surface_meshes.h"
#include "plumb/base/internal/degrees.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/trace.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::exponential_map_test {
namespace {

constexpr double kPi = std::numbers::pi;

double distance(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// A mesh, a centre and lines from there.
struct Fan {
  Fan(SurfaceMesh surface, std::uint32_t face, double u, double v, double angle = 0)
      : mesh(std::make_unique<const SurfaceMesh>(std::move(surface))),
        points(*mesh),
        centre(points.add_in_face(FaceId(face), u, v)),
        map(points, centre, FaceId(face), angle) {}

  std::optional<SurfacePointId> at(double x, double y) { return map.add({x, y}, points, context); }

  std::unique_ptr<const SurfaceMesh> mesh;
  SurfacePointTable points;
  SurfacePointId centre;
  ExponentialMap map;
  Context context;
};

struct Centre {
  std::uint32_t face;  ///< of grid_surface(8): 2 (8 y + x), and the next for the upper triangle
  double u, v;
};

/// In faces, on edges, on vertices; some at the border.
const std::vector<Centre> kCentres{{2 * (8 * 3 + 4), .25, .5},
                                   {2 * (8 * 3 + 4) + 1, .25, .5},
                                   {2 * (8 * 3 + 4), .5, 0},
                                   {2 * (8 * 3 + 4), .5, .5},
                                   {2 * (8 * 3 + 4), 0, .5},
                                   {2 * (8 * 3 + 4), 0, 0},
                                   {2 * (8 * 3 + 4), 1, 0},
                                   {2 * (8 * 3 + 4) + 1, 1, 0},
                                   {2 * (8 * 3 + 4) + 1, 0, 1},
                                   {2 * 4, .5, 0},
                                   {2 * 4, 0, 0},
                                   {2 * 4, 1, 0},
                                   {0, 0, 0},
                                   {1, 0, 0},
                                   {2 * 63, 0, 1}};

TEST(ExponentialMap, FlatMeshesAreMappedBySimilarities) {
  for (const Centre& c : kCentres) {
    for (const double angle : {0., 30., 90., -45., 180., 1000.}) {
      Fan fan(grid_surface(8), c.face, c.u, c.v, angle);
      const Point3 from = fan.points.position(fan.centre);
      const Point2 x_axis = unit_vector(angle + (c.face % 2 == 1 ? 45 : 0));
      Dice dice(c.face);
      for (int i = 0; i < 200; ++i) {
        const double x = static_cast<double>(dice.between(-64, 64)) / 8;
        const double y = static_cast<double>(dice.between(-64, 64)) / 8;
        const double to_x = from.x + x * x_axis.x - y * x_axis.y;
        const double to_y = from.y + x * x_axis.y + y * x_axis.x;
        const double over = std::max({-to_x, -to_y, to_x - 8, to_y - 8});
        const auto p = fan.at(x, y);
        SCOPED_TRACE(::testing::Message() << c.face << " " << c.u << " " << c.v << " turned "
                                          << angle << ": " << x << ", " << y);
        if (std::fabs(over) > 1e-9) {
          ASSERT_EQ(p.has_value(), over < 0);
        }
        if (p) {
          ASSERT_LT(distance(fan.points.position(*p), {to_x, to_y, 0}), 1e-11);
        }
      }
    }
  }
}

/// A flat grid somewhere in space: grid_surface(kRotated) turned, scaled and sheared.
struct RotatedGrid {
  explicit RotatedGrid(Dice& dice) {
    const auto component = [&dice] { return static_cast<double>(dice.between(-1000, 1000)); };
    const auto direction = [&component] {
      const double px = component(), py = component(), pz = component() + .5;
      return Point3{px, py, pz};
    };
    const Point3 a = unit(direction()), b = direction();
    const double along = a.x * b.x + a.y * b.y + a.z * b.z;
    const Point3 c = unit({b.x - along * a.x, b.y - along * a.y, b.z - along * a.z});
    const double size = static_cast<double>(1 + dice.below(1000)) / 7;
    const double shear = dice.below(2) == 0 ? 0 : static_cast<double>(dice.below(100)) / 100;
    x_axis = sum(size, a, 0, c);
    y_axis = sum(size * shear, a, size, c);
    across = sum(size, c, 0, a);
  }
  static Point3 unit(const Point3& p) {
    const double length = std::hypot(p.x, p.y, p.z);
    return {p.x / length, p.y / length, p.z / length};
  }
  static Point3 sum(double s, const Point3& a, double t, const Point3& b) {
    return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z};
  }
  Point3 at(double x, double y) const { return sum(x, x_axis, y, y_axis); }

  SurfaceMesh mesh(std::uint32_t n) const {
    const SurfaceMesh flat = grid_surface(n);
    std::vector<Point3> points;
    std::vector<SurfaceTriangle> triangles;
    for (std::uint32_t v = 0; v < flat.vertex_count(); ++v) {
      const Point3& p = flat.point(VertexId(v));
      points.push_back(at(p.x, p.y));
    }
    for (std::uint32_t f = 0; f < flat.face_count(); ++f) {
      triangles.push_back(flat.corners(FaceId(f)));
    }
    return {std::move(points), std::move(triangles)};
  }
  /// What to ask of a map whose axis x is that of the first side of lower faces, or the diagonal.
  Point2 offset(double x, double y, bool is_upper) const {
    const Point3 to = at(x, y), axis = unit(is_upper ? at(1, 1) : x_axis);
    const double size = std::hypot(across.x, across.y, across.z);
    const Point3 first = unit(x_axis), second = sum(1 / size, across, 0, across);
    const auto dot = [](const Point3& p, const Point3& q) {
      return p.x * q.x + p.y * q.y + p.z * q.z;
    };
    const Point3 normal_to_axis = sum(-dot(axis, second), first, dot(axis, first), second);
    return {dot(to, axis), dot(to, normal_to_axis)};
  }

  Point3 x_axis, y_axis;
  Point3 across;  // a quarter turn from the axis x
};

/// Directions of mesh lines and others, as steps on the grid.
constexpr std::array<std::array<int, 2>, 16> kDirections{{{1, 0},
                                                          {0, 1},
                                                          {1, 1},
                                                          {-1, 0},
                                                          {0, -1},
                                                          {-1, -1},
                                                          {1, -1},
                                                          {-1, 1},
                                                          {2, 1},
                                                          {1, 2},
                                                          {-2, -1},
                                                          {-1, -2},
                                                          {2, -1},
                                                          {-1, 2},
                                                          {3, 2},
                                                          {-2, 3}}};

/// Lines that start on sides of the mesh and run along them, lines that do so behind a vertex, and
/// others: rounding decides which faces they go through, but not where they end.
TEST(ExponentialMap, RotatedFlatMeshesAreMappedBySimilarities) {
  constexpr std::uint32_t kSide = 14;
  Dice dice(2941);
  for (int round = 0; round < 400; ++round) {
    const RotatedGrid grid(dice);
    const bool is_upper = dice.below(2) == 1;
    const std::uint32_t column = 6 + dice.below(2), row = 6 + dice.below(2);
    // 1 - t and what is left of 1 beside it add up exactly.
    const double t = std::array{.5, .25, .3, 1. / 3, .1, .9}[dice.below(6)];
    const auto [u, v] = std::array<std::array<double, 2>, 9>{{{0, t},
                                                              {t, 0},
                                                              {1 - (1 - t), 1 - t},
                                                              {1. / 3, 1. / 3},
                                                              {.25, .5},
                                                              {.5, .25},
                                                              {0, 0},
                                                              {1, 0},
                                                              {0, 1}}}[dice.below(9)];
    Fan fan(grid.mesh(kSide), 2 * (kSide * row + column) + (is_upper ? 1 : 0), u, v);
    const double from_x = column + (is_upper ? u : u + v), from_y = row + (is_upper ? u + v : v);
    for (const auto& [dx, dy] : kDirections) {
      for (const double steps : {.5, 1., 1. / 3, 1.25, .7, 1.75}) {
        const Point2 offset = grid.offset(steps * dx, steps * dy, is_upper);
        const auto p = fan.at(offset.x, offset.y);
        const Point3 expected = grid.at(from_x + steps * dx, from_y + steps * dy);
        SCOPED_TRACE(::testing::Message() << round << ": (" << from_x << ", " << from_y << ") + "
                                          << steps << " (" << dx << ", " << dy << ')');
        ASSERT_TRUE(p);
        const double size = std::hypot(grid.across.x, grid.across.y, grid.across.z);
        ASSERT_LT(distance(fan.points.position(*p), expected), 1e-12 * kSide * size);
      }
    }
  }
}

/// Shorter than a square of a double can tell.
TEST(ExponentialMap, ShortLines) {
  Fan fan(grid_surface(8), 2 * (8 * 3 + 4), .5, 0);
  for (const double length : {1e-100, 1e-200, 1e-300, 5e-324}) {
    for (int degrees = 0; degrees < 360; degrees += 15) {
      const Point2 to = unit_vector(degrees);
      const auto p = fan.at(length * to.x, length * to.y);
      ASSERT_TRUE(p);
      EXPECT_LT(distance(fan.points.position(*p), {4.5, 3, 0}), 1e-15);
    }
  }
}

TEST(ExponentialMap, WhatMeetsVerticesAndEdgesIsThere) {
  Fan fan(grid_surface(8), 2 * (8 * 3 + 4), .25, .5);  // (4.75, 3.5)
  const auto vertex = fan.at(-2.75, 1.5);
  EXPECT_EQ(fan.points.place(*vertex), SurfacePlace::Vertex);
  EXPECT_EQ(fan.points.vertex(*vertex), VertexId(5 * 9 + 2));
  const auto edge = fan.at(.25, -2.75);
  ASSERT_EQ(fan.points.place(*edge), SurfacePlace::Edge);
  EXPECT_EQ(fan.points.position(*edge), (Point3{5, .75, 0}));
  EXPECT_TRUE(fan.points.is_same(*fan.at(0, 0), fan.centre));
}

/// Faces 0 and 1 of the square, the second listed the other way round: its first side is still the
/// axis.
TEST(ExponentialMap, TheAxisIsThatOfTheModel) {
  const std::vector<Point3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  Fan fan(SurfaceMesh(corners,
                      {
                          {0, 1, 2},
                          {3, 2, 0},
                      }),
          1, .25, .25);
  ASSERT_TRUE(fan.mesh->is_flipped(FaceId(1)));
  const Point3 from = fan.points.position(fan.centre);
  const Point3 to = fan.points.position(*fan.at(.25, .125));
  EXPECT_LT(distance(to, {from.x + .25, from.y + .125, 0}), 1e-15);
}

/// Five triangles around a vertex: what comes to it along the bisector of one leaves along the edge
/// opposite.
TEST(ExponentialMap, VerticesArePassedWithEqualAngles) {
  const SurfaceMesh ball = sphere_surface(0);
  const double side =
      distance(ball.point(ball.corner(FaceId(0), 0)), ball.point(ball.corner(FaceId(0), 1)));
  Fan fan(sphere_surface(0), 0, 1. / 3, 1. / 3, 30 + 180);
  const double to_vertex = side / std::sqrt(3.);
  const auto at = fan.at(to_vertex, 0);
  ASSERT_EQ(fan.points.place(*at), SurfacePlace::Vertex);
  EXPECT_EQ(fan.points.vertex(*at), ball.corner(FaceId(0), 0));
  const auto beyond = fan.at(to_vertex + side / 4, 0);
  ASSERT_EQ(fan.points.place(*beyond), SurfacePlace::Edge);
  EXPECT_NEAR(distance(fan.points.position(*beyond), fan.points.position(*at)), side / 4, 1e-12);
}

TEST(ExponentialMap, DirectionsAtAVertexAreSpreadEvenly) {
  Fan fan(sphere_surface(0), 0, 0, 0);
  for (int fifth = 0; fifth < 5; ++fifth) {
    const Point2 to = unit_vector(72. * fifth);
    EXPECT_EQ(fan.points.place(*fan.at(to.x / 4, to.y / 4)), SurfacePlace::Edge) << fifth;
    const Point2 between = unit_vector(72. * fifth + 36);
    EXPECT_EQ(fan.points.place(*fan.at(between.x / 4, between.y / 4)), SurfacePlace::Face);
  }
}

double length_of(const SurfacePath& path, const SurfacePointTable& points) {
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += distance(points.position(path.points[i - 1]), points.position(path.points[i]));
  }
  return sum;
}

TEST(ExponentialMap, LinesAreAsLongAsTheirOffsets) {
  for (SurfaceMesh& mesh : std::vector<SurfaceMesh>{sphere_surface(2), torus_surface(24, 12, .4)}) {
    for (const Centre& c : {Centre{7, .25, .5}, {7, 0, .5}, {7, 0, 0}, {7, 1, 0}}) {
      Fan fan(mesh, c.face, c.u, c.v);
      Tracer tracer(*fan.mesh);
      for (int degrees = 0; degrees < 360; degrees += 7) {
        for (const double length : {.01, .3, 1., 5.}) {
          const Point2 to = unit_vector(degrees);
          const auto p = fan.at(length * to.x, length * to.y);
          ASSERT_TRUE(p);
          const auto path = tracer.trace(fan.points, fan.centre, *p, fan.context);
          const double traced = length_of(*path, fan.points);
          if (length < .1) {
            EXPECT_NEAR(traced, length, 1e-9);
          } else if (length < 1) {
            EXPECT_LT(traced, length + 1e-9);
            EXPECT_GT(traced, .9 * length);
          }
        }
      }
    }
  }
}

/// What is within a distance r of a point of the unit sphere has the area 2 pi (1 - cos r).
TEST(ExponentialMap, CirclesOnASphere) {
  for (const Centre& c : {Centre{7, .25, .5}, {2000, 0, .5}, {4000, 0, 0}}) {
    for (const double r : {.2, .7, 1.2}) {
      const auto mesh = std::make_shared<const SurfaceMesh>(sphere_surface(4));
      SurfaceScene scene{mesh, SurfacePolygons(*mesh), {}, {}};
      SurfacePointTable& points = scene.polygons.points;
      const ExponentialMap map(points, points.add_in_face(FaceId(c.face), c.u, c.v), FaceId(c.face),
                               0);
      Context context;
      std::vector<SurfacePointId> ring;
      constexpr int kCorners = 90;
      for (int i = 0; i < kCorners; ++i) {
        const Point2 to = unit_vector(360. * i / kCorners);
        ring.push_back(*map.add({r * to.x, r * to.y}, points, context));
      }
      Tracer tracer(*mesh);
      ASSERT_FALSE(add_traced_polygon(tracer, ring, scene.polygons, context));
      const SurfaceDivision division(scene, context);
      const double area =
          division.evaluate(parse_set_expression("A"), WindingRule::Positive).region.area;
      const double expected = 2 * kPi * (1 - std::cos(r));
      EXPECT_NEAR(area, expected, .01 * expected) << c.face << ", " << r;
    }
  }
}

TEST(ExponentialMap, WhatIsTooFarIsRefused) {
  Fan ball(sphere_surface(1), 3, .3, .3);
  for (const double far : {1e4, 1e5, 1e200, 1e308}) {
    try {
      ball.at(far, far / 3);
      EXPECT_LT(far, 1e5);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    }
  }
}

/// All lines but those around the cylinder reach its ends; short ones do not.
TEST(ExponentialMap, BordersEndLines) {
  Fan cylinder(cylinder_surface(8, 4), 3, .3, .3);
  int ended = 0;
  for (int degrees = 0; degrees < 360; degrees += 10) {
    const Point2 to = unit_vector(degrees);
    EXPECT_TRUE(cylinder.at(.1 * to.x, .1 * to.y).has_value());
    ended += cylinder.at(100 * to.x, 100 * to.y) ? 0 : 1;
  }
  EXPECT_GE(ended, 32);
}

/// Triangles without area, edges without length: an answer, any answer, or none in time.
TEST(ExponentialMap, DegenerateMeshes) {
  Dice dice(1);
  for (int round = 0; round < 300; ++round) {
    std::vector<Point3> points;
    for (int i = 0; i < 9; ++i) {
      const auto x = static_cast<double>(dice.below(3));
      const auto y = static_cast<double>(dice.below(2));
      points.push_back({x, y, 0});
    }
    std::vector<SurfaceTriangle> triangles;
    for (std::uint32_t v = 0; v < 4; ++v) {
      const std::uint32_t a = v / 2 * 3 + v % 2;
      triangles.push_back({a, a + 1, a + 4});
      triangles.push_back({a, a + 4, a + 3});
    }
    const auto face = dice.below(8);
    const double u = dice.below(3) / 2., v = u == 1 ? 0 : dice.below(2) / 2.;
    Fan fan(SurfaceMesh(points, triangles), face, u, v);
    for (int i = 0; i < 10; ++i) {
      const auto x = static_cast<double>(dice.between(-4, 4)) / 2;
      const auto y = static_cast<double>(dice.between(-4, 4)) / 2;
      try {
        fan.at(x, y);
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
      }
    }
  }
}

}  // namespace
}  // namespace plumb::testing::exponential_map_test
