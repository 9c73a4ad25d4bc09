// Triangles of a mesh laid out in the plane, each beside the one before: for paths that are found in doubles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "plumb/predicates/point.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Vertices times 2^-exponent, so that no product of two of their coordinates overflows.
struct ScaledPositions {
  std::vector<Point3> at;
  int exponent = 0;
};
ScaledPositions scaled_positions(const SurfaceMesh& mesh);

/// Where the corners of a face are, in the order of the mesh, counter-clockwise.
using FaceCorners = std::array<Point2, 3>;

/// Corner `first` at the origin, the one after it to the right of that.
FaceCorners laid_out(const SurfaceMesh& mesh, std::span<const Point3> positions, FaceId f,
                     std::size_t first);
/// The face across a door of the one whose corners these are. Requires that there is one.
FaceCorners laid_out_across(const SurfaceMesh& mesh, std::span<const Point3> positions,
                            const FaceCorners& corners, HalfedgeId door);

/// Of the face of h, at the origin of h; 0 to pi.
double corner_angle(const SurfaceMesh& mesh, std::span<const Point3> positions, HalfedgeId h);

/// Where a point lies, by its approximate parameters, among three corners of one of its faces.
std::array<double, 3> weights_in(const SurfacePointTable& table, SurfacePointId p, FaceId f);

/// Vectors of doubles, for those who lay out.
namespace layout {

inline Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
inline double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
inline double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
inline double length(Point2 a) { return std::hypot(a.x, a.y); }

inline Point2 combined(const FaceCorners& p, const std::array<double, 3>& w) {
  return {w[0] * p[0].x + w[1] * p[1].x + w[2] * p[2].x,
          w[0] * p[0].y + w[1] * p[1].y + w[2] * p[2].y};
}

}  // namespace layout
}  // namespace plumb
#pragma GCC visibility pop
