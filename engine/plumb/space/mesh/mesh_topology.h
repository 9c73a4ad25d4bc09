// Derives facts from the incidences of a mesh: where it is open, its components and their
// orientations, and the vertices around which it cannot cross itself.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/sign.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/space/mesh/link_facets.h"
#include "plumb/space/space_complex.h"

namespace plumb {

// Borders.

/// How often an edge is run through from its lesser to its greater vertex, less how often back.
struct EdgeSurplus {
  std::array<std::uint32_t, 2> end;  ///< The vertices of the edge, ascending.
  std::int32_t times;                ///< In a collected list, it is not 0.
};
/// Surpluses of edges. In a collected list, edges ascend, are different, and do not balance.
using EdgeSurpluses = std::vector<EdgeSurplus>;

/// Adds an edge that is run through `times` times from one vertex to another.
inline void add_to(EdgeSurpluses& list, std::uint32_t from, std::uint32_t to, std::int32_t times) {
  if (from < to) {
    list.push_back({{from, to}, times});
  } else {
    list.push_back({{to, from}, -times});
  }
}
/// Sorts a list, adds up the entries of each edge, and drops the edges that balance.
void collect(EdgeSurpluses& list);

/// For each edge of a list, the vertices inside it, from its first end to its second.
struct InnerVertices {
  std::vector<std::uint32_t> begin = {0};  ///< Starts in `vertex`, one more than there are edges.
  std::vector<std::uint32_t> vertex;       ///< The vertices.

  /// Returns the vertices inside edge i.
  std::span<const std::uint32_t> of(std::size_t i) const {
    return std::span(vertex).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

/// Finds the ends of the edges that lie inside other edges. The ends of an edge must be different
/// points. `points` has the place of each vertex. O((m + k) log m) for m edges, where k is the
/// number of nodes of a tree over the ends whose boxes meet edges. This is a few times m log m,
/// unless many edges run closely along each other. Charges all memory that it allocates to
/// `memory`, including the memory of the result. Throws the errors of the Context.
InnerVertices vertices_inside(std::span<const std::array<std::uint32_t, 2>> edges,
                              std::span<const SpacePoint> points, const Point3Table& table,
                              MemoryCharge& memory, Context& context);

/// Cuts the edges of a collected list at the ends of others that lie on them. Returns the collected
/// list of the parts. Cost and errors are the same as for vertices_inside().
EdgeSurpluses cut_at_vertices(const EdgeSurpluses& edges, std::span<const SpacePoint> points,
                              const Point3Table& table, MemoryCharge& memory, Context& context);

/// Returns the closed chains of vertices that would balance a collected list of surpluses. Requires
/// that as many edges lead into every vertex as out of it, as in the boundary of any set of faces.
/// Each chain has a vertex once. O(m log m) for m edges. Throws the errors of the Context.
std::vector<std::vector<std::uint32_t>> chains_of(const EdgeSurpluses& surplus,
                                                  MemoryCharge& memory, Context& context);

/// Returns where directed edges and their reverses do not balance: closed chains of vertices, in
/// the direction that would balance them; none if the mesh is closed. Places count, not indices: an
/// edge with vertices of the mesh on it balances the edges between them. `points` has the place of
/// each vertex. O(n) for a closed mesh, besides the cost of vertices_inside() for the edges that no
/// edge of the same ends balances. Throws the errors of the Context. Proof: docs/design/meshes.md,
/// Lemma 1.
std::vector<std::vector<std::uint32_t>> trace_borders(const MeshFacets& facets,
                                                      const MeshLinks& links,
                                                      std::span<const SpacePoint> points,
                                                      const Point3Table& table, Context& context);

// Components.

/// Connected closed parts of a mesh, and the signs of their volumes.
struct MeshComponents {
  std::vector<std::uint32_t> of_facet;  ///< The component of each facet, numbered by least facet.
  std::vector<Sign> volume;             ///< The sign of the volume of each component.
};

/// Returns the components of a mesh. Facets that alone share an edge are joined; where more than
/// two meet, those are joined whose component would not be closed there. What is still open (closed
/// by vertices on edges, or by faces without area) is one component. Volumes of components that are
/// not closed (surfaces) are meaningless. Requires facets with one cycle. O(n alpha(n)).
MeshComponents find_components(const SpaceComplex& complex, std::span<const std::int32_t> jump);

// Fans: vertices around which the facets of a complex cannot cross, found by a few comparisons.
//
// The sectors at a vertex form a fan if, projected along some coordinate axis, they do not overlap
// and together go around the vertex exactly once. The view of a fan is one to one: edges leave the
// vertex in different directions, no corner holds another, and triangles, which lie within their
// corners, have only the vertex and the edges between them in common. In most meshes most vertices
// have one, which spares the exact test of some nine pairs of triangles for each.
//
// Main flow of find_fans(), for the three axes at once:
//  1. sides  finds, from the plane's row, which side of each facet is seen along the axis
//  2. edges  checks that the two facets at an edge lie on different sides of it; else both its ends
//            have no fan
//  3. turns  counts turns: given 2, all corners around a vertex turn one way. A corner passes the
//            direction 0 if and only if it begins in the lower half-plane and ends in the upper
//            one, or is no less than half a turn and begins in the half-plane where it ends; the
//            corners go around once if and only if one of them passes it.
//
// For triangles of input points coordinates are compared and nothing is computed: O(n), about 10 ns
// a triangle. For other facets the boxes of their corners are compared, which may leave it open,
// and an exact sign decides which corners are reflex.

/// Returns for each vertex 1 if the corners around it surely are a fan and it is not inside a facet
/// besides, else 0. With 1, edges leave it in different directions, corners lie side by side, and
/// triangles of two facets around it meet in common edges and vertices alone; so do triangles of
/// which larger facets are made. Requires edges, planes of facets, and cycles.
std::vector<std::uint8_t> find_fans(const SpaceComplex& complex);

}  // namespace plumb
