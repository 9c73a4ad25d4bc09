// Results of Booleans as scenes.
#pragma once

#include "plumb/surface/surface.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The borders of a result as one shape, the same set again whatever the rule: its label is 1 in selected cells and 0
/// in others. Borders alone say so only up to a constant for each component of the mesh. Where the usual zero of
/// labels is not it, because all of a component is selected, or all cells at its border, the first such component
/// is given by `outside` and others by `levels`; by a level, too, where no face has its first corner outside. O(mesh).
SurfaceScene result_scene(const SurfaceDivision& division, const SurfaceResult& result);

}  // namespace plumb
#pragma GCC visibility pop
