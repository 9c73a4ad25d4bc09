// A region of the plane cut by the lines of its own sides (internal to plane_partition).
//
// Main flow of cut_by_sides():
//  1. join     each hole, in the order of their least vertices: the lesser end of a side there goes on to lesser
//              points, so it meets what has been joined before, or infinity
//  2. resolve  each corner that is still reflex: one of its sides goes on into it, up to the first thing it meets on the
//              boundary of its piece. Both parts of the corner are at most half a turn then
//  3. tidy     cuts that later ones made superfluous go (drop_superfluous())
//
// Each cut of 1 joins two loops and each cut of 2 parts one, so r reflex corners and h holes make at most r + 1 - h pieces.
// A cut lies on a line of the set, and what it meets on another: a point is the crossing of two lines of the set.
// Cost: O(n) for each cut, less where pieces get small.
#pragma once

#include "plumb/base/context.h"
#include "plumb/convex/plane_region.h"

namespace plumb {

void cut_by_sides(PlaneRegion& region, Context& context);

/// Takes away, in their order, cuts without which no corner becomes reflex. O(n).
void drop_superfluous(PlaneRegion& region);

}  // namespace plumb
