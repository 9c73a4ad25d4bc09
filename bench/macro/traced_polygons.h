// Polygons all over a mesh, joined by geodesics.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/error.h"
#include "plumb/surface/trace.h"

namespace plumb::bench {

/// So many, through eight faces each. Requires a connected mesh.
inline SurfacePolygons traced_polygons(const SurfaceMesh& mesh, std::size_t count) {
  SurfacePolygons polygons(mesh);
  Tracer tracer(mesh);
  Context context;
  std::size_t face = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<SurfacePointId, 8> corners;
    for (SurfacePointId& corner : corners) {
      face = (face + 7919) % mesh.face_count();
      corner = polygons.points.add_in_face(FaceId(face), 0.375, 0.25);
    }
    PLUMB_CHECK(!add_traced_polygon(tracer, corners, polygons, context));
  }
  return polygons;
}

}  // namespace plumb::bench
