// Meshes that cross themselves, as cells of space: facets are cut where they meet, so that every point off
// them lies in a volume with one winding number.
//
// Main flow of arrange():
//  1. find_layers  (mesh_layers.h) facets in layers that do not cross themselves; one layer: done
//  2. overlay      of the layers, pairwise in a balanced tree (combine.h): a union of surfaces in which nothing
//                  is simplified. Volumes have mark 0, facets 1, edges and vertices the mark that no operation
//                  changes (kBeyond): so an edge stays even in the midst of a facet
//  3. name         where facets of two layers lie upon each other the common facet gets a new number for the pair;
//                  in the end each is unfolded to the sheets it lies in
//
// A sheet is a facet of the mesh as it was. Jumps of the sheets of one facet add up, so coincident
// sheets of opposite sides cancel.
//
// Cost: layers - 1 overlays of surfaces, O((n + c) log(n + c)) each for c contacts. Booleans do no more.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/from_mesh.h"

namespace plumb {

/// Makes facets meet in common vertices and edges only, fills MeshComplex::sheets and labels volumes; marks mean
/// nothing. Nothing happens to a mesh that is arranged. Requires a complex (MeshOptions).
void arrange(MeshComplex& mesh, Context& context);

/// Per facet of an arranged mesh: how much the winding number rises from its negative to its positive side.
std::vector<std::int32_t> facet_jumps(const MeshComplex& mesh);

}  // namespace plumb
