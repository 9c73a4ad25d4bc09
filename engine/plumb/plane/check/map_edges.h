// The undirected edges of a listed map, the cycles that list them, the connected components, and
// the borders of what the cycles cover.
//
// Half-edges are numbered by edge: half-edge 2e runs from ends[e].from to ends[e].to, 2e+1 back. A
// half-edge that no cycle lists exists all the same; its cycle is kNoCycle.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/plane/map.h"
#include "plumb/plane/sweep/sweep.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The edges of a map.
struct MapEdges {
  static constexpr std::uint32_t kNoCycle = std::numeric_limits<std::uint32_t>::max();

  /// A listing of a half-edge beyond its first.
  struct ExtraUse {
    std::uint32_t halfedge;  ///< The half-edge.
    std::uint32_t cycle;     ///< The cycle that lists it again.
  };

  std::vector<SweepSegment> ends;        ///< The ends of each edge; from < to as indices.
  std::vector<std::uint32_t> cycle_of;   ///< The first cycle that lists each half-edge.
  std::vector<ExtraUse> extra_uses;      ///< By half-edge, then by position in the input.
  std::vector<std::uint32_t> at_corner;  ///< The half-edge of each corner of the listing.

  std::size_t edge_count() const { return ends.size(); }
  std::size_t halfedge_count() const { return cycle_of.size(); }
  std::uint32_t origin(std::uint32_t h) const {
    return (h & 1U) == 0 ? ends[h >> 1U].from : ends[h >> 1U].to;
  }
  std::uint32_t target(std::uint32_t h) const { return origin(h ^ 1U); }
  /// Whether h is listed and its twin is not.
  bool is_open(std::uint32_t h) const {
    return cycle_of[h] != kNoCycle && cycle_of[h ^ 1U] == kNoCycle;
  }
  /// Returns all cycles that list half-edge h, one entry for each time.
  std::vector<std::uint32_t> uses(std::uint32_t h) const;
  /// Returns a cycle that lists edge e in both directions, or kNoCycle.
  std::uint32_t cycle_on_both_sides(std::uint32_t e) const;
  /// Returns the edge {u, v}, or edge_count() if there is none. O(log n), as edges are sorted by
  /// their ends.
  std::size_t find(std::uint32_t u, std::uint32_t v) const;
};

/// Returns the edges of a map: buckets the directed edges by their lesser vertex and pairs them.
/// O(n) and the sorting of the edges at each vertex. The order of `ends` depends on the set of
/// edges only.
MapEdges match_twins(const Map& map);

/// The connected components of the edge graph.
struct MapComponents {
  static constexpr std::uint32_t kNoComponent = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t>
      of_vertex;          ///< The component of each vertex; kNoComponent without edge.
  std::size_t count = 0;  ///< The number of components.
};
/// Returns the components, numbered by their least vertices. O(n a(n)).
MapComponents connect(const Map& map, const MapEdges& edges);

// Borders of what the listed cycles cover: chains of half-edges that no cycle lists.

/// A closed chain of unlisted half-edges whose twins are listed, in the direction in which a cycle
/// that closes the map would list them.
struct OpenChain {
  std::vector<std::uint32_t> halfedges;  ///< The half-edges in order.
  /// The sign of the area: Negative for a clockwise chain, the missing outer boundary of a part of
  /// the map; Positive for a gap, a missing face; Zero for a slit without area.
  Sign area;
};

/// Returns all chains, by their least half-edges. At a vertex where several borders meet, each
/// turns so that it stays with the same faces. Requires that no half-edge is listed twice, as then
/// every chain closes. O(n).
std::vector<OpenChain> trace_open_chains(const Map& map, const MapEdges& edges);

/// Returns the vertices of a chain, as a cycle to list.
std::vector<std::uint32_t> cycle_of_chain(const MapEdges& edges, const OpenChain& chain);

}  // namespace plumb
#pragma GCC visibility pop
