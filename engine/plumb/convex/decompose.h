// Decomposition of sets of space into convex parts.
//
// Main flow of decompose():
//  1. parts_of    (set_parts.h) splits the set by dimension. Each marked volume, together with the
//                 boundary cells assigned to this volume, is one part. Each dangling facet, edge or
//                 point is a further part
//  2. cut_set     (cut_set.h) cuts by planes through reflex edges until no edge is reflex. With
//                 method Best, this step then merges neighbouring parts whose union is convex
//                 (merge_parts.h)
//  3. walls       (walls.h) is done only with method Best. If vertical walls are expected to cut a
//                 bounded volume into fewer convex parts, the step also cuts this volume by walls.
//                 The decomposition with fewer parts is kept
//
// Every set can be decomposed. The set may be open, closed, half-open or unbounded, and need not be
// a manifold. The set may have voids, several components, and dangling facets, edges and points.
//
// In the names of functions and types, a convex part is a piece. Every piece has a dimension, and
// its relative interior is convex. Points of the boundary of a piece may be missing, so the piece
// itself need not be convex. Every point of the set belongs to exactly one piece. A point on a cut
// keeps its mark and is assigned to the piece on one side of the cut. The union of the pieces is
// the set. The union of the closures of the pieces is the closure of the set.
//
// Numbers. The plane of each cut contains an edge of the set. The plane also passes through a
// vertex of the set, or it belongs to the pencil of the planes of the two facets at the edge. In
// the second case, its equation is a combination of the equations of these two planes, with integer
// coefficients. No plane is defined by a point that an earlier cut constructed. So the lengths of
// the numbers in cuts do not grow if parts are cut again and again. Walls are made in rounds
// (walls.h), and the lengths of the numbers in walls grow with the number of rounds. More than one
// round is needed only if some vertical line meets one cell in several segments. The equation of
// the plane of a later wall is a combination of the equations of two earlier walls.
//
// Origins distinguish walls from facets of the set. If a facet of a piece lies in a facet of the
// set, both facets have the same facet_origin. Any other facet of a piece has kWallOrigin. A wall
// can continue a facet of the set in the same plane. Because pieces are minimal complexes, the wall
// and the facet are then one facet of the piece. This combined facet counts as a facet of the set.
// Some facets of the set have no id, such as the facet of a half-space. Such a facet has the
// facet_origin kNoOrigin. The facets of pieces that lie in it have the facet_origin kNoOrigin, too.
// A wall of a piece gets kNoOrigin when the piece is decomposed again.
//
// The pieces have the sources of the set (source_mesh.h). So mesh_with_attributes() gives each
// facet of a piece the attributes of the faces of the sources in which it lies. Walls lie in no
// face of the boundary. So they have no source, except where an operation had removed a face of a
// source.
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
  /// Makes cuts along planes that contain reflex edges. Each cut follows one connected component of
  /// the intersection of the plane with the set.
  Cuts,
  /// Makes cuts along vertical walls that contain reflex edges (walls.h). A set with r reflex edges
  /// is cut into O(r^2) pieces.
  Walls,
  Best,  ///< Tries Cuts and Walls, merges neighbours, and takes the result with fewer pieces.
};

/// Options of decompose().
struct DecomposeOptions {
  DecomposeMethod method = DecomposeMethod::Best;  ///< The method that makes the pieces.
  /// Whether to return the closures of the pieces. The closures of two neighbouring pieces share
  /// the points on the cut between these pieces.
  bool closed = false;
};

/// The facet_origin of a facet without an id, such as a facet of a half-space.
inline constexpr std::uint32_t kNoOrigin = ~std::uint32_t{0};
/// The facet_origin of a piece's facet that lies in no facet of the set. Ids that the caller gives
/// to facets should be less than 2^32 - 3.
inline constexpr std::uint32_t kWallOrigin = kNoOrigin - 1;

/// The result of decompose().
struct ConvexPieces {
  std::vector<Nef3> pieces;        ///< The convex parts, in an order that depends on the set alone.
  std::uint64_t reflex_edges = 0;  ///< The number of reflex edges of the set (convexity.h).
  /// The method used: Walls if walls made the pieces of at least one volume, and Cuts otherwise.
  DecomposeMethod method = DecomposeMethod::Cuts;
};

/// Returns the convex parts of `set` and the method that made them. The empty set has no parts.
/// Throws Error{ResourceLimit} if method Walls leaves reflex edges after 64 rounds. Also throws the
/// errors of the Context.
ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options = {},
                       Context& context = unlimited_context());

/// Whether facet `f` of a piece lies on a cut but not in a facet of the decomposed set. O(1).
inline bool is_wall(const SpaceComplex& piece, FacetId f) {
  return piece.facet_origin[f] == kWallOrigin;
}

}  // namespace plumb
#pragma GCC visibility pop
