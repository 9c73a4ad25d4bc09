// Boxes of doubles around the items of a complex, surely large enough. Of an input point: the point
// itself.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Around a point. Infinite when nothing is known of it.
Box3 box_of(const PointBox& point);
/// A point of the frame is beyond all numbers along the axes along which R moves it.
Box3 box_of_constructed(const Point3Table& points, SpacePoint p);
inline Box3 box_of(const Point3Table& points, SpacePoint p) {
  if (!p.is_input()) return box_of_constructed(points, p);
  const Point3& at = points.planes().point(p.input());
  return {{at.x, at.y, at.z}, {at.x, at.y, at.z}};
}

inline Box3 box_of(const SpaceComplex& complex, VertexId v) {
  return box_of(complex.points(), complex.vertex_point[v.value()]);
}
Box3 box_of(const SpaceComplex& complex, EdgeId e);
/// O(its outer cycle).
Box3 box_of(const SpaceComplex& complex, FacetId f);
/// Around all vertices.
Box3 box_of(const SpaceComplex& complex);

// The directions in which a cloud of points extends, for boxes that lie along it.

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<Vector3, 3>;  ///< rows

/// Unit vectors, the eigenvectors of a symmetric matrix, as rows (Jacobi): at right angles but for
/// some roundings. The coordinate axes where numbers are not finite.
Matrix3 principal_axes(Matrix3 m);

// Boxes along other directions than the coordinate axes: thin parts along a diagonal have large
// boxes that all meet, but small ones in a frame of their own.
//
// A frame is three linear functions; boxes hold their values. What they are decides about speed
// alone: boxes are surely large enough in any. The frame of edges has the eigenvectors of their
// covariance.

class BoxFrame {
 public:
  /// The coordinate axes.
  BoxFrame() = default;
  /// The directions that the edges run in, longer ones counting more.
  static BoxFrame of_edges(std::span<const SpaceComplex* const> complexes);

  /// Around all of a box of the coordinate axes. Infinite if that is.
  Box3 turned(const Box3& box) const;
  /// Of facets the outer cycle.
  Box3 box_of(const SpaceComplex& complex, FacetId f) const;
  Box3 box_of(const SpaceComplex& complex, EdgeId e) const;
  Box3 box_of(const SpaceComplex& complex, VertexId v) const;

 private:
  std::array<std::array<double, 3>, 3> axis_ = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  bool is_turned_ = false;
};

/// How many pairs of boxes, one of each, would meet if they lay anywhere within all. Not finite
/// where boxes are not.
double expected_pairs(std::span<const Box3> a, std::span<const Box3> b);

/// Are there so many that another frame is worth a try, `items` being the number of boxes?
bool has_many_pairs(double expected, std::size_t items);
/// Is another frame with so many of them worth its use?
constexpr bool is_better_frame(double expected, double than) { return expected < than / 4; }

}  // namespace plumb
