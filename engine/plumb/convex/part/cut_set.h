// The first method of decomposition: planes through reflex edges.
//
// Main flow of cut_solid():
//  1. choose   takes a plane through a reflex edge of the piece (choose_plane.h). The rule Greedy
//              takes the plane that leaves the fewest reflex edges, anew in each piece; Fixed takes
//              the only plane of the first edge of the piece, in the order of the solid's edges
//  2. cut      divides along the component of the section that the edge bounds (surface_cut.h)
//  3. repeat   goes on with one piece, or two, until nothing is reflex
//
// Main flow of cut_set(), for a part of any kind:
//  1. cut_solid     cuts the part if it is a solid with one connected surface; most parts are done
//                   then
//  2. divide        divides a part that is not such a solid, or is stuck, by a Boolean with a
//                   half-space, and goes on with the parts of both halves
//  3. again         cuts by the rule Fixed if such a solid gave more pieces than most_pieces()
//
// A surface that is connected and has no reflex edges bounds a convex solid (docs/design/walls.md,
// section Convexity).
//
// The bound. By the rule Fixed a solid with one connected surface that is a 2-manifold gives at
// most 1 + (r^2 + r) / 2 pieces for r reflex edges, if no tip is in the way. Cuts make no reflex
// edges, and a cut through one resolves that part of it. The edge e_i is divided only by planes of
// edges before it, each in one point at most, because its own plane is used only where all edges
// before it are resolved in the piece; so it has at most i parts. A part is reflex in one piece
// only, because two angles within one turn are not both more than half. So the i-th plane cuts at
// most i times, and a cut adds at most one piece. Source: B. Chazelle, SIAM J. Comput. 13 (1984). A
// tip on the line of e_i, but off e_i, is in the way if the plane of e_i may touch the solid there
// from one side (choose_plane.h). Then a later edge is cut first in that piece; its plane may
// divide edges between both, while theirs divide it in another piece, and nothing is proven.
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

/// How planes are chosen: Greedy looks for the best plane in each piece, Fixed uses one plane for
/// each reflex edge of the solid.
enum class CutRule : std::uint8_t { Greedy, Fixed };

/// The result of cut_solid(). Each piece is a list of faces of the surface.
struct SolidPieces {
  /// Pieces without reflex edges.
  std::vector<std::vector<FaceId>> convex;
  /// Pieces that no plane cuts this way (PlaneSection::find()).
  std::vector<std::vector<FaceId>> stuck;
  std::size_t reflex_edges = 0;  ///< Number of reflex edges of the solid.
};

/// Cuts the surface until no piece has a reflex edge that can be cut. Requires a surface that has
/// not been cut. Throws the errors of the Context.
SolidPieces cut_solid(CutSurface& surface, CutRule rule, Context& context);

/// Returns the proven bound on the number of pieces of a solid with one connected surface.
constexpr std::size_t most_pieces(std::size_t reflex_edges) {
  constexpr std::size_t kSquare = std::size_t{1} << 31U;
  if (reflex_edges >= kSquare) return std::numeric_limits<std::size_t>::max();
  return 1 + (reflex_edges * reflex_edges + reflex_edges) / 2;
}

/// Returns the convex pieces of one part. The method Best merges neighbours. The rule Fixed is
/// tried if there are more pieces than most_pieces(), or more than `most`, which tests lower to
/// reach that rule. Throws the errors of the Context.
std::vector<Nef3> cut_set(const SetPart& part, const DecomposeOptions& options, Context& context,
                          std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace plumb
