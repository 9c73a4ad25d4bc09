#include "plumb/space/shell_nodes.h"

namespace plumb {

ShellNodes::ShellNodes(const SpaceComplex& complex, std::span<const std::uint8_t> connected)
    : complex_(complex),
      classes_(2 * complex.facet_count() + complex.vertex_count()),
      free_node_(complex.edge_count(), kNone) {
  join_around_edges();
  join_at_irregular_vertices(connected);
}

void ShellNodes::join_around_edges() {
  for (std::uint32_t u = 0; u < complex_.use_count(); ++u) {
    classes_.unite(node_after(UseId(u)), node_before(complex_.use_radial[u]));
  }
}

namespace {

/// How many corners follow each other around the vertex from `first` on, each beyond an edge of two facets. More
/// than `most`: not known.
std::size_t count_corners(const SpaceComplex& complex, UseId first, std::size_t most) {
  std::size_t count = 0;
  UseId corner = first;
  // The edge to leave the corner by: that of its use, or else the one before.
  HalfedgeId over = complex.use_halfedge[corner.value()];
  do {
    const UseId own =
        complex.use_halfedge[corner.value()] == over ? corner : complex.use_prev[corner.value()];
    const UseId other = complex.use_radial[own.value()];
    if (complex.use_radial[other.value()] != own || other == own || ++count > most) return most + 1;
    const bool leaves = complex.use_halfedge[other.value()] == over;
    corner = leaves ? other : complex.use_next[other.value()];
    const HalfedgeId at_end = complex.use_halfedge[corner.value()];
    over = leaves
               ? SpaceComplex::twin(complex.use_halfedge[complex.use_prev[corner.value()].value()])
               : at_end;
  } while (corner != first);
  return count;
}

/// Do the corners make one ring that all edges are on? (Nearly always; else they may still hang together.)
bool has_one_ring(const SpaceComplex& complex, VertexId v) {
  const auto star = complex.star_of(v);
  if (star.empty() || complex.vertex_facet[v.value()].is_valid()) return false;
  const UseId use = complex.edge_use[star[0].value() / 2];
  if (!use.is_valid()) return false;
  const UseId corner =
      complex.use_halfedge[use.value()] == star[0] ? use : complex.use_next[use.value()];
  return count_corners(complex, corner, star.size()) == star.size();
}

}  // namespace

/// Vertices whose sphere map is not connected, has a loop or points without arcs.
std::vector<VertexId> ShellNodes::irregular_vertices(
    std::span<const std::uint8_t> connected) const {
  std::vector<VertexId> doubtful, irregular;
  for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
    if (!connected.empty() && connected[v] != 0) continue;
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

void ShellNodes::join_at_irregular_vertices(std::span<const std::uint8_t> connected) {
  LocalMap local;
  std::vector<std::uint32_t> node;
  for (const VertexId v : irregular_vertices(connected)) {
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
