// A mesh that crosses itself, taken apart into layers that do not.
//
// Facets that meet in common vertices and edges only may share a layer. A component that crosses others but not
// itself stays whole; of one that crosses itself, neighbours stay together as long as they can: borders
// of layers are edges that an overlay has to meet again.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct MeshLayers {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_facet;
};

/// Greedy colours of the graph of crossing pairs. `component`: per facet. O(n + pairs), and the number of layers for
/// each facet in the worst case.
MeshLayers find_layers(const SpaceComplex& complex, std::span<const std::uint32_t> component,
                       std::span<const std::pair<FacetId, FacetId>> crossings);

/// Some facets of a mesh, each of one cycle, as a complex of their own: all marks 0, volumes labelled,
/// facet_origin their number in `complex`. Auxiliary planes are added to `tables`, those of `complex`.
/// O(k log k) for k corners, and a ray for each connected piece.
SpaceComplex layer_of(const SpaceComplex& complex, std::span<const FacetId> facets,
                      std::shared_ptr<SpaceTables> tables, Context& context);

}  // namespace plumb
