// Makes a layer from the bounded marked faces of a set of the plane. Each face becomes one feature
// with one polygon.
//
// For example, let `lines` be a union of segments. The segments bound faces, which are not marked
// in `lines`, but are marked in the complement. So layer_of_faces(lines.complement()) returns the
// polygons that the segments bound.
#pragma once

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns a layer with a feature for each bounded marked face, in the order of the faces. The
/// polygon of a feature is the closure of its face. It has an outer ring, and a ring for each hole.
/// Edges that have the face on both sides are left out. Coordinates are exact. Features have no ids
/// and no properties. Cost: O(n log n) for n cells. Throws the errors of the Context.
[[nodiscard]] Layer layer_of_faces(const Nef2& set, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
