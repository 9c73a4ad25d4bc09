// What the tests of mesh formats share: meshes that are the same, meshes made up.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "plumb/space/mesh_arrays.h"

namespace plumb::testing {

inline bool is_same(const PolygonMesh& a, const PolygonMesh& b) {
  return a.points == b.points && a.exact == b.exact && a.face_begin == b.face_begin &&
         a.corners == b.corners;
}

inline PolygonMesh mesh_of(std::vector<Point3> points,
                           std::initializer_list<std::vector<std::uint32_t>> faces) {
  PolygonMesh mesh;
  mesh.points = std::move(points);
  for (const std::vector<std::uint32_t>& face : faces) mesh.add_face(face);
  return mesh;
}

/// The tetrahedron of the hostile tables.
inline PolygonMesh tetrahedron() {
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

/// Doubles that are hard to print, in triangles and a pentagon.
inline PolygonMesh awkward_mesh() {
  return mesh_of({{0.1, -1.0 / 3, 1e23},
                  {5e-324, -1.7976931348623157e308, 9007199254740993.0},
                  {0x1p63, -0x1p-1022, 123456.789},
                  {-7, 1e15, 1e22},
                  {0.30000000000000004, 2.5, -0x1p60}},
                 {{0, 1, 2}, {2, 1, 3}, {0, 1, 2, 3, 4}, {4, 0, 3}});
}

/// With vertices that no double holds.
inline PolygonMesh exact_mesh() {
  PolygonMesh mesh = tetrahedron();
  mesh.exact = {{1, {Rational(1, 3), 0, 5}}, {3, {0, Rational("-9007199254740993"), 1}}};
  mesh.points[1] = {1.0 / 3, 0, 5};
  mesh.points[3] = {0, -9007199254740992.0, 1};
  return mesh;
}

}  // namespace plumb::testing
