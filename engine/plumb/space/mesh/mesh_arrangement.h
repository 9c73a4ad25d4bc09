// A mesh that crosses itself, taken apart into layers that do not.
//
// Facets that meet in common vertices and edges only may share a layer. A component that crosses
// others but not itself stays whole; of one that crosses itself, neighbours stay together as long
// as they can: borders of layers are edges that an overlay has to meet again.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct MeshLayers {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_facet;
};

/// Greedy colours of the graph of crossing pairs. `component`: per facet. O(n + pairs), and the
/// number of layers for each facet in the worst case.
MeshLayers find_layers(const SpaceComplex& complex, std::span<const std::uint32_t> component,
                       std::span<const std::pair<FacetId, FacetId>> crossings);

/// Some facets of a mesh, each of one cycle, as a complex of their own: all marks 0, volumes
/// labelled, facet_origin their number in `complex`. Auxiliary planes are added to `tables`, those
/// of `complex`. O(k log k) for k corners, and a ray for each connected piece.
SpaceComplex layer_of(const SpaceComplex& complex, std::span<const FacetId> facets,
                      const std::shared_ptr<SpaceTables>& tables, Context& context);

// Meshes that cross themselves, as cells of space: facets are cut where they meet, so that every
// point off them lies in a volume with one winding number.
//
// Main flow of arrange():
//  1. find_layers  (mesh_arrangement.h) facets in layers that do not cross themselves; one layer:
//                  done
//  2. overlay      of the layers, pairwise in a balanced tree (boolean_op.h): a union of surfaces
//                  in which nothing is simplified. Volumes have mark 0, facets 1, edges and
//                  vertices the mark that no operation changes (kBeyond): so an edge stays even in
//                  the midst of a facet
//  3. name         where facets of two layers lie upon each other the common facet gets a new
//                  number for the pair; in the end each is unfolded to the sheets it lies in
//
// A sheet is a facet of the mesh as it was. Jumps of the sheets of one facet add up, so coincident
// sheets of opposite sides cancel.
//
// Cost: layers - 1 overlays of surfaces, O((n + c) log(n + c)) each for c contacts. Booleans do no
// more.

/// Makes facets meet in common vertices and edges only, fills MeshComplex::sheets and labels
/// volumes; marks mean nothing. Nothing happens to a mesh that is arranged. Requires a complex
/// (MeshOptions).
void arrange(MeshComplex& mesh, Context& context);

/// Per facet of an arranged mesh: how much the winding number rises from its negative to its
/// positive side.
std::vector<std::int32_t> facet_jumps(const MeshComplex& mesh);

// Meshes whose faces look inwards.

/// Turns the components of negative volume that the others do not enclose: the jumps of their
/// sheets change sign. Enclosed is one that nowhere borders on the unbounded volume but where it
/// lies upon others that do elsewhere; a component that crosses the only one around it sticks out
/// and is turned. Returns the least face of each. Arranges the mesh, which must be closed.
std::vector<std::uint32_t> turn_inside_out(MeshComplex& mesh, Context& context);

}  // namespace plumb
