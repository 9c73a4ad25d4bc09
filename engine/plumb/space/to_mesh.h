// Converts a complex with volumes and marks to a polygon mesh: the boundary of the closure of its
// interior.
//
// Main flow of mesh_of_complex():
//  1. boundary_sides   finds the facets between a marked and an unmarked volume, and turns them so
//                      that the marked volume is behind them
//  2. mesh_of_sides    joins the corners around each vertex to cones, makes vertices, then polygons
//                      and triangles
//  3. ClosureCount     counts marked cells outside the closure of the interior, and unmarked cells
//                      in it
//
// Triangles have only vertices of the complex as corners, and no vertex in the interior of a side:
// there are no T-junctions.
//
// Cost: O(n log n), and about 5 us for each constructed vertex, which is rounded exactly.
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

/// How facets become faces.
enum class MeshFaces : std::uint8_t {
  /// Facets that are simple polygons and whose corners are doubles stay polygons. Others are
  /// triangulated.
  PlanarPolygons,
  /// All facets that are simple polygons stay polygons; rounded corners may leave their planes.
  Polygons,
  Triangles,  ///< All facets are triangulated.
};

/// Options of the conversion to a mesh.
struct ToMeshOptions {
  MeshFaces faces = MeshFaces::PlanarPolygons;  ///< How facets become faces.
  /// Whether each cone of the solid at a vertex gets a vertex of its own, with equal coordinates.
  /// Edges with more than two faces are then split too.
  bool split_vertices = false;
  /// Whether mesh.exact is filled, which triples the time of a mesh with many constructed vertices.
  /// check_rounding() and exact formats need it.
  bool keeps_exact = false;
};

/// A facet seen from one of its sides, which is the outside of a solid.
struct FacetSide {
  FacetId facet;     ///< The facet.
  bool is_reversed;  ///< Whether it is seen from its negative side.
  friend bool operator==(const FacetSide&, const FacetSide&) = default;
};

/// Numbers of cells.
struct ItemCounts {
  std::uint64_t facets = 0;    ///< Number of facets.
  std::uint64_t edges = 0;     ///< Number of edges.
  std::uint64_t vertices = 0;  ///< Number of vertices.
  /// Returns the number of all cells.
  std::uint64_t total() const { return facets + edges + vertices; }
};

/// What a mesh does not represent of its set, and where it is not a manifold.
struct ToMeshReport {
  /// Whether a marked volume reaches to infinity; the mesh is then empty. For soup_of_complex(),
  /// whether a facet does; such facets are left out.
  bool is_unbounded = false;
  ItemCounts dropped;                       ///< Marked cells not in the closure of marked volumes.
  ItemCounts filled;                        ///< Unmarked cells inside the solid, now part of it.
  ItemCounts closed;                        ///< Unmarked cells on its boundary, now part of it.
  std::uint64_t non_manifold_edges = 0;     ///< Edges with more than two faces.
  std::uint64_t non_manifold_vertices = 0;  ///< Vertices with several cones.
  /// Whether an edge has more than two faces, or a vertex several cones.
  bool is_soup() const { return non_manifold_edges + non_manifold_vertices > 0; }
};

/// A mesh and the facets that it comes from.
struct MeshOfComplex {
  /// The mesh. Its points are correctly rounded; `exact` holds the coordinates of those that are
  /// no doubles, if options.keeps_exact is set.
  PolygonMesh mesh;
  std::vector<FacetId> facet;  ///< The facet behind each face.
  ToMeshReport report;         ///< What the mesh does not represent.
};

/// Returns the boundary of the closure of the interior as a mesh. If a marked volume is unbounded,
/// the mesh is empty and report.is_unbounded is set. Requires volumes and marks. Cells of the frame
/// and beyond it do not count.
MeshOfComplex mesh_of_complex(const SpaceComplex& complex, const ToMeshOptions& options = {},
                              Context& context = unlimited_context());

/// Returns all facets of a set as a mesh, whether there is a solid behind them or not. Facets of
/// boundary_sides() are seen from outside; other facets (dangling facets, cuts in a solid) occur
/// once, seen from their positive side. Facets that reach to infinity are left out, and
/// report.is_unbounded is set. report.dropped counts marked edges and vertices outside the closure
/// of the marked volumes; its number of facets is 0. Requires volumes and marks.
MeshOfComplex soup_of_complex(const SpaceComplex& complex, const ToMeshOptions& options = {},
                              Context& context = unlimited_context());

/// Whether the facet reaches to infinity: whether it has a vertex on the frame.
bool is_unbounded(const SpaceComplex& complex, FacetId f);

/// Returns the boundary of the closure of the interior, as sides in ascending order of facets.
/// Requires volumes and marks. O(facets).
std::vector<FacetSide> boundary_sides(const SpaceComplex& complex);

/// Returns any sides, for instance those of a shell, as a mesh. Only the counts of non-manifold
/// edges and vertices are filled in the report. Requires that each side occurs at most once, and
/// that as many sides have the solid before them as after them around every edge.
MeshOfComplex mesh_of_sides(const SpaceComplex& complex, std::span<const FacetSide> sides,
                            const ToMeshOptions& options = {},
                            Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
