// Step 5 of audit(): volumes, the frame, the minimal form.
#include <algorithm>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/space_audit_parts.h"
#include "plumb/space/volumes.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {
namespace {

class MarkAudit : SpaceAuditPart {
 public:
  MarkAudit(const SpaceComplex& complex, std::span<const std::uint8_t> has_fan, Context& context)
      : SpaceAuditPart(complex, context, 4), has_fan_(has_fan), overlay_(complex.planes()) {}

  std::optional<SpaceFlaw> run(bool minimal) {
    static_cast<void>(has_right_volumes() && has_sane_frame() &&
                      (!minimal || (is_minimal() && has_needed_frame())));
    return flaw_;
  }

 private:
  // ---- volumes

  bool has_right_volumes() {
    const VolumeLabels again = find_volumes(c_, step_.context(), has_fan_);
    if (!require(again.count == c_.volume_count(),
                 "volumes are the connected parts between facets")) {
      return false;
    }
    forth_.assign(c_.volume_count(), VolumeId());
    back_.assign(c_.volume_count(), VolumeId());
    forth_[0] = back_[0] = VolumeId(0);
    return all_of<FacetId>(c_.facet_count(),
                           [&](FacetId f) {
                             const auto& [above, below] = c_.facet_volume[f.value()];
                             const auto& there = again.facet[f.value()];
                             return has_same_volume(above, there[0], f) &&
                                    has_same_volume(below, there[1], f);
                           }) &&
           all_of<EdgeId>(c_.edge_count(),
                          [&](EdgeId e) {
                            return has_same_volume(c_.edge_volume[e.value()], again.edge[e.value()],
                                                   e);
                          }) &&
           all_of<VertexId>(c_.vertex_count(), [&](VertexId v) {
             return has_same_volume(c_.vertex_volume[v.value()], again.vertex[v.value()], v);
           });
  }
  /// Up to a renumbering that keeps volume 0.
  template <class Id>
  bool has_same_volume(VolumeId here, VolumeId there, Id at) {
    if (!here.is_valid() && !there.is_valid()) return true;
    bool same = here.is_valid() && there.is_valid();
    if (same) {
      VolumeId& to = forth_[here.value()];
      VolumeId& from = back_[there.value()];
      if (!to.is_valid() && !from.is_valid()) {
        to = there;
        from = here;
      }
      same = to == there && from == here;
    }
    return require(same, "volumes are the connected parts between facets", at);
  }

  // ---- the frame

  static bool is_beyond(Mark m) { return m == kBeyond; }
  bool is_beyond(FacetId f) const { return is_beyond(c_.facet_mark[f.value()]); }
  bool has_frame() const { return is_beyond(c_.volume_mark[0]); }

  bool has_sane_frame() {
    for (std::uint32_t v = 1; v < c_.volume_count(); ++v) {
      if (!require(!is_beyond(c_.volume_mark[v]), "only volume 0 is beyond", VolumeId(v)))
        return false;
    }
    return all_of<FacetId>(c_.facet_count(), [this](FacetId f) { return is_sane(f); }) &&
           all_of<EdgeId>(c_.edge_count(), [this](EdgeId e) { return is_sane(e); }) &&
           all_of<VertexId>(c_.vertex_count(), [this](VertexId v) { return is_sane(v); });
  }
  bool is_sane(FacetId f) {
    const auto [above, below] = c_.facet_volume[f.value()];
    const bool at_frame = has_frame() && (above == VolumeId(0)) != (below == VolumeId(0));
    const bool in_beyond = has_frame() && above == VolumeId(0) && below == VolumeId(0);
    return require(!in_beyond && at_frame == is_beyond(f),
                   "facets of the frame, and no others, have the beyond on one side", f) &&
           require(is_beyond(f) == c_.planes().is_frame(plane(f)),
                   "facets of the frame, and no others, lie in its planes", f);
  }
  bool is_sane(EdgeId e) {
    const bool in_beyond = has_frame() && c_.edge_volume[e.value()] == VolumeId(0);
    return require(!in_beyond, "nothing is in the beyond", e) &&
           require(is_beyond(c_.edge_mark[e.value()]) == has_facet_of_frame(e),
                   "edges of the frame, and no others, bound its facets", e);
  }
  bool has_facet_of_frame(EdgeId e) const {
    const UseId first = c_.edge_use[e.value()];
    return first.is_valid() && !all_of_ring(first, [&](UseId u) { return !is_beyond(facet(u)); });
  }
  template <class Visit>
  bool all_of_ring(UseId first, Visit visit) const {
    UseId u = first;
    do {
      if (!visit(u)) return false;
      u = c_.use_radial[u.value()];
    } while (u != first);
    return true;
  }
  bool is_sane(VertexId v) {
    const auto star = c_.star_of(v);
    const bool at_frame = std::any_of(star.begin(), star.end(), [&](HalfedgeId h) {
      return is_beyond(c_.edge_mark[h.value() / 2]);
    });
    const FacetId inside = c_.vertex_facet[v.value()];
    const bool in_beyond = has_frame() && c_.vertex_volume[v.value()] == VolumeId(0);
    return require(!in_beyond, "nothing is in the beyond", v) &&
           require(is_beyond(c_.vertex_mark[v.value()]) ==
                       (at_frame || (inside.is_valid() && is_beyond(inside))),
                   "vertices of the frame, and no others, are ends of its edges", v);
  }
  /// A facet or an edge of the set reaches the frame.
  bool has_needed_frame() {
    bool needed = !has_frame();
    for (std::uint32_t e = 0; e < c_.edge_count() && !needed; ++e) {
      const UseId first = c_.edge_use[e];
      const bool at_frame = is_beyond(c_.edge_mark[e]);
      needed = at_frame ? !all_of_ring(first, [&](UseId u) { return is_beyond(facet(u)); })
                        : is_beyond(c_.vertex_mark[c_.origin[2 * e].value()]) ||
                              is_beyond(c_.vertex_mark[c_.origin[2 * e + 1].value()]);
    }
    return require(needed, "a frame is there only if something reaches it");
  }

  // ---- the minimal form

  /// Is that clear without a look at the sphere map?
  bool is_surely_needed(FacetId f) const {
    const auto [above, below] = c_.facet_volume[f.value()];
    return c_.volume_mark[above.value()] != c_.volume_mark[below.value()];
  }
  bool is_surely_needed(EdgeId e) const {
    const UseId u = c_.edge_use[e.value()];
    return u.is_valid() && plane(u) != plane(c_.use_radial[u.value()]);
  }
  /// Other edges than the two directions of one line.
  bool is_surely_needed(VertexId v) const { return c_.star_of(v).size() > 2; }

  template <class Id>
  bool is_needed(Id item, PyramidKind kind) {
    if (is_surely_needed(item)) return true;
    local_map(c_, item, local_);
    return require(!overlay_.simplify(local_.map) && classify(c_.planes(), local_.map) == kind,
                   "no item can go without changing the set", item);
  }
  bool is_minimal() {
    return all_of<FacetId>(c_.facet_count(),
                           [this](FacetId f) { return is_needed(f, PyramidKind::Facet); }) &&
           all_of<EdgeId>(c_.edge_count(),
                          [this](EdgeId e) { return is_needed(e, PyramidKind::Edge); }) &&
           all_of<VertexId>(c_.vertex_count(),
                            [this](VertexId v) { return is_needed(v, PyramidKind::Vertex); });
  }

  std::span<const std::uint8_t> has_fan_;  ///< per vertex
  SphereOverlay overlay_;
  LocalMap local_;
  std::vector<VolumeId> forth_;
  std::vector<VolumeId> back_;
};

}  // namespace

std::optional<SpaceFlaw> audit_marks(const SpaceComplex& complex,
                                     std::span<const std::uint8_t> has_fan, bool minimal,
                                     Context& context) {
  return MarkAudit(complex, has_fan, context).run(minimal);
}

}  // namespace plumb
