// The first method: planes through reflex edges.
//
// Main flow of cut_solid():
//  1. choose   a plane through a reflex edge of the piece, by the rule Greedy  (choose_plane.h)
//              that which leaves the fewest reflex edges, anew in each piece
//                Fixed   (choose_plane.h) of the piece's first edge, in the order of the solid's,
//                        the one plane it has
//  2. cut      (surface_cut.h) along the part of the section that the edge bounds
//  3. repeat   with one piece, or two, until nothing is reflex
//
// Main flow of cut_set(), for a part of any kind:
//  1. cut_solid     if the part is a solid with one connected surface: this is done with most
//  2. divide        what is none, or is stuck, by a Boolean with a half-space; then its parts in
//                   turn
//  3. again         by the rule Fixed, if that made more pieces of such a solid than most_pieces()
//
// A surface that is connected and has no reflex edges bounds a convex solid (space_convexity.h).
//
// The bound. By the rule Fixed a solid with one connected surface that is a 2-manifold gives at
// most 1 + (r^2 + r) / 2 pieces, r its reflex edges, if no tip is in the way. Cuts make no reflex
// edges, and a cut through one resolves that part of it. The edge e_i is cut into parts only by
// planes of edges before it, each in one point at most, as its plane's turn comes when all edges
// before it are resolved in the piece: so it has i parts at most. A part is reflex in one piece
// only, as two angles that share a turn are not both more than half. So the i-th plane cuts i times
// at most, and a cut makes one piece more at most. Source: Chazelle, SIAM J. Comput. 13 (1984). In
// the way is a tip on the line of e_i, off e_i, where the plane of e_i may touch the solid from one
// side (choose_plane.h). Then a later edge is cut first in that piece, whose plane may divide edges
// between both, while theirs divide it in another piece: nothing is proven then.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/part/cut_surface.h"
#include "plumb/convex/wall/set_parts.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// How planes are chosen.
enum class CutRule : std::uint8_t { Greedy, Fixed };

/// Lists of faces.
struct SolidPieces {
  std::vector<std::vector<FaceId>> convex;
  std::vector<std::vector<FaceId>> stuck;  ///< no plane cuts these this way (PlaneSection::find())
  std::size_t reflex_edges = 0;            ///< of the solid
};

/// Requires a surface that has not been cut.
SolidPieces cut_solid(CutSurface& surface, CutRule rule, Context& context);

/// Of a solid with one connected surface.
constexpr std::size_t most_pieces(std::size_t reflex_edges) {
  constexpr std::size_t kSquare = std::size_t{1} << 31U;
  if (reflex_edges >= kSquare) return std::numeric_limits<std::size_t>::max();
  return 1 + (reflex_edges * reflex_edges + reflex_edges) / 2;
}

/// The convex pieces of one part. Method Best: neighbours are merged. `most`: the rule Fixed is
/// tried where there are more pieces than that, too, not only where there are more than
/// most_pieces() (for tests).
std::vector<Nef3> cut_set(const SetPart& part, const DecomposeOptions& options, Context& context,
                          std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace plumb
