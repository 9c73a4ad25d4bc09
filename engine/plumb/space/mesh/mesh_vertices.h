// Finds the vertices of a mesh, and sorts meshes. The first part of this header merges points with
// equal coordinates into one vertex, and drops points that no face uses. The second part sorts a
// mesh of triangles so that neighbours in space are close together in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/complex/space_tables.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The vertices of a mesh. Each vertex is a set of points with equal coordinates. Vertices are in
/// the order of the least point index in each set.
struct MeshVertices {
  std::vector<std::uint32_t> of_point;  ///< The vertex of each point; kNone if no face uses it.
  std::vector<std::uint32_t> input;     ///< The least point index of each vertex, ascending.
  std::vector<SpacePoint> point;        ///< The point of each vertex in the tables.
  std::uint64_t merged =
      0;  ///< The number of used points that have the coordinates of an earlier used point.
};

/// Returns the vertices of a mesh and adds their points to the tables. The coordinates -0 and 0
/// count as equal. Throws Error{BadIndex} if a corner is not the index of a point, and
/// Error{NotFinite} if a coordinate is not finite. O(n) expected for n corners.
MeshVertices merge_equal_points(const MeshView& mesh, SpaceTables& tables);

/// Drops the points that no face uses. The other points keep their order. Returns the new index of
/// each point, which is kNone for a dropped point. O(n) for n corners.
std::vector<std::uint32_t> drop_unused_points(PolygonMesh& mesh);

// Sorting by position in space.
//
// Files list points and faces in any order. All later steps follow links from facets to edges,
// vertices and planes. These steps are slow if linked cells are far apart in memory. For example,
// without sorting, the union of two scanned meshes took up to 1.7 times as long.
//
// A grid with 2^10 cells along each axis covers all points. Points are sorted by the grid cell that
// contains them. Grid cells are in Morton order (G. Morton, A computer oriented geodetic data base
// and a new technique in file sequencing, IBM, 1966). Faces are sorted by the least grid cell of
// their corners. Points with equal coordinates are in the same grid cell, and faces with the same
// corners have the same least grid cell. Points of the same grid cell keep their order. Faces with
// the same least grid cell keep their order, too.

/// A mesh of triangles after sorting.
struct OrderedMesh {
  std::vector<double> coordinates;     ///< Three coordinates for each point.
  std::vector<std::uint32_t> corners;  ///< Three point indices for each triangle.
  std::vector<std::uint32_t> face;     ///< The index that each triangle has in the original mesh.
  std::vector<std::uint32_t> cell;     ///< The Morton code of the cell of each point, ascending.

  /// Returns a view of the mesh. The view is valid as long as this object exists.
  MeshView view() const { return mesh_of_triangles(coordinates, corners); }
  /// Whether this object is empty. ordered_in_space() returns an empty object if the original order
  /// of the mesh must be kept.
  bool is_empty() const { return face.empty(); }
};

/// Returns the points and faces of a mesh, sorted by their grid cells. Returns an empty object if
/// the order must be kept. This is the case if the mesh has:
/// - no faces,
/// - faces other than triangles,
/// - points whose coordinates are not doubles, not finite or too far apart,
/// - corners that are not indices of points.
///
/// Meshes with faces other than triangles keep their order for the following reason. A polygon that
/// is not planar is triangulated. The choice of its triangles, and the report about them, depend on
/// the indices of the polygon's points. Cost: O(n) for n triangles; 30 to 40 ns for each triangle
/// of a mesh of 60,000 to 300,000 triangles.
OrderedMesh ordered_in_space(const MeshView& mesh);

/// Does what merge_equal_points() does to the view of an ordered mesh. Equal points are in the same
/// grid cell. So each point is compared only with the points of its grid cell, unless a grid cell
/// contains very many points.
MeshVertices merge_equal_points(const OrderedMesh& mesh, SpaceTables& tables);

}  // namespace plumb
#pragma GCC visibility pop
