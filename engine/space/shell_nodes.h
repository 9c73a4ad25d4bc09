// Which sides of facets, free edges and vertices bound one volume without a gap: the classes that
// volumes and shells are made of.
//
// Nodes: side s of facet f is 2f + s (0: the positive one); the only face of the map of a vertex v without
// facets around it is 2F + v. Two nodes are joined where they meet at an edge or in one face of a sphere map.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/union_find.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_complex.h"

namespace plumb {

class ShellNodes {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Joins everything. Volumes are not looked at. O(n alpha(n)), and a sphere map for each vertex
  /// whose map is not connected. `connected` as for label_volumes().
  explicit ShellNodes(const SpaceComplex& complex, std::span<const std::uint8_t> connected = {});

  std::size_t size() const { return classes_.size(); }
  std::uint32_t root(std::uint32_t node) { return classes_.root(node); }
  void unite(std::uint32_t i, std::uint32_t j) { classes_.unite(i, j); }

  static std::uint32_t facet_node(FacetId f, bool is_negative_side) {
    return 2 * f.value() + (is_negative_side ? 1 : 0);
  }
  std::uint32_t vertex_node(VertexId v) const {
    return static_cast<std::uint32_t>(2 * complex_.facet_count()) + v.value();
  }
  /// The node around an edge without uses; kNone for others.
  std::uint32_t free_node(EdgeId e) const { return free_node_[e.value()]; }
  /// In radial order.
  std::uint32_t node_after(UseId u) const {
    const HalfedgeId h = complex_.use_halfedge[u.value()];
    return facet_node(complex_.use_facet[u.value()], SpaceComplex::is_reverse(h));
  }
  std::uint32_t node_before(UseId u) const { return node_after(u) ^ 1U; }

  /// A node for each face of the map of an item; a face without arcs has the item's own.
  void face_nodes(const LocalMap& local, SpaceItem item, std::vector<std::uint32_t>& node) const;

 private:
  void join_around_edges();
  std::vector<VertexId> irregular_vertices(std::span<const std::uint8_t> connected) const;
  void join_at_irregular_vertices(std::span<const std::uint8_t> connected);

  const SpaceComplex& complex_;
  UnionFind classes_;
  std::vector<std::uint32_t> free_node_;
};

}  // namespace plumb
