// Vertical walls: the second method of decompose().
#pragma once

#include "plumb/base/context.h"
#include "plumb/convex/decompose.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// decompose() with method Walls. "Vertical" is the direction that gives the fewest pieces.
ConvexPieces decompose_by_walls(const Nef3& set, const DecomposeOptions& options, Context& context);

}  // namespace plumb
