// Pairing of the directed edges of a map, its components, and the borders of the covered area.
//
// Directed edges are bucketed by the lesser of their vertices and sorted within a bucket, so equal
// edges come side by side, first forward, then backward, each in the order of the listing. A border
// is followed through the faces beside it. From a missing half-edge, the walk turns around its end
// from one listed half-edge to the next, until a half-edge is missing.
//
// Tested by tests/plane/map_check_test.cpp and tests/plane/map_check_property_test.cpp.

#include "plumb/plane/check/map_edges.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>

#include "plumb/predicates/plane/plane_points.h"

namespace plumb {
namespace {

// A directed edge of the listing, seen from the lesser of its two vertices.
struct DirectedUse {
  std::uint32_t greater;
  std::uint32_t corner;
  std::uint32_t cycle;
  bool backward;  // Whether it leads from the greater to the lesser vertex.

  friend bool operator<(const DirectedUse& p, const DirectedUse& q) {
    return std::tie(p.greater, p.backward, p.corner) < std::tie(q.greater, q.backward, q.corner);
  }
};

// Calls visit(corner, cycle, from, to) for every corner in listing order.
template <class Visit>
void for_each_corner(const Map& map, const Visit& visit) {
  for (std::uint32_t c = 0; c < map.cycle_count(); ++c) {
    const std::uint32_t begin = map.cycle_begin[c];
    const std::uint32_t end = map.cycle_begin[c + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      visit(i, c, map.corners[i], map.corners[i + 1 == end ? begin : i + 1]);
    }
  }
}

struct Buckets {
  std::vector<std::uint32_t> begin;  // Where the bucket of each vertex begins.
  std::vector<DirectedUse> uses;
};

// Sorts the directed edges into buckets by a counting sort. The counts are stored two places ahead.
// After the summation, the start of each bucket moves to its final place while the bucket is
// filled.
Buckets bucket_by_lesser_vertex(const Map& map) {
  Buckets buckets;
  buckets.begin.assign(map.vertex_count() + 2, 0);
  for_each_corner(map, [&](std::uint32_t, std::uint32_t, std::uint32_t from, std::uint32_t to) {
    ++buckets.begin[std::min(from, to) + 2];
  });
  std::partial_sum(buckets.begin.begin(), buckets.begin.end(), buckets.begin.begin());
  buckets.uses.resize(map.corners.size());
  for_each_corner(
      map, [&](std::uint32_t corner, std::uint32_t cycle, std::uint32_t from, std::uint32_t to) {
        const std::uint32_t slot = buckets.begin[std::min(from, to) + 1]++;
        buckets.uses[slot] = {std::max(from, to), corner, cycle, from > to};
      });
  buckets.begin.pop_back();
  return buckets;
}

// Adds a directed edge. Equal edges must come one after the other.
void add_use(MapEdges& edges, std::uint32_t lesser, const DirectedUse& use) {
  if (edges.ends.empty() || edges.ends.back().from != lesser ||
      edges.ends.back().to != use.greater) {
    edges.ends.push_back({lesser, use.greater});
    edges.cycle_of.insert(edges.cycle_of.end(), 2, MapEdges::kNoCycle);
  }
  const auto halfedge =
      static_cast<std::uint32_t>(2 * (edges.ends.size() - 1) + (use.backward ? 1 : 0));
  edges.at_corner[use.corner] = halfedge;
  if (edges.cycle_of[halfedge] == MapEdges::kNoCycle) {
    edges.cycle_of[halfedge] = use.cycle;
  } else {
    edges.extra_uses.push_back({halfedge, use.cycle});
  }
}

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

}  // namespace

std::vector<std::uint32_t> MapEdges::uses(std::uint32_t h) const {
  std::vector<std::uint32_t> cycles;
  if (cycle_of[h] != kNoCycle) cycles.push_back(cycle_of[h]);
  const auto less = [](const ExtraUse& use, std::uint32_t halfedge) {
    return use.halfedge < halfedge;
  };
  auto use = std::lower_bound(extra_uses.begin(), extra_uses.end(), h, less);
  for (; use != extra_uses.end() && use->halfedge == h; ++use) cycles.push_back(use->cycle);
  return cycles;
}

std::uint32_t MapEdges::cycle_on_both_sides(std::uint32_t e) const {
  if (extra_uses.empty())
    return cycle_of[2 * e] == cycle_of[2 * e + 1] ? cycle_of[2 * e] : kNoCycle;
  std::vector<std::uint32_t> forward = uses(2 * e);
  std::vector<std::uint32_t> backward = uses(2 * e + 1);
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  std::vector<std::uint32_t> both;
  std::set_intersection(forward.begin(), forward.end(), backward.begin(), backward.end(),
                        std::back_inserter(both));
  return both.empty() ? kNoCycle : both.front();
}

std::size_t MapEdges::find(std::uint32_t u, std::uint32_t v) const {
  const SweepSegment wanted{std::min(u, v), std::max(u, v)};
  const auto less = [](const SweepSegment& p, const SweepSegment& q) {
    return std::tie(p.from, p.to) < std::tie(q.from, q.to);
  };
  const auto found = std::lower_bound(ends.begin(), ends.end(), wanted, less);
  const bool exists = found != ends.end() && !less(wanted, *found);
  return exists ? static_cast<std::size_t>(found - ends.begin()) : edge_count();
}

MapEdges match_twins(const Map& map) {
  Buckets buckets = bucket_by_lesser_vertex(map);
  MapEdges edges;
  edges.at_corner.resize(map.corners.size());
  edges.ends.reserve(map.corners.size() / 2 + 1);
  edges.cycle_of.reserve(map.corners.size() + 2);
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    const auto first = buckets.uses.begin() + buckets.begin[v];
    const auto last = buckets.uses.begin() + buckets.begin[v + 1];
    std::sort(first, last);
    for (auto use = first; use != last; ++use) add_use(edges, v, *use);
  }
  return edges;
}

MapComponents connect(const Map& map, const MapEdges& edges) {
  std::vector<std::uint32_t> parent(map.vertex_count());
  std::iota(parent.begin(), parent.end(), 0U);
  MapComponents components;
  components.of_vertex.assign(map.vertex_count(), MapComponents::kNoComponent);
  for (const SweepSegment& e : edges.ends) {
    const std::uint32_t a = find_root(parent, e.from);
    const std::uint32_t b = find_root(parent, e.to);
    parent[std::max(a, b)] = std::min(a, b);
    components.of_vertex[e.from] = components.of_vertex[e.to] = 0;
  }
  // A root is the least vertex of its component, so it is numbered before the others are reached.
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    if (components.of_vertex[v] == MapComponents::kNoComponent) continue;
    const std::uint32_t root = find_root(parent, v);
    components.of_vertex[v] =
        root == v ? static_cast<std::uint32_t>(components.count++) : components.of_vertex[root];
  }
  return components;
}

namespace {

// Follows borders. For this purpose, it finds the half-edge before a listed half-edge in its cycle.
class BorderWalker {
 public:
  BorderWalker(const Map& map, const MapEdges& edges) : map_(map), edges_(edges) {
    corner_of_.resize(edges.halfedge_count());
    for (std::uint32_t i = 0; i < edges.at_corner.size(); ++i) {
      corner_of_[edges.at_corner[i]] = i;
    }
  }

  // Returns the unlisted half-edge that follows `missing`. The walk turns around its target through
  // the listed faces until it reaches the next border.
  std::uint32_t after(std::uint32_t missing) const {
    std::uint32_t h = missing ^ 1U;
    while (edges_.cycle_of[h] != MapEdges::kNoCycle) h = previous_in_cycle(h) ^ 1U;
    return h;
  }

 private:
  std::uint32_t previous_in_cycle(std::uint32_t h) const {
    const std::uint32_t cycle = edges_.cycle_of[h];
    const std::uint32_t corner = corner_of_[h];
    const std::uint32_t before =
        (corner == map_.cycle_begin[cycle] ? map_.cycle_begin[cycle + 1] : corner) - 1;
    return edges_.at_corner[before];
  }

  const Map& map_;
  const MapEdges& edges_;
  std::vector<std::uint32_t> corner_of_;  // The corner of each listed half-edge.
};

}  // namespace

std::vector<std::uint32_t> cycle_of_chain(const MapEdges& edges, const OpenChain& chain) {
  std::vector<std::uint32_t> cycle;
  cycle.reserve(chain.halfedges.size());
  for (const std::uint32_t h : chain.halfedges) cycle.push_back(edges.origin(h));
  return cycle;
}

// Every unlisted half-edge whose twin is listed is in exactly one chain, because after() is
// one-to-one.
std::vector<OpenChain> trace_open_chains(const Map& map, const MapEdges& edges) {
  const BorderWalker walker(map, edges);
  std::vector<char> seen(edges.halfedge_count(), 0);
  std::vector<OpenChain> chains;
  for (std::uint32_t start = 0; start < edges.halfedge_count(); ++start) {
    if (seen[start] != 0 || !edges.is_open(start ^ 1U)) continue;
    OpenChain chain;
    for (std::uint32_t h = start; seen[h] == 0; h = walker.after(h)) {
      seen[h] = 1;
      chain.halfedges.push_back(h);
    }
    chain.area = polygon_area_sign(map.points, cycle_of_chain(edges, chain));
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace plumb
