// The undirected edges of a listed map, and who uses them.
//
// Half-edges are numbered by edge: half-edge 2e runs from ends[e].from to ends[e].to, 2e+1 back. A
// half-edge that no cycle lists exists all the same (its cycle is kNoCycle): it is "open".
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plumb/plane/map.h"
#include "plumb/plane/sweep/sweep.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

struct MapEdges {
  static constexpr std::uint32_t kNoCycle = std::numeric_limits<std::uint32_t>::max();

  /// A use of a half-edge beyond its first.
  struct ExtraUse {
    std::uint32_t halfedge;
    std::uint32_t cycle;
  };

  std::vector<SweepSegment> ends;        ///< per edge; from < to as indices
  std::vector<std::uint32_t> cycle_of;   ///< per half-edge: the cycle that lists it (first use)
  std::vector<ExtraUse> extra_uses;      ///< ascending by half-edge, then by position in the input
  std::vector<std::uint32_t> at_corner;  ///< per corner of the listing: its half-edge

  std::size_t edge_count() const { return ends.size(); }
  std::size_t halfedge_count() const { return cycle_of.size(); }
  std::uint32_t origin(std::uint32_t h) const {
    return (h & 1U) == 0 ? ends[h >> 1U].from : ends[h >> 1U].to;
  }
  std::uint32_t target(std::uint32_t h) const { return origin(h ^ 1U); }
  bool is_open(std::uint32_t h) const {  // listed, but its twin is not
    return cycle_of[h] != kNoCycle && cycle_of[h ^ 1U] == kNoCycle;
  }
  /// All cycles that list half-edge h, one entry per use.
  std::vector<std::uint32_t> uses(std::uint32_t h) const;
  /// A cycle that lists edge e in both directions, or kNoCycle.
  std::uint32_t cycle_on_both_sides(std::uint32_t e) const;
  /// The edge {u, v}, or edge_count() when there is none. O(log n): edges are sorted by their ends.
  std::size_t find(std::uint32_t u, std::uint32_t v) const;
};

/// Buckets the directed edges by their lesser vertex and pairs them. O(n) plus the sorting of the
/// edges at each vertex; the order of `ends` depends on the set of edges only.
MapEdges match_twins(const Map& map);

/// Connected parts of the edge graph: per vertex a component number (kNoComponent: no edge).
struct MapComponents {
  static constexpr std::uint32_t kNoComponent = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> of_vertex;
  std::size_t count = 0;
};
MapComponents connect(const Map& map, const MapEdges& edges);

// Borders of what the listed cycles cover: chains of half-edges that nobody lists.

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
#pragma GCC visibility pop
