// Do two convex polygons in space meet outside their common vertices and edges? By clipping one
// with the other in rationals.
#pragma once

#include <vector>

#include "plumb/predicates/rational_point.h"

namespace plumb::testing {

/// A convex polygon in a plane, not on a line; flat corners allowed.
using FacetPolygon = std::vector<RationalPoint3>;

bool meet_elsewhere(const FacetPolygon& a, const FacetPolygon& b);

}  // namespace plumb::testing
