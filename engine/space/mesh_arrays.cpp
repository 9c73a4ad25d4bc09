#include "plumb/space/mesh_arrays.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"

namespace plumb {
namespace {

// A point is three doubles and nothing else, so an array of points is one of doubles.
static_assert(sizeof(Point3) == 3 * sizeof(double) && alignof(Point3) == alignof(double));
static_assert(std::is_standard_layout_v<Point3> && std::is_trivially_copyable_v<Point3>);

std::vector<Point3> points_of(std::span<const double> coordinates) {
  if (coordinates.size() % 3 != 0) {
    throw Error(ErrorCode::BadArgument, "the number of coordinates is no multiple of three");
  }
  std::vector<Point3> points(coordinates.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  }
  return points;
}

}  // namespace

PolygonMesh mesh_of_triangles(std::span<const double> coordinates,
                              std::span<const std::uint32_t> corners) try {
  if (corners.size() % 3 != 0) {
    throw Error(ErrorCode::BadArgument, "the number of corners is no multiple of three");
  }
  if (corners.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorCode::BadArgument, "more corners than 2^32 - 1");
  }
  PolygonMesh mesh;
  mesh.points = points_of(coordinates);
  mesh.corners.assign(corners.begin(), corners.end());
  mesh.face_begin.resize(corners.size() / 3 + 1);
  for (std::size_t f = 0; f < mesh.face_begin.size(); ++f) {
    mesh.face_begin[f] = static_cast<std::uint32_t>(3 * f);
  }
  return mesh;
} catch (...) {
  rethrow_refused_memory();
}

PolygonMesh mesh_of_polygons(std::span<const double> coordinates,
                             std::span<const std::uint32_t> face_begin,
                             std::span<const std::uint32_t> corners) try {
  if (face_begin.empty() || face_begin.front() != 0 || face_begin.back() != corners.size() ||
      !std::is_sorted(face_begin.begin(), face_begin.end())) {
    throw Error(ErrorCode::BadArgument, "face_begin does not divide the corners into faces");
  }
  PolygonMesh mesh;
  mesh.points = points_of(coordinates);
  mesh.corners.assign(corners.begin(), corners.end());
  mesh.face_begin.assign(face_begin.begin(), face_begin.end());
  return mesh;
} catch (...) {
  rethrow_refused_memory();
}

std::span<const double> coordinates_of(const PolygonMesh& mesh) {
  return {reinterpret_cast<const double*>(mesh.points.data()), 3 * mesh.points.size()};
}

}  // namespace plumb
