// Parts of a set by dimension. Owners gives every marked cell one owner of the highest dimension
// beside it, the least of those: a volume, facet, edge or vertex. A cell that owns itself is a
// part, and the part consists of the cells it owns, so parts are disjoint, their union is the set,
// and the relative interior of each has one dimension.
//
// Volumes of a bounded set are copied in one pass over sphere maps (VolumeSplitter). Facets, edges
// and points are copied by ThinParts into complexes of their own with numbers that are assigned on
// first use, in time of the part's size. Only in an unbounded set does each part cost O(n), because
// each part needs the frame.
// Tested by tests/convex/convex_pieces_test.cpp.
#include "plumb/convex/wall/set_parts.h"

#include <algorithm>
#include <utility>

#include "plumb/convex/wall/wall_complex.h"
#include "plumb/space/boolean/simplify.h"

namespace plumb {
namespace {

/// Gives every marked cell an owner: the least one of the highest dimension beside it.
class Owners {
 public:
  explicit Owners(const SpaceComplex& complex) : c_(complex) {
    for (std::size_t f = 0; f < c_.facet_count(); ++f) facet_.push_back(owner_of(FacetId(f)));
    for (std::size_t e = 0; e < c_.edge_count(); ++e) edge_.push_back(owner_of(EdgeId(e)));
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) vertex_.push_back(owner_of(VertexId(v)));
  }

  /// Returns all cells that own themselves, the volumes first.
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

  /// Returns the mark of a cell in the part of the owner. It is 1 if the owner owns the cell.
  Mark mark_for(SpaceItem owner, EdgeId e) const { return edge_[e] == owner ? 1 : 0; }
  Mark mark_for(SpaceItem owner, VertexId v) const { return vertex_[v] == owner ? 1 : 0; }

  /// Returns the marks of the part of an owner.
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
  /// The best owner so far. Volumes precede facets, facets precede edges, and within each kind the
  /// least id is first.
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
    if (v.is_valid() && c_.volume_mark[v] == 1) best.take(v);
  }
  void take_facet(Best& best, FacetId f) const {
    for (const VolumeId v : c_.facet_volume[f]) take_volume(best, v);
    if (c_.facet_mark[f] == 1) best.take(f);
  }
  /// If an edge is free, it is beside its volume. Otherwise, it is beside the facets around it and
  /// the volumes beside these facets.
  void take_edge(Best& best, EdgeId e) const {
    const UseId first = c_.edge_use[e];
    if (c_.edge_mark[e] == 1) best.take(e);
    if (!first.is_valid()) return take_volume(best, c_.edge_volume[e]);
    UseId u = first;
    do {
      take_facet(best, c_.use_facet[u]);
      u = c_.use_radial[u];
    } while (u != first);
  }

  SpaceItem owner_of(FacetId f) const {
    Best best;
    if (c_.facet_mark[f] == 1) take_facet(best, f);
    return best.item;
  }
  SpaceItem owner_of(EdgeId e) const {
    Best best;
    if (c_.edge_mark[e] == 1) take_edge(best, e);
    return best.item;
  }
  SpaceItem owner_of(VertexId v) const {
    Best best;
    if (c_.vertex_mark[v] != 1) return best.item;
    best.take(v);
    for (const HalfedgeId h : c_.star_of(v)) take_edge(best, SpaceComplex::edge_of(h));
    if (c_.vertex_facet[v].is_valid()) take_facet(best, c_.vertex_facet[v]);
    take_volume(best, c_.vertex_volume[v]);
    return best.item;
  }

  const SpaceComplex& c_;
  IdVector<FacetId, SpaceItem> facet_;
  IdVector<EdgeId, SpaceItem> edge_;
  IdVector<VertexId, SpaceItem> vertex_;
};

/// Copies single facets, edges and points of the complex of a bounded set to separate complexes.
/// Scratch memory is reused.
class ThinParts {
 public:
  ThinParts(const SpaceComplex& complex, const Owners& owners)
      : c_(complex),
        owners_(owners),
        vertex_number_(complex.vertex_count()),
        edge_number_(complex.edge_count()),
        use_number_(complex.use_count()) {}

  /// Returns the part of an owner as a set. A facet is copied with its edges and vertices, which
  /// are marked only if the facet owns them. The result is simplified, because some of these cells
  /// may be superfluous.
  Nef3 set_of(SpaceItem owner, Context& context) {
    owner_ = owner;
    out_ = {};
    vertices_.clear();
    edges_.clear();
    uses_.clear();
    out_.tables = c_.tables;
    out_.volume_mark = {0};
    out_.cycle_begin = {0};
    out_.inner_begin = {0};
    if (owner.kind() == SpaceItem::Kind::Facet) add_facet(owner.facet());
    if (owner.kind() == SpaceItem::Kind::Edge) add_edge(owner.edge());
    if (owner.kind() == SpaceItem::Kind::Vertex) add_vertex(owner.vertex());
    link_uses();
    out_.list_stars(vertices_.size());
    for (const VertexId v : out_.inner) out_.vertex_facet[v] = FacetId(0);
    for (std::size_t v = 0; v < vertices_.size() && uses_.empty() && edges_.empty(); ++v) {
      out_.vertex_volume[v] = VolumeId(0);
    }
    return Nef3::from_minimal_unchecked(simplified(std::move(out_), context));
  }

 private:
  /// Returns the number of a cell in a list, and whether the cell was appended by this call.
  template <class Id>
  static std::pair<std::uint32_t, bool> numbered(Id id, std::vector<Id>& list,
                                                 IdVector<Id, std::uint32_t>& number) {
    std::uint32_t& n = number[id];
    if (n < list.size() && list[n] == id) return {n, false};
    n = static_cast<std::uint32_t>(list.size());
    list.push_back(id);
    return {n, true};
  }

  VertexId add_vertex(VertexId v) {
    const auto [n, is_new] = numbered(v, vertices_, vertex_number_);
    if (is_new) {
      out_.vertex_point.push_back(c_.vertex_point[v]);
      out_.vertex_mark.push_back(owners_.mark_for(owner_, v));
      out_.vertex_volume.emplace_back();
      out_.vertex_facet.emplace_back();
    }
    return VertexId(n);
  }

  EdgeId add_edge(EdgeId e) {
    const auto [n, is_new] = numbered(e, edges_, edge_number_);
    if (is_new) {
      out_.edge_planes.push_back(c_.edge_planes[e]);
      out_.edge_mark.push_back(owners_.mark_for(owner_, e));
      out_.edge_use.emplace_back();
      out_.edge_volume.push_back(uses_.empty() ? VolumeId(0) : VolumeId());
      for (const std::uint32_t h : {2 * e.value(), 2 * e.value() + 1}) {
        const VertexId v = add_vertex(c_.origin[h]);
        out_.origin.push_back(v);
      }
    }
    return EdgeId(n);
  }

  void add_facet(FacetId f) {
    out_.facet_plane.push_back(c_.facet_plane[f]);
    out_.facet_mark.push_back(1);
    out_.facet_volume.push_back({VolumeId(0), VolumeId(0)});
    out_.facet_origin.push_back(c_.facet_origin[f]);
    for (const UseId first : c_.cycles_of(f)) {
      out_.cycle.push_back(UseId(uses_.size()));
      UseId u = first;
      do {
        numbered(u, uses_, use_number_);
        const HalfedgeId h = c_.use_halfedge[u];
        const EdgeId e = add_edge(SpaceComplex::edge_of(h));
        out_.use_halfedge.push_back(HalfedgeId(2 * e.value() + (h.value() & 1U)));
        out_.use_facet.push_back(FacetId(0));
        u = c_.use_next[u];
      } while (u != first);
    }
    for (const VertexId v : c_.inner_of(f)) out_.inner.push_back(add_vertex(v));
    out_.cycle_begin.push_back(static_cast<std::uint32_t>(out_.cycle.size()));
    out_.inner_begin.push_back(static_cast<std::uint32_t>(out_.inner.size()));
  }

  /// Links the edge uses around each edge. The facet occurs there once, or twice at a slit.
  void link_uses() {
    for (std::uint32_t i = 0; i < uses_.size(); ++i) {
      const auto number = [&](UseId u) { return UseId(use_number_[u]); };
      out_.use_next.push_back(number(c_.use_next[uses_[i]]));
      out_.use_prev.push_back(number(c_.use_prev[uses_[i]]));
      UseId& known = out_.edge_use[SpaceComplex::edge_of(out_.use_halfedge[i])];
      out_.use_radial.push_back(known.is_valid() ? known : UseId(i));
      if (known.is_valid()) out_.use_radial[known] = UseId(i);
      known = UseId(i);
    }
  }

  const SpaceComplex& c_;
  const Owners& owners_;
  IdVector<VertexId, std::uint32_t> vertex_number_;
  IdVector<EdgeId, std::uint32_t> edge_number_;
  IdVector<UseId, std::uint32_t> use_number_;
  SpaceItem owner_;
  SpaceComplex out_;
  std::vector<VertexId> vertices_;
  std::vector<EdgeId> edges_;
  std::vector<UseId> uses_;
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
  ThinParts thin(set.complex(), owners);
  for (const SpaceItem owner : parts) {
    context.checkpoint("taking parts", result.size(), parts.size());
    const int dimension = static_cast<int>(owner.kind());
    if (parts.size() == 1) {
      result.push_back({set, dimension});
    } else if (dimension < 3 && set.is_bounded()) {
      result.push_back({thin.set_of(owner, context), dimension});
    } else {
      result.push_back({set.with_marks(owners.marks_of(owner), context), dimension});
    }
  }
  return result;
}

}  // namespace plumb
