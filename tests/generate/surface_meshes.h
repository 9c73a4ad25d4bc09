// Triangle meshes to draw on, made by rule.
#pragma once

#include <cstdint>

#include "plumb/space/mesh_arrays.h"
#include "plumb/surface/surface_mesh.h"

namespace plumb::testing {

/// The triangles of a mesh whose polygons are triangles.
SurfaceMesh surface_of(const PolygonMesh& mesh);

/// The square [0, n] x [0, n] in n x n unit squares, each cut from lower left to upper right: faces
/// 2 (n y + x) with corners (x, y), (x + 1, y), (x + 1, y + 1), and the next number with (x, y), (x
/// + 1, y + 1), (x, y + 1).
SurfaceMesh grid_surface(std::uint32_t n);
/// Vertex i tube + j lies at i / ring around the axis z and j / tube around the tube, from its
/// outermost circle upwards. Radii 1 and `thin`.
SurfaceMesh torus_surface(std::uint32_t ring, std::uint32_t tube, double thin);
/// A sphere of radius 1, 20 * 4^depth triangles.
SurfaceMesh sphere_surface(int depth);
/// The side of a prism over a regular polygon, radius 1: vertex i (rows + 1) + j at i / ring
/// around, height j.
SurfaceMesh cylinder_surface(std::uint32_t ring, std::uint32_t rows);

}  // namespace plumb::testing
