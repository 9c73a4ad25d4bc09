#include "plumb/space/shell_nodes.h"

namespace plumb {

ShellNodes::ShellNodes(const SpaceComplex& complex)
    : complex_(complex),
      classes_(2 * complex.facet_count() + complex.vertex_count()),
      free_node_(complex.edge_count(), kNone) {
  join_around_edges();
  join_at_irregular_vertices();
}

void ShellNodes::join_around_edges() {
  for (std::uint32_t u = 0; u < complex_.use_count(); ++u) {
    classes_.unite(node_after(UseId(u)), node_before(complex_.use_radial[u]));
  }
}

/// Vertices whose sphere map is not connected, has a loop or points without arcs.
std::vector<VertexId> ShellNodes::irregular_vertices() const {
  std::vector<VertexId> doubtful, irregular;
  for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
    if (!has_one_ring(complex_, VertexId(v))) doubtful.push_back(VertexId(v));
  }
  if (doubtful.empty()) return irregular;
  UnionFind link(complex_.origin.size());  // half-edges of one vertex, joined by corners
  for (std::uint32_t u = 0; u < complex_.use_count(); ++u) {
    const HalfedgeId back = SpaceComplex::twin(complex_.use_halfedge[complex_.use_prev[u].value()]);
    link.unite(complex_.use_halfedge[u].value(), back.value());
  }
  for (const VertexId v : doubtful) {
    const auto star = complex_.star_of(v);
    bool is_regular = !star.empty() && !complex_.vertex_facet[v.value()].is_valid() &&
                      complex_.edge_use[star[0].value() / 2].is_valid();
    for (std::size_t i = 1; i < star.size() && is_regular; ++i) {
      is_regular = link.root(star[i].value()) == link.root(star[0].value());
    }
    if (!is_regular) irregular.push_back(v);
  }
  return irregular;
}

void ShellNodes::face_nodes(const LocalMap& local, SpaceItem item,
                            std::vector<std::uint32_t>& node) const {
  std::uint32_t own = kNone;
  if (item.kind() == SpaceItem::Kind::Vertex) own = vertex_node(item.vertex());
  if (item.kind() == SpaceItem::Kind::Edge) own = free_node(item.edge());
  node.assign(local.map.face_count(), own);
  for (std::uint32_t h = 0; h < local.map.face.size(); ++h) {
    node[local.map.face[h]] = facet_node(local.facet[h / 2], (h & 1U) != 0);
  }
}

void ShellNodes::join_at_irregular_vertices() {
  LocalMap local;
  std::vector<std::uint32_t> node;
  for (const VertexId v : irregular_vertices()) {
    local_map(complex_, v, local);
    face_nodes(local, v, node);
    for (std::uint32_t h = 0; h < local.map.face.size(); ++h) {
      classes_.unite(node[local.map.face[h]], facet_node(local.facet[h / 2], (h & 1U) != 0));
    }
    for (std::size_t i = 0; i < local.halfedge.size(); ++i) {
      if (local.map.first_out[i] != SphereMap::kNone) continue;
      std::uint32_t& known = free_node_[local.halfedge[i].value() / 2];
      const std::uint32_t here = node[local.map.point_face[i]];
      if (known == kNone) known = here;
      classes_.unite(known, here);
    }
  }
}

}  // namespace plumb
