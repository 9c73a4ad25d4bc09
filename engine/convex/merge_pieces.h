// Neighbours whose union is convex become one piece.
//
// Main flow of merge_pieces():
//  1. match   faces on both sides of a cut that are the same polygon
//  2. test    the union of the two pieces is convex if no edge of the polygon is reflex once it is gone
//  3. join    the edges around it, until no pair is left
//
// A union of two convex pieces is closed, connected and locally convex but perhaps along the rim of what they
// share, so the rim decides (Tietze 1928). Cost: O(n log n) besides, for n corners of cuts.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/cut_surface.h"

namespace plumb {

/// Requires convex pieces. Merged ones take the place of the first.
void merge_pieces(CutSurface& surface, std::vector<std::vector<FaceId>>& pieces, Context& context);

}  // namespace plumb
