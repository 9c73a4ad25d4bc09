#include "plumb/space/boolean/vertex_labels.h"

#include <numeric>
#include <optional>

#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_locator.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

namespace {

SpaceItem item_of(const Contact& c, std::size_t operand) { return operand == 0 ? c.a : c.b; }

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

  std::vector<VolumeId> run() {
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
  bool needs_label(VertexId v) const {
    return !own_.is_touched(v) && !label_[v.value()].is_valid();
  }

  /// The volume of the other operand that a half-edge leaves the contact into.
  VolumeId volume_along(const Contact& contact, HalfedgeId h) {
    local_map(other_, item_of(contact, 1 - operand_), local_);
    const SphereCell cell = locate(tables_.planes, local_.map, direction_of(complex_, h));
    PLUMB_CHECK(cell.kind() == SphereCell::Kind::Face);
    return local_.volume[cell.index()];
  }

  void seed_around(VertexId touched) {
    for (const HalfedgeId h : complex_.star_of(touched)) {
      const VertexId v = complex_.target(h);
      if (own_.is_touched(SpaceComplex::edge_of(h)) || !needs_label(v)) continue;
      flood(v, volume_along(contacts_[own_.contact_of_vertex[touched.value()]], h));
    }
  }

  void flood(VertexId start, VolumeId volume) {
    collect(start);
    for (const VertexId v : group_) label_[v.value()] = volume;
  }

  /// All untouched vertices that edges without contacts join to `start`.
  void collect(VertexId start) {
    group_.assign(1, start);
    if (in_group_.empty()) in_group_.assign(complex_.vertex_count(), 0);
    in_group_[start.value()] = 1;
    for (std::size_t i = 0; i < group_.size(); ++i) {
      for (const HalfedgeId h : complex_.star_of(group_[i])) {
        const VertexId v = complex_.target(h);
        if (own_.is_touched(SpaceComplex::edge_of(h)) || !needs_label(v)) continue;
        if (in_group_[v.value()] != 0) continue;
        in_group_[v.value()] = 1;
        group_.push_back(v);
      }
    }
  }

  void label_group(VertexId start) {
    collect(start);
    VolumeId volume;
    for (const VertexId v : group_) {
      volume = volume_by_contact(v);
      if (volume.is_valid()) break;
    }
    if (!volume.is_valid()) volume = volume_by_ray(start);
    for (const VertexId v : group_) label_[v.value()] = volume;
  }

  /// By the nearest contact on an edge that leaves v, if there is one.
  VolumeId volume_by_contact(VertexId v) {
    for (const HalfedgeId h : complex_.star_of(v)) {
      const EdgeId e = SpaceComplex::edge_of(h);
      if (own_.is_touched(e)) return volume_along(nearest_contact(h), SpaceComplex::twin(h));
    }
    return VolumeId();
  }

  const Contact& nearest_contact(HalfedgeId h) const {
    const EdgeId e = SpaceComplex::edge_of(h);
    const auto& planes = complex_.edge_planes[e.value()];
    const Sign along = SpaceComplex::is_reverse(h) ? Sign::Negative : Sign::Positive;
    std::uint32_t best = own_.edge_contacts[own_.edge_begin[e.value()]];
    for (std::uint32_t i = own_.edge_begin[e.value()] + 1; i < own_.edge_begin[e.value() + 1];
         ++i) {
      const std::uint32_t c = own_.edge_contacts[i];
      const Sign after = order_along_line(tables_.points, planes[0], planes[1],
                                          contacts_[best].point, contacts_[c].point);
      if (after == -along) best = c;
    }
    return contacts_[best];
  }

  VolumeId volume_by_ray(VertexId v) {
    if (other_.vertex_count() == 0) return VolumeId(0);
    if (!locator_) locator_.emplace(other_);
    const SpaceItem hit = locator_->shoot_left(complex_.vertex_point[v.value()]);
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
  std::vector<VolumeId> label_;
  std::vector<std::uint8_t> in_group_;
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
  std::partial_sum(edge_begin.begin(), edge_begin.end(), edge_begin.begin());
  edge_contacts.resize(edge_begin.back());
  std::vector<std::uint32_t> at(edge_begin.begin(), edge_begin.end() - 1);
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const SpaceItem item = item_of(contacts[i], operand);
    if (item.kind() == SpaceItem::Kind::Edge) edge_contacts[at[item.index()]++] = i;
  }
}

std::vector<VolumeId> label_vertices(const TouchedComplex& own, const SpaceComplex& other,
                                     std::span<const Contact> contacts, std::size_t operand,
                                     const SpaceTables& tables, Context& context) {
  return Labels(own, other, contacts, operand, tables, context).run();
}

}  // namespace plumb
