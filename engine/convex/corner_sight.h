// Which corners of a simple region see each other (internal to plane_partition).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/plane_region.h"

namespace plumb {

/// The corners along the boundary of a region with one loop, from r.loops on.
std::vector<HalfedgeId> corners_of(const PlaneRegion& region);

/// Per corner, ascending, the lesser corners that it sees: neighbours on the boundary, and those to which a straight line
/// leads inside the region and past no vertex. Requires a bounded region with one loop, uncut. O(n log n) and the triangles
/// seen from each corner.
std::vector<std::vector<std::uint32_t>> lesser_corners_seen(const PlaneRegion& region,
                                                            Context& context);

}  // namespace plumb
