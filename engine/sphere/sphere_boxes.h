// Boxes in space that surely hold the points and arcs of a map, taken on the unit sphere. Internal.
//
// In doubles, from the rows of planes and their error bounds: a filter, which decides nothing. An arc
// shorter than a half-circle reaches beyond the box of its ends along an axis only where its coordinate
// grows at one end and falls at the other, that is by the signs of n x P and n x Q; then it may go as
// far as its circle does.
#pragma once

#include <vector>

#include "plumb/base/box_tree.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// Boxes of the points, then of the arcs; none of them empty.
void boxes_of(const PlaneTable& planes, const SphereMap& map, std::vector<Box3>& boxes);

}  // namespace plumb
