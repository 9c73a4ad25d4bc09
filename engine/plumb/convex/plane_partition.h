// Decomposition of sets of the plane into convex parts: decompose() of a Nef2.
//
// Main flow, for each marked face:
//  1. region    (plane_region.h) copies its boundary into half-edges of its own: outer ring, holes,
//               slits, and points removed from it
//  2. cut       adds edges between corners, by one of three methods:
//       cuts       (region_cuts.h) prolong one side of each reflex corner up to the first vertex or
//                  edge that the line meets, or to infinity
//       diagonals  (optimal_cuts.h) triangulate between the vertices, then remove every diagonal
//                  that no reflex corner needs (Hertel and Mehlhorn)
//       optimal    (optimal_cuts.h) finds the fewest parts that diagonals between vertices can
//                  make, by a dynamic program
//     Best runs optimal where the face allows it, else diagonals, and also cuts where these are
//     affordable, and takes the fewer parts. Unbounded faces are cut by cuts only
//  3. pieces    (region_cuts.h) makes each remaining loop a set, with the boundary that it owns
// Marked edges and vertices that border no marked face then become parts of their own.
//
// As in space, the interface calls a convex part a piece: it has one dimension and a convex
// relative interior, so it is convex except for points of its boundary. Every point of the set
// belongs to exactly one piece. Points on a cut go to one side. The union of the pieces is the set;
// the union of closed pieces is the closure of the set.
//
// Bounds. For a face with r reflex corners and h holes of positive area, cuts make at most
// r + 1 - h parts, and no partition makes fewer than r / 2 + 1 - h, because one segment ends at two
// corners at most. If 3 h <= r this is a factor of 4; without holes it is a factor of 2. Diagonals
// make at most 2 r + 1 - h parts. docs/convex.md has the proofs.
//
// Cost: O(n log n) for diagonals, O(r n) for cuts, O(n^3) for optimal. Diagonals make no points;
// cuts make intersections of two lines of the set. Sources: S. Hertel and K. Mehlhorn, Fast
// triangulation of simple polygons, FCT 1983; M. Keil and J. Snoeyink, On the time bound for convex
// decomposition of simple polygons, International Journal of Computational Geometry and
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
  Cuts,       ///< Prolongs sides; cuts faces of any set.
  Diagonals,  ///< Removes diagonals of a triangulation; cuts bounded faces.
  Optimal,    ///< Cuts bounded faces with one boundary and at most kMostCornersForOptimal corners.
  Best,       ///< Takes the fewest pieces of the others; cuts faces of any set.
};

/// The largest number of corners of a face that PartitionMethod::Optimal cuts.
inline constexpr std::size_t kMostCornersForOptimal = 500;

/// Options of decompose().
struct PartitionOptions {
  PartitionMethod method = PartitionMethod::Best;  ///< The method that cuts faces.
  bool closed = false;  ///< Whether to return closures, which share the points on cuts.
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

/// Whether the areas of the pieces add up exactly to that of the set; empty if the area of the set
/// is infinite. Throws what the context throws.
std::optional<bool> do_areas_add_up(const Nef2& set, std::span<const Nef2> pieces,
                                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
