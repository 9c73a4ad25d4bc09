// Which walls meet outside of common vertices and sides? (internal to walls)
#pragma once

#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Pairs of facets, each once: all that meet so, and a few more; for layers that is enough. Requires facets in vertical
/// planes, linked by their vertices. Seen along the vertical they are segments, so two in different planes
/// can only meet on one vertical line; where both end there, they do in common vertices only.
/// O(n log n) and a sign for each corner of facets with common boxes.
std::vector<std::pair<FacetId, FacetId>> find_wall_conflicts(const SpaceComplex& walls,
                                                             Context& context);

}  // namespace plumb
