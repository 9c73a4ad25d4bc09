// The bounded faces of a set of the plane as a layer: one feature with one polygon for each face.
//
// The union of some segments, for instance, has faces that the segments bound. The complement of
// this union has these faces as marked faces, so layer_of_faces(lines.complement()) makes polygons
// of lines.
#pragma once

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns a layer with a feature for each bounded marked face, in the order of the faces. Its
/// polygon is the closure of the face: an outer ring and a ring for each hole. Edges that have the
/// face on both sides are left out. Coordinates are exact. Features have no ids and no properties.
/// Cost: O(n log n). Throws what the context throws.
[[nodiscard]] Layer layer_of_faces(const Nef2& set, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
