// The vertices of a mesh: points of equal coordinates are one vertex. The second part orders a mesh
// of triangles so that neighbours in space are neighbours in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/complex/space_tables.h"
#include "plumb/space/mesh_arrays.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The vertices of a mesh, numbered by their least points.
struct MeshVertices {
  std::vector<std::uint32_t> of_point;  ///< The vertex of each point; kNone if no face uses it.
  std::vector<std::uint32_t> input;     ///< The least point of each vertex, ascending.
  std::vector<SpacePoint> point;        ///< The place of each vertex.
  std::uint64_t merged = 0;             ///< The number of used points merged into an earlier one.
};

/// Returns the vertices of a mesh and adds their points to the tables. -0 equals 0. Throws
/// Error{BadIndex} for a corner without a point, Error{NotFinite}. O(n) expected.
MeshVertices merge_equal_points(const MeshView& mesh, SpaceTables& tables);

// Order in space.
//
// Files name points and faces in any order. All later steps follow links from facets to edges,
// vertices and planes, and wait for memory where these lead far away: a union of two scans took up
// to 1.7 times as long in the order of their files.
//
// Notation: the place of a point is its cell on a grid of 2^10 cells an axis around all points, in
// Morton order (G. Morton, A computer oriented geodetic data base and a new technique in file
// sequencing, IBM, 1966); that of a face is the least place of its corners. So points of equal
// coordinates have equal places, and faces over the same points do, too: what is equal keeps its
// order.

/// A mesh of triangles in another order.
struct OrderedMesh {
  std::vector<double> coordinates;     ///< Three for each point.
  std::vector<std::uint32_t> corners;  ///< Three points for each triangle.
  std::vector<std::uint32_t> face;     ///< The number of each face in the mesh that was ordered.

  /// Returns a view of the mesh, valid as long as this object.
  MeshView view() const { return mesh_of_triangles(coordinates, corners); }
  /// Whether the mesh was left as it is.
  bool is_empty() const { return face.empty(); }
};

/// Returns the points and faces of a mesh, sorted by their places. Returns an empty mesh if the
/// order is to be kept: if there are faces other than triangles, points that are no doubles or not
/// finite or too far apart, corners that are no points, or no faces at all. Faces of more corners
/// keep their order because, where they are not flat, their triangles depend on the numbers of
/// their points, and so does what is reported of them. O(n): 30 to 40 ns a triangle for 60,000 to
/// 300,000 triangles.
OrderedMesh ordered_in_space(const MeshView& mesh);

}  // namespace plumb
#pragma GCC visibility pop
