// The volumes of a complex: connected parts of space between its facets.
//
// Main flow of find_volumes():
//  1. join the sides of facets around every edge and in every face of every sphere map: each class is a
//     shell, the boundary of one volume on one connected piece
//  2. the outer shell of a piece is the one that its lexicographically least vertex sees towards -x
//  3. a ray from there towards -x finds the next piece, and the shell that faces the ray: both bound the same
//     volume; no hit: volume 0
// O(n alpha(n)) and a ray for each piece but the least.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The volumes around items, numbered by their least facet, then edge, then vertex; volume 0 reaches to infinity.
struct VolumeLabels {
  std::vector<std::array<VolumeId, 2>> facet;  ///< on the positive and on the negative side
  std::vector<VolumeId> edge;                  ///< of a free edge; else invalid
  std::vector<VolumeId> vertex;                ///< of a vertex alone in a volume; else invalid
  std::size_t count = 0;
};

/// Of a complex whose volumes, if any are named, are not looked at. `connected`, per vertex: not 0 where the sphere
/// map surely hangs together; empty: nothing is known.
VolumeLabels find_volumes(const SpaceComplex& complex, Context& context,
                          std::span<const std::uint8_t> connected = {});

/// Fills facet_volume, edge_volume, vertex_volume and volume_mark (all 0) with them. `connected` as above.
void label_volumes(SpaceComplex& complex, Context& context,
                   std::span<const std::uint8_t> connected = {});

/// Winding numbers of volumes: 0 in volume 0, rising by jump[f] from the negative to the positive side of
/// facet f. Facets link all volumes. Jumps that are not those of a closed surface stop the program.
/// O(facets).
std::vector<std::int32_t> winding_numbers(const SpaceComplex& complex,
                                          std::span<const std::int32_t> jump);

}  // namespace plumb
