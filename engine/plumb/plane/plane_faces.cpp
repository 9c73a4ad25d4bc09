// Makes features of the faces of a complex. Tested by tests/plane/plane_faces_test.cpp.
#include "plumb/plane/plane_faces.h"

#include <vector>

#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {
namespace {

constexpr std::size_t kFacesBetweenCheckpoints = 256;

PointTable2 vertex_points(const PlaneComplex& complex) {
  PointTable2 points;
  points.reserve(complex.vertex_count());
  for (const std::uint32_t p : complex.vertex_point) {
    const RationalPoint2 at = exact(complex.points, p);
    points.push_back(at.x, at.y);
  }
  return points;
}

}  // namespace

Layer layer_of_faces(const Nef2& set, Context& context) {
  const PlaneComplex& complex = set.complex();
  Layer layer;
  layer.points = vertex_points(complex);
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (f % kFacesBetweenCheckpoints == 0) context.checkpoint("faces", f, complex.face_count());
    const FaceId face(f);
    if (!complex.mark(face) || is_unbounded(complex, face)) continue;
    for (const std::vector<VertexId>& ring : face_rings(complex, face)) {
      for (const VertexId v : ring) layer.ring_corners.push_back(v.value());
      layer.end_ring();
    }
    layer.end_polygon();
    layer.end_feature({}, {});
  }
  return layer;
}

}  // namespace plumb
