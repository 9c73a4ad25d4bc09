// Boxes of doubles around the items of a complex, surely large enough. Of an input point: the point itself.
#pragma once

#include "plumb/base/box_tree.h"
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

}  // namespace plumb
