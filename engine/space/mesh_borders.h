// Where a mesh is open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/mesh_links.h"
#include "plumb/space/space_tables.h"

namespace plumb {

/// Where directed edges and their reverses do not balance: closed chains of vertices, in the direction that
/// would balance them. It is places that count: an edge with vertices of the mesh on it balances the
/// edges between them. `points`: per vertex.
/// O(n), besides O((m + c) log m) for m edges that no edge of the same ends balances and c pairs of their
/// boxes and ends that meet.
std::vector<std::vector<std::uint32_t>> trace_borders(const MeshFacets& facets,
                                                      const MeshLinks& links,
                                                      std::span<const SpacePoint> points,
                                                      const Point3Table& table);

}  // namespace plumb
