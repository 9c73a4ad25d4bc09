#include "plumb/space/meet_leaves.h"

#include <algorithm>

#include "plumb/space/facet_slabs.h"
#include "plumb/space/space_boxes.h"

namespace plumb {

MeetLeaves::MeetLeaves(const SpaceComplex& complex, const Box3& reach)
    : complex_(complex), reach_(reach), is_taken_(complex.vertex_count()) {
  for (std::size_t f = 0; f < complex.facet_count(); ++f) add_facet(FacetId(f));
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (!complex.edge_use[e].is_valid()) add_free_edge(EdgeId(e));
  }
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    if (complex.star_of(VertexId(v)).empty()) add_vertex(VertexId(v));
  }
  open(FacetId(), true);  // the end of the last
}

// Everything of a facet lies within the box of its outer cycle.
void MeetLeaves::add_facet(FacetId f) {
  Box3 box;
  uses_.clear();
  for (const UseId first : complex_.cycles_of(f)) {
    const bool is_outer = uses_.empty();
    UseId u = first;
    do {
      if (is_outer) box.add(box_of(complex_, complex_.use_origin(u)));
      uses_.push_back(u);
      u = complex_.use_next[u.value()];
    } while (u != first);
    if (is_outer && !is_in_reach(box)) return;
  }
  if (uses_.size() > FacetSites::kFewCorners) large_facets_.push_back(f);
  open(f, false);
  if (uses_.size() <= kMostCorners) take_corners(uses_);
  close(box);
  if (uses_.size() > kMostCorners) add_corners_of_large_facet();
}

void MeetLeaves::add_corners_of_large_facet() {
  for (std::size_t i = 0; i < uses_.size(); i += kMostCorners) {
    open(FacetId(), false);
    take_corners(std::span(uses_).subspan(i, std::min(kMostCorners, uses_.size() - i)));
    Box3 box;
    for (const VertexId v : std::span(vertices_).subspan(leaves_.back().vertex_begin)) {
      box.add(box_of(complex_, v));
    }
    close(box);
  }
}

void MeetLeaves::add_free_edge(EdgeId e) {
  open(FacetId(), true);
  take_vertex(complex_.origin[2 * e.value()]);
  take_vertex(complex_.origin[2 * e.value() + 1]);
  take_edge(e, true);
  close(box_of(complex_, e));
}

void MeetLeaves::add_vertex(VertexId v) {
  open(FacetId(), true);
  take_vertex(v);
  close(box_of(complex_, v));
}

void MeetLeaves::open(FacetId facet, bool is_bare) {
  leaves_.push_back({facet, static_cast<std::uint32_t>(vertices_.size()),
                     static_cast<std::uint32_t>(edges_.size()), 0, is_bare, false});
}

/// Drops what is empty or out of reach.
void MeetLeaves::close(const Box3& box) {
  const MeetLeaf& leaf = leaves_.back();
  const bool is_empty = !leaf.facet.is_valid() && vertices_.size() == leaf.vertex_begin;
  if (!is_empty && is_in_reach(box)) return boxes_.push_back(box);
  vertices_.resize(leaf.vertex_begin);
  edges_.resize(leaf.edge_begin);
  leaves_.pop_back();
}

/// Its own vertices first, then the ends of its edges.
void MeetLeaves::take_corners(std::span<const UseId> uses) {
  for (const UseId u : uses) take_vertex(complex_.use_origin(u));
  for (const UseId u : uses) {
    const EdgeId e = SpaceComplex::edge_of(complex_.use_halfedge[u.value()]);
    if (complex_.edge_use[e.value()] == u) take_edge(e, is_flat(u));
  }
}

void MeetLeaves::take_vertex(VertexId v) {
  if (is_taken_[v.value()]) return;
  is_taken_[v.value()] = true;
  vertices_.push_back(v);
  ++leaves_.back().own;
}

void MeetLeaves::take_edge(EdgeId e, bool is_flat) {
  const std::uint8_t from = place_of(complex_.origin[2 * e.value()]);
  const std::uint8_t to = place_of(complex_.origin[2 * e.value() + 1]);
  edges_.push_back({e, from, to, is_flat});
  leaves_.back().has_flat_edges |= is_flat;
}

std::uint8_t MeetLeaves::place_of(VertexId v) {
  const auto begin = vertices_.begin() + leaves_.back().vertex_begin;
  const auto at = std::find(begin, vertices_.end(), v);
  const auto place = static_cast<std::uint8_t>(at - begin);
  if (at == vertices_.end()) vertices_.push_back(v);
  return place;
}

bool MeetLeaves::is_flat(UseId u) const {
  const PlaneId plane = complex_.facet_plane[complex_.use_facet[u.value()].value()];
  for (UseId v = complex_.use_radial[u.value()]; v != u; v = complex_.use_radial[v.value()]) {
    if (complex_.facet_plane[complex_.use_facet[v.value()].value()] != plane) return false;
  }
  return true;
}

}  // namespace plumb
