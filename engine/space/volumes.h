// The volumes of a complex: connected parts of space between its facets.
//
// Main flow of label_volumes():
//  1. join the sides of facets around every edge and in every face of every sphere map: each class is a
//     shell, the boundary of one volume on one connected piece
//  2. the outer shell of a piece is the one that its lexicographically least vertex sees towards -x
//  3. a ray from there towards -x finds the next piece, and the shell that faces the ray: both bound the same
//     volume; no hit: volume 0
// O(n alpha(n)) and a ray for each piece but the least.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Fills facet_volume, edge_volume, vertex_volume and volume_mark (all 0) of a complex in which everything
/// else is there. Volume 0 reaches to infinity; the others are numbered by their least facet, then
/// edge, then vertex. `connected`, per vertex: not 0 where the sphere map surely hangs together; empty: nothing is known.
void label_volumes(SpaceComplex& complex, Context& context,
                   std::span<const std::uint8_t> connected = {});

/// Winding numbers of volumes: 0 in volume 0, rising by jump[f] from the negative to the positive side of
/// facet f. Facets link all volumes. Jumps that are not those of a closed surface stop the program.
/// O(facets).
std::vector<std::int32_t> winding_numbers(const SpaceComplex& complex,
                                          std::span<const std::int32_t> jump);

}  // namespace plumb
