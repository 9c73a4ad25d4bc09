// Location of vertices by flooding, and carrying vertices into a draft.
//
// An edge without a contact inside lies, up to its other end, in the volume in which one end lies
// (docs/design/boolean.md, Lemma 4). So labels spread over such edges without arithmetic. They
// start at contacts, where the sphere map of the other operand is asked for the face into which an
// edge leaves; or at the contact that is nearest to a vertex on one of its edges. A group without
// any contact asks one ray towards -x; the map of the cell that it hits has the volume that lies on
// the side from which it came, direction +x, {kPlaneY, kPlaneZ}.
//
// Invariant: every vertex gets a label once, and a group is collected only while it has no label;
// so all floods together cost O(vertices + edges). The locator for rays is built for the first
// group that needs it.
//
// Tested by tests/space/nef3_property_test.cpp and tests/space/degenerate_families_test.cpp.

#include "plumb/space/boolean/vertex_labels.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_locator.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

namespace {

/// Returns the cell of operand 0 or 1.
SpaceItem item_of(const Contact& c, std::size_t operand) { return operand == 0 ? c.a : c.b; }

/// The search for the labels of one operand.
class Labels {
 public:
  Labels(const TouchedComplex& own, const SpaceComplex& other, std::span<const Contact> contacts,
         std::size_t operand, const SpaceTables& tables, Context& context)
      : own_(own),
        complex_(own.complex),
        other_(other),
        contacts_(contacts),
        operand_(operand),
        tables_(tables),
        context_(context),
        label_(own.complex.vertex_count()) {}

  IdVector<VertexId, VolumeId> run() {
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      if (own_.is_touched(VertexId(v))) seed_around(VertexId(v));
    }
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      if (v % 4096 == 0) context_.checkpoint("locate", v, complex_.vertex_count());
      if (!own_.is_touched(VertexId(v)) && !label_[v].is_valid()) label_group(VertexId(v));
    }
    return std::move(label_);
  }

 private:
  /// Whether the vertex has no contact and no label yet.
  bool needs_label(VertexId v) const { return !own_.is_touched(v) && !label_[v].is_valid(); }

  /// Returns the volume of the other operand that a half-edge enters when it leaves a contact. The
  /// half-edge enters a face of the map. If it left along an arc or a point, it would lie in a
  /// facet or an edge of the other operand, and the next vertex or place along it would have a
  /// contact.
  VolumeId volume_along(const Contact& contact, HalfedgeId h) {
    local_map(other_, item_of(contact, 1 - operand_), local_);
    const SphereCell cell = locate(tables_.planes, local_.map, direction_of(complex_, h));
    PLUMB_CHECK(cell.kind() == SphereCell::Kind::Face);
    return local_.volume[cell.index()];
  }

  /// Floods from the neighbours of a vertex with a contact.
  void seed_around(VertexId touched) {
    for (const HalfedgeId h : complex_.star_of(touched)) {
      const VertexId v = complex_.target(h);
      if (own_.is_touched(SpaceComplex::edge_of(h)) || !needs_label(v)) continue;
      flood(v, volume_along(contacts_[own_.contact_of_vertex[touched]], h));
    }
  }

  /// Gives the whole group of `start` a label.
  void flood(VertexId start, VolumeId volume) {
    collect(start);
    for (const VertexId v : group_) label_[v] = volume;
  }

  /// Collects in group_ all vertices without a label that are connected with `start` by edges
  /// without contacts.
  void collect(VertexId start) {
    group_.assign(1, start);
    if (in_group_.empty()) in_group_.assign(complex_.vertex_count(), 0);
    in_group_[start] = 1;
    for (std::size_t i = 0; i < group_.size(); ++i) {
      for (const HalfedgeId h : complex_.star_of(group_[i])) {
        const VertexId v = complex_.target(h);
        if (own_.is_touched(SpaceComplex::edge_of(h)) || !needs_label(v)) continue;
        if (in_group_[v] != 0) continue;
        in_group_[v] = 1;
        group_.push_back(v);
      }
    }
  }

  /// Labels a group that has no label from a contact at a vertex. The label is found by a contact
  /// on an edge that leaves the group, or otherwise by a ray.
  void label_group(VertexId start) {
    collect(start);
    VolumeId volume;
    for (const VertexId v : group_) {
      volume = volume_by_contact(v);
      if (volume.is_valid()) break;
    }
    if (!volume.is_valid()) volume = volume_by_ray(start);
    for (const VertexId v : group_) label_[v] = volume;
  }

  /// Returns the volume before the nearest contact on an edge that leaves v, or an invalid id if no
  /// such edge has a contact.
  VolumeId volume_by_contact(VertexId v) {
    for (const HalfedgeId h : complex_.star_of(v)) {
      const EdgeId e = SpaceComplex::edge_of(h);
      if (own_.is_touched(e)) return volume_along(nearest_contact(h), SpaceComplex::twin(h));
    }
    return VolumeId();
  }

  /// Returns the first contact on the edge of h, seen from the origin of h.
  const Contact& nearest_contact(HalfedgeId h) const {
    const EdgeId e = SpaceComplex::edge_of(h);
    const auto& planes = complex_.edge_planes[e];
    // A contact is nearer than the best one if it precedes the best one in the direction of h.
    const Sign along = SpaceComplex::is_reverse(h) ? Sign::Negative : Sign::Positive;
    std::uint32_t best = own_.edge_contacts[own_.edge_begin[e]];
    for (std::uint32_t i = own_.edge_begin[e] + 1; i < own_.edge_begin[e.value() + 1]; ++i) {
      const std::uint32_t c = own_.edge_contacts[i];
      const Sign after = order_along_line(tables_.points, planes[0], planes[1],
                                          contacts_[best].point, contacts_[c].point);
      if (after == -along) best = c;
    }
    return contacts_[best];
  }

  /// Returns the volume in which v lies, by a ray towards -x: volume 0 if it hits nothing.
  VolumeId volume_by_ray(VertexId v) {
    if (other_.vertex_count() == 0) return VolumeId(0);
    if (!locator_) locator_.emplace(other_);
    const SpaceItem hit = locator_->shoot_left(complex_.vertex_point[v]);
    if (!hit.is_valid()) return VolumeId(0);
    local_map(other_, hit, local_);
    const SphereCell cell = locate(tables_.planes, local_.map, {kPlaneY, kPlaneZ});
    PLUMB_CHECK(cell.kind() == SphereCell::Kind::Face);
    return local_.volume[cell.index()];
  }

  const TouchedComplex& own_;
  const SpaceComplex& complex_;
  const SpaceComplex& other_;
  std::span<const Contact> contacts_;
  std::size_t operand_;
  const SpaceTables& tables_;
  Context& context_;
  IdVector<VertexId, VolumeId> label_;
  IdVector<VertexId, std::uint8_t> in_group_;
  std::vector<VertexId> group_;
  LocalMap local_;
  std::optional<SpaceLocator> locator_;
};

}  // namespace

TouchedComplex::TouchedComplex(const SpaceComplex& touched, std::span<const Contact> contacts,
                               std::size_t operand)
    : complex(touched),
      contact_of_vertex(touched.vertex_count(), kUntouched),
      edge_begin(touched.edge_count() + 1, 0) {
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const SpaceItem item = item_of(contacts[i], operand);
    if (item.kind() == SpaceItem::Kind::Vertex) contact_of_vertex[item.index()] = i;
    if (item.kind() == SpaceItem::Kind::Edge) ++edge_begin[item.index() + 1];
  }
  // Contacts are sorted by edges in two passes: counts, then places.
  std::partial_sum(edge_begin.begin(), edge_begin.end(), edge_begin.begin());
  edge_contacts.resize(edge_begin.back());
  IdVector<EdgeId, std::uint32_t> at(edge_begin.begin(), edge_begin.end() - 1);
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const SpaceItem item = item_of(contacts[i], operand);
    if (item.kind() == SpaceItem::Kind::Edge) edge_contacts[at[item.index()]++] = i;
  }
}

IdVector<VertexId, VolumeId> label_vertices(const TouchedComplex& own, const SpaceComplex& other,
                                            std::span<const Contact> contacts, std::size_t operand,
                                            const SpaceTables& tables, Context& context) {
  return Labels(own, other, contacts, operand, tables, context).run();
}

// ---------------------------------------------------------------- carrying vertices

void VertexCarrier::start(SpaceDraft& draft) {
  for (const HalfedgeId h : carried_) point_of_[h] = kNone;
  carried_.clear();
  draft_ = &draft;
}

void VertexCarrier::face_ends() {
  for (const HalfedgeId h : carried_) {
    draft_->twin[point_of_[h]] = point_of_[SpaceComplex::twin(h)];
  }
}

void VertexCarrier::add(VertexId v, const LocalMap& local) {
  origin_ids_.clear();
  for (const FacetId f : local.facet) origin_ids_.push_back(complex_.facet_origin[f]);
  const auto offsets = draft_->add(complex_.vertex_point[v], local.map, false, origin_ids_);
  for (std::uint32_t i = 0; i < local.halfedge.size(); ++i) {
    carried_.push_back(local.halfedge[i]);
    point_of_[local.halfedge[i]] = offsets.point + i;
  }
}

// Simplifying renumbers points and arcs. The array kept_ has the old number of each new one.
void VertexCarrier::add_simplified(VertexId v, LocalMap& local) {
  overlay_.simplify(local.map, &kept_);
  const PyramidKind kind = classify(complex_.planes(), local.map);
  if (kind != PyramidKind::Vertex && kind != PyramidKind::Edge) return;
  origin_ids_.clear();
  for (const auto& cells : kept_.arc) {
    origin_ids_.push_back(complex_.facet_origin[local.facet[cells[0].index()]]);
  }
  const auto offsets =
      draft_->add(complex_.vertex_point[v], local.map, kind == PyramidKind::Edge, origin_ids_);
  for (std::uint32_t i = 0; i < local.map.point_count(); ++i) {
    carried_.push_back(local.halfedge[kept_.point[i][0].index()]);
    point_of_[carried_.back()] = offsets.point + i;
  }
}

// ---------------------------------------------------------------- rings

bool VertexCarrier::may_have_ring(VertexId v) const {
  const std::span<const HalfedgeId> star = complex_.star_of(v);
  if (star.empty() || complex_.vertex_facet[v].is_valid()) return false;
  return std::ranges::all_of(star, [this](HalfedgeId h) {
    const UseId first = complex_.edge_use[h.value() / 2];
    if (!first.is_valid()) return false;
    const UseId second = complex_.use_radial[first];
    return second != first && complex_.use_radial[second] == first;
  });
}

// The draft grows once for all vertices, by sizes that follow from their degrees. It is shortened
// again if a vertex has several rings.
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

/// Writes the map of a vertex with the numbering of local_map(): points have the order of the star,
/// and arcs the order of the points at which their edge uses begin. The face to the left of the
/// first half-arc precedes the other face. Returns false if there are several rings; in this case,
/// no map is written.
bool VertexCarrier::write_ring(const Remarked& remarked, std::uint32_t vertex,
                               const SpaceDraft::Offsets& at) {
  const auto& [v, becomes] = remarked;
  const std::span<const HalfedgeId> star = complex_.star_of(v);
  SpaceDraft& draft = *draft_;
  draft.vertex_point[vertex] = complex_.vertex_point[v];
  draft.vertex_mark[vertex] = becomes[complex_.vertex_mark[v]];
  draft.begin[vertex] = at;
  std::uint32_t point = at.point, arc = at.arc;
  for (const HalfedgeId h : star) {
    draft.maps.direction[point] = direction_of(complex_, h);
    draft.maps.point_mark[point] = becomes[complex_.edge_mark[h.value() / 2]];
    draft.vertex_of_point[point] = VertexId(vertex);
    ++point;
    // A corner belongs to the use that leaves along its first edge.
    for (const UseId u : two_uses(h)) {
      if (complex_.use_halfedge[u] != h) continue;
      const FacetId f = complex_.use_facet[u];
      draft.maps.circle[arc] = complex_.facet_plane[f];
      draft.maps.arc_mark[arc] = becomes[complex_.facet_mark[f]];
      draft.arc_origin[arc] = complex_.facet_origin[f];
      if (arc == at.arc) write_face_marks(f, becomes, at.face);
      arc_of_use_[u] = arc++;
    }
  }
  if (!link_ring(star, at)) return false;
  for (std::uint32_t i = 0; i < star.size(); ++i) {
    carried_.push_back(star[i]);
    point_of_[star[i]] = at.point + i;
  }
  return true;
}

/// Writes the marks of the two faces. The positive side of its facet is to the left of the first
/// half-arc.
void VertexCarrier::write_face_marks(FacetId of_first_arc, const std::array<Mark, 3>& becomes,
                                     std::uint32_t face) {
  const auto& [positive, negative] = complex_.facet_volume[of_first_arc];
  draft_->maps.face_mark[face] = becomes[complex_.volume_mark[positive]];
  draft_->maps.face_mark[face + 1] = becomes[complex_.volume_mark[negative]];
}

/// Links half-arcs around the points of a vertex. With two arcs at every point, after the one that
/// arrives follows the other one that leaves. Returns false if the face to the left of the first
/// half-arc does not have a half-arc of every arc: then the arcs make several rings.
bool VertexCarrier::link_ring(std::span<const HalfedgeId> star, const SpaceDraft::Offsets& at) {
  SphereMap& maps = draft_->maps;
  std::uint32_t point = at.point;
  for (const HalfedgeId h : star) {
    const auto uses = two_uses(h);
    // A half-arc that arrives at this point is followed, along the same face, by the other half-arc
    // that leaves the point.
    const std::uint32_t x = half_arc(uses[0], h), y = half_arc(uses[1], h);
    maps.origin[x] = maps.origin[y] = point;
    maps.next[SphereMap::twin(x)] = y;
    maps.next[SphereMap::twin(y)] = x;
    maps.first_out[point++] = SpaceComplex::is_reverse(h) ? y : x;
  }
  // The face to the left of the first half-arc is followed, and gets the number at.face. All other
  // half-arcs keep at.face + 1. If there is one ring, this face has as many half-arcs as there are
  // points.
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

/// Returns the two uses of an edge between two facets.
std::array<UseId, 2> VertexCarrier::two_uses(HalfedgeId h) const {
  const UseId first = complex_.edge_use[h.value() / 2];
  return {first, complex_.use_radial[first]};
}

/// Returns the half-arc that leaves point h in the facet of u. It is the half-arc of the corner
/// that begins along h, or the reverse of the half-arc of the corner that ends there.
std::uint32_t VertexCarrier::half_arc(UseId u, HalfedgeId h) const {
  if (complex_.use_halfedge[u] == h) return 2 * arc_of_use_[u];
  return 2 * arc_of_use_[complex_.use_next[u]] + 1;
}

}  // namespace plumb
