#include "generate/surface_meshes.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "generate/meshes.h"

namespace plumb::testing {
namespace {

double turn(std::uint32_t i, std::uint32_t n) { return 2 * std::numbers::pi * i / n; }

/// Two triangles of the square a, b, c, d.
void add_square(std::vector<SurfaceTriangle>& triangles, std::uint32_t a, std::uint32_t b,
                std::uint32_t c, std::uint32_t d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

}  // namespace

SurfaceMesh surface_of(const PolygonMesh& mesh) {
  std::vector<SurfaceTriangle> triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    triangles.push_back({face[0], face[1], face[2]});
  }
  return {mesh.points, std::move(triangles)};
}

SurfaceMesh grid_surface(std::uint32_t n) {
  std::vector<Point3> points;
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      points.push_back({static_cast<double>(x), static_cast<double>(y), 0});
      const std::uint32_t a = (n + 1) * y + x;
      if (x < n && y < n) add_square(triangles, a, a + 1, a + n + 2, a + n + 1);
    }
  }
  return {std::move(points), std::move(triangles)};
}

SurfaceMesh torus_surface(std::uint32_t ring, std::uint32_t tube, double thin) {
  std::vector<Point3> points;
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t i = 0; i < ring; ++i) {
    for (std::uint32_t j = 0; j < tube; ++j) {
      const double r = 1 + thin * std::cos(turn(j, tube));
      points.push_back({r * std::cos(turn(i, ring)), r * std::sin(turn(i, ring)),
                        thin * std::sin(turn(j, tube))});
      const std::uint32_t i2 = (i + 1) % ring, j2 = (j + 1) % tube;
      add_square(triangles, i * tube + j, i2 * tube + j, i2 * tube + j2, i * tube + j2);
    }
  }
  return {std::move(points), std::move(triangles)};
}

SurfaceMesh sphere_surface(int depth) { return surface_of(icosphere_mesh(depth, 1, {0, 0, 0})); }

SurfaceMesh cylinder_surface(std::uint32_t ring, std::uint32_t rows) {
  std::vector<Point3> points;
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t i = 0; i < ring; ++i) {
    for (std::uint32_t j = 0; j <= rows; ++j) {
      points.push_back({std::cos(turn(i, ring)), std::sin(turn(i, ring)), static_cast<double>(j)});
      const std::uint32_t a = i * (rows + 1) + j, b = (i + 1) % ring * (rows + 1) + j;
      if (j < rows) add_square(triangles, a, b, b + 1, a + 1);
    }
  }
  return {std::move(points), std::move(triangles)};
}

}  // namespace plumb::testing
