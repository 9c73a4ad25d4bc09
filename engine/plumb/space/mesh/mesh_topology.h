// Where a mesh is open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/sign.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/space/mesh/link_facets.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Where directed edges and their reverses do not balance: closed chains of vertices, in the
/// direction that would balance them. It is places that count: an edge with vertices of the mesh on
/// it balances the edges between them. `points`: per vertex. O(n), besides O((m + c) log m) for m
/// edges that no edge of the same ends balances and c pairs of their boxes and ends that meet.
std::vector<std::vector<std::uint32_t>> trace_borders(const MeshFacets& facets,
                                                      const MeshLinks& links,
                                                      std::span<const SpacePoint> points,
                                                      const Point3Table& table);

// Connected closed parts of a mesh and the signs of their volumes.

struct MeshComponents {
  std::vector<std::uint32_t> of_facet;  ///< numbered by least facet
  std::vector<Sign> volume;             ///< per component
};

/// Facets that share an edge with no others are joined; where more meet, those whose component
/// would not be closed there. What is open even so (closed by vertices on edges, faces without
/// area) is one component. Requires facets with one cycle. Volumes of components that are not
/// closed (surfaces) are meaningless. O(n alpha(n)).
MeshComponents find_components(const SpaceComplex& complex, std::span<const std::int32_t> jump);

}  // namespace plumb
