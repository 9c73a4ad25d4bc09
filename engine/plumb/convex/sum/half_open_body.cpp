// Convex pieces with the marks of their boundaries, and their sums.
//
// HalfOpenReader assigns the items of the piece to faces of its closure. The closure of a convex
// set is convex, so no two of its facets lie in one plane. The planes of the facets around an item
// therefore name the face: one plane a facet, two planes an edge, and a vertex of the closure is a
// vertex of the piece with the same point.
//
// A face whose items have different marks is judged again without its inner items. A facet of the
// piece is inner if it is a wall. Whether an edge or a vertex is inner is found by the location of
// one of its points in the closure of the set. Invariant: a face is Uneven only if it has marked
// and unmarked items that are not inner, so that walls alone never cost additional sums.
// Declared in sum/half_open_body.h, whose opening comment gives the reasons.
// Tested by tests/convex/half_open_sum_test.cpp.
#include "plumb/convex/sum/half_open_body.h"

#include <algorithm>

#include "plumb/convex/decompose.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/boolean/simplify.h"

namespace plumb {

/// Steps 1 and 2: fills the arrays of a body.
class HalfOpenReader {
 public:
  HalfOpenReader(HalfOpenBody& out, const Nef3& hull, Context& context)
      : out_(out),
        body_(out.body_),
        c_(out.piece_.complex()),
        closed_(closure_of(c_, context)),
        hull_(hull),
        context_(context) {}

  void run() {
    body_ = convex_body_of(closed_);
    number_faces();
    list_links();
    list_planes();
    assign();
    judge();
  }

 private:
  static SpaceComplex closure_of(SpaceComplex c, Context& context) {
    std::fill(c.vertex_mark.begin(), c.vertex_mark.end(), Mark{1});
    std::fill(c.edge_mark.begin(), c.edge_mark.end(), Mark{1});
    std::fill(c.facet_mark.begin(), c.facet_mark.end(), Mark{1});
    return simplified(std::move(c), context);
  }

  void number_faces() {
    const auto vertices = static_cast<std::uint32_t>(body_.point.size());
    out_.first_ = {0, vertices, vertices + static_cast<std::uint32_t>(body_.edge.size())};
  }

  void list_links() {
    for (std::uint32_t e = 0; e < body_.edge.size(); ++e) {
      const auto [v, w] = body_.edge[e].end;
      out_.link_.push_back({v, w, e});
      out_.link_.push_back({w, v, e});
    }
    std::sort(out_.link_.begin(), out_.link_.end());
  }

  // ---- the face of an item

  void list_planes() {
    PLUMB_CHECK(closed_.tables == c_.tables);
    for (std::uint32_t f = 0; f < closed_.facet_count(); ++f) {
      facet_.emplace_back(closed_.facet_plane[f], f);
    }
    std::sort(facet_.begin(), facet_.end());
    for (std::uint32_t v = 0; v < closed_.vertex_count(); ++v) {
      vertex_.emplace_back(closed_.vertex_point[v], v);
    }
    std::sort(vertex_.begin(), vertex_.end());
    for (std::uint32_t e = 0; e < body_.edge.size(); ++e) {
      const auto [left, right] = std::minmax(body_.edge[e].side[0], body_.edge[e].side[1]);
      edge_.push_back({left, right, e});
    }
    std::sort(edge_.begin(), edge_.end());
  }

  std::uint32_t facet_in(PlaneId plane) const {
    const auto at = std::lower_bound(facet_.begin(), facet_.end(), std::pair(plane, 0U));
    PLUMB_CHECK(at != facet_.end() && at->first == plane);
    return at->second;
  }

  /// Adds the facets of the closure that contain the facets around an edge.
  void add_facets_at(EdgeId e, std::vector<std::uint32_t>& facets) const {
    const UseId first = c_.edge_use[e];
    PLUMB_CHECK(first.is_valid());
    UseId u = first;
    do {
      facets.push_back(facet_in(c_.facet_plane[c_.use_facet[u]]));
      u = c_.use_radial[u];
    } while (u != first);
  }

  /// Returns the face in whose relative interior the facets meet. Sorts them.
  BodyFace common_face(std::vector<std::uint32_t>& facets) const {
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    PLUMB_CHECK(facets.size() == 1 || facets.size() == 2);
    if (facets.size() == 1) return {2, facets[0]};
    const std::array<std::uint32_t, 3> key{facets[0], facets[1], 0};
    const auto at = std::lower_bound(edge_.begin(), edge_.end(), key);
    PLUMB_CHECK(at != edge_.end() && (*at)[0] == facets[0] && (*at)[1] == facets[1]);
    return {1, (*at)[2]};
  }

  BodyFace face_of(VertexId v) const {
    const std::pair key(c_.vertex_point[v], 0U);
    const auto at = std::lower_bound(vertex_.begin(), vertex_.end(), key);
    if (at != vertex_.end() && at->first == key.first) return {0, at->second};
    std::vector<std::uint32_t> facets;
    if (c_.vertex_facet[v].is_valid()) {
      facets.push_back(facet_in(c_.facet_plane[c_.vertex_facet[v]]));
    }
    for (const HalfedgeId h : c_.star_of(v)) add_facets_at(SpaceComplex::edge_of(h), facets);
    return common_face(facets);
  }

  void assign() {
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      add({2, facet_in(c_.facet_plane[f])}, FacetId(f));
    }
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      std::vector<std::uint32_t> facets;
      add_facets_at(EdgeId(e), facets);
      add(common_face(facets), EdgeId(e));
    }
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) add(face_of(VertexId(v)), VertexId(v));
    std::sort(out_.item_.begin(), out_.item_.end());
  }
  void add(BodyFace face, SpaceItem item) { out_.item_.emplace_back(out_.code(face), item); }

  // ---- the marks of a face

  void judge() {
    const std::size_t faces = out_.first_[2] + body_.facet_count();
    out_.mark_.assign(faces, FaceMark::None);
    for (std::size_t i = 0; i < out_.item_.size();) {
      const std::uint32_t face = out_.item_[i].first;
      const std::size_t first = i;
      while (i < out_.item_.size() && out_.item_[i].first == face) ++i;
      out_.mark_[face] = mark_of(std::span(out_.item_).subspan(first, i - first));
    }
  }

  using Items = std::span<const std::pair<std::uint32_t, SpaceItem>>;

  FaceMark mark_of(Items items) const {
    const FaceMark all = common_mark(items, false);
    return all == FaceMark::Uneven ? common_mark(items, true) : all;
  }

  /// Returns the common mark of the items or, if `skips_inner`, of the items that are not inner.
  FaceMark common_mark(Items items, bool skips_inner) const {
    std::array<bool, 2> has_mark{false, false};
    for (const auto& [face, item] : items) {
      if (skips_inner && is_inner(item)) continue;
      has_mark[mark_of(item) == 1 ? 1 : 0] = true;
    }
    if (!has_mark[1]) return FaceMark::None;
    return has_mark[0] ? FaceMark::Uneven : FaceMark::All;
  }

  Mark mark_of(SpaceItem item) const {
    switch (item.kind()) {
      case SpaceItem::Kind::Vertex:
        return c_.vertex_mark[item.vertex()];
      case SpaceItem::Kind::Edge:
        return c_.edge_mark[item.edge()];
      case SpaceItem::Kind::Facet:
        return c_.facet_mark[item.facet()];
      case SpaceItem::Kind::Volume:
        break;
    }
    return 1;
  }

  bool is_inner(SpaceItem item) const {
    if (item.kind() == SpaceItem::Kind::Facet) return is_wall(c_, item.facet());
    const SpaceLocation at = hull_.locate(point_of(item), context_);
    return at.marked && at.item.kind() == SpaceItem::Kind::Volume;
  }

  /// Returns a point in the relative interior of a vertex or an edge.
  RationalPoint3 point_of(SpaceItem item) const {
    if (item.kind() == SpaceItem::Kind::Vertex) return point(item.vertex());
    const RationalPoint3 p = point(c_.origin[2 * item.index()]);
    const RationalPoint3 q = point(c_.origin[2 * item.index() + 1]);
    return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
  }
  RationalPoint3 point(VertexId v) const { return exact(c_.points(), c_.vertex_point[v]); }

  HalfOpenBody& out_;
  ConvexBody& body_;
  const SpaceComplex& c_;
  SpaceComplex closed_;  // The closure of the piece. It has the same tables.
  const Nef3& hull_;
  Context& context_;
  std::vector<std::pair<PlaneId, std::uint32_t>> facet_;  // Facets of the closure by plane.
  // The vertices of the closure, by point.
  std::vector<std::pair<SpacePoint, std::uint32_t>> vertex_;
  // The edges of the closure, by their two facets.
  std::vector<std::array<std::uint32_t, 3>> edge_;
};

HalfOpenBody::HalfOpenBody(const Nef3& piece, const Nef3& hull, Context& context) : piece_(piece) {
  HalfOpenReader(*this, hull, context).run();
}

std::uint32_t HalfOpenBody::edge_between(std::uint32_t v, std::uint32_t w) const {
  const std::array<std::uint32_t, 3> key{v, w, 0};
  return (*std::lower_bound(link_.begin(), link_.end(), key))[2];
}

BodyFace HalfOpenBody::face_of(std::span<const std::uint32_t> vertices) const {
  if (vertices.size() == 1) return {0, vertices[0]};
  const std::uint32_t e = edge_between(vertices[0], vertices[1]);
  if (vertices.size() == 2) return {1, e};
  const ConvexBody::Edge& edge = body_.edge[e];
  return {2, edge.side[edge.end[0] == vertices[0] ? 0 : 1]};
}

/// Returns the codes of a face and of the faces in its boundary, ascending.
std::vector<std::uint32_t> HalfOpenBody::closure_of(BodyFace face) const {
  std::vector<std::uint32_t> codes{code(face)};
  if (face.dimension == 1) {
    for (const std::uint32_t v : body_.edge[face.number].end) codes.push_back(code({0, v}));
  }
  if (face.dimension == 2) {
    const auto corners = body_.corners(face.number);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      codes.push_back(code({0, corners[i]}));
      codes.push_back(code({1, edge_between(corners[i], corners[(i + 1) % corners.size()])}));
    }
  }
  std::sort(codes.begin(), codes.end());
  return codes;
}

template <class Visit>
void HalfOpenBody::for_each_marked(BodyFace face, bool with_boundary, const Visit& visit) const {
  const SpaceComplex& c = piece_.complex();
  const auto is_marked = [&](SpaceItem item) {
    if (item.kind() == SpaceItem::Kind::Vertex) return c.vertex_mark[item.vertex()] != 0;
    if (item.kind() == SpaceItem::Kind::Edge) return c.edge_mark[item.edge()] != 0;
    return item.kind() == SpaceItem::Kind::Facet && c.facet_mark[item.facet()] != 0;
  };
  const auto faces = with_boundary ? closure_of(face) : std::vector<std::uint32_t>{code(face)};
  for (const std::uint32_t of : faces) {
    auto at = std::lower_bound(item_.begin(), item_.end(), std::pair(of, SpaceItem(VertexId(0))));
    for (; at != item_.end() && at->first == of; ++at) {
      if (is_marked(at->second)) visit(at->second);
    }
  }
}

bool HalfOpenBody::has_part(BodyFace face, bool with_boundary) const {
  bool has_item = false;
  for_each_marked(face, with_boundary, [&](SpaceItem) { has_item = true; });
  return has_item;
}

Nef3 HalfOpenBody::part(BodyFace face, bool with_boundary, Context& context) const {
  const SpaceComplex& c = piece_.complex();
  SpaceMarks marks{std::vector<Mark>(c.vertex_count(), 0), std::vector<Mark>(c.edge_count(), 0),
                   std::vector<Mark>(c.facet_count(), 0), std::vector<Mark>(c.volume_count(), 0)};
  for_each_marked(face, with_boundary, [&](SpaceItem item) {
    const std::uint32_t i = item.index();
    if (item.kind() == SpaceItem::Kind::Vertex) marks.vertex[i] = 1;
    if (item.kind() == SpaceItem::Kind::Edge) marks.edge[i] = 1;
    if (item.kind() == SpaceItem::Kind::Facet) marks.facet[i] = 1;
  });
  return piece_.with_marks(marks, context);
}

std::size_t HalfOpenBody::bytes() const {
  return piece_.bytes() + memory_bytes(body_) + link_.capacity() * sizeof(link_[0]) +
         item_.capacity() * sizeof(item_[0]) + mark_.capacity();
}

Nef3 half_open_sum(const HalfOpenBody& a, const HalfOpenBody& b,
                   const std::function<void(BodyFace, BodyFace, bool is_parallel)>& visit,
                   Context& context) {
  const auto mark_of = [&](unsigned dimension, std::span<const std::uint32_t> face_a,
                           std::span<const std::uint32_t> face_b) -> Mark {
    const BodyFace f = a.face_of(face_a), g = b.face_of(face_b);
    const FaceMark of_f = a.mark(f), of_g = b.mark(g);
    if (of_f == FaceMark::All && of_g == FaceMark::All) return 1;
    const bool is_parallel = f.dimension + g.dimension > dimension;
    if (is_parallel || (of_f != FaceMark::None && of_g != FaceMark::None)) {
      visit(f, g, is_parallel);
    }
    return 0;
  };
  return convex_sum(a.body(), b.body(), mark_of, context);
}

}  // namespace plumb
