// A bounded region of the plane cut by diagonals between its vertices (internal to plane_partition).
//
// Main flow of cut_by_diagonals(), after Hertel and Mehlhorn:
//  1. triangulate   (plumb/space/triangulate.h) between all vertices, points inside too
//  2. sew           triangles become the loops of the region, their sides edges
//  3. tidy          diagonals that no reflex corner needs go (drop_superfluous() of plane_cuts.h)
//
// At a reflex corner at most two of the diagonals left are needed there, at others none. No point is made.
// Cost: O(n log n).
#pragma once

#include "plumb/base/context.h"
#include "plumb/convex/plane_region.h"

namespace plumb {

/// 1 and 2. Requires a bounded region without cuts.
void triangulate(PlaneRegion& region, Context& context);

void cut_by_diagonals(PlaneRegion& region, Context& context);

}  // namespace plumb
