#include "plumb/convex/set_parts.h"

#include <algorithm>
#include <utility>

#include "plumb/convex/wall_complex.h"

namespace plumb {
namespace {

/// Gives every marked item an owner of the highest dimension beside it, the least of these.
class Owners {
 public:
  explicit Owners(const SpaceComplex& complex) : c_(complex) {
    for (std::size_t f = 0; f < c_.facet_count(); ++f) facet_.push_back(owner_of(FacetId(f)));
    for (std::size_t e = 0; e < c_.edge_count(); ++e) edge_.push_back(owner_of(EdgeId(e)));
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) vertex_.push_back(owner_of(VertexId(v)));
  }

  /// All items that own themselves: the highest dimension first.
  std::vector<SpaceItem> owners() const {
    std::vector<SpaceItem> owners;
    for (std::size_t v = 0; v < c_.volume_count(); ++v) {
      if (c_.volume_mark[v] == 1) owners.emplace_back(VolumeId(v));
    }
    const auto add = [&](const std::vector<SpaceItem>& of, auto id) {
      for (std::size_t i = 0; i < of.size(); ++i) {
        const SpaceItem self = decltype(id)(i);
        if (of[i] == self) owners.push_back(self);
      }
    };
    add(facet_, FacetId());
    add(edge_, EdgeId());
    add(vertex_, VertexId());
    return owners;
  }

  SpaceMarks marks_of(SpaceItem owner) const {
    SpaceMarks marks;
    const auto fill = [owner](std::vector<Mark>& to, const std::vector<SpaceItem>& of) {
      for (const SpaceItem item : of) to.push_back(item == owner ? 1 : 0);
    };
    fill(marks.facet, facet_);
    fill(marks.edge, edge_);
    fill(marks.vertex, vertex_);
    marks.volume.assign(c_.volume_count(), 0);
    if (owner.kind() == SpaceItem::Kind::Volume) marks.volume[owner.index()] = 1;
    return marks;
  }

 private:
  /// The best owner seen so far: volumes before facets before edges, then the least.
  struct Best {
    SpaceItem item;
    void take(SpaceItem other) {
      const auto rank = [](SpaceItem i) {
        return std::pair(-static_cast<int>(i.kind()), i.index());
      };
      if (!item.is_valid() || rank(other) < rank(item)) item = other;
    }
  };

  void take_volume(Best& best, VolumeId v) const {
    if (v.is_valid() && c_.volume_mark[v.value()] == 1) best.take(v);
  }
  void take_facet(Best& best, FacetId f) const {
    for (const VolumeId v : c_.facet_volume[f.value()]) take_volume(best, v);
    if (c_.facet_mark[f.value()] == 1) best.take(f);
  }
  void take_edge(Best& best, EdgeId e) const {
    const UseId first = c_.edge_use[e.value()];
    if (c_.edge_mark[e.value()] == 1) best.take(e);
    if (!first.is_valid()) return take_volume(best, c_.edge_volume[e.value()]);
    UseId u = first;
    do {
      take_facet(best, c_.use_facet[u.value()]);
      u = c_.use_radial[u.value()];
    } while (u != first);
  }

  SpaceItem owner_of(FacetId f) const {
    Best best;
    if (c_.facet_mark[f.value()] == 1) take_facet(best, f);
    return best.item;
  }
  SpaceItem owner_of(EdgeId e) const {
    Best best;
    if (c_.edge_mark[e.value()] == 1) take_edge(best, e);
    return best.item;
  }
  SpaceItem owner_of(VertexId v) const {
    Best best;
    if (c_.vertex_mark[v.value()] != 1) return best.item;
    best.take(v);
    for (const HalfedgeId h : c_.star_of(v)) take_edge(best, SpaceComplex::edge_of(h));
    if (c_.vertex_facet[v.value()].is_valid()) take_facet(best, c_.vertex_facet[v.value()]);
    take_volume(best, c_.vertex_volume[v.value()]);
    return best.item;
  }

  const SpaceComplex& c_;
  std::vector<SpaceItem> facet_, edge_, vertex_;
};

}  // namespace

std::vector<SetPart> parts_of(const Nef3& whole, Context& context) {
  std::vector<SetPart> result;
  Nef3 set = whole;
  if (whole.is_bounded() && whole.counts().marked_volumes > 1) {
    for (Nef3& volume : volumes_as_sets(whole.complex(), context)) {
      result.push_back({std::move(volume), 3});
    }
    set = without_volumes(whole, context);
  }
  const Owners owners(set.complex());
  const std::vector<SpaceItem> parts = owners.owners();
  for (const SpaceItem owner : parts) {
    context.checkpoint("taking parts", result.size(), parts.size());
    const int dimension = static_cast<int>(owner.kind());
    result.push_back(
        {parts.size() == 1 ? set : set.with_marks(owners.marks_of(owner), context), dimension});
  }
  return result;
}

}  // namespace plumb
