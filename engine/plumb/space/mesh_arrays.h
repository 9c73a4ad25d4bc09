// Polygon meshes with shared vertices. Such meshes are read from and written to mesh files, and are
// converted to sets of space and back.
//
// A program can pass its own arrays without conversion. One array contains the coordinates of all
// points (x y z x y z ...). Another array contains the corners of each face as indices of points,
// counter-clockwise seen from outside:
//
//   in     mesh_of_triangles(xyz, corners) and mesh_of_polygons(xyz, face_begin, corners) return
//          a MeshView
//   out    coordinates_of(mesh), mesh.corners and mesh.face_begin are the arrays of a mesh
//
// A view does not copy the arrays, and functions read them in place. There is one exception:
// complex_of_mesh() copies a mesh of 4,096 or more triangles in sorted order, and releases this
// copy early. A set stores its own copy of all data, so the arrays may be released when the set has
// been made. The functions of this header do not check that corners are indices of points, and do
// not check that coordinates are finite. The function complex_of_mesh() reads the mesh and checks
// both conditions. If a condition is violated, complex_of_mesh() throws Error{BadIndex} or
// Error{NotFinite}.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Triangles in plain arrays, in the form that graphics programs use.
struct TriangleMesh {
  std::vector<double> coordinates;  ///< The coordinates x y z of each point.
  /// Three point indices for each triangle, counter-clockwise seen from outside.
  std::vector<std::uint32_t> triangles;

  /// Returns the number of points.
  [[nodiscard]] std::size_t point_count() const { return coordinates.size() / 3; }
  /// Returns the number of triangles.
  [[nodiscard]] std::size_t triangle_count() const { return triangles.size() / 3; }
};

/// A mesh of polygons over shared points, in flat arrays.
struct PolygonMesh {
  std::vector<Point3> points;  ///< The vertices, rounded to the nearest doubles.
  /// A pair (index, exact coordinates) for each vertex whose coordinates are not doubles. The pairs
  /// are in ascending order of their indices.
  std::vector<std::pair<std::uint32_t, RationalPoint3>> exact;
  /// For each face, the index in `corners` at which its corners start. The last entry is the size
  /// of `corners`.
  std::vector<std::uint32_t> face_begin = {0};
  std::vector<std::uint32_t> corners;  ///< Point indices, counter-clockwise seen from outside.

  /// Returns the number of faces.
  std::size_t face_count() const { return face_begin.size() - 1; }
  /// Returns the corners of face f, which are indices of points.
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
  }
  /// Appends a face. Nothing is checked.
  void add_face(std::span<const std::uint32_t> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    face_begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

/// Non-owning view of mesh arrays. The arrays must outlive the view. A PolygonMesh converts to a
/// view. Requires that face_begin satisfies the conditions of mesh_of_polygons(). Functions that
/// take a view do not check these conditions again.
struct MeshView {
  std::span<const double>
      coordinates;  ///< The coordinates x y z of each point; rounded if `exact` lists the point.
  /// Pairs (index, exact coordinates), as in PolygonMesh::exact.
  std::span<const std::pair<std::uint32_t, RationalPoint3>> exact = {};
  std::span<const std::uint32_t> face_begin =
      {};  ///< As in PolygonMesh. If this span is empty, all faces are triangles.
  std::span<const std::uint32_t> corners = {};  ///< Point indices, as in PolygonMesh.

  MeshView() = default;  ///< Makes a view without points and faces.
  /// Makes a view of the arrays of `mesh`.
  MeshView(const PolygonMesh& mesh);
  /// Deleted, because a view of a temporary mesh would outlive the mesh.
  MeshView(const PolygonMesh&& mesh) = delete;

  /// Returns the number of points.
  std::size_t point_count() const { return coordinates.size() / 3; }
  /// Returns point i, rounded to the nearest doubles.
  Point3 point(std::size_t i) const {
    return {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  }
  /// Returns the number of faces.
  std::size_t face_count() const {
    return face_begin.empty() ? corners.size() / 3 : face_begin.size() - 1;
  }
  /// Returns the index in `corners` at which the corners of face f begin. The corners of the last
  /// face end before begin_of(face_count()).
  std::uint32_t begin_of(std::size_t f) const {
    return face_begin.empty() ? static_cast<std::uint32_t>(3 * f) : face_begin[f];
  }
  /// Returns the corners of face f, which are indices of points.
  std::span<const std::uint32_t> face(std::size_t f) const {
    return corners.subspan(begin_of(f), begin_of(f + 1) - begin_of(f));
  }
};

/// Returns a view of triangles. Triangle t has the corners corners[3 t], corners[3 t + 1] and
/// corners[3 t + 2]. Throws Error{BadArgument} if the size of an array is not a multiple of three,
/// or if there are 2^32 or more points or corners. O(1).
MeshView mesh_of_triangles(std::span<const double> coordinates,
                           std::span<const std::uint32_t> corners);

/// Returns a view of polygons. Face f has the corners corners[face_begin[f]], ...,
/// corners[face_begin[f + 1] - 1]. The function checks face_begin in O(F) time for F faces. Throws
/// Error{BadArgument} unless all of these conditions hold:
/// - face_begin ascends from 0 to the number of corners,
/// - the number of coordinates is a multiple of three,
/// - there are fewer than 2^32 points, and the other arrays have fewer than 2^32 entries.
MeshView mesh_of_polygons(std::span<const double> coordinates,
                          std::span<const std::uint32_t> face_begin,
                          std::span<const std::uint32_t> corners);

/// Returns the coordinates x y z of all points. Coordinates of points in mesh.exact are rounded to
/// the nearest doubles. The span is valid until mesh.points changes or is destroyed.
std::span<const double> coordinates_of(const PolygonMesh& mesh);

}  // namespace plumb
#pragma GCC visibility pop
