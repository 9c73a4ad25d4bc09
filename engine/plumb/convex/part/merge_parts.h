// Neighbours whose union is convex become one set: what merge_pieces() is to pieces of one surface.
//
// Main flow of merge_sets():
//  1. match   facets of two sets, on either side of one polygon, by the fingerprints of their
//             corners
//  2. test    are the corners of each behind all other facets of the other? Then the union, which
//             says the rest: that its interior is convex
//  3. repeat  with the facets of what was merged, until it has no match
//
// A polygon that was refused once is not tried again: pieces only grow, so an angle at its rim that
// was too large stays too large as long as it is a facet of both. Cost: O(n log n), the product of
// both sizes for each polygon, and a small Boolean for each that passes.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/part/cut_surface.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// Requires convex pieces (decompose.h). Of bounded ones with a volume; merged ones take the place
/// of the first.
void merge_sets(std::vector<Nef3>& pieces, Context& context);

// Neighbours whose union is convex become one piece.
//
// Main flow of merge_pieces():
//  1. match   faces on both sides of a cut that are the same polygon
//  2. test    the union of the two pieces is convex if no edge of the polygon is reflex once it is
//             gone
//  3. join    the edges around it, until no pair is left
//
// A union of two convex pieces is closed, connected and locally convex but perhaps along the rim of
// what they share, so the rim decides (Tietze 1928). Cost: O(n log n) besides, for n corners of
// cuts.

/// Requires convex pieces. Merged ones take the place of the first.
void merge_pieces(CutSurface& surface, std::vector<std::vector<FaceId>>& pieces, Context& context);

}  // namespace plumb
