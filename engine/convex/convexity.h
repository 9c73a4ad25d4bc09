// Is a mesh or a set of space convex? With evidence: the edges that are reflex, the faces that fail, and for
// each a vertex that shows it.
//
// Main flow of is_convex_mesh(), for a mesh that is a closed 2-manifold:
//  1. pair     every directed edge has one reverse
//  2. star     a point o that lies strictly behind every face
//  3. edges    no edge is reflex, no polygon has a reflex corner
//  4. degree   one ray from o meets one face
// The projection from o onto a sphere is a covering near faces (2) and edges (3), branched at vertices at most. Its
// degree is the number of faces a ray meets; degree 1 leaves no branches, so the surface is star-shaped
// about o, and convex as all its edges are. Without 4 a double pyramid that winds twice around its axis would
// pass. Where no o is found (a body so flat that no double lies inside), the set of the mesh is asked, which
// takes longer and is exact, too.
//
// Cost: O(E), 0.2 us a face. Evidence: O(F log V) expected, O(F V) at worst, for early exits. Sources: the second note
// (IsPolyhedronConvex); Mehlhorn, Naeher et al., "Checking geometric programs", CGTA 12 (1999).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Is the mesh, either way out, the surface of one convex body, every part of it once? Faces may lie in one
/// plane. A mesh that is open, not connected or no 2-manifold is not. Throws as complex_of_mesh().
bool is_convex_mesh(const MeshView& mesh, Context& context);

/// A face, with vertices strictly on both sides of its plane.
struct FailingFace {
  std::uint32_t face = 0;    ///< 0-based, in the input; of a set: the facet's number
  std::uint32_t vertex = 0;  ///< strictly on the outer side
  friend bool operator==(const FailingFace&, const FailingFace&) = default;
};

/// What speaks for and against. Numbers are 0-based, in the mesh or the complex asked about; lists ascend.
struct ConvexityEvidence {
  bool is_convex = false;          ///< the answer
  std::uint64_t reflex_edges = 0;  ///< how many there are
  std::vector<FailingFace> faces;  ///< faces that are not all on one side of the rest
};

/// Edges between two faces are reflex where the solid behind them spans more than half a turn. Of a mesh
/// that is not a closed 2-manifold neither is known: it is not convex, and only faces are listed.
ConvexityEvidence convexity_of_mesh(const MeshView& mesh, Context& context);

/// The same of any set; is_convex as Nef3::is_convex(): as a point set, with its marks. Empty, the whole space,
/// a point, an open or half-open convex body are convex; a closed cube without an inner point of an edge is
/// not, though no edge is reflex and no face fails.
ConvexityEvidence convexity_of_set(const Nef3& set, Context& context);

/// The edges around which some marked volume spans more than half a turn, each once: a facet's rim inside a volume
/// and a line taken out of one, too. Ascending. O(n).
std::vector<EdgeId> reflex_edges(const SpaceComplex& complex);

}  // namespace plumb
#pragma GCC visibility pop
