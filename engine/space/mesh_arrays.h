// Meshes from and to plain arrays, as most programs hold them: coordinates x y z x y z ..., and indices of points,
// three for each triangle, counter-clockwise seen from outside.
//
//   in     mesh_of_triangles(xyz, corners), mesh_of_polygons(xyz, face_begin, corners)
//   out    coordinates_of(mesh), mesh.corners, mesh.face_begin
//
// Arrays are taken as they are, each copied once; on the way out nothing is copied. Corners that are no points are
// found by whoever uses the mesh (complex_of_mesh(): Error{BadIndex}), as are coordinates that are not finite.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/space/polygon_mesh.h"

namespace plumb {

/// Triangle t has the corners 3 t, 3 t + 1, 3 t + 2. Throws Error{BadArgument} unless both sizes are multiples of
/// three. O(n).
PolygonMesh mesh_of_triangles(std::span<const double> coordinates,
                              std::span<const std::uint32_t> corners);

/// Face f has the corners from face_begin[f] up to face_begin[f + 1]: one entry more than faces, the first 0, the last
/// the number of corners. Throws Error{BadArgument} for other arrays. O(n).
PolygonMesh mesh_of_polygons(std::span<const double> coordinates,
                             std::span<const std::uint32_t> face_begin,
                             std::span<const std::uint32_t> corners);

/// x y z of all points, rounded to the nearest doubles where mesh.exact has others. Valid as long as mesh.points.
std::span<const double> coordinates_of(const PolygonMesh& mesh);

}  // namespace plumb
