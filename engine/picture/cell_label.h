// Room for a label inside a polygon.
#pragma once

#include <optional>
#include <vector>

#include "plumb/picture/picture.h"

namespace plumb {

/// A box of this size that lies inside the polygon of the rings (even-odd), as near to the middle
/// of it as a few tries find. Nothing if none of the tries fits. O(points).
std::optional<Rectangle> room_inside(const std::vector<std::vector<Point2>>& rings, double width,
                                     double height);

}  // namespace plumb
