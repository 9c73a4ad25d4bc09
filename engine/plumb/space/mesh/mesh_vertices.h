// The vertices of a mesh. The first part makes points of equal coordinates one vertex. The second
// part orders a mesh of triangles so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/complex/space_tables.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The vertices of a mesh, in the order of their points of least index.
struct MeshVertices {
  std::vector<std::uint32_t> of_point;  ///< The vertex of each point; kNone if no face uses it.
  std::vector<std::uint32_t> input;     ///< The point of least index of each vertex, ascending.
  std::vector<SpacePoint> point;        ///< The point of each vertex in the tables.
  std::uint64_t merged = 0;             ///< The number of used points merged into an earlier point.
};

/// Returns the vertices of a mesh and adds their points to the tables. -0 equals 0. Throws
/// Error{BadIndex} if a corner is not the index of a point, and Error{NotFinite} if a coordinate is
/// not finite. O(n) expected.
MeshVertices merge_equal_points(const MeshView& mesh, SpaceTables& tables);

// Order in space.
//
// Files list points and faces in any order. All later steps follow links from facets to edges,
// vertices and planes. They wait for memory if linked cells are far apart in memory: a union of two
// scans took up to 1.7 times as long in the order of their files.
//
// Each point is sorted by its cell on a grid around all points, with 2^10 cells along each axis.
// Grid cells are in Morton order (G. Morton, A computer oriented geodetic data base and a new
// technique in file sequencing, IBM, 1966). Each face is sorted by the least grid cell of its
// corners. So points of equal coordinates have the same grid cell, and so have faces over the same
// points. Points or faces with the same grid cell keep their order.

/// A mesh of triangles in another order.
struct OrderedMesh {
  std::vector<double> coordinates;     ///< Three coordinates for each point.
  std::vector<std::uint32_t> corners;  ///< Three point indices for each triangle.
  std::vector<std::uint32_t> face;     ///< The index of each face in the original mesh.

  /// Returns a view of the mesh. The view is valid as long as this object.
  MeshView view() const { return mesh_of_triangles(coordinates, corners); }
  /// Whether the mesh was not ordered: there are no faces here.
  bool is_empty() const { return face.empty(); }
};

/// Returns the points and faces of a mesh, sorted by their grid cells. Returns an empty mesh if the
/// order must be kept, which is so if there are:
/// - no faces,
/// - faces other than triangles,
/// - points whose coordinates are not doubles, not finite or too far apart,
/// - corners that are not indices of points.
///
/// Meshes of other polygons keep their order for the following reason. A polygon that is not flat
/// is triangulated, and its triangles and the report about them depend on the indices of its
/// points. O(n): 30 to 40 ns for each triangle of a mesh of 60,000 to 300,000 triangles.
OrderedMesh ordered_in_space(const MeshView& mesh);

}  // namespace plumb
#pragma GCC visibility pop
