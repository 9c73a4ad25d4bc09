// Polygons with shared vertices: what mesh files hold, and what sets of space come from and go to.
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

/// Faces over shared points: flat arrays.
struct PolygonMesh {
  std::vector<Point3> points;  ///< the nearest doubles of the vertices
  /// Vertices whose coordinates are no doubles: (index, exact coordinates), ascending by index.
  std::vector<std::pair<std::uint32_t, RationalPoint3>> exact;
  std::vector<std::uint32_t> face_begin = {0};  ///< face_count() + 1 entries into corners
  std::vector<std::uint32_t> corners;           ///< counter-clockwise seen from outside

  /// Faces of any number of corners.
  std::size_t face_count() const { return face_begin.size() - 1; }
  /// Its corners, indices of points.
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(face_begin[f], face_begin[f + 1] - face_begin[f]);
  }
  /// Appends a face. Nothing is checked.
  void add_face(std::span<const std::uint32_t> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    face_begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

}  // namespace plumb
#pragma GCC visibility pop
