#include "plumb/space/boolean/vertex_carrier.h"

#include <algorithm>

namespace plumb {

namespace {

constexpr std::uint32_t kNone = SphereMap::kNone;

}  // namespace

void VertexCarrier::start(SpaceDraft& draft) {
  for (const HalfedgeId h : carried_) point_of_[h.value()] = kNone;
  carried_.clear();
  draft_ = &draft;
}

void VertexCarrier::face_ends() {
  for (const HalfedgeId h : carried_) {
    draft_->twin[point_of_[h.value()]] = point_of_[SpaceComplex::twin(h).value()];
  }
}

void VertexCarrier::add(VertexId v, const LocalMap& local) {
  origin_ids_.clear();
  for (const FacetId f : local.facet) origin_ids_.push_back(complex_.facet_origin[f.value()]);
  const auto offsets = draft_->add(complex_.vertex_point[v.value()], local.map, false, origin_ids_);
  for (std::uint32_t i = 0; i < local.halfedge.size(); ++i) {
    carried_.push_back(local.halfedge[i]);
    point_of_[local.halfedge[i].value()] = offsets.point + i;
  }
}

void VertexCarrier::add_simplified(VertexId v, LocalMap& local) {
  overlay_.simplify(local.map, &kept_);
  const PyramidKind kind = classify(complex_.planes(), local.map);
  if (kind != PyramidKind::Vertex && kind != PyramidKind::Edge) return;
  origin_ids_.clear();
  for (const auto& cells : kept_.arc) {
    origin_ids_.push_back(complex_.facet_origin[local.facet[cells[0].index()].value()]);
  }
  const auto offsets = draft_->add(complex_.vertex_point[v.value()], local.map,
                                   kind == PyramidKind::Edge, origin_ids_);
  for (std::uint32_t i = 0; i < local.map.point_count(); ++i) {
    carried_.push_back(local.halfedge[kept_.point[i][0].index()]);
    point_of_[carried_.back().value()] = offsets.point + i;
  }
}

// ---------------------------------------------------------------- rings

bool VertexCarrier::may_have_ring(VertexId v) const {
  const std::span<const HalfedgeId> star = complex_.star_of(v);
  if (star.empty() || complex_.vertex_facet[v.value()].is_valid()) return false;
  return std::ranges::all_of(star, [this](HalfedgeId h) {
    const UseId first = complex_.edge_use[h.value() / 2];
    if (!first.is_valid()) return false;
    const UseId second = complex_.use_radial[first.value()];
    return second != first && complex_.use_radial[second.value()] == first;
  });
}

std::size_t VertexCarrier::add_rings(std::span<const Remarked> vertices) {
  if (vertices.empty()) return 0;
  const auto first = static_cast<std::uint32_t>(draft_->vertex_count());
  SpaceDraft::Offsets at = draft_->end();
  std::size_t degrees = 0;
  for (const Remarked& r : vertices) degrees += complex_.star_of(r.vertex).size();
  draft_->resize(first + vertices.size(), at.point + degrees, at.arc + degrees,
                 at.face + 2 * vertices.size());
  arc_of_use_.resize(complex_.use_count());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    if (!write_ring(vertices[i], first + i, at)) {
      draft_->resize(first + i, at.point, at.arc, at.face);
      return i;
    }
    const auto degree = static_cast<std::uint32_t>(complex_.star_of(vertices[i].vertex).size());
    at = {at.point + degree, at.arc + degree, at.face + 2};
  }
  return vertices.size();
}

/// As local_map() numbers them: points in the order of the star, arcs by the point at which their
/// use begins, the face to the left of the first half-arc before the other one. False: there are
/// several rings, and nothing is carried.
bool VertexCarrier::write_ring(const Remarked& remarked, std::uint32_t vertex,
                               const SpaceDraft::Offsets& at) {
  const auto& [v, becomes] = remarked;
  const std::span<const HalfedgeId> star = complex_.star_of(v);
  SpaceDraft& draft = *draft_;
  draft.vertex_point[vertex] = complex_.vertex_point[v.value()];
  draft.vertex_mark[vertex] = becomes[complex_.vertex_mark[v.value()]];
  draft.begin[vertex] = at;
  std::uint32_t point = at.point, arc = at.arc;
  for (const HalfedgeId h : star) {
    draft.maps.direction[point] = direction_of(complex_, h);
    draft.maps.point_mark[point] = becomes[complex_.edge_mark[h.value() / 2]];
    draft.vertex_of_point[point] = VertexId(vertex);
    ++point;
    for (const UseId u : two_uses(h)) {
      if (complex_.use_halfedge[u.value()] != h) continue;
      const std::uint32_t f = complex_.use_facet[u.value()].value();
      draft.maps.circle[arc] = complex_.facet_plane[f];
      draft.maps.arc_mark[arc] = becomes[complex_.facet_mark[f]];
      draft.arc_origin[arc] = complex_.facet_origin[f];
      if (arc == at.arc) write_face_marks(FacetId(f), becomes, at.face);
      arc_of_use_[u.value()] = arc++;
    }
  }
  if (!link_ring(star, at)) return false;
  for (std::uint32_t i = 0; i < star.size(); ++i) {
    carried_.push_back(star[i]);
    point_of_[star[i].value()] = at.point + i;
  }
  return true;
}

void VertexCarrier::write_face_marks(FacetId of_first_arc, const std::array<Mark, 3>& becomes,
                                     std::uint32_t face) {
  const auto& [positive, negative] = complex_.facet_volume[of_first_arc.value()];
  draft_->maps.face_mark[face] = becomes[complex_.volume_mark[positive.value()]];
  draft_->maps.face_mark[face + 1] = becomes[complex_.volume_mark[negative.value()]];
}

/// False: the face to the left of the first half-arc does not have one of every arc.
bool VertexCarrier::link_ring(std::span<const HalfedgeId> star, const SpaceDraft::Offsets& at) {
  SphereMap& maps = draft_->maps;
  std::uint32_t point = at.point;
  for (const HalfedgeId h : star) {
    const auto uses = two_uses(h);
    const std::uint32_t x = half_arc(uses[0], h), y = half_arc(uses[1], h);
    maps.origin[x] = maps.origin[y] = point;
    maps.next[SphereMap::twin(x)] = y;
    maps.next[SphereMap::twin(y)] = x;
    maps.first_out[point++] = SpaceComplex::is_reverse(h) ? y : x;
  }
  const std::uint32_t first = 2 * at.arc;
  std::fill_n(maps.face.begin() + first, 2 * star.size(), at.face + 1);
  std::uint32_t half = first;
  std::size_t length = 0;
  do {
    maps.face[half] = at.face;
    half = maps.next[half];
    ++length;
  } while (half != first);
  return length == star.size();
}

std::array<UseId, 2> VertexCarrier::two_uses(HalfedgeId h) const {
  const UseId first = complex_.edge_use[h.value() / 2];
  return {first, complex_.use_radial[first.value()]};
}

/// The one that leaves along h in the facet of u.
std::uint32_t VertexCarrier::half_arc(UseId u, HalfedgeId h) const {
  if (complex_.use_halfedge[u.value()] == h) return 2 * arc_of_use_[u.value()];
  return 2 * arc_of_use_[complex_.use_next[u.value()].value()] + 1;
}

}  // namespace plumb
