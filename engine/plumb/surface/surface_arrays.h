// Conversions between surfaces and plain arrays, in the form of plumb/space/mesh_arrays.h.
//
//   in     surface_of(mesh_of_triangles(xyz, corners)): a SurfaceMesh
//   out    view_of(mesh), view_of(triangulation): spans of coordinates and of corners
//
// Input is copied once, into the arrays of the surface; output is read in place. The same views
// make sets of space: Nef3::from_mesh(view_of(surface), {.rule = rule}, context).
#pragma once

#include "plumb/space/mesh_arrays.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/triangulation.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the triangles of `mesh` as a surface; the arrays are not needed afterwards. Vertices and
/// faces keep their indices, but some faces are flipped (SurfaceMesh::is_flipped()). Exact
/// coordinates in MeshView::exact are rounded to the nearest doubles. Throws:
/// - Error{BadArgument} if a face is not a triangle,
/// - Error{NotFinite} with the index of the vertex, if a coordinate is not finite,
/// - what the constructor of SurfaceMesh throws.
///
/// Cost: O(n).
SurfaceMesh surface_of(const MeshView& mesh);

/// Returns a view of the vertices and faces of a surface, with the same indices. The surface must
/// outlive the view and must not be moved from.
MeshView view_of(const SurfaceMesh& mesh);

/// Returns a view of the points and triangles of a triangulation, with the same indices. The arrays
/// of the triangulation must outlive the view.
MeshView view_of(const SurfaceTriangulation& triangulation);

}  // namespace plumb
#pragma GCC visibility pop
