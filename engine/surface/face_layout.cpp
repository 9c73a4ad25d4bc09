#include "plumb/surface/face_layout.h"

#include <algorithm>

namespace plumb {
namespace {

Point3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Point3& a) { return std::sqrt(dot(a, a)); }

/// The third corner of a triangle, to the right of the line from a to b.
Point2 third_corner(std::span<const Point3> positions, Point2 a, Point2 b, VertexId va, VertexId vb,
                    VertexId vc) {
  const Point3 along = positions[vb.value()] - positions[va.value()];
  const Point3 to = positions[vc.value()] - positions[va.value()];
  const double square = dot(along, along);
  if (square == 0) return {a.x + length(to), a.y};
  const double s = dot(along, to) / square, h = length(cross(along, to)) / square;
  const double x = b.x - a.x, y = b.y - a.y;
  return {a.x + s * x + h * y, a.y + s * y - h * x};
}

}  // namespace

ScaledPositions scaled_positions(const SurfaceMesh& mesh) {
  double largest = 0;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Point3& p = mesh.point(VertexId(v));
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  ScaledPositions scaled;
  std::frexp(largest, &scaled.exponent);
  scaled.at.reserve(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Point3& p = mesh.point(VertexId(v));
    scaled.at.push_back({std::ldexp(p.x, -scaled.exponent), std::ldexp(p.y, -scaled.exponent),
                         std::ldexp(p.z, -scaled.exponent)});
  }
  return scaled;
}

FaceCorners laid_out(const SurfaceMesh& mesh, std::span<const Point3> positions, FaceId f,
                     std::size_t first) {
  const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
  const VertexId a = mesh.corner(f, first), b = mesh.corner(f, second), c = mesh.corner(f, third);
  FaceCorners corners;
  corners[second] = {length(positions[b.value()] - positions[a.value()]), 0};
  corners[third] = third_corner(positions, corners[second], corners[first], b, a, c);
  return corners;
}

FaceCorners laid_out_across(const SurfaceMesh& mesh, std::span<const Point3> positions,
                            const FaceCorners& corners, HalfedgeId door) {
  const std::size_t side = SurfaceMesh::side(door);
  const Point2 right = corners[side], left = corners[(side + 1) % 3];
  const HalfedgeId twin = mesh.twin(door);
  const std::size_t k = SurfaceMesh::side(twin);
  FaceCorners beyond;
  beyond[k] = left;
  beyond[(k + 1) % 3] = right;
  beyond[(k + 2) % 3] = third_corner(positions, right, left, mesh.origin(door), mesh.target(door),
                                     mesh.corner(SurfaceMesh::face(twin), (k + 2) % 3));
  return beyond;
}

double corner_angle(const SurfaceMesh& mesh, std::span<const Point3> positions, HalfedgeId h) {
  const Point3& p = positions[mesh.origin(h).value()];
  const Point3 a = positions[mesh.target(h).value()] - p;
  const Point3 b = positions[mesh.origin(SurfaceMesh::prev(h)).value()] - p;
  return std::atan2(length(cross(a, b)), dot(a, b));
}

std::array<double, 3> weights_in(const SurfacePointTable& table, SurfacePointId p, FaceId f) {
  const Point2 at = table.approx(p);
  if (table.place(p) == SurfacePlace::Face) return {1 - at.x - at.y, at.x, at.y};
  const SurfaceMesh& mesh = table.mesh();
  const bool is_vertex = table.place(p) == SurfacePlace::Vertex;
  const VertexId low = is_vertex ? table.vertex(p) : mesh.lower(table.edge(p));
  const VertexId high = is_vertex ? low : mesh.upper(table.edge(p));
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexId v = mesh.corner(f, k);
    weights[k] = v == low ? 1 - at.x : v == high ? at.x : 0;
  }
  return weights;
}

}  // namespace plumb
