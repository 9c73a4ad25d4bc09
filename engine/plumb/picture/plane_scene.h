// Makes flat scenes of maps and sets of the plane, for pictures without text and for programs that
// need triangles.
#pragma once

#include "plumb/picture/scene.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the scene of a set: its marked faces, all edges, and the vertices that show more than
/// the edges do. The set is cut at a window, as in write_nef2_svg(). Exact coordinates are
/// triangulated. Cost: O(n log n), about 10 us for each vertex.
Scene scene_of(const Nef2& set);

/// Returns the scene of a report: the regions of a valid map, or the listed edges and the defects
/// of a defective map.
Scene scene_of(const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
