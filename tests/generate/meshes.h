// Polygon meshes made by rule.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/space/mesh_arrays.h"

namespace plumb::testing {

using Face = std::vector<std::uint32_t>;

PolygonMesh make_mesh(std::vector<Point3> points, const std::vector<Face>& faces);

/// The box between two corners: six squares.
PolygonMesh box_mesh(Point3 low, Point3 high);
/// Four triangles; corners a, b, c counter-clockwise seen from outside, d behind them.
PolygonMesh tetrahedron_mesh(Point3 a, Point3 b, Point3 c, Point3 d);
/// A sphere of 20 * 4^depth triangles.
PolygonMesh icosphere_mesh(int depth, double radius, Point3 centre);
/// A cube of width n whose faces are grids of squares of width 1, each in two triangles: 12 n^2 of
/// them.
PolygonMesh grid_cube_mesh(std::uint32_t n, Point3 low);
/// The prism over a polygon of the plane z = low, counter-clockwise.
PolygonMesh prism_mesh(const std::vector<Point2>& polygon, double low, double high);

PolygonMesh reversed(PolygonMesh mesh);
/// Both, one after the other; vertices stay separate.
PolygonMesh joined(PolygonMesh a, const PolygonMesh& b);
PolygonMesh moved(PolygonMesh mesh, Point3 by);
/// Turned about the z axis, in doubles.
PolygonMesh turned(PolygonMesh mesh, double angle);
/// Every polygon a fan of triangles.
PolygonMesh fanned(const PolygonMesh& mesh);

}  // namespace plumb::testing
