#include "plumb/space/canonical_order.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "plumb/predicates/point3_signs.h"

namespace plumb {
namespace {

class Ordering {
 public:
  Ordering(const SpaceComplex& complex, Context& context) : c_(complex), context_(context) {}

  CanonicalOrder run() && {
    order_vertices();
    order_edges();
    order_facets();
    order_uses();
    order_volumes();
    return std::move(order_);
  }

 private:
  void order_vertices();
  void order_edges();
  void order_facets();
  void order_uses();
  void order_volumes();

  /// Where the boundary of a facet is at its least vertex. No other facet is at the same corner: it is neither straight
  /// nor a full turn, because all of the facet follows the vertex, so it lies in one plane and on one side in it.
  struct Corner {
    VertexId vertex;
    VertexId to;
    VertexId from;
    friend auto operator<=>(const Corner&, const Corner&) = default;
  };
  Corner corner(UseId u) const {
    const UseId before = c_.use_prev[u.value()];
    return {order_.vertices(c_.use_origin(u)),
            order_.vertices(c_.target(c_.use_halfedge[u.value()])),
            order_.vertices(c_.use_origin(before))};
  }
  Corner least_corner(FacetId f) const {
    const UseId first = c_.cycles_of(f).front();
    Corner least = corner(first);
    for (UseId u = c_.use_next[first.value()]; u != first; u = c_.use_next[u.value()]) {
      least = std::min(least, corner(u));
    }
    return least;
  }
  /// The use of its cycle with the least half-edge.
  std::pair<HalfedgeId, UseId> start_of_cycle(UseId first) const {
    std::pair least{order_.halfedge(c_, c_.use_halfedge[first.value()]), first};
    for (UseId u = c_.use_next[first.value()]; u != first; u = c_.use_next[u.value()]) {
      least = std::min(least, {order_.halfedge(c_, c_.use_halfedge[u.value()]), u});
    }
    return least;
  }
  void append(VolumeId v) {
    if (v.is_valid() && !order_.volumes.has(v)) order_.volumes.append(v);
  }

  const SpaceComplex& c_;
  Context& context_;
  CanonicalOrder order_;
};

void Ordering::order_vertices() {
  const std::size_t n = c_.vertex_count();
  std::vector<std::uint32_t> vertices(n);
  std::iota(vertices.begin(), vertices.end(), 0U);
  std::uint64_t compared = 0;
  std::sort(vertices.begin(), vertices.end(), [&](std::uint32_t v, std::uint32_t w) {
    if (++compared % 4096 == 0) context_.checkpoint("order of vertices", 0, 0);
    return compare_xyz(c_.points(), c_.vertex_point[v], c_.vertex_point[w]) == Sign::Negative;
  });
  order_.vertices = NewOrder<VertexId>(n);
  for (const std::uint32_t v : vertices) order_.vertices.append(VertexId(v));
}

void Ordering::order_edges() {
  context_.checkpoint("order of edges", 1, 5);
  using Ends = std::array<VertexId, 2>;
  std::vector<std::pair<Ends, EdgeId>> edges;
  edges.reserve(c_.edge_count());
  for (std::size_t e = 0; e < c_.edge_count(); ++e) {
    const VertexId v = order_.vertices(c_.origin[2 * e]), w = order_.vertices(c_.origin[2 * e + 1]);
    edges.emplace_back(Ends{std::min(v, w), std::max(v, w)}, EdgeId(e));
  }
  std::sort(edges.begin(), edges.end());
  order_.edges = NewOrder<EdgeId>(edges.size());
  for (const auto& [ends, e] : edges) order_.edges.append(e);
}

void Ordering::order_facets() {
  context_.checkpoint("order of facets", 2, 5);
  std::vector<std::pair<Corner, FacetId>> facets;
  facets.reserve(c_.facet_count());
  for (std::size_t f = 0; f < c_.facet_count(); ++f) {
    facets.emplace_back(least_corner(FacetId(f)), FacetId(f));
  }
  std::sort(facets.begin(), facets.end());
  order_.facets = NewOrder<FacetId>(facets.size());
  for (const auto& [corner, f] : facets) order_.facets.append(f);
}

void Ordering::order_uses() {
  context_.checkpoint("order of uses", 3, 5);
  order_.uses = NewOrder<UseId>(c_.use_count());
  order_.cycles.reserve(c_.cycle.size());
  std::vector<std::pair<HalfedgeId, UseId>> starts;
  for (const FacetId f : order_.facets.ids()) {
    starts.clear();
    for (const UseId first : c_.cycles_of(f)) starts.push_back(start_of_cycle(first));
    std::sort(starts.begin() + 1, starts.end());  // the outer cycle stays the first
    for (const auto& [h, start] : starts) {
      order_.cycles.push_back(start);
      UseId u = start;
      do {
        order_.uses.append(u);
        u = c_.use_next[u.value()];
      } while (u != start);
    }
  }
}

void Ordering::order_volumes() {
  context_.checkpoint("order of volumes", 4, 5);
  order_.volumes = NewOrder<VolumeId>(c_.volume_count());
  append(VolumeId(0));
  for (const FacetId f : order_.facets.ids()) {
    for (const VolumeId v : c_.facet_volume[f.value()]) append(v);
  }
  for (const EdgeId e : order_.edges.ids()) append(c_.edge_volume[e.value()]);
  for (const VertexId v : order_.vertices.ids()) append(c_.vertex_volume[v.value()]);
}

}  // namespace

CanonicalOrder canonical_order(const SpaceComplex& complex, Context& context) {
  return Ordering(complex, context).run();
}

}  // namespace plumb
