// Tests whether a mesh or a set of space is convex, and returns evidence: the number of reflex
// edges, and the faces that fail, each with a vertex that proves it.
//
// Main flow of is_convex_mesh(), for a mesh that is a closed 2-manifold:
//  1. pair     checks that every directed edge has one reverse
//  2. star     finds a point o that lies strictly behind every face
//  3. edges    checks that no edge is reflex and no polygon has a reflex corner
//  4. degree   checks that one ray from o meets one face
// The projection from o onto a sphere is a covering near faces (2) and edges (3), branched at
// vertices at most. Its degree is the number of faces that a ray meets. Degree 1 leaves no
// branches, so the surface is star-shaped about o, and convex because all its edges are. Without
// step 4 a double pyramid that winds twice around its axis would pass. If no o is found (the body
// may be so flat that no point with double coordinates lies inside), the set of the mesh is tested
// instead, which takes longer and is exact, too.
//
// Cost: O(E) for E edges, about 0.2 us for each face. Evidence takes O(F log V) expected time for F
// faces and V vertices, and O(F V) at worst, because tests of a face stop early. Proof:
// docs/design/walls.md. Source: K. Mehlhorn, S. Naeher et al., Checking geometric programs or
// verification of geometric structures, Computational Geometry 12 (1999).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Whether the mesh is the surface of one convex body, covered once, with either orientation. Faces
/// may be coplanar. Returns false for a mesh that is open, not connected or not a 2-manifold.
/// Throws what complex_of_mesh() throws.
[[nodiscard]] bool is_convex_mesh(const MeshView& mesh, Context& context = unlimited_context());
/// Returns the same for a mesh that owns its arrays.
[[nodiscard]] inline bool is_convex_mesh(const PolygonMesh& mesh,
                                         Context& context = unlimited_context()) {
  return is_convex_mesh(MeshView(mesh), context);
}

/// A face that has vertices strictly on both sides of its plane.
struct FailingFace {
  std::uint32_t face = 0;    ///< 0-based number of the input face, or of the set's facet.
  std::uint32_t vertex = 0;  ///< A vertex strictly on the outer side.
  friend bool operator==(const FailingFace&, const FailingFace&) = default;
};

/// The result of a convexity test. Numbers are 0-based, in the mesh or complex that was tested;
/// lists ascend.
struct ConvexityEvidence {
  bool is_convex = false;          ///< Whether the mesh or set is convex.
  std::uint64_t reflex_edges = 0;  ///< The number of reflex edges.
  std::vector<FailingFace> faces;  ///< The faces with vertices strictly on both sides.
};

/// Returns whether the mesh is convex, with evidence. An edge between two faces is reflex if the
/// solid behind them spans more than half a turn. A mesh that is not a closed 2-manifold is not
/// convex, its reflex edges are unknown, and only its failing faces are listed. Throws what
/// complex_of_mesh() throws.
[[nodiscard]] ConvexityEvidence convexity_of_mesh(const MeshView& mesh,
                                                  Context& context = unlimited_context());
/// Returns the same for a mesh that owns its arrays.
[[nodiscard]] inline ConvexityEvidence convexity_of_mesh(const PolygonMesh& mesh,
                                                         Context& context = unlimited_context()) {
  return convexity_of_mesh(MeshView(mesh), context);
}

/// Returns whether the set is convex, with evidence. The set is tested as a point set with its
/// marks, as by Nef3::is_convex(). The empty set, the whole space, a point, and an open or
/// half-open convex body are convex. A closed cube without an inner point of an edge is not convex,
/// although no edge is reflex and no face fails. Throws what the context throws.
ConvexityEvidence convexity_of_set(const Nef3& set, Context& context = unlimited_context());

/// Returns the edges around which some marked volume spans more than half a turn, each once, in
/// ascending order. These include the rim of a facet inside a volume and a line removed from a
/// volume. O(n).
std::vector<EdgeId> reflex_edges(const SpaceComplex& complex);

}  // namespace plumb
#pragma GCC visibility pop
