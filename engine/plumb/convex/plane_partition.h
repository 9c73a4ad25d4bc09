// Decomposition of sets of the plane into convex parts: decompose() of a Nef2.
//
// Main flow, for each marked face:
//  1. region    (plane_region.h) copies the boundary of the face into a separate list of
//               half-edges. The boundary consists of the outer ring, holes, slits, and points
//               removed from the face
//  2. cut       adds edges between corners, by one of three methods:
//       cuts       (region_cuts.h) prolongs one side of each reflex corner up to the first vertex
//                  or edge that the line meets, or to infinity
//       diagonals  (optimal_cuts.h) triangulates the face, then removes every diagonal that no
//                  reflex corner needs (Hertel and Mehlhorn)
//       optimal    (optimal_cuts.h) finds the fewest parts that diagonals between vertices can
//                  make, by a dynamic program
//  3. pieces    (region_cuts.h) takes each region that the boundary and the added edges now
//               enclose, and makes a set from this region and the boundary cells assigned to it
// Then each marked edge or vertex that is not on the boundary of a marked face becomes a separate
// part.
//
// Method Best tries several methods on each bounded face, and takes the result with the fewest
// parts. First it runs method optimal if this method can cut the face; otherwise it runs method
// diagonals. Then it also runs method cuts, except in two cases: the first method made only two
// parts, or the product r n is too large. Here r is the number of reflex corners, and n is the
// number of corners. Only method cuts can cut an unbounded face.
//
// As in space, the interface calls a convex part a piece. Every piece has a dimension, and its
// relative interior is convex. Points of the boundary of a piece may be missing, so the piece
// itself need not be convex. Every point of the set belongs to exactly one piece. A point on a cut
// is assigned to the piece on one side of the cut. The union of the pieces is the set. The union of
// the closures of the pieces is the closure of the set.
//
// Bounds. Consider a face with r reflex corners and h holes of positive area. Method cuts makes at
// most r + 1 - h parts. No partition has fewer than r / 2 + 1 - h parts. The reason is that a
// segment of the partition must divide each reflex corner, and a segment can divide at most two
// corners, one at each of its ends. If 3 h <= r, these two bounds differ by a factor of at most 4.
// If there are no holes, the two bounds differ by a factor of at most 2. Method diagonals makes at
// most 2 r + 1 - h parts. The proofs are in docs/convex.md.
//
// Cost for a face with n corners: O(n log n) for diagonals, O(r n) for cuts, O(n^3) for optimal.
// Method diagonals constructs no points. Method cuts constructs only points that are intersections
// of two lines of the set. Sources: S. Hertel and K. Mehlhorn, Fast triangulation of simple
// polygons, FCT 1983; M. Keil and J. Snoeyink, On the time bound for convex decomposition of simple
// polygons, International Journal of Computational Geometry and Applications 12 (2002) 181-192.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_rounding.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The method that cuts faces. Not every method can cut every face.
enum class PartitionMethod : std::uint8_t {
  Cuts,       ///< Prolongs sides of reflex corners; can cut every face.
  Diagonals,  ///< Triangulates, then removes diagonals; can cut bounded faces only.
  /// Finds the fewest parts that diagonals can make. Can cut only bounded faces with one boundary
  /// loop and at most kMostCornersForOptimal corners.
  Optimal,
  Best,  ///< Takes the method that makes the fewest pieces; can cut every face.
};

/// The greatest number of corners of a face that PartitionMethod::Optimal can cut.
inline constexpr std::size_t kMostCornersForOptimal = 500;

/// Options of decompose().
struct PartitionOptions {
  PartitionMethod method = PartitionMethod::Best;  ///< The method that cuts faces.
  /// Whether to return the closures of the pieces. The closures of two neighbouring pieces share
  /// the points on the cut between these pieces.
  bool closed = false;
};

/// The result of decompose().
struct PlanePieces {
  std::vector<Nef2> pieces;  ///< The convex parts, in an order that depends on the set alone.
  /// The number of corners around which a marked face spans more than half a turn. A point removed
  /// from a face is such a corner.
  std::uint64_t reflex_corners = 0;
};

/// Returns the convex parts of `set`. Throws Error{BadArgument} if the method cannot cut one of the
/// faces. Also throws the errors of the Context.
PlanePieces decompose(const Nef2& set, const PartitionOptions& options = {},
                      Context& context = unlimited_context());

/// Pieces whose vertices have doubles as coordinates.
struct RoundedPieces {
  /// The closure of each piece, with vertices whose coordinates are doubles. If rounding leaves
  /// nothing of a piece, its entry is the empty set.
  std::vector<Nef2> pieces;
  /// The number of pieces that are not convex, because rounding bent a side to a corner of a
  /// neighbour.
  std::size_t not_convex = 0;
  PlaneRoundingReport rounding;  ///< The changes that rounding has caused.
};

/// Returns the closures of the pieces, rounded to doubles. All pieces are rounded together, as one
/// subdivision of the plane (plane_rounding.h). Therefore bounded pieces with an area still have
/// disjoint interiors, and pieces that share a border still share it. Suppose that a corner of one
/// piece lies on a side of another piece, and that this corner has to be rounded. Then the side may
/// be bent, so that it still passes through the corner. No point of the side moves farther than
/// rounding.largest_move. If all coordinates of vertices are doubles, the function returns the
/// closures of the pieces unchanged. Requires that the pieces have disjoint interiors, like the
/// pieces that decompose() returns. Pieces without area are rounded one by one, and unbounded
/// pieces are returned exactly. Throws Error{NumberOutOfRange} if a coordinate lies beyond the
/// largest double, and the errors of the Context. Cost: O(n log n) for n corners of all pieces.
RoundedPieces round_to_doubles(std::span<const Nef2> pieces,
                               Context& context = unlimited_context());

/// Returns whether the sum of the areas of the pieces is exactly the area of the set. Returns no
/// value if the area of the set is infinite. Throws the errors of the Context.
std::optional<bool> do_areas_add_up(const Nef2& set, std::span<const Nef2> pieces,
                                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
