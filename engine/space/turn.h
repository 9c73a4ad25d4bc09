// Meshes whose faces look inwards.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/from_mesh.h"

namespace plumb {

/// Turns the components of negative volume that lie in no other component: the jumps of their
/// facets change sign. Returns the least face of each. Labels the volumes. Requires a closed mesh
/// that does not cross itself.
std::vector<std::uint32_t> turn_inside_out(MeshComplex& mesh, Context& context);

}  // namespace plumb
