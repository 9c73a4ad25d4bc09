// Where the rings of a polygon cross or overlap each other or themselves.
//
// A polygon with such places is no valid polygon in most programs. The even-odd rule still states
// what it covers, so these places are found for reports only.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/layer/covered_cells.h"

namespace plumb {

/// A place at which the rings of a polygon cross or overlap.
struct SelfCrossing {
  std::uint32_t polygon;  ///< The polygon.
  VertexId vertex;        ///< The crossing, or a vertex of the overlap.
};

/// Returns the places at which the rings of the polygons of a layer cross or overlap, in ascending
/// order of the polygons. Rings that only touch at a point do not cross. Edges of a polygon that
/// lie on each other and hang together are one place. `layer` is the layer of the cells. O(n log n)
/// for n edges of the arrangement and of the polygons on them.
std::vector<SelfCrossing> self_crossings(const CoveredCells& cells, const Layer& layer,
                                         Context& context);

}  // namespace plumb
