// Merging of neighbours whose union is convex: of sets (merge_sets()), and of pieces of one surface
// (merge_pieces()).
//
// Main flow of merge_sets():
//  1. match   finds facets of two sets on either side of one polygon, by the fingerprints of their
//             corners
//  2. test    asks whether the vertices of each set are behind all other facets of the other; if
//             so, makes the union and asks whether its interior is convex
//  3. repeat  goes on with the facets of the merged set until it has no match
//
// A polygon that was refused once is not tried again: pieces only grow, so an angle at its rim that
// was too large stays too large as long as it is a facet of both. Cost: O(n log n), the product of
// both sizes for each polygon, and a small Boolean for each polygon that passes.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/part/cut_surface.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// Merges bounded pieces with a volume. Requires convex pieces (decompose.h). A merged piece takes
/// the place of the first of the two. Throws the errors of the Context.
void merge_sets(std::vector<Nef3>& pieces, Context& context);

// Main flow of merge_pieces():
//  1. match   finds faces on both sides of a cut that are the same polygon
//  2. test    asks whether an edge of the polygon is reflex once the polygon is gone; if none is,
//             the union of the two pieces is convex
//  3. join    joins the edges around it, until no pair is left
//
// A union of two convex pieces is closed, connected, and locally convex except perhaps along the
// rim of what they share, so the rim decides (H. Tietze, Mathematische Zeitschrift 28, 1928). Cost:
// O(n log n) besides, for n corners of cuts.

/// Merges pieces of one surface. Requires convex pieces. A merged piece takes the place of the
/// first of the two. Throws the errors of the Context.
void merge_pieces(CutSurface& surface, std::vector<std::vector<FaceId>>& pieces, Context& context);

}  // namespace plumb
