// Makes the faces of the regions of facets. Internal.
#pragma once

#include "plumb/space/set/cut_state.h"

namespace plumb {

/// Makes the faces of all regions, and moves the pieces to the result. Requires that the edge cuts
/// are sorted. A facet whose edges have vertices inside gets these vertices.
CutBoundary faces_of_regions(CutState& state);

}  // namespace plumb
