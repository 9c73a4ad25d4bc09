// Converts a complex with volumes and marks to a polygon mesh. The mesh represents the boundary of
// the closure of the interior of the set.
//
// Main flow of mesh_of_complex():
//  1. boundary_sides   finds the facets between a marked and an unmarked volume. Each of these
//                      facets is seen from the side of the unmarked volume
//  2. mesh_of_sides    groups the sectors of the facets at each vertex into cones. A cone is a part
//                      of the solid near the vertex that touches the other parts only in the vertex
//                      or in edges. Then the step makes the vertices of the mesh, and finally its
//                      polygons or triangles
//  3. ClosureCount     counts the marked cells outside the closure of the interior, and the
//                      unmarked cells inside the closure of the interior
//
// The corners of triangles are vertices of the complex, and no vertex lies inside a side of a
// triangle. So there are no T-junctions.
//
// Cost: O(n log n) for n cells, plus about 5 us for each constructed vertex, whose coordinates must
// be rounded correctly.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The facets that are triangulated.
enum class MeshFaces : std::uint8_t {
  /// A facet becomes one polygon if it is simple and the coordinates of its corners are doubles.
  /// Other facets are triangulated.
  PlanarPolygons,
  /// A facet becomes one polygon if it is simple. After rounding, the corners of the polygon do not
  /// always lie in one plane. Other facets are triangulated.
  Polygons,
  Triangles,  ///< All facets are triangulated.
};

/// Options of the conversion to a mesh.
struct ToMeshOptions {
  MeshFaces faces = MeshFaces::PlanarPolygons;  ///< The facets that are triangulated.
  /// Whether the mesh has a separate vertex for each cone (see above) of the solid at a vertex of
  /// the set. The separate vertices have equal coordinates. If this option is set, edges with more
  /// than two faces are split, too.
  bool split_vertices = false;
  /// Whether mesh.exact is filled. Its contents are needed by check_rounding() and by exact file
  /// formats. If the mesh has many constructed vertices, filling mesh.exact triples the time of the
  /// conversion.
  bool keeps_exact = false;
};

/// A facet seen from one of its two sides. A solid lies on the other side of the facet.
struct FacetSide {
  FacetId facet;     ///< The facet.
  bool is_reversed;  ///< Whether the facet is seen from its negative side.
  friend bool operator==(const FacetSide&, const FacetSide&) = default;
};

/// The numbers of facets, edges and vertices.
struct ItemCounts {
  std::uint64_t facets = 0;    ///< Number of facets.
  std::uint64_t edges = 0;     ///< Number of edges.
  std::uint64_t vertices = 0;  ///< Number of vertices.
  /// Returns the number of all cells.
  std::uint64_t total() const { return facets + edges + vertices; }
};

/// A report on a conversion to a mesh. It counts the cells of the set that the mesh does not
/// represent, and the edges and vertices at which the mesh is not a manifold.
struct ToMeshReport {
  /// mesh_of_complex() sets this if a marked volume reaches to infinity. The mesh is then empty.
  /// soup_of_complex() sets this if a facet reaches to infinity. The mesh does not contain such
  /// facets.
  bool is_unbounded = false;
  ItemCounts
      dropped;  ///< Marked cells outside the closure of the marked volumes; the mesh omits them.
  ItemCounts filled;  ///< Unmarked cells inside the solid; the solid of the mesh includes them.
  /// Unmarked cells on the boundary of the solid; the solid of the mesh includes them.
  ItemCounts closed;
  std::uint64_t non_manifold_edges = 0;     ///< Edges with more than two faces.
  std::uint64_t non_manifold_vertices = 0;  ///< Vertices with more than one cone.
  /// Whether an edge has more than two faces, or a vertex has more than one cone.
  bool is_soup() const { return non_manifold_edges + non_manifold_vertices > 0; }
};

/// A mesh, and the facets from which its faces were made.
struct MeshOfComplex {
  /// The mesh. Its points are correctly rounded. If ToMeshOptions::keeps_exact is set, mesh.exact
  /// lists the exact coordinates of the points that had to be rounded.
  PolygonMesh mesh;
  std::vector<FacetId> facet;  ///< The facet from which each face was made.
  /// For each point that had to be rounded, its index and its vertex of the complex. The indices
  /// are in ascending order.
  std::vector<std::pair<std::uint32_t, VertexId>> rounded;
  ToMeshReport report;  ///< The cells that the mesh does not represent.
};

/// Returns a mesh of the boundary of the closure of the interior. If a marked volume is unbounded,
/// the mesh is empty and report.is_unbounded is set. Requires that the complex has volumes and
/// marks. Cells of the frame and cells outside the frame are ignored.
MeshOfComplex mesh_of_complex(const SpaceComplex& complex, const ToMeshOptions& options = {},
                              Context& context = unlimited_context());

/// Returns all facets of a set as a mesh, even facets that do not bound a solid. The facets that
/// boundary_sides() returns are oriented as seen from outside the solid. All other facets (dangling
/// facets, and cuts in a solid) occur once, and are oriented as seen from their positive side.
/// Facets that reach to infinity are left out, and report.is_unbounded is set. report.dropped
/// counts marked edges and vertices outside the closure of the marked volumes;
/// report.dropped.facets is 0. Requires that the complex has volumes and marks.
MeshOfComplex soup_of_complex(const SpaceComplex& complex, const ToMeshOptions& options = {},
                              Context& context = unlimited_context());

/// Whether the facet reaches to infinity. This is so if and only if the facet has a vertex on the
/// frame.
bool is_unbounded(const SpaceComplex& complex, FacetId f);

/// Returns the boundary of the closure of the interior as a list of sides of facets. The list is in
/// ascending order of facets. Requires that the complex has volumes and marks. O(facets).
std::vector<FacetSide> boundary_sides(const SpaceComplex& complex);

/// Makes a mesh of the given sides, for instance of the sides of a shell. In the report, only the
/// counts of non-manifold edges and vertices are filled. Requires that each side occurs at most
/// once. Consider a counter-clockwise walk around an edge. At some sides, the walk leaves the
/// solid; at all other sides, it enters the solid. Requires that, at every edge, there are as many
/// sides of the first kind as of the second kind.
MeshOfComplex mesh_of_sides(const SpaceComplex& complex, std::span<const FacetSide> sides,
                            const ToMeshOptions& options = {},
                            Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
