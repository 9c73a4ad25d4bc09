// The triangles over which the channels of a mesh are linear. Internal.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh/face_corners.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/source_mesh.h"

namespace plumb {

/// Returns the triangles of all faces, in the order of faces. Faces of fewer than three corners
/// have none. A planar and simple polygon is cut as triangulated() (repair_mesh.h) cuts it. Any
/// other polygon is cut as Nef3::from_mesh() cuts it, so that its triangles have the same planes as
/// the set. Triangles without area are left out. Throws the errors of the Context. O(n log n).
std::vector<FaceTriangle> triangles_of_faces(const PolygonMesh& mesh, Context& context);

/// Returns the same triangles for the mesh of a source. If it has polygons, the source keeps them,
/// because the pieces of a set (decompose.h) have the same sources. Can be called from several
/// threads at once.
SourceTrianglesCache::Triangles triangles_of_source(const MeshSource& source, Context& context);

}  // namespace plumb
