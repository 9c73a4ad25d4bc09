// Views of meshes in plain arrays: sizes and starts are checked here, corners and coordinates by
// the functions that read the mesh.
//
// Tested by tests/space/mesh_arrays_test.cpp.

#include "plumb/space/mesh_arrays.h"

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// A point has exactly three doubles, so an array of points is an array of doubles.
static_assert(sizeof(Point3) == 3 * sizeof(double) && alignof(Point3) == alignof(double));
static_assert(std::is_standard_layout_v<Point3> && std::is_trivially_copyable_v<Point3>);

/// Throws Error{BadArgument} unless the size is a multiple of three.
void require_triples(std::size_t size, const char* what) {
  if (size % 3 != 0) {
    throw Error(ErrorCode::BadArgument,
                std::string("the number of ") + what + " is no multiple of three");
  }
}

/// Throws Error{BadArgument} if there are more than 2^32 - 1: points and corners have numbers of 32
/// bits.
void require_countable(std::size_t count, const char* what) {
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::BadArgument, std::string("more ") + what + " than 2^32 - 1");
  }
}

/// Returns a view of arrays whose sizes it checks.
MeshView view_of(std::span<const double> coordinates, std::span<const std::uint32_t> corners) {
  require_triples(coordinates.size(), "coordinates");
  require_countable(coordinates.size() / 3, "points");
  require_countable(corners.size(), "corners");
  MeshView mesh;
  mesh.coordinates = coordinates;
  mesh.corners = corners;
  return mesh;
}

}  // namespace

MeshView::MeshView(const PolygonMesh& mesh)
    : coordinates(coordinates_of(mesh)),
      exact(mesh.exact),
      face_begin(mesh.face_begin),
      corners(mesh.corners) {}

MeshView mesh_of_triangles(std::span<const double> coordinates,
                           std::span<const std::uint32_t> corners) {
  require_triples(corners.size(), "corners");
  return view_of(coordinates, corners);
}

MeshView mesh_of_polygons(std::span<const double> coordinates,
                          std::span<const std::uint32_t> face_begin,
                          std::span<const std::uint32_t> corners) {
  require_countable(face_begin.size(), "faces");
  if (face_begin.empty() || face_begin.front() != 0 || face_begin.back() != corners.size() ||
      !std::is_sorted(face_begin.begin(), face_begin.end())) {
    throw Error(ErrorCode::BadArgument, "face_begin does not divide the corners into faces");
  }
  MeshView mesh = view_of(coordinates, corners);
  mesh.face_begin = face_begin;
  return mesh;
}

std::span<const double> coordinates_of(const PolygonMesh& mesh) {
  return {reinterpret_cast<const double*>(mesh.points.data()), 3 * mesh.points.size()};
}

}  // namespace plumb
