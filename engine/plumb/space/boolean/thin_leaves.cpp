// Triangles that cover leaves: the surface of a facet lies within its outer cycle, and a cycle is
// covered by the triangles of its first corner and each of its edges, because the signed sum of
// their windings is 1 inside. Other leaves are edges and vertices, which are triangles without
// area.
//
// Tested by tests/space/find_contacts_test.cpp.
#include "plumb/space/boolean/thin_leaves.h"

namespace plumb {

ThinLeaves::ThinLeaves(const ContactLeaves& leaves, const std::function<void()>& on_step)
    : triangles_(cover(leaves)), tree_(triangles_.corners, {}, on_step) {
  triangles_.corners = std::vector<OrientedBoxTree::Triangle>();  // The memory is released here.
}

ThinLeaves::Triangles ThinLeaves::cover(const ContactLeaves& leaves) {
  Triangles triangles;
  for (std::uint32_t i = 0; i < leaves.boxes().size(); ++i) {
    cover_leaf(leaves.complex(), leaves[i], i, triangles);
  }
  return triangles;
}

void ThinLeaves::cover_leaf(const SpaceComplex& complex, const ContactLeaf& leaf,
                            std::uint32_t number, Triangles& triangles) {
  const auto add = [&](VertexId a, VertexId b, VertexId c) {
    const auto box = [&](VertexId v) { return complex.points().box(complex.vertex_point[v]); };
    triangles.corners.push_back({box(a), box(b), box(c)});
    triangles.leaf.push_back(number);
  };
  const auto origin = [&](UseId u) { return complex.use_origin(u); };
  if (leaf.bare.kind() == SpaceItem::Kind::Vertex) {
    const VertexId v = leaf.bare.vertex();
    add(v, v, v);
  } else if (leaf.bare.kind() == SpaceItem::Kind::Edge) {
    const HalfedgeId h(2 * std::size_t{leaf.bare.index()});
    add(complex.origin[h], complex.target(h), complex.target(h));
  } else if (leaf.facet.is_valid()) {
    const UseId first = complex.cycles_of(leaf.facet).front();
    UseId u = complex.use_next[first];
    do {
      const UseId after = complex.use_next[u];
      add(origin(first), origin(u), origin(after));
      u = after;
    } while (complex.use_next[u] != first && u != first);
  } else {
    UseId u = leaf.first;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const UseId after = complex.use_next[u];
      add(origin(u), origin(after), origin(after));
      u = after;
    }
  }
}

// A facet of n corners has at most n triangles for its surface and n edges in leaves of corners.
std::size_t count_thin_triangles(const SpaceComplex& complex) {
  return 2 * complex.use_count() + complex.edge_count() + complex.vertex_count();
}

}  // namespace plumb
