// Sets of space as scenes: the facets of the minimal complex, its edges, and those points that say more
// than the edges do.
//
// Flow of scene_of(set):
//  1. SpaceWindow   a box around all vertices and a point of each facet and line without one
//  2. the set * the open box, if it is unbounded: cut off exactly
//  3. points, facets (triangles between vertices), edges, dots; what lies on the box is Paint::Cut or left out
#pragma once

#include "plumb/base/context.h"
#include "plumb/picture/scene.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Any set. O(n log n).
Scene scene_of(const Nef3& set, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
