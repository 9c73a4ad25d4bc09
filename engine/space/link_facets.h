// Edges, uses, radial orders and stars of facets that meet in common vertices and edges.
#pragma once

#include <memory>
#include <span>

#include "plumb/space/mesh_links.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The complex of the facets, all marks 0, volumes invalid. Adds auxiliary planes, parallel to an axis,
/// through edges between facets of one plane. O(n log k) for k uses of an edge.
SpaceComplex link_facets(const MeshFacets& facets, const MeshLinks& links,
                         std::span<const SpacePoint> points, std::shared_ptr<SpaceTables> tables);

}  // namespace plumb
