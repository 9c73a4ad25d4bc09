// The undirected edges of a map that is given by a list of cycles. For each edge, the functions of
// this header also find the cycles that list it. Other functions find the connected components, and
// the borders of the area that the cycles cover.
//
// Edge e has the half-edges 2 e and 2 e + 1. Half-edge 2 e runs from ends[e].from to ends[e].to,
// and half-edge 2 e + 1 runs in the opposite direction. Every edge has both half-edges, even if
// cycles list only one of the two. If no cycle lists a half-edge, the cycle of this half-edge is
// kNoCycle.
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

  /// A second or later occurrence of a half-edge in the listed cycles.
  struct ExtraUse {
    std::uint32_t halfedge;  ///< The half-edge.
    std::uint32_t cycle;     ///< The cycle that lists the half-edge again.
  };

  std::vector<SweepSegment> ends;       ///< The end vertices of each edge; `from` < `to`.
  std::vector<std::uint32_t> cycle_of;  ///< For each half-edge, the first cycle that lists it.
  /// The extra occurrences, sorted by half-edge. The occurrences of the same half-edge are in the
  /// order of the input.
  std::vector<ExtraUse> extra_uses;
  std::vector<std::uint32_t> at_corner;  ///< The half-edge that starts at each listed corner.

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
  /// Returns all cycles that list half-edge h. A cycle that lists h several times occurs the same
  /// number of times in the result.
  std::vector<std::uint32_t> uses(std::uint32_t h) const;
  /// Returns a cycle that lists edge e in both directions, or kNoCycle if there is none.
  std::uint32_t cycle_on_both_sides(std::uint32_t e) const;
  /// Returns the index of the edge {u, v}, or edge_count() if there is no such edge. O(log n),
  /// because edges are sorted by their ends.
  std::size_t find(std::uint32_t u, std::uint32_t v) const;
};

/// Returns the edges of a map. The function sorts the directed edges into buckets by the lesser of
/// their two vertex ids. In each bucket, it finds the directed edges of the same undirected edge.
/// Cost: O(n) for n corners, plus sorting the edges in each bucket. A MapReport does not keep the
/// edges, because they would take 12 bytes for each corner. Instead, to_dcel() and the writer of
/// half-edges call this function again. These calls take only a small part of the time of
/// check_map(). The order of MapEdges::ends depends only on the set of undirected edges.
MapEdges match_twins(const Map& map);

/// The connected components of the edge graph.
struct MapComponents {
  static constexpr std::uint32_t kNoComponent = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t>
      of_vertex;          ///< The component of each vertex; kNoComponent if it has no edge.
  std::size_t count = 0;  ///< The number of components.
};
/// Returns the components, numbered in the order of their least vertex ids. O(n a(n)), where a is
/// the inverse Ackermann function.
MapComponents connect(const Map& map, const MapEdges& edges);

// The borders of the area that the listed cycles cover. Each border is a chain of half-edges that
// no cycle lists.

/// A closed chain of half-edges that are not listed, but whose twins are listed. The chain has the
/// direction of a missing cycle. If the chain were added to the map as a cycle, its edges would no
/// longer be open.
struct OpenChain {
  std::vector<std::uint32_t> halfedges;  ///< The half-edges in order.
  /// The sign of the area that the chain encloses. The sign is Negative for a clockwise chain,
  /// which is the missing outer boundary of a part of the map. It is Positive for a
  /// counter-clockwise chain, which bounds a gap, that is, a missing face. It is Zero for a slit,
  /// which encloses no area.
  Sign area;
};

/// Returns all chains, in the order of their least half-edges. If several chains meet at a vertex,
/// a chain that arrives along some faces continues along the same faces. Requires that no half-edge
/// is listed twice. This requirement ensures that every chain closes. O(n) for n half-edges.
std::vector<OpenChain> trace_open_chains(const Map& map, const MapEdges& edges);

/// Returns the vertices of a chain in order, in the form of a cycle of a map.
std::vector<std::uint32_t> cycle_of_chain(const MapEdges& edges, const OpenChain& chain);

}  // namespace plumb
#pragma GCC visibility pop
