// Meshes from and to plain arrays, as most programs hold them: coordinates x y z x y z ..., and indices of points,
// three for each triangle, counter-clockwise seen from outside.
//
//   in     mesh_of_triangles(xyz, corners), mesh_of_polygons(xyz, face_begin, corners): a MeshView
//   out    coordinates_of(mesh), mesh.corners, mesh.face_begin
//
// A view is read where it lies; of 4,096 triangles and more a copy is sorted, which goes at once. What a set keeps are
// its vertices as points of its own tables, so that the arrays may go as soon as the set is there. Corners that are no points are
// found by whoever uses the mesh (complex_of_mesh(): Error{BadIndex}), as are coordinates that are not finite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/polygon_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A mesh in arrays that somebody else holds; valid as long as they are: give it no name where they are temporaries.
/// Every PolygonMesh is one. face_begin must be as mesh_of_polygons() demands; who uses a mesh does not look again.
struct MeshView {
  std::span<const double> coordinates;  ///< x y z of each point
  /// As PolygonMesh::exact.
  std::span<const std::pair<std::uint32_t, RationalPoint3>> exact = {};
  std::span<const std::uint32_t> face_begin = {};  ///< as there; empty: all faces are triangles
  std::span<const std::uint32_t> corners = {};     ///< counter-clockwise seen from outside

  MeshView() = default;  ///< No points, no faces.
  /// The arrays of `mesh`.
  MeshView(const PolygonMesh& mesh);

  /// Points that faces may name.
  std::size_t point_count() const { return coordinates.size() / 3; }
  /// The nearest doubles of one.
  Point3 point(std::size_t i) const {
    return {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  }
  /// Faces of any number of corners.
  std::size_t face_count() const {
    return face_begin.empty() ? corners.size() / 3 : face_begin.size() - 1;
  }
  /// Where its corners begin; those of the last face end at begin_of(face_count()).
  std::uint32_t begin_of(std::size_t f) const {
    return face_begin.empty() ? static_cast<std::uint32_t>(3 * f) : face_begin[f];
  }
  /// Its corners, indices of points.
  std::span<const std::uint32_t> face(std::size_t f) const {
    return corners.subspan(begin_of(f), begin_of(f + 1) - begin_of(f));
  }
};

/// Triangle t has the corners 3 t, 3 t + 1, 3 t + 2. Throws Error{BadArgument} unless both sizes are multiples of
/// three, and there are less than 2^32 points and corners. O(1).
MeshView mesh_of_triangles(std::span<const double> coordinates,
                           std::span<const std::uint32_t> corners);

/// Face f has the corners from face_begin[f] up to face_begin[f + 1]: one entry more than faces, the first 0, the last
/// the number of corners. Throws Error{BadArgument} for other arrays. O(faces), to look at face_begin.
MeshView mesh_of_polygons(std::span<const double> coordinates,
                          std::span<const std::uint32_t> face_begin,
                          std::span<const std::uint32_t> corners);

/// x y z of all points, rounded to the nearest doubles where mesh.exact has others. Valid as long as mesh.points.
std::span<const double> coordinates_of(const PolygonMesh& mesh);

}  // namespace plumb
#pragma GCC visibility pop
