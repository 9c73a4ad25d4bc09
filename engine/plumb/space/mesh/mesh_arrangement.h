// Meshes that cross themselves as cells of space: facets are cut where they meet, so that every
// point off them lies in a volume with one winding number. The first part divides such a mesh into
// layers that do not cross themselves, the second overlays the layers, the third turns components
// that face inwards.
//
// A sheet is a facet of the mesh as it was. Jumps of the sheets of one facet add up, so coincident
// sheets of opposite sides cancel.
//
// Main flow of arrange():
//  1. find_layers  divides facets into layers that do not cross themselves; with one layer it is
//                  done
//  2. overlay      overlays the layers pairwise in a balanced tree (boolean_op.h): a union of
//                  surfaces in which nothing is simplified. Volumes have mark 0, facets 1, edges
//                  and vertices the mark that no operation changes (kBeyond), so an edge stays even
//                  in the midst of a facet
//  3. name         gives the common facet of two layers a new number for the pair; in the end each
//                  number is unfolded to the sheets in which the facet lies
//
// Cost: layers - 1 overlays of surfaces, each of which takes O((n + c) log(n + c)) for c contacts,
// like a Boolean. Proof: docs/design/meshes.md, "Layers of a mesh that crosses itself".
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

/// Layers of a mesh: a colouring of its facets.
struct MeshLayers {
  std::uint32_t count = 0;              ///< The number of layers.
  std::vector<std::uint32_t> of_facet;  ///< The layer of each facet, below `count`.
};

/// Divides the facets into layers of which none crosses itself: greedy colours of the graph of
/// crossing pairs. Facets that meet in common vertices and edges only may share a layer. A
/// component that crosses other components, but not itself, stays whole. If a component crosses
/// itself, neighbours stay together as long as possible, because an overlay has to find the edges
/// between layers again. `component` has the component of each facet. O(n + pairs), and the number
/// of layers for each facet in the worst case.
MeshLayers find_layers(const SpaceComplex& complex, std::span<const std::uint32_t> component,
                       std::span<const std::pair<FacetId, FacetId>> crossings);

/// Returns some facets of a mesh, each of one cycle, as a complex of their own: all marks 0,
/// volumes labelled, facet_origin their number in `complex`. Auxiliary planes are added to
/// `tables`, which must be the tables of `complex` or a copy of them. O(k log k) for k corners, and
/// a ray for each connected piece.
SpaceComplex layer_of(const SpaceComplex& complex, std::span<const FacetId> facets,
                      const std::shared_ptr<SpaceTables>& tables, Context& context);

// The arrangement of a mesh.

/// Makes facets meet in common vertices and edges only, fills MeshComplex::sheet and labels
/// volumes; marks are left without meaning. Does nothing to a mesh that is arranged already.
/// Requires that the mesh has a complex. Throws the errors of the Context.
void arrange(MeshComplex& mesh, Context& context);

/// Returns for each facet of an arranged mesh by how much the winding number rises from its
/// negative to its positive side. O(sheets).
std::vector<std::int32_t> facet_jumps(const MeshComplex& mesh);

// Meshes whose faces look inwards.

/// Turns the components of negative volume that the others do not enclose: the jumps of their
/// sheets change sign. Returns the least face of each. A component is enclosed if it nowhere
/// borders on the unbounded volume, except where it lies upon others that border on it elsewhere; a
/// component that crosses the only one around it sticks out and is turned. Arranges the mesh.
/// Requires that the mesh is closed.
std::vector<std::uint32_t> turn_inside_out(MeshComplex& mesh, Context& context);

}  // namespace plumb
