// Surfaces from and to plain arrays, in the form of plumb/space/mesh_arrays.h.
//
//   in     surface_of(mesh_of_triangles(xyz, corners)): a SurfaceMesh
//   out    view_of(mesh), view_of(triangulation): spans of coordinates and of corners
//
// What comes in is copied once, into the arrays that the surface keeps; what goes out is read where it lies. A
// view is what sets of space are made of as well: Nef3::mesh(view_of(surface), rule, context).
#pragma once

#include "plumb/space/mesh_arrays.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/triangulation.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The triangles of `mesh` as a surface; the arrays may go when it is there. Vertices keep their numbers and
/// faces theirs (some are turned: SurfaceMesh::is_flipped). Coordinates are the nearest doubles of what MeshView::exact has. Throws
/// what the constructor of SurfaceMesh throws, Error{NotFinite} with the number of the vertex, and Error{BadArgument}
/// for a face that is no triangle. O(n).
SurfaceMesh surface_of(const MeshView& mesh);

/// Vertices and faces of a surface, by their numbers. Valid as long as the surface, and until it is moved from.
MeshView view_of(const SurfaceMesh& mesh);

/// Points and triangles, by their indices. Valid as long as these arrays.
MeshView view_of(const SurfaceTriangulation& triangulation);

}  // namespace plumb
#pragma GCC visibility pop
