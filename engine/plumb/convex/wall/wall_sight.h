// Step 1 of walls: the obstacles that are visible from a reflex edge straight up and down (internal
// to walls).
//
// Main flow of sight_walls(), for each reflex edge that is not vertical, once up and once down if a
// marked volume is there:
//  1. section   cuts facets and free edges whose shadow along the vertical meets the edge's by the
//               plane of the wall
//  2. sight     finds the obstacle that comes first above each point of the edge: obstacles do not
//               cross, so each is inserted into a list of intervals where it is nearer than what is
//               there
//  3. polygon   joins the edge and the obstacles seen by vertical sides
//
// A vertical side is over the end of the edge, or where an obstacle ends. The edge that ends it
// crosses the wall there, and the plane through that edge and the vertical is its own wall: of the
// pencil of two facets of the complex.
//
// Cost: O(n log n), and for each edge the facets whose shadow is near.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/wall/wall_section.h"

namespace plumb {

/// A facet to add: a simple polygon, counter-clockwise seen from the positive side of its plane.
/// Points with different ids may be equal.
struct WallPolygon {
  PlaneId plane;
  std::vector<SpacePoint> corners;
};

/// Returns the walls above and below reflex edges. Requires the complex of a bounded set with
/// volumes; `tables` are its own. Throws the errors of the Context.
std::vector<WallPolygon> sight_walls(const SpaceComplex& complex, SpaceTables& tables,
                                     Vertical& vertical, Context& context);

}  // namespace plumb
