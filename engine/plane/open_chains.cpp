#include "plumb/plane/open_chains.h"

#include "plumb/predicates/polygon.h"

namespace plumb {
namespace {

// Walks borders: needs to know, for a listed half-edge, the one before it in its cycle.
class BorderWalker {
 public:
  BorderWalker(const Map& map, const MapEdges& edges) : map_(map), edges_(edges) {
    corner_of_.resize(edges.halfedge_count());
    for (std::uint32_t i = 0; i < edges.at_corner.size(); ++i) {
      corner_of_[edges.at_corner[i]] = i;
    }
  }

  // The unlisted half-edge that follows `missing`: turn around its target through the listed faces
  // until the next border.
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
  std::vector<std::uint32_t> corner_of_;  // per listed half-edge
};

}  // namespace

std::vector<std::uint32_t> cycle_of_chain(const MapEdges& edges, const OpenChain& chain) {
  std::vector<std::uint32_t> cycle;
  cycle.reserve(chain.halfedges.size());
  for (const std::uint32_t h : chain.halfedges) cycle.push_back(edges.origin(h));
  return cycle;
}

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
