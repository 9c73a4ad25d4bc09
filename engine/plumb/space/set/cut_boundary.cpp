// Lays facets over the source triangles of their planes, and cuts them where the source changes.
//
// Main flow of cut_boundary():
//  1. add_without_overlay  (whole_facets.h) adds the facets that lie in one source triangle, or are
//                          a face of a source, as regions. Most facets are of this kind.
//  2. cut_plane            (plane_cutter.h) cuts all other facets, plane by plane, into regions.
//  3. EdgeCuts::sort       (cut_state.h) sorts the vertices inside of edges, and merges equal ones.
//  4. faces_of_regions     (region_faces.h) makes the faces of all regions.
//
// A cut that ends inside an edge of a facet makes a vertex there. All facets at this edge get the
// vertex, so that triangles meet in common edges. Therefore step 4 begins after all planes have
// been cut.
//
// Tested by tests/space/mesh_with_attributes_test.cpp.
#include "plumb/space/set/cut_boundary.h"

#include <algorithm>
#include <span>
#include <utility>

#include "plumb/space/set/cut_state.h"
#include "plumb/space/set/plane_cutter.h"
#include "plumb/space/set/region_faces.h"
#include "plumb/space/set/whole_facets.h"
#include "plumb/space/to_mesh.h"

namespace plumb {
namespace {

/// Cuts all facets with more than one source, plane by plane.
void cut_planes(CutState& state, std::vector<FacetSide> sides) {
  const auto plane_of = [&](const FacetSide& s) { return state.complex().facet_plane[s.facet]; };
  std::sort(sides.begin(), sides.end(), [&](const FacetSide& a, const FacetSide& b) {
    return std::pair(plane_of(a), a.facet) < std::pair(plane_of(b), b.facet);
  });
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first;
    while (last < sides.size() && plane_of(sides[last]) == plane_of(sides[first])) ++last;
    state.context.checkpoint("lay facets over sources", first, sides.size());
    cut_plane(state, plane_of(sides[first]), std::span(sides).subspan(first, last - first));
    first = last;
  }
}

}  // namespace

CutBoundary cut_boundary(GrowingComplex& complex, SourceTriangles& sources,
                         const AttributeOptions& options, Context& context) {
  CutState state{complex, sources, options, context, {}, {}, {}, EdgeCuts(complex)};
  const std::vector<FacetSide> sides = boundary_sides(complex.get());
  state.pieces.reserve(sides.size());
  state.regions.reserve(sides.size());
  std::vector<FacetSide> to_cut;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i % 4096 == 0) context.checkpoint("find sources of facets", i, sides.size());
    if (!add_without_overlay(state, sides[i])) to_cut.push_back(sides[i]);
  }
  cut_planes(state, std::move(to_cut));
  state.edge_cuts.sort();
  return faces_of_regions(state);
}

}  // namespace plumb
