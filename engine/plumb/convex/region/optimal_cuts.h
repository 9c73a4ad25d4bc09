// A bounded region of the plane cut by diagonals between its vertices (internal to
// plane_partition).
//
// Main flow of cut_by_diagonals(), after Hertel and Mehlhorn:
//  1. triangulate   (plumb/space/triangulate.h) between all vertices, points inside too
//  2. sew           triangles become the loops of the region, their sides edges
//  3. tidy          diagonals that no reflex corner needs go (drop_superfluous() of region_cuts.h)
//
// At a reflex corner at most two of the diagonals left are needed there, at others none. No point
// is made. Cost: O(n log n).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/region/plane_region.h"

namespace plumb {

/// 1 and 2. Requires a bounded region without cuts.
void triangulate(PlaneRegion& region, Context& context);

void cut_by_diagonals(PlaneRegion& region, Context& context);

// Which corners of a simple region see each other (internal to plane_partition).

/// The corners along the boundary of a region with one loop, from r.loops on.
std::vector<HalfedgeId> corners_of(const PlaneRegion& region);

/// Per corner, ascending, the lesser corners that it sees: neighbours on the boundary, and those to
/// which a straight line leads inside the region and past no vertex. Requires a bounded region with
/// one loop, uncut. O(n log n) and the triangles seen from each corner.
std::vector<std::vector<std::uint32_t>> lesser_corners_seen(const PlaneRegion& region,
                                                            Context& context);

// The fewest convex pieces that diagonals between vertices can cut a region into (internal to
// plane_partition).
//
// Notation
//   corners   0 .. n-1 along the only boundary loop; a link (i, j), i < j, is a side or a diagonal
//             between corners that see each other. A diagonal touches no vertex between its ends
//   chain     from i to j: links over ascending corners that turn left or go straight at each, so
//             that together with the way back from j to i they would bound a convex piece
//   cost      of a link (i, j): 0 for a side; of a diagonal 1 + that of the best chain from i to j,
//             its piece being the one behind the diagonal. Of a chain: the sum over its links
//
// Main flow of cut_optimally():
//  1. see     which corners see each other: from each a walk through a triangulation, between the
//             rays to what it sees
//  2. chain   for all i < j by growing j - i: the least cost of a chain, and of the chains of that
//             cost those that no other beats at both ends (steeper in at i, out at j). A chain to k
//             is one to j and the link (j, k)
//  3. cut     back along the choices, from the chain 0 .. n-1 whose way back is the last side
//
// A chain that costs more than the least is never needed: the diagonal (i, j) costs one more than
// the least and does no less well at both ends. Only where i and j do not see each other is there
// no such diagonal: then no convex piece has both, or they lie on one straight side of it. That
// side may come first, as links in a row (row_), or last, when any chain to j does.
//
// Steepness is order of corners: those seen from i lie around it in their order. So chains that are
// kept, sorted by their last corner, are sorted by their first, too.
//
// Cost: O(n^2) memory and O(n^3 log n) time at worst, less where little is seen.
// Sources: Keil, SIAM J. Comput. 14 (1985) 799-817; Keil and Snoeyink, IJCGA 12 (2002) 181-192.

/// Requires a bounded region with one boundary loop and no cuts.
void cut_optimally(PlaneRegion& region, Context& context);

}  // namespace plumb
