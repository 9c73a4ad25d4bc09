#include "plumb/space/meet_leaves.h"

#include <algorithm>

#include "plumb/space/facet_slabs.h"
#include "plumb/space/space_boxes.h"

namespace plumb {

// ---------------------------------------------------------------- leaves

MeetLeaves::MeetLeaves(const SpaceComplex& complex, const Box3& reach)
    : complex_(complex), reach_(reach) {
  for (std::size_t f = 0; f < complex.facet_count(); ++f) add_facet(FacetId(f));
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.edge_use[e].is_valid()) continue;
    add({FacetId(), EdgeId(e), UseId(), 0}, box_of(complex, EdgeId(e)));
  }
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    if (!complex.star_of(VertexId(v)).empty()) continue;
    add({FacetId(), VertexId(v), UseId(), 0}, box_of(complex, VertexId(v)));
  }
}

// Everything of a facet lies within the box of its outer cycle.
void MeetLeaves::add_facet(FacetId f) {
  const std::span<const UseId> cycles = complex_.cycles_of(f);
  if (cycles.empty()) return;
  Box3 box;
  std::uint32_t corners = 0;
  UseId u = cycles.front();
  do {
    box.add(box_of(complex_, complex_.use_origin(u)));
    ++corners;
    u = complex_.use_next[u.value()];
  } while (u != cycles.front());
  if (!box.meets(reach_)) return;
  if (cycles.size() == 1 && corners <= LeafItems::kMostCorners) {
    return add({f, SpaceItem(), u, corners}, box);
  }
  add({f, SpaceItem(), UseId(), 0}, box);
  corners = 0;
  for (const UseId first : cycles) corners += add_corners(first);
  if (corners > FacetSites::kFewCorners) large_facets_.push_back(f);
}

/// Returns how many there are, whether their own or not.
std::uint32_t MeetLeaves::add_corners(UseId first) {
  LeafItems items;
  std::uint32_t count = 0;
  UseId u = first;
  do {
    MeetLeaf leaf{FacetId(), SpaceItem(), u, 0};
    Box3 box = box_of(complex_, complex_.use_origin(u));
    do {
      u = complex_.use_next[u.value()];
      box.add(box_of(complex_, complex_.use_origin(u)));
      ++leaf.count;
    } while (u != first && leaf.count < LeafItems::kMostCorners);
    count += leaf.count;
    items.fill(complex_, leaf);
    if (!items.vertices().empty()) add(leaf, box);  // else all of it belongs to neighbours
  } while (u != first);
  return count;
}

void MeetLeaves::add(const MeetLeaf& leaf, const Box3& box) {
  if (!box.meets(reach_)) return;
  leaves_.push_back(leaf);
  boxes_.push_back(box);
}

// ---------------------------------------------------------------- items of a leaf

namespace {

bool is_flat(const SpaceComplex& complex, UseId u) {
  const PlaneId plane = complex.facet_plane[complex.use_facet[u.value()].value()];
  for (UseId v = complex.use_radial[u.value()]; v != u; v = complex.use_radial[v.value()]) {
    if (complex.facet_plane[complex.use_facet[v.value()].value()] != plane) return false;
  }
  return true;
}

/// The use that begins at the vertex and in whose leaf it is; not valid: it has free edges only.
UseId owner(const SpaceComplex& complex, VertexId v) {
  for (const HalfedgeId h : complex.star_of(v)) {
    const UseId u = complex.edge_use[SpaceComplex::edge_of(h).value()];
    if (!u.is_valid()) continue;
    return complex.use_halfedge[u.value()] == h ? u : complex.use_next[u.value()];
  }
  return UseId();
}

}  // namespace

void LeafItems::fill(const SpaceComplex& complex, const MeetLeaf& leaf) {
  own_ = vertex_count_ = edge_count_ = 0;
  has_flat_edges_ = false;
  if (leaf.bare.is_valid()) return take_bare(complex, leaf.bare);
  UseId u = leaf.first;
  for (std::uint32_t i = 0; i < leaf.count; ++i, u = complex.use_next[u.value()]) {
    const VertexId v = complex.use_origin(u);
    if (owner(complex, v) == u) take_vertex(v);
  }
  u = leaf.first;
  for (std::uint32_t i = 0; i < leaf.count; ++i, u = complex.use_next[u.value()]) {
    const EdgeId e = SpaceComplex::edge_of(complex.use_halfedge[u.value()]);
    if (complex.edge_use[e.value()] == u) take_edge(complex, e, is_flat(complex, u));
  }
}

void LeafItems::take_bare(const SpaceComplex& complex, SpaceItem bare) {
  if (bare.kind() == SpaceItem::Kind::Vertex) return take_vertex(bare.vertex());
  for (const std::uint32_t h : {2 * bare.index(), 2 * bare.index() + 1}) {
    const VertexId v = complex.origin[h];
    const bool is_own = complex.star_of(v).front() == HalfedgeId(h);
    if (is_own && !owner(complex, v).is_valid()) take_vertex(v);
  }
  take_edge(complex, bare.edge(), true);
}

void LeafItems::take_vertex(VertexId v) {
  vertices_[vertex_count_++] = v;
  ++own_;
}

void LeafItems::take_edge(const SpaceComplex& complex, EdgeId e, bool is_flat) {
  const std::uint8_t from = place_of(complex.origin[2 * e.value()]);
  const std::uint8_t to = place_of(complex.origin[2 * e.value() + 1]);
  edges_[edge_count_++] = {e, from, to, is_flat};
  has_flat_edges_ |= is_flat;
}

std::uint8_t LeafItems::place_of(VertexId v) {
  const auto known = vertices();
  const auto place = static_cast<std::size_t>(std::ranges::find(known, v) - known.begin());
  if (place == vertex_count_) vertices_[vertex_count_++] = v;
  return static_cast<std::uint8_t>(place);
}

}  // namespace plumb
