// Cuts of a bounded region of the plane by diagonals between its vertices (internal to
// plane_partition): a few diagonals fast (cut_by_diagonals()), or the fewest that are possible
// (cut_optimally()).
//
// Main flow of cut_by_diagonals(), after Hertel and Mehlhorn:
//  1. triangulate   triangulates between all vertices, isolated points included (triangulate.h)
//  2. sew           makes triangles the loops of the region, and their sides edges
//  3. tidy          removes diagonals that no reflex corner needs (drop_superfluous() of
//                   region_cuts.h)
//
// At most two of the remaining diagonals are needed at each reflex corner, and none elsewhere. No
// point is made. Cost: O(n log n). Source: S. Hertel and K. Mehlhorn, Fast triangulation of simple
// polygons, FCT 1983.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/region/plane_region.h"

namespace plumb {

/// Steps 1 and 2: makes the triangles of a triangulation the loops of the region. Requires a
/// bounded region without cuts.
void triangulate(PlaneRegion& region, Context& context);

/// Cuts the region into convex parts by diagonals. Requires a bounded region without cuts. Throws
/// the errors of the Context.
void cut_by_diagonals(PlaneRegion& region, Context& context);

// Visibility between the corners of a region with one loop.

/// Returns the corners along the boundary of a region with one loop, beginning with r.loops.
std::vector<HalfedgeId> corners_of(const PlaneRegion& region);

/// Returns for each corner, ascending, the lesser corners that it sees: neighbours on the boundary,
/// and those to which a straight line leads inside the region and past no vertex. Requires a
/// bounded region with one loop and no cuts. Cost: O(n log n), and the triangles seen from each
/// corner.
std::vector<std::vector<std::uint32_t>> lesser_corners_seen(const PlaneRegion& region,
                                                            Context& context);

// The fewest convex parts into which diagonals between vertices can cut a region.
//
// Notation
//   corners   0 .. n-1 along the only boundary loop. A link (i, j), i < j, is a side, or a diagonal
//             between corners that see each other; a diagonal touches no vertex between its ends
//   chain     links from i to j over ascending corners that turn left or go straight at each, so
//             that together with the way back from j to i they would bound a convex part
//   cost      of a link (i, j): 0 for a side; for a diagonal 1 + the cost of the best chain from i
//             to j, whose part is the one behind the diagonal. The cost of a chain is the sum over
//             its links
//
// Main flow of cut_optimally():
//  1. see     finds which corners see each other, by walks from each corner through a
//             triangulation, between the rays to what it sees
//  2. chain   computes for all i < j, by growing j - i, the least cost of a chain, and of the
//             chains of that cost those that no other beats at both ends (steeper in at i, out at
//             j). A chain to k is one to j and the link (j, k)
//  3. cut     follows the choices back, from the chain 0 .. n-1 whose way back is the last side
//
// A chain that costs more than the least is never needed: the diagonal (i, j) costs one more than
// the least and does no less well at both ends. There is no such diagonal only if i and j do not
// see each other: then no convex part has both, or they lie on one straight side of it. That side
// may come first, as links in a row (Cell::row), or last, in which case any chain to j serves.
//
// Steepness is order of corners: those seen from i lie around it in their order. So the chains that
// are kept, sorted by their last corner, are sorted by their first corner, too.
//
// Cost: O(n^2) memory, and O(n^3 log n) time at worst, less if little is seen. Sources: J. M. Keil,
// SIAM Journal on Computing 14 (1985) 799-817; M. Keil and J. Snoeyink, International Journal of
// Computational Geometry and Applications 12 (2002) 181-192.

/// Cuts the region into the fewest convex parts. Requires a bounded region with one loop and no
/// cuts. Throws the errors of the Context.
void cut_optimally(PlaneRegion& region, Context& context);

}  // namespace plumb
