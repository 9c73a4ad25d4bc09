// Step 2 of walls: cells without reflex edges but vertical ones, cut by walls that prolong facets
// across these (internal to walls).
//
// Seen along the vertical such a cell is a region of the plane: its floor and its ceiling bulge
// outwards, and a vertical line meets it in one piece. So a wall that runs ahead from a vertical
// edge lies between two chains of facets, joined end to end.
//
// Main flow of spread_walls(), for each vertical reflex edge of each marked volume:
//  1. prolong   the plane of a facet at the edge, away from that facet: an angle of half a turn
//               stays, and a lesser one. Nothing is done if an earlier wall of the cell ended there
//               and did as much
//  2. section   the cell's facets with that plane
//  3. follow    ceiling and floor, from the ends of the edge, until they end at an upright facet or
//               edge
//  4. stop      at the first earlier wall of the cell, or there
//
// Each edge so makes at most one piece more. Cost: the facets of the cell for each edge.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/wall/wall_section.h"
#include "plumb/convex/wall/wall_sight.h"

namespace plumb {

/// Requires a bounded set's complex with volumes; `tables` are its own.
std::vector<WallPolygon> spread_walls(const SpaceComplex& complex, SpaceTables& tables,
                                      Vertical& vertical, Context& context);

}  // namespace plumb
