// Makes scenes of sets of space. A scene shows the facets and edges of the minimal complex. It
// shows a vertex as a dot where the edges do not show whether the vertex belongs to the set.
// exploded_scene() shows several sets in one scene and moves the sets apart.
//
// Main flow of scene_of(set):
//  1. window  makes the window, a box (SpaceWindow). The box contains all vertices. The box also
//             contains at least one point of each facet without vertices, and at least one point of
//             each line without vertices.
//  2. cut     intersects an unbounded set with the interior of the box, exactly
//  3. draw    adds points, facets (as triangles between vertices), edges and dots. Facets on the
//             border of the box get Paint::Cut. Edges and points on this border are left out.
#pragma once

#include <span>

#include "plumb/base/context.h"
#include "plumb/picture/scene.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the scene of a set. Cost: O(n log n).
Scene scene_of(const Nef3& set, Context& context = unlimited_context());

/// Returns a scene of several sets in one layer. Each set is a group with its own colour. Each set
/// is moved away from the middle of all sets. The distance of this move is `apart` times the
/// distance between the middle of the set and the middle of all sets. If `apart` is 0, the sets are
/// not moved. Throws Error{BadArgument} if a set is unbounded, if `apart` is negative or not
/// finite, or if a point would be moved beyond the largest double. Cost: O(n log n).
Scene exploded_scene(std::span<const Nef3> sets, double apart,
                     Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
