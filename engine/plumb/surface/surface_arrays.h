// Converts plain arrays to surfaces, and surfaces to plain arrays. The arrays are passed as a
// MeshView (plumb/space/mesh_arrays.h).
//
//   in     surface_of(mesh_of_triangles(xyz, corners)) returns a SurfaceMesh
//   out    view_of(mesh) and view_of(triangulation) return spans of coordinates and of corners
//
// surface_of() copies its input once, into the arrays of the surface. view_of() copies nothing.
// Sets of space are made from the same views: Nef3::from_mesh(view_of(surface), {.rule = rule},
// context).
#pragma once

#include "plumb/space/mesh_arrays.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/triangulation.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the triangles of `mesh` as a surface. The arrays of `mesh` are not needed afterwards.
/// Vertices and faces keep their indices. In flipped faces, the last two corners are exchanged
/// (SurfaceMesh::is_flipped()). Exact coordinates in MeshView::exact are rounded to the nearest
/// doubles. Throws:
/// - Error{BadArgument} if a face is not a triangle,
/// - Error{NotFinite} with the index of the vertex, if a coordinate is not finite,
/// - what the constructor of SurfaceMesh throws.
///
/// Cost: O(n) for n triangles.
SurfaceMesh surface_of(const MeshView& mesh);

/// Returns a view of the vertices and faces of a surface, with the same indices. The surface must
/// outlive the view. While the view is used, the contents of the surface must not be moved to
/// another object.
MeshView view_of(const SurfaceMesh& mesh);

/// Returns a view of the points and triangles of a triangulation, with the same indices. The arrays
/// of the triangulation must outlive the view.
MeshView view_of(const SurfaceTriangulation& triangulation);

}  // namespace plumb
#pragma GCC visibility pop
