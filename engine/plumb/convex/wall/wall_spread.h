// Step 2 of walls: cells whose reflex edges are all vertical, cut by walls that prolong facets
// across these edges (internal to walls).
//
// Seen along the vertical such a cell is a region of the plane: its floor and its ceiling bulge
// outwards, and a vertical line meets it in one segment. So a wall that runs ahead from a vertical
// edge lies between two chains of facets, joined end to end.
//
// Main flow of spread_walls(), for each vertical reflex edge of each marked volume:
//  1. prolong   takes the plane of a facet at the edge, away from that facet: an angle of half a
//               turn remains, and a smaller one. Nothing is done if an earlier wall of the cell
//               ended there and did as much
//  2. section   cuts the cell's facets by that plane
//  3. follow    follows ceiling and floor from the ends of the edge, until they end at an upright
//               facet or edge
//  4. stop      stops at the first earlier wall of the cell, or there
//
// So each edge makes at most one piece more. Cost: the facets of the cell for each edge.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/wall/wall_section.h"
#include "plumb/convex/wall/wall_sight.h"

namespace plumb {

/// Returns the walls that resolve vertical reflex edges. Requires the complex of a bounded set with
/// volumes; `tables` are its own. Throws the errors of the Context.
std::vector<WallPolygon> spread_walls(const SpaceComplex& complex, SpaceTables& tables,
                                      Vertical& vertical, Context& context);

}  // namespace plumb
