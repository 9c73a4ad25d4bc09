// Edges, uses, radial orders and stars of facets that meet in common vertices and edges.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "plumb/space/mesh_links.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Edges between two triangles of one plane, with corners at input points: what is asked of such triangles needs no planes of edges.
enum class FlatEdges : std::uint8_t {
  Complete,  ///< have a second plane: through them, parallel to an axis
  Open,      ///< have that one plane, and half-edges in any order, until they go or are completed
};

/// The complex of the facets, all marks 0, volumes invalid. Adds second planes of edges at which all facets are in one
/// plane. O(n log k) for k uses of an edge.
SpaceComplex link_facets(const MeshFacets& facets, const MeshLinks& links,
                         std::span<const SpacePoint> points, std::shared_ptr<SpaceTables> tables,
                         FlatEdges flat_edges = FlatEdges::Complete);

/// Gives open edges their second planes.
void complete_flat_edges(SpaceComplex& complex);

}  // namespace plumb
