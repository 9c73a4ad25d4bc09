// Decomposition of sets of space into convex parts.
//
// Main flow of decompose():
//  1. parts_of    (set_parts.h) splits the set by dimension: each marked volume with the boundary
//                 that it owns, and the dangling facets, edges and points
//  2. cut_set     (cut_set.h) cuts by planes through reflex edges until no edge is reflex; with
//                 method Best, merges neighbours whose union is convex (merge_parts.h)
//  3. walls       (walls.h) with method Best, cuts each bounded volume by vertical walls where
//                 fewer convex parts are expected, and takes the smaller decomposition
//
// The set is arbitrary. It may be open, closed, half-open or unbounded, and need not be a manifold.
// It may have voids, several components, and dangling facets, edges and points.
//
// The interface calls a convex part a piece. A piece has one dimension and a convex relative
// interior, so it is convex except for points of its boundary. Every point of the set belongs to
// exactly one piece. A point on a cut keeps its mark and goes to the piece on one side. The union
// of the pieces is the set; the union of closed pieces is the closure of the set.
//
// Numbers. The plane of a cut goes through an edge of the set. It also goes through a vertex of the
// set, or belongs to the pencil of the planes at that edge. No plane goes through a point that an
// earlier cut constructed. So the numbers of cuts do not grow with the depth of the recursion. The
// numbers of walls grow with the rounds. One round is enough unless some cell lies above itself;
// later rounds use pencils of walls (walls.h).
//
// Origins distinguish walls from facets of the set. A facet of a piece has the facet_origin of the
// set's facet in which it lies, or kWallOrigin if it lies in none. A facet is both if a wall
// prolongs a facet of the set: pieces are minimal complexes, so the two are one facet. Such a facet
// counts as a facet of the set. Facets of the set without an id, such as those of half-spaces, keep
// kNoOrigin. A wall of a piece gets kNoOrigin when the piece is decomposed again.
//
// Cost and bounds: docs/convex.md; proofs: docs/design/walls.md. Sources: B. Chazelle, Convex
// partitions of polyhedra, SIAM Journal on Computing 13 (1984); P. Hachenberger, Exact Minkowski
// sums of polyhedra and exact and efficient decomposition of polyhedra into convex pieces,
// Algorithmica 55 (2009) 329-345.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The method that makes the pieces.
enum class DecomposeMethod : std::uint8_t {
  /// Cuts by planes through reflex edges, each along one component of its section with the set.
  Cuts,
  /// Cuts by vertical walls through reflex edges (walls.h): O(r^2) pieces for r reflex edges.
  Walls,
  Best,  ///< Takes the smaller result of Cuts and Walls, with neighbours merged.
};

/// Options of decompose().
struct DecomposeOptions {
  DecomposeMethod method = DecomposeMethod::Best;  ///< The method that makes the pieces.
  /// Whether to return the closures of the pieces, which share the points on cuts.
  bool closed = false;
};

/// The facet_origin of a facet without an id, such as a facet of a half-space.
inline constexpr std::uint32_t kNoOrigin = ~std::uint32_t{0};
/// The facet_origin of a piece's facet that lies in no facet of the set. The caller's own ids
/// should be below 2^32 - 3.
inline constexpr std::uint32_t kWallOrigin = kNoOrigin - 1;

/// The result of decompose().
struct ConvexPieces {
  std::vector<Nef3> pieces;        ///< The convex parts, in an order that depends on the set alone.
  std::uint64_t reflex_edges = 0;  ///< The number of reflex edges of the set (convexity.h).
  /// Is Walls if walls made the pieces of at least one volume, else Cuts.
  DecomposeMethod method = DecomposeMethod::Cuts;
};

/// Returns the convex parts of `set` and the method that made them. The empty set has no parts.
/// Throws what the context throws, and Error{ResourceLimit} if method Walls leaves reflex edges
/// after 64 rounds.
ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options = {},
                       Context& context = unlimited_context());

/// Whether the facet lies on a cut and in no facet of the set. O(1).
inline bool is_wall(const SpaceComplex& piece, FacetId f) {
  return piece.facet_origin[f.value()] == kWallOrigin;
}

}  // namespace plumb
#pragma GCC visibility pop
