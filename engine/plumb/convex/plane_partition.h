// Decomposition of sets of the plane into convex parts: decompose() of a Nef2.
//
// Main flow, for each marked face:
//  1. region    (plane_region.h) copies its boundary into half-edges of its own: outer ring, holes,
//               slits, and points removed from it
//  2. cut       adds edges between corners, by one of three methods:
//       cuts       (region_cuts.h) prolongs one side of each reflex corner up to the first vertex
//                  or edge that the line meets, or to infinity
//       diagonals  (optimal_cuts.h) triangulates between the vertices, then removes every diagonal
//                  that no reflex corner needs (Hertel and Mehlhorn)
//       optimal    (optimal_cuts.h) finds the fewest parts that diagonals between vertices can
//                  make, by a dynamic program
//  3. pieces    (region_cuts.h) makes each remaining loop a set, with the boundary that it owns
// Each marked edge or vertex that borders no marked face then becomes a part of its own.
//
// Method Best tries several methods on each bounded face, and takes the result with the fewest
// parts. It runs optimal if the face allows it, otherwise diagonals. It also runs cuts, unless
// there are only two parts already or r n is too large, where r and n are the numbers of reflex
// corners and of corners. An unbounded face can be cut by method cuts only.
//
// As in space, the interface calls a convex part a piece. A piece has one dimension and a convex
// relative interior, so it is convex except for points of its boundary. Every point of the set
// belongs to exactly one piece. A point on a cut goes to the piece on one side. The union of the
// pieces is the set; the union of closed pieces is the closure of the set.
//
// Bounds. Consider a face with r reflex corners and h holes of positive area. Cuts make at most
// r + 1 - h parts. No partition makes fewer than r / 2 + 1 - h parts, because one segment ends at
// two corners at most. If 3 h <= r, the two bounds differ by a factor of at most 4; without holes,
// by a factor of at most 2. Diagonals make at most 2 r + 1 - h parts. docs/convex.md has the
// proofs.
//
// Cost: O(n log n) for diagonals, O(r n) for cuts, O(n^3) for optimal. Diagonals construct no
// points. Cuts construct intersections of two lines of the set. Sources: S. Hertel and K. Mehlhorn,
// Fast triangulation of simple polygons, FCT 1983; M. Keil and J. Snoeyink, On the time bound for
// convex decomposition of simple polygons, International Journal of Computational Geometry and
// Applications 12 (2002) 181-192.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The method that cuts faces, and the faces that it can cut.
enum class PartitionMethod : std::uint8_t {
  Cuts,       ///< Prolongs sides of reflex corners; cuts faces of any set.
  Diagonals,  ///< Triangulates and removes diagonals; cuts bounded faces only.
  /// Finds the fewest parts; cuts bounded faces with one boundary and at most
  /// kMostCornersForOptimal corners.
  Optimal,
  Best,  ///< Takes the method that makes the fewest pieces; cuts faces of any set.
};

/// The greatest number of corners that a face may have to be cut by PartitionMethod::Optimal.
inline constexpr std::size_t kMostCornersForOptimal = 500;

/// Options of decompose().
struct PartitionOptions {
  PartitionMethod method = PartitionMethod::Best;  ///< The method that cuts faces.
  /// Whether to return the closures of the pieces, which share the points on cuts.
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
/// faces, and what the context throws.
PlanePieces decompose(const Nef2& set, const PartitionOptions& options = {},
                      Context& context = unlimited_context());

/// Whether the areas of the pieces add up exactly to the area of the set. Returns no value if the
/// area of the set is infinite. Throws what the context throws.
std::optional<bool> do_areas_add_up(const Nef2& set, std::span<const Nef2> pieces,
                                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
