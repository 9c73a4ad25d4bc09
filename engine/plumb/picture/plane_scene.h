// Makes flat scenes (scene.h) of maps and of sets of the plane. Flat scenes are used for pictures
// without text, and for files that pass triangles to other programs.
#pragma once

#include "plumb/base/context.h"
#include "plumb/picture/scene.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the scene of a set. The scene shows the marked faces, all edges, and some of the
/// vertices. Vertices are left out if the edges alone show where they are and whether they belong
/// to the set. The set is intersected with a window, as in write_nef2_svg(). Faces are triangulated
/// with exact coordinates. Throws the errors of the Context. Cost: O(n log n) for n cells, about 10
/// us for each vertex.
Scene scene_of(const Nef2& set, Context& context = unlimited_context());

/// Returns the scene of a report. The scene of a valid map shows its regions. The scene of a
/// defective map shows the listed edges and the defects. Throws the errors of the Context.
Scene scene_of(const MapReport& report, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
