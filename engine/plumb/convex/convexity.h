// Tests whether a mesh or a set of space is convex, and returns evidence. The evidence is the
// number of reflex edges and the list of failing faces. A face fails if there are vertices strictly
// on both sides of its plane. Each failing face is returned with one vertex that lies strictly on
// the outer side of this plane.
//
// Main flow of is_convex_mesh(), for a mesh that is a closed 2-manifold:
//  1. pair     checks that for every directed edge exactly one edge has the opposite direction
//  2. star     finds a point o that lies strictly behind every face
//  3. edges    checks that no edge is reflex and no polygon has a reflex corner
//  4. degree   checks that one ray from o meets exactly one face
// Steps 1 to 4 prove that the mesh is convex, for the following reason. Project the surface from o
// onto a sphere around o. By step 2, the projection is a covering near each face. By step 3, it is
// a covering near each edge. So only vertices can be branch points of the projection. The degree of
// the projection is the number of faces that a ray from o meets. By step 4 the degree is 1. A
// covering of degree 1 has no branch points, so the surface is star-shaped about o. A star-shaped
// surface without reflex edges is convex. Step 4 is needed. Without step 4, a double pyramid that
// winds twice around its axis would pass the test.
//
// Step 2 may find no point o, because a body can be so flat that no point with double coordinates
// lies inside the body. In this case the mesh is converted to a set, and the set is tested. The
// test of the set is exact, too, but takes longer.
//
// Cost: the test of a mesh with E edges takes O(E) time, about 0.2 us for each face. The evidence
// for F faces and V vertices takes O(F log V) expected time. The reason is that the search for a
// vertex on one side of a face stops at the first vertex found. In the worst case the evidence
// takes O(F V) time. Proof: docs/design/walls.md. Source: K. Mehlhorn, S. Naeher et al., Checking
// geometric programs or verification of geometric structures, Computational Geometry 12 (1999).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns whether the mesh is the surface of one convex body and covers this surface exactly once.
/// The faces must be oriented consistently: either all of them outwards or all of them inwards.
/// Faces may be coplanar. Returns false if the mesh is open, is not connected, or is not a
/// 2-manifold. Throws what complex_of_mesh() throws.
[[nodiscard]] bool is_convex_mesh(const MeshView& mesh, Context& context = unlimited_context());
/// Calls the function above for a mesh that owns its arrays.
[[nodiscard]] inline bool is_convex_mesh(const PolygonMesh& mesh,
                                         Context& context = unlimited_context()) {
  return is_convex_mesh(MeshView(mesh), context);
}

/// A face that has vertices strictly on both sides of its plane.
struct FailingFace {
  std::uint32_t face = 0;    ///< 0-based index of the input face, or of the facet of the set.
  std::uint32_t vertex = 0;  ///< A vertex strictly on the outer side of the plane.
  friend bool operator==(const FailingFace&, const FailingFace&) = default;
};

/// The result of a convexity test. Faces and vertices are 0-based indices in the mesh or complex
/// that was tested. All lists are in ascending order.
struct ConvexityEvidence {
  bool is_convex = false;          ///< Whether the mesh or set is convex.
  std::uint64_t reflex_edges = 0;  ///< The number of reflex edges.
  std::vector<FailingFace> faces;  ///< The faces whose planes have vertices strictly on both sides.
};

/// Returns whether the mesh is convex, with evidence. An edge between two faces is reflex if the
/// solid behind the faces spans more than half a turn around the edge. A mesh that is not a closed
/// 2-manifold is not convex. For such a mesh only the failing faces are listed; the number of
/// reflex edges is unknown. Throws what complex_of_mesh() throws.
[[nodiscard]] ConvexityEvidence convexity_of_mesh(const MeshView& mesh,
                                                  Context& context = unlimited_context());
/// Calls the function above for a mesh that owns its arrays.
[[nodiscard]] inline ConvexityEvidence convexity_of_mesh(const PolygonMesh& mesh,
                                                         Context& context = unlimited_context()) {
  return convexity_of_mesh(MeshView(mesh), context);
}

/// Returns whether the set is convex, with evidence. Nef3::is_convex() gives the same answer. The
/// test takes the marks of facets, edges and vertices into account. The empty set, the whole space,
/// a point, and an open or half-open convex body are convex. A closed cube from which one inner
/// point of an edge was removed is not convex, although no edge is reflex and no face fails. Throws
/// the errors of the Context.
ConvexityEvidence convexity_of_set(const Nef3& set, Context& context = unlimited_context());

/// Returns the edges around which some marked volume spans more than half a turn. Each edge occurs
/// once in the returned list, which is in ascending order. If a facet lies inside a marked volume,
/// the edges of its boundary are reflex edges. If a line was removed from a marked volume, the
/// edges on this line are reflex edges. Cost: O(n) for n cells.
std::vector<EdgeId> reflex_edges(const SpaceComplex& complex);

}  // namespace plumb
#pragma GCC visibility pop
