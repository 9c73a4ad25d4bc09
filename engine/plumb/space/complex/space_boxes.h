// Boxes of doubles around the cells of a complex, surely large enough. The box of an input point is
// the point itself. The second part has boxes along other axes than the coordinate axes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Returns a box around a point; infinite if nothing is known of it.
Box3 box_of(const PointBox& point);
/// Returns a box around a constructed point. A point of the frame is beyond all numbers along the
/// axes along which R moves it.
Box3 box_of_constructed(const Point3Table& points, SpacePoint p);
/// Returns a box around any point of a table.
inline Box3 box_of(const Point3Table& points, SpacePoint p) {
  if (!p.is_input()) return box_of_constructed(points, p);
  const Point3& at = points.planes().point(p.input());
  return {{at.x, at.y, at.z}, {at.x, at.y, at.z}};
}

/// Extends a box to contain a point of a table.
inline void add_point(const Point3Table& points, SpacePoint p, Box3& box) {
  if (!p.is_input()) return box.add(box_of_constructed(points, p));
  const Point3& at = points.planes().point(p.input());
  const std::array<double, 3> x{at.x, at.y, at.z};
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(box.low[i], x[i]);
    box.high[i] = std::max(box.high[i], x[i]);
  }
}

/// Returns a box around a vertex.
inline Box3 box_of(const SpaceComplex& complex, VertexId v) {
  return box_of(complex.points(), complex.vertex_point[v]);
}
/// Returns a box around an edge.
Box3 box_of(const SpaceComplex& complex, EdgeId e);
/// Returns a box around a facet. O(length of its outer cycle).
Box3 box_of(const SpaceComplex& complex, FacetId f);
/// Returns a box around all vertices. O(n).
Box3 box_of(const SpaceComplex& complex);

// The directions in which a cloud of points extends, for boxes that lie along it.

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< Three rows.

/// Returns the eigenvectors of a symmetric matrix as rows (Jacobi's method): unit vectors at right
/// angles up to some roundings. Returns the coordinate axes if numbers are not finite.
Matrix3 principal_axes(Matrix3 m);

// Boxes along other directions than the coordinate axes. Thin parts along a diagonal have large
// boxes that all meet, but their boxes in a suitable frame are small.
//
// A frame is three linear functions; boxes hold their values. The choice of a frame has influence
// on speed alone: boxes are surely large enough in any. The frame of edges has the eigenvectors of
// their covariance. (It has nothing to do with the frame of unbounded sets.)

/// A frame for boxes.
class BoxFrame {
 public:
  /// Makes the frame of the coordinate axes.
  BoxFrame() = default;
  /// Returns a frame that suits the directions of the edges. Longer edges have a greater weight.
  /// O(edges).
  static BoxFrame of_edges(std::span<const SpaceComplex* const> complexes);

  /// Returns a box of this frame around a box of the coordinate axes; infinite if that is.
  Box3 turned(const Box3& box) const;
  /// Returns a box of this frame around a facet, that is around its outer cycle.
  Box3 box_of(const SpaceComplex& complex, FacetId f) const;
  /// Returns a box of this frame around an edge.
  Box3 box_of(const SpaceComplex& complex, EdgeId e) const;
  /// Returns a box of this frame around a vertex.
  Box3 box_of(const SpaceComplex& complex, VertexId v) const;

 private:
  std::array<std::array<double, 3>, 3> axis_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  bool is_turned_ = false;
};

/// Returns how many pairs of boxes, one of each list, would meet if they lay at random places
/// within the box around all. Not finite if a box is not finite.
double expected_pairs(std::span<const Box3> a, std::span<const Box3> b);

/// Whether so many pairs are expected that another frame is worth a try. `items` is the number of
/// boxes.
bool has_many_pairs(double expected, std::size_t items);
/// Whether another frame with so many expected pairs is worth its use.
constexpr bool is_better_frame(double expected, double than) { return expected < than / 4; }

}  // namespace plumb
