// Cuts the facets of one plane along the source triangles of this plane. Internal.
#pragma once

#include <span>

#include "plumb/predicates/space/plane_table.h"
#include "plumb/space/set/cut_state.h"
#include "plumb/space/to_mesh.h"

namespace plumb {

/// Adds the regions of the given sides of facets, which all lie in `plane`. Adds the vertices at
/// which facets are cut to the complex, and those inside of edges to `state.edge_cuts`. Takes
/// O(n log n) time for n edges of facets and triangles and their crossings. Throws the errors of
/// the Context.
void cut_plane(CutState& state, PlaneId plane, std::span<const FacetSide> sides);

}  // namespace plumb
