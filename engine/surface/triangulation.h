// A divided surface as triangles: what pictures and files show.
//
// Main flow of triangulate_surface():
//  1. cut       each piece of a touched face between its nodes (plumb/space/triangulate.h)
//  2. flip      edges inside pieces until they are Delaunay, as distances in the face are (piece_points.h):
//               arcs and sides of faces are constraints, so this is the constrained Delaunay triangulation of
//               each face, and nodes on sides are corners of triangles on both sides of it
//  3. sew       triangles within pieces, across half-edges, and with the faces that are not touched
// Cost: O(mesh + k log k) for k half-edges as a rule.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Side 3 t + i runs from corner i of triangle t to corner i + 1.
struct SurfaceTriangulation {
  std::vector<Point3> points;              ///< rounded; those of the mesh first, then of nodes
  std::vector<NodeId> node;                ///< per point; invalid where no node is
  std::vector<SurfaceTriangle> triangles;  ///< corners are indices of points
  std::vector<CellId> cell;                ///< per triangle: its group
  std::vector<FaceId> face;                ///< per triangle: the face of the mesh it is part of
  std::vector<std::uint32_t> across;       ///< per side: the side of the other triangle, or kNone
  std::vector<ArcId> arc;                  ///< per side: what polygons run along it; invalid: none
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};  ///< no cell, no node
};

/// The surface in triangles, each in one cell. O(n log n).
SurfaceTriangulation triangulate_surface(const SurfaceDivision& division, Context& context);

/// Where a node is, rounded.
Point3 node_position(const SurfaceDivision& division, NodeId node);

}  // namespace plumb
#pragma GCC visibility pop
