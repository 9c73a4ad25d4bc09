// Meshes whose faces look inwards.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/from_mesh.h"

namespace plumb {

/// Turns the components of negative volume that the others do not enclose: the jumps of their sheets change
/// sign. Enclosed is one that nowhere borders on the unbounded volume but where it lies upon others that
/// do elsewhere; a component that crosses the only one around it sticks out and is turned. Returns the
/// least face of each. Arranges the mesh, which must be closed.
std::vector<std::uint32_t> turn_inside_out(MeshComplex& mesh, Context& context);

}  // namespace plumb
