// Finds the pairs of facets of a mesh that have a point in common outside common vertices and
// edges.
//
// Notation: triangles (0, 1, 2) run counter-clockwise seen from the positive side of their
// (canonical) plane. Facets of more corners are triangulated. Their diagonals are no edges: two
// facets may share an edge only where it bounds both.
//
// Main flow of find_mesh_crossings():
//  1. gather_triangles  triangulates the facets
//  2. pairs             finds pairs of triangles of different facets whose boxes meet: by
//                       packed_boxes.h; where that takes more than some steps a box, by
//                       oriented_boxes.h; for boxes of many scales, by box_tree.h. Of very many
//                       triangles around one vertex it takes the pairs whose directions from the
//                       vertex meet (triangle_crossing.h)
//  3. test              tests a pair exactly (triangle_crossing.h), unless a common vertex has a
//                       fan (mesh_topology.h), by the number of common vertices
//       2   overlap if in one plane on the same side of the edge; else only the edge is common
//       1   meet elsewhere if the sectors at the vertex have another direction in common
//       0   meet, in one plane, if no line of an edge separates them; else if an edge of one meets
//           the other
//
// Source of step 3: the cases of orient3d in P. Guigue, O. Devillers, Fast and robust
// triangle-triangle overlap test using orientation predicates, Journal of Graphics Tools 8 (2003).
// No point is constructed. See docs/design/meshes.md, "Does the mesh meet itself?".
//
// Cost: O(n log n + c) for c pairs of boxes that meet; around vertices of many triangles boxes of
// directions are counted (triangle_crossing.h). Most pairs cost two to six filtered signs.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/bounds/packed_boxes.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Returns the pairs of facets that cross, ascending, each once. `has_fan` is the result of
/// find_fans(complex). Requires what link_facets() makes of any mesh: edges and planes of facets,
/// and boundary cycles that are simple polygons; radial orders and volumes are not read. If
/// `order` is Kept, triangles that are near each other should have numbers near each other, which
/// only makes the search faster. Throws the errors of the Context.
std::vector<std::pair<FacetId, FacetId>> find_mesh_crossings(const SpaceComplex& complex,
                                                             std::span<const std::uint8_t> has_fan,
                                                             Context& context,
                                                             BoxOrder order = BoxOrder::Any);

}  // namespace plumb
