// Sets of space cut into convex pieces.
//
// Main flow of decompose():
//  1. parts_of    (set_parts.h) the set by dimension: each marked volume with the boundary it owns, what dangles
//  2. cut_set     (cuts.h) planes through reflex edges, until nothing is reflex. Best: neighbours whose union is convex
//                 become one (merge_pieces.h, merge_sets.h)
//  3. walls       (walls.h) Best: of each bounded volume, where fewer pieces are to be expected; the fewer are taken
//
// Any set: open, closed, half-open, unbounded, not a manifold, with voids, several components, dangling facets, edges
// and points. Each piece is of one dimension and convex but for points of its boundary: its relative interior is
// convex, and every point of the set belongs to exactly one piece. What lies on a cut keeps its mark and goes
// to one side. The union of the pieces is the set; of closed pieces, the set's closure.
//
// No plane goes through a constructed point: cuts go through an edge of the set and one of its vertices, or
// belong to the pencil of the edge's planes. So numbers do not grow with the depth of the recursion.
//
// Walls are told from what was there by origin: a facet of a piece has the facet_origin of the set's
// facet it lies in, or kWallOrigin. (One facet that is both, where a wall prolongs a facet, counts as
// the set's: pieces are minimal.) Facets of the set that have no id of their own, such as those of half-spaces, keep
// kNoOrigin, and so do walls of pieces that are cut again.
//
// Cost and bounds: docs/convex.md. Errors: what the context throws. Sources: the second note
// (convex-cutting); Chazelle, SIAM J. Comput. 13 (1984); Hachenberger, Algorithmica 55 (2009).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How pieces come about.
enum class DecomposeMethod : std::uint8_t {
  Cuts,   ///< planes through reflex edges, each along one part of its section
  Walls,  ///< vertical walls through reflex edges: O(r^2) pieces (walls.h)
  Best,   ///< the fewer of both, merged
};

/// What pieces are wanted.
struct DecomposeOptions {
  DecomposeMethod method = DecomposeMethod::Best;  ///< how they come about
  bool closed = false;  ///< closures of the pieces: they share what lies on a cut
};

/// facet_origin of a facet that nobody gave an id, as half-spaces make them.
inline constexpr std::uint32_t kNoOrigin = ~std::uint32_t{0};
/// facet_origin of a facet of a piece that no facet of the set lies in. Ids of the user's own should be below 2^32 - 3.
inline constexpr std::uint32_t kWallOrigin = kNoOrigin - 1;

/// What decompose() gives.
struct ConvexPieces {
  std::vector<Nef3> pieces;        ///< in an order that depends on the set alone
  std::uint64_t reflex_edges = 0;  ///< of the set (convexity.h)
  DecomposeMethod method =
      DecomposeMethod::Cuts;  ///< Walls: pieces of one volume at least are theirs
};

/// The convex pieces of any set, and how they came about; see above.
ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options, Context& context);

/// Is the facet part of a cut?
inline bool is_wall(const SpaceComplex& piece, FacetId f) {
  return piece.facet_origin[f.value()] == kWallOrigin;
}

}  // namespace plumb
#pragma GCC visibility pop
