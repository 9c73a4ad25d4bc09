// Makes scenes of sets of space: the facets of the minimal complex, its edges, and the points that
// show more than the edges do. Several sets can be moved apart in one scene (exploded_scene).
//
// Main flow of scene_of(set):
//  1. window  makes a box around all vertices, and a point of each facet and line without
//             vertices (SpaceWindow)
//  2. cut     intersects an unbounded set with the open box, exactly
//  3. draw    adds points, facets (triangles between vertices), edges and dots; what lies on the
//             box is Paint::Cut or left out
#pragma once

#include <span>

#include "plumb/base/context.h"
#include "plumb/picture/scene.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the scene of a set. Cost: O(n log n).
Scene scene_of(const Nef3& set, Context& context = unlimited_context());

/// Returns a scene of several sets in one layer; each set is a group with a colour of its own. The
/// middle of each set is moved away from the middle of all by `apart` times their distance, so that
/// 0 leaves the sets in place. Throws Error{BadArgument} if a set is unbounded, if `apart` is
/// negative or not finite, or if a point would be moved beyond the largest double. Cost: O(n log
/// n).
Scene exploded_scene(std::span<const Nef3> sets, double apart,
                     Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
