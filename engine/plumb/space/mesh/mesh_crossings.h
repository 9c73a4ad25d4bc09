// Does a mesh meet itself anywhere but in common vertices and edges?
//
// Notation: triangles (0, 1, 2) run counter-clockwise seen from the positive side of their
// (canonical) plane. Facets of more corners are triangulated; their diagonals are no edges: two
// facets may share an edge only where it bounds both.
//
// Main flow of find_mesh_crossings():
//  1. gather_triangles
//  2. pairs            of triangles whose boxes meet, of different facets (packed_boxes.h; where
//                      that takes more than some steps a box, oriented_boxes.h; of many scales,
//                      box_tree.h); of very many around one vertex, of directions from it that meet
//                      (triangle_crossing.h)
//  3. test             (triangle_crossing.h) none where a common vertex has a fan (mesh_topology.h); by
//                      the number of common vertices
//       2   same plane and same side of the edge: they overlap; else only the edge is common
//       1   do the sectors at the vertex meet elsewhere?
//       0   one plane: is no edge's line between them? else: does an edge of one meet the other?
//
// Source of 3: the cases of orient3d in Guigue and Devillers, "Fast and robust triangle-triangle
// overlap test", JGT 8 (2003). No point is constructed.
//
// Cost: O(n log n + c) for c pairs of boxes that meet, around vertices of many triangles boxes of
// directions (triangle_crossing.h); most pairs cost two to six filtered signs.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Pairs of facets, ascending, each once. has_fan: of find_fans(complex). Requires what
/// link_facets() makes, of any mesh: edges and planes of facets, boundary cycles that are simple
/// polygons; rings and volumes are not looked at.
std::vector<std::pair<FacetId, FacetId>> find_mesh_crossings(const SpaceComplex& complex,
                                                             std::span<const std::uint8_t> has_fan,
                                                             Context& context);

}  // namespace plumb
