#include "plumb/surface/surface_arrays.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// A point has exactly three doubles, and a triangle exactly three indices, so an array of them is
// an array of these numbers.
static_assert(sizeof(Point3) == 3 * sizeof(double) && alignof(Point3) == alignof(double));
static_assert(std::is_standard_layout_v<Point3> && std::is_trivially_copyable_v<Point3>);
static_assert(sizeof(SurfaceTriangle) == 3 * sizeof(std::uint32_t));

void require_triangles(const MeshView& mesh) {
  if (mesh.face_begin.empty()) return;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() != 3) {
      throw Error(ErrorCode::BadArgument, "face " + std::to_string(f) + " is no triangle");
    }
  }
}

Point3 finite_point(const MeshView& mesh, std::size_t i) {
  const Point3 p = mesh.point(i);
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
    throw Error(ErrorCode::NotFinite, "vertex " + std::to_string(i) + " is not finite");
  }
  return p;
}

MeshView view_of(std::span<const Point3> points, std::span<const SurfaceTriangle> triangles) {
  MeshView view;
  view.coordinates = {reinterpret_cast<const double*>(points.data()), 3 * points.size()};
  view.corners = {reinterpret_cast<const std::uint32_t*>(triangles.data()), 3 * triangles.size()};
  return view;
}

/// Returns an array of `count` entries. `first()` returns a reference to the first entry.
template <class First>
auto span_of(std::size_t count, First first) {
  return std::span(count == 0 ? nullptr : &first(), count);
}

}  // namespace

SurfaceMesh surface_of(const MeshView& mesh) {
  require_triangles(mesh);
  std::vector<Point3> points(mesh.point_count());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = finite_point(mesh, i);
  std::vector<SurfaceTriangle> triangles(mesh.face_count());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    std::copy_n(mesh.face(f).begin(), 3, triangles[f].begin());
  }
  return SurfaceMesh(std::move(points), std::move(triangles));
}

MeshView view_of(const SurfaceMesh& mesh) {
  return view_of(span_of(
                     mesh.vertex_count(), [&]() -> auto& { return mesh.point(VertexId(0)); }),
                 span_of(
                     mesh.face_count(), [&]() -> auto& { return mesh.corners(FaceId(0)); }));
}

MeshView view_of(const SurfaceTriangulation& triangulation) {
  return view_of(triangulation.points, triangulation.triangles);
}

}  // namespace plumb
