// Sets of the plane cut into convex pieces: decompose() of a Nef2.
//
// Main flow, for each marked face:
//  1. region    (plane_region.h) its boundary as half-edges of its own: outer ring, holes, slits, points taken out
//  2. cut       by one of three methods, each of which only adds edges between corners:
//       cuts       (plane_cuts.h) from each reflex corner the line of one of its sides goes on up to the first thing
//                  it meets, or to infinity
//       diagonals  (plane_diagonals.h) a triangulation between the vertices, then every diagonal goes that no reflex
//                  corner needs (Hertel and Mehlhorn)
//       optimal    (plane_optimal.h) the fewest pieces that diagonals between vertices can make: a dynamic program
//     Best: optimal where it is affordable, else diagonals, and cuts; the fewer pieces are taken
//  3. pieces    (plane_pieces.h) each loop that is left, as a set, with what it owns of the boundary
// then the marked edges and vertices that no marked face has beside it, each for itself.
//
// As in space every piece is of one dimension and convex but for points of its boundary (its relative interior is
// convex), and every point of the set belongs to exactly one piece. What lies on a cut goes to one side. The
// union of the pieces is the set; of closed pieces, the set's closure.
//
// Bounds, for a face with r reflex corners and h holes that have an area: cuts make at most r + 1 - h pieces, and no
// partition whatever makes fewer than r / 2 + 1 - h, as one segment ends at two corners at most. With 3 h <= r this is
// a factor of 4, without holes of 2. Diagonals make at most 2 r + 1 - h. docs/convex.md has the proofs.
//
// Cost: O(n log n) for diagonals, O(r n) for cuts, O(n^3) for optimal. Points: diagonals make none; cuts make crossings
// of two lines of the set. Sources: Hertel and Mehlhorn, FCT 1983; Keil and Snoeyink, IJCGA 12 (2002) 181-192.
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

/// How faces are cut.
enum class PartitionMethod : std::uint8_t {
  Cuts,       ///< any set
  Diagonals,  ///< bounded faces
  Optimal,    ///< bounded faces with one boundary, of at most kMostCornersForOptimal corners
  Best,       ///< any set
};

/// The most corners of a face that PartitionMethod::Optimal cuts.
inline constexpr std::size_t kMostCornersForOptimal = 500;

/// What pieces are wanted.
struct PartitionOptions {
  PartitionMethod method = PartitionMethod::Best;  ///< how they come about
  bool closed = false;  ///< closures of the pieces: they share what lies on a cut
};

/// What decompose() gives.
struct PlanePieces {
  std::vector<Nef2> pieces;  ///< in an order that depends on the set alone
  /// Corners of marked faces of more than half a turn; a point taken out of a face is one.
  std::uint64_t reflex_corners = 0;
};

/// The convex pieces of a set, see above. Throws Error{BadArgument} where the method cannot cut one of the faces, and
/// what the context throws.
PlanePieces decompose(const Nef2& set, const PartitionOptions& options, Context& context);

/// Do the areas of the pieces add up to that of the set? None where it is infinite. Exact. Throws what the context throws.
std::optional<bool> do_areas_add_up(const Nef2& set, std::span<const Nef2> pieces,
                                    Context& context);

}  // namespace plumb
#pragma GCC visibility pop
