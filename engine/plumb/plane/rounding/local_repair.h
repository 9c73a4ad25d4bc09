// Repairs edges around vertices that have moved, without a look at the rest of the subdivision.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/rounding/labelled_edges.h"

namespace plumb {

/// Makes edges meet only in common ends again after the ends of some edges have moved. `moved`
/// contains the indices of these edges; all other edges meet only in common ends. Edges that meet
/// otherwise are arranged exactly, on their own, and the new crossings are rounded: to the nearest
/// doubles in the first rounds, then to local grids that are twice as coarse in each round. In
/// these later rounds edges are also bent to each rounded crossing that they pass within half a
/// step, so that edges that are nearly parallel fall together. `round` is the number of rounds so
/// far; it is increased. Gives up when `most_rounds` is reached.
///
/// Cost: O(n) for a tree over the boxes of all edges in each round, O(log n) for each edge that has
/// moved, and the sweep over the edges that meet others.
void repair_locally(LabelledEdges& scene, std::vector<std::uint32_t> moved, int& round,
                    int most_rounds, EdgeTrace& trace, Context& context);

/// Returns the level of the grid for crossings of a round (places_of_crossings).
int level_of_round(int round);

}  // namespace plumb
