// Connected closed parts of a mesh and the signs of their volumes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/sign.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct MeshComponents {
  std::vector<std::uint32_t> of_facet;  ///< numbered by least facet
  std::vector<Sign> volume;             ///< per component
};

/// Facets that share an edge with no others are joined; where more meet, those whose component would
/// not be closed there. What is open even so (closed by vertices on edges, faces without area) is one
/// component. Requires facets with one cycle. Volumes of components that are not closed
/// (surfaces) are meaningless. O(n alpha(n)).
MeshComponents find_components(const SpaceComplex& complex, std::span<const std::int32_t> jump);

}  // namespace plumb
