// Maps and sets of the plane as flat scenes: for pictures without text, and for programs that want triangles.
#pragma once

#include "plumb/picture/scene.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Marked faces, all edges, and vertices that say more than the edges; cut at a window as write_nef2_svg() does.
/// Exact coordinates are triangulated: O(n log n), ~10 us a vertex.
Scene scene_of(const Nef2& set);

/// The regions of a valid map; of a defective one the listed edges, and what is wrong.
Scene scene_of(const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
