// Borders of what the listed cycles cover: chains of half-edges that nobody lists.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/plane/map_edges.h"
#include "plumb/predicates/sign.h"

namespace plumb {

/// A closed chain of unlisted half-edges whose twins are listed, in the direction in which a cycle
/// that closes the map would list them.
struct OpenChain {
  std::vector<std::uint32_t> halfedges;
  /// Negative: clockwise, the outer boundary of a part of the map is missing. Positive: a gap, a
  /// face is missing. Zero: a slit without area.
  Sign area;
};

/// All chains, by their least half-edge. Requires no duplicate uses (then every chain closes); at a
/// vertex where several borders meet each turns so as to stay with the same faces. O(n).
std::vector<OpenChain> trace_open_chains(const Map& map, const MapEdges& edges);

/// The vertices of a chain, as a cycle to list.
std::vector<std::uint32_t> cycle_of_chain(const MapEdges& edges, const OpenChain& chain);

}  // namespace plumb
