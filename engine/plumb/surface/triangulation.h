// Triangulates a divided surface, for pictures and files.
//
// Main flow of triangulate_surface():
//  1. cut       triangulates each piece of each face that polygons touch
//               (plumb/space/planar/triangulate.h). The corners of the triangles are nodes
//  2. flip      flips edges inside pieces until they are Delaunay. Distances are measured in the
//               face (triangulation.cpp). Arcs and sides of faces are never flipped. So the result
//               is the constrained Delaunay triangulation of each face. A node on a side is a
//               corner of triangles in both adjacent faces
//  3. sew       finds the neighbours of triangles: within a piece, across half-edges, and in faces
//               that no polygon touches
// Cost: usually O(mesh + k log k) for k half-edges.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A divided surface as a list of triangles. Side 3 t + i runs from corner i of triangle t to
/// corner i + 1.
struct SurfaceTriangulation {
  /// Rounded positions: first the positions of the vertices of the mesh, then the positions of the
  /// nodes.
  std::vector<Point3> points;
  std::vector<NodeId> node;  ///< The node at each point; invalid if no node lies there.
  std::vector<SurfaceTriangle> triangles;  ///< The point indices of each triangle's corners.
  std::vector<CellId> cell;                ///< The cell that contains each triangle.
  std::vector<FaceId> face;                ///< The face of the mesh that contains each triangle.
  /// For each side, the index of the same side in the adjacent triangle; kNone at the border.
  std::vector<std::uint32_t> across;
  std::vector<ArcId> arc;  ///< The arc along each side; invalid if no arc runs there.
};

/// Returns the triangulation of the surface. Each triangle lies in one cell. Throws the errors of
/// the Context. Cost: O(n log n) for n half-edges.
SurfaceTriangulation triangulate_surface(const SurfaceDivision& division,
                                         Context& context = unlimited_context());

/// Returns the rounded position of a node in space.
Point3 node_position(const SurfaceDivision& division, NodeId node);

}  // namespace plumb
#pragma GCC visibility pop
