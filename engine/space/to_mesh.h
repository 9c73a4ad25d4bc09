// From a complex with volumes and marks to polygons: the boundary of the closure of its interior.
//
// Main flow of mesh_of_complex():
//  1. boundary_sides   facets between a marked and an unmarked volume, the marked one behind them
//  2. count_dropped    marked items that are not in the closure of the interior, unmarked ones that are
//  3. mesh_of_sides    corners around each vertex join to cones; vertices; polygons and triangles
//
// Triangles have vertices of the complex for corners only, and no vertex on a side: no T-junctions.
// Cost: O(n log n); ~5 us for each constructed vertex, which is rounded exactly.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/polygon_mesh.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What becomes of facets.
enum class MeshFaces : std::uint8_t {
  /// Facets that are simple polygons and whose corners are doubles stay polygons; others are cut.
  PlanarPolygons,
  Polygons,  ///< all facets that are simple polygons; rounded corners may leave their planes
  Triangles,
};

/// What a mesh is to be like.
struct ToMeshOptions {
  MeshFaces faces = MeshFaces::PlanarPolygons;  ///< what becomes of facets
  /// Where several cones of the solid meet in a vertex, each gets a vertex of its own (with equal
  /// coordinates). Edges with more than two faces then fall apart too.
  bool split_vertices = false;
  /// Fill mesh.exact. Without it rounding is as correct, and takes a third of the time.
  bool keeps_exact = true;
};

/// A facet as seen from outside: from its positive side, or reversed.
struct FacetSide {
  FacetId facet;     ///< which
  bool is_reversed;  ///< seen from its negative side?
  friend bool operator==(const FacetSide&, const FacetSide&) = default;
};

/// Numbers of items.
struct ItemCounts {
  std::uint64_t facets = 0;                                          ///< how many
  std::uint64_t edges = 0;                                           ///< how many
  std::uint64_t vertices = 0;                                        ///< how many
  std::uint64_t total() const { return facets + edges + vertices; }  ///< All together.
};

/// What a mesh does not say of the set.
struct ToMeshReport {
  /// A marked volume reaches to infinity: no mesh. Of a soup: facets that do are left out.
  bool is_unbounded = false;
  ItemCounts dropped;  ///< marked, with no marked volume around: dangling
  ItemCounts filled;   ///< not marked, but in the closure of marked volumes: openness
  std::uint64_t non_manifold_edges = 0;     ///< more than two faces
  std::uint64_t non_manifold_vertices = 0;  ///< more than one cone
  /// Has it other than two faces at an edge, or several cones at a vertex?
  bool is_soup() const { return non_manifold_edges + non_manifold_vertices > 0; }
};

/// A mesh and where it comes from.
struct MeshOfComplex {
  PolygonMesh
      mesh;  ///< points: correctly rounded; exact: the coordinates that were rounded, if kept
  std::vector<FacetId> facet;  ///< per face
  ToMeshReport report;         ///< what the mesh does not say
};

/// Requires volumes and marks. Items beyond the frame are not looked at.
MeshOfComplex mesh_of_complex(const SpaceComplex& complex, const ToMeshOptions& options,
                              Context& context);

/// All facets of any set as polygons: those of boundary_sides() from outside, others (dangling ones, cuts in a solid)
/// once, from their positive side. No solid has to be behind them; what is not a facet is dropped. Facets that reach
/// to infinity are left out: report.is_unbounded. Dropped: marked edges and vertices without a marked volume.
MeshOfComplex soup_of_complex(const SpaceComplex& complex, const ToMeshOptions& options,
                              Context& context);

/// Does the facet reach the frame?
bool is_unbounded(const SpaceComplex& complex, FacetId f);

/// The boundary of the closure of the interior, by facet.
std::vector<FacetSide> boundary_sides(const SpaceComplex& complex);

/// Any sides as a mesh, for instance a shell. Requires each at most once, and around every edge as many with
/// the solid before them as after them. Of the report, the last two counts are filled.
MeshOfComplex mesh_of_sides(const SpaceComplex& complex, std::span<const FacetSide> sides,
                            const ToMeshOptions& options, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
