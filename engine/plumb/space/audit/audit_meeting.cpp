// Parts 4 and 5 of audit(): cells meet only in common vertices and edges; volumes, frame and
// minimal form.
//
// Part 4. Rings, corners and cycles have been checked: near a vertex or an edge, no cells that
// contain it overlap. So two cells overlap only if somewhere a vertex lies inside an edge or a
// facet, two edges cross inside both, or an edge passes through a facet: a common segment of two
// facets ends in one of these. Nearly all such cases are found by testing vertices and edges
// against closed facets that do not contain them as a part. The other cases are
//
//   a vertex inside an edge    the edge is free, or all its facets have the vertex as a corner and
//                              none is a triangle
//   edges that cross           all facets of both lie in one plane, or there are none
//
// and such edges are few; they are tested against vertices and each other. Triangles around a
// common vertex that has a fan (mesh_topology.h) need no test. Candidates are pairs of the leaves
// of contact_leaves.h whose boxes meet.
//
// Part 5 finds the volumes again and compares them up to numbering; checks that the mark kBeyond is
// exactly on the cube and beyond it; and that no sphere map can be simplified
// (docs/design/boolean.md, Lemma 2).
//
// Declared in plumb/space/audit/audit_parts.h.
// Tested by tests/space/space_audit_test.cpp.

#include <algorithm>
#include <array>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/audit/audit_parts.h"
#include "plumb/space/boolean/contact_leaves.h"
#include "plumb/space/bounds/packed_boxes.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/query/volumes.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {
namespace {

/// Part 5.
class MarkAudit : SpaceAuditPart {
 public:
  MarkAudit(const SpaceComplex& complex, std::span<const std::uint8_t> has_fan, Context& context)
      : SpaceAuditPart(complex, context, 4), has_fan_(has_fan), overlay_(complex.planes()) {}

  std::optional<SpaceFlaw> run(AuditForm form) {
    static_cast<void>(has_right_volumes() && has_sane_frame() &&
                      (form == AuditForm::Any || (is_minimal() && has_needed_frame())));
    return flaw_;
  }

 private:
  // ---- volumes

  /// Whether the volumes are those that find_volumes() finds.
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
                             const auto& [above, below] = c_.facet_volume[f];
                             const auto& there = again.facet[f];
                             return has_same_volume(above, there[0], f) &&
                                    has_same_volume(below, there[1], f);
                           }) &&
           all_of<EdgeId>(
               c_.edge_count(),
               [&](EdgeId e) { return has_same_volume(c_.edge_volume[e], again.edge[e], e); }) &&
           all_of<VertexId>(c_.vertex_count(), [&](VertexId v) {
             return has_same_volume(c_.vertex_volume[v], again.vertex[v], v);
           });
  }
  /// Whether two volumes correspond, up to a renumbering that keeps volume 0.
  template <class Id>
  bool has_same_volume(VolumeId here, VolumeId there, Id at) {
    if (!here.is_valid() && !there.is_valid()) return true;
    bool same = here.is_valid() && there.is_valid();
    if (same) {
      VolumeId& to = forth_[here];
      VolumeId& from = back_[there];
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
  bool is_beyond(FacetId f) const { return is_beyond(c_.facet_mark[f]); }
  bool has_frame() const { return is_beyond(c_.volume_mark[0]); }

  /// Whether the mark kBeyond is exactly on volume 0, on the facets beside it, and on their edges
  /// and vertices.
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
    const auto [above, below] = c_.facet_volume[f];
    const bool at_frame = has_frame() && (above == VolumeId(0)) != (below == VolumeId(0));
    const bool in_beyond = has_frame() && above == VolumeId(0) && below == VolumeId(0);
    return require(!in_beyond && at_frame == is_beyond(f),
                   "facets of the frame, and no others, have the beyond on one side", f) &&
           require(is_beyond(f) == c_.planes().is_frame(plane(f)),
                   "facets of the frame, and no others, lie in its planes", f);
  }
  bool is_sane(EdgeId e) {
    const bool in_beyond = has_frame() && c_.edge_volume[e] == VolumeId(0);
    return require(!in_beyond, "nothing is in the beyond", e) &&
           require(is_beyond(c_.edge_mark[e]) == has_facet_of_frame(e),
                   "edges of the frame, and no others, bound its facets", e);
  }
  bool has_facet_of_frame(EdgeId e) const {
    const UseId first = c_.edge_use[e];
    return first.is_valid() && !all_of_ring(first, [&](UseId u) { return !is_beyond(facet(u)); });
  }
  /// Whether `visit` is true for all uses around an edge.
  template <class Visit>
  bool all_of_ring(UseId first, Visit visit) const {
    UseId u = first;
    do {
      if (!visit(u)) return false;
      u = c_.use_radial[u];
    } while (u != first);
    return true;
  }
  bool is_sane(VertexId v) {
    const auto star = c_.star_of(v);
    const bool at_frame = std::any_of(star.begin(), star.end(), [&](HalfedgeId h) {
      return is_beyond(c_.edge_mark[h.value() / 2]);
    });
    const FacetId inside = c_.vertex_facet[v];
    const bool in_beyond = has_frame() && c_.vertex_volume[v] == VolumeId(0);
    return require(!in_beyond, "nothing is in the beyond", v) &&
           require(is_beyond(c_.vertex_mark[v]) ==
                       (at_frame || (inside.is_valid() && is_beyond(inside))),
                   "vertices of the frame, and no others, are ends of its edges", v);
  }
  /// Whether a facet or an edge of the set reaches the frame, if there is one.
  bool has_needed_frame() {
    bool needed = !has_frame();
    for (std::uint32_t e = 0; e < c_.edge_count() && !needed; ++e) {
      const UseId first = c_.edge_use[e];
      const bool at_frame = is_beyond(c_.edge_mark[e]);
      needed = at_frame ? !all_of_ring(first, [&](UseId u) { return is_beyond(facet(u)); })
                        : is_beyond(c_.vertex_mark[c_.origin[2 * e]]) ||
                              is_beyond(c_.vertex_mark[c_.origin[2 * e + 1]]);
    }
    return require(needed, "a frame is there only if something reaches it");
  }

  // ---- the minimal form

  /// Whether a facet is certainly needed, without its sphere map: the volumes beside it differ.
  bool is_surely_needed(FacetId f) const {
    const auto [above, below] = c_.facet_volume[f];
    return c_.volume_mark[above] != c_.volume_mark[below];
  }
  /// Whether an edge is certainly needed, because facets in different planes meet there.
  bool is_surely_needed(EdgeId e) const {
    const UseId u = c_.edge_use[e];
    return u.is_valid() && plane(u) != plane(c_.use_radial[u]);
  }
  /// Whether a vertex is certainly needed, because it has edges other than the two directions of
  /// one line.
  bool is_surely_needed(VertexId v) const { return c_.star_of(v).size() > 2; }

  /// Whether the set would change without this cell. This is the case if its sphere map cannot be
  /// simplified and is the map of such a cell.
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

  std::span<const std::uint8_t> has_fan_;  ///< Whether each vertex has a fan.
  SphereOverlay overlay_;
  LocalMap local_;
  IdVector<VolumeId, VolumeId> forth_;
  IdVector<VolumeId, VolumeId> back_;
};

}  // namespace

std::optional<SpaceFlaw> audit_marks(const SpaceComplex& complex,
                                     std::span<const std::uint8_t> has_fan, AuditForm form,
                                     Context& context) {
  return MarkAudit(complex, has_fan, context).run(form);
}

// Part 4: cells meet only in common vertices and edges.

namespace {

constexpr Box3 kEverywhere{{-Box3::kInfinity, -Box3::kInfinity, -Box3::kInfinity},
                           {Box3::kInfinity, Box3::kInfinity, Box3::kInfinity}};

/// Part 4.
class MeetingAudit : SpaceAuditPart {
 public:
  MeetingAudit(const SpaceComplex& complex, std::span<const std::uint8_t> has_fan, Context& context)
      : SpaceAuditPart(complex, context, 3),
        points_(complex.points()),
        leaves_(complex, kEverywhere),
        items_(leaves_) {
    is_triangle_.resize(c_.facet_count());
    triangles_.reserve(leaves_.boxes().size());
    corner_begin_.reserve(leaves_.boxes().size() + 1);
    corner_begin_.push_back(0);
    for (std::size_t x = 0; x < leaves_.boxes().size(); ++x) gather_corners(leaves_[x], has_fan);
  }

  std::optional<SpaceFlaw> run() {
    if (!test_pairs_of(PackedBoxTree(leaves_.boxes()))) {
      BoxTree(leaves_.boxes()).for_each_pair_inside([this](std::uint32_t x, std::uint32_t y) {
        step_();
        if (!share_fan(triangles_[x], triangles_[y])) test(x, y);
      });
    }
    gather_edges();
    test_vertices_on_edges();
    test_flat_edges();
    return flaw_;
  }

 private:
  /// The kinds of flaws. The first kind in this order is reported, even if others are found
  /// earlier.
  enum Kind { kVertexInEdge, kEdgesCross, kVertexInFacet, kEdgeThroughFacet, kNothing };
  /// Notes a flaw, unless one of an earlier kind is known.
  template <class A, class B>
  void note(Kind kind, A a, B b) {
    static constexpr std::array<const char*, 4> kInvariants{
        "no vertex lies inside an edge", "edges do not cross",
        "no vertex lies inside a facet unlisted", "no edge passes through a facet"};
    if (kind >= worst_) return;
    worst_ = kind;
    fail(kInvariants[kind], name(a) + ", " + name(b));
  }

  // ---- pairs

  /// Tests all pairs that a packed tree finds. Returns false if some pairs are missing because the
  /// boxes do not suit the tree.
  bool test_pairs_of(const PackedBoxTree& tree) {
    constexpr std::size_t kStepsPerLeaf = 32;
    if (!tree.fits()) return false;
    std::size_t left = kStepsPerLeaf * (leaves_.boxes().size() + 256);
    const auto may_go_on = [&] {
      step_();
      return --left > 0;
    };
    std::vector<Triangle> triangles;
    triangles.reserve(tree.order().size());
    for (const std::uint32_t x : tree.order()) triangles.push_back(triangles_[x]);
    const auto look_at = [&](std::uint32_t i, std::uint32_t j) {
      if (!share_fan(triangles[i], triangles[j])) test(tree.order()[i], tree.order()[j]);
    };
    return tree.for_each_pair_in_order(look_at, may_go_on);
  }
  /// Tests two leaves against each other, unless the plane of one separates them.
  void test(std::uint32_t x, std::uint32_t y) {
    if (!leaves_.boxes()[x].meets(leaves_.boxes()[y])) return;
    if (lies_beside(x, y) || lies_beside(y, x)) return;
    test_against_facet(x, y);
    test_against_facet(y, x);
  }

  // ---- corners

  /// The corners of a facet that is a triangle without inner vertices. They are invalid for any
  /// other leaf.
  struct Triangle {
    std::array<VertexId, 3> corner;
    std::uint32_t fans = 0;  ///< Bit i is 1 if corner i has a fan.
    bool is_valid() const { return corner[0].is_valid(); }
  };
  void gather_corners(const ContactLeaf& leaf, std::span<const std::uint8_t> has_fan) {
    Triangle t;
    if (leaf.facet.is_valid()) {
      UseId u = leaf.first;
      for (std::uint32_t i = 0; i < leaf.count; ++i, u = c_.use_next[u]) {
        corner_.push_back(c_.use_origin(u));
      }
      if (leaf.count == 3 && c_.inner_of(leaf.facet).empty()) {
        std::copy_n(corner_.end() - 3, 3, t.corner.begin());
        for (std::size_t i = 0; i < 3; ++i) {
          t.fans |= std::uint32_t{has_fan[t.corner[i].value()]} << i;
        }
        is_triangle_[leaf.facet] = 1;
      }
    }
    triangles_.push_back(t);
    corner_begin_.push_back(static_cast<std::uint32_t>(corner_.size()));
  }
  /// Returns the corners of the leaf's facet if it is small and has one cycle; otherwise none.
  std::span<const VertexId> corners_of(std::uint32_t leaf) const {
    return std::span(corner_).subspan(corner_begin_[leaf],
                                      corner_begin_[leaf + 1] - corner_begin_[leaf]);
  }
  /// Whether two triangles have a common corner that has a fan.
  static bool share_fan(const Triangle& s, const Triangle& t) {
    unsigned shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = s.corner[i];
      const unsigned is_shared = static_cast<unsigned>(v == t.corner[0]) |
                                 static_cast<unsigned>(v == t.corner[1]) |
                                 static_cast<unsigned>(v == t.corner[2]);
      shared |= is_shared << i;
    }
    return (shared & s.fans) != 0;
  }

  /// Whether all corners of the facet of leaf x, except common corners, are strictly on one side of
  /// the plane of leaf y. In this case, the facets meet only in common corners and edges.
  bool lies_beside(std::uint32_t x, std::uint32_t y) const {
    const auto others = corners_of(y);
    if (others.empty()) return false;
    Sign known = Sign::Zero;
    for (const VertexId v : corners_of(x)) {
      if (std::ranges::find(others, v) != others.end()) continue;
      const Sign here = side_of(v, plane(leaves_[y].facet));
      if (here == Sign::Zero || here == -known) return false;
      known = here;
    }
    return known != Sign::Zero;
  }

  // ---- against facets

  Sign side_of(VertexId v, PlaneId p) const { return side(points_, at(v), p); }
  VertexId end(EdgeId e, std::uint32_t i) const { return c_.origin[2 * e.value() + i]; }

  /// Tests the vertices and edges of leaf x against the facet of leaf y.
  void test_against_facet(std::size_t x, std::size_t y) {
    const FacetId f = leaves_[y].facet;
    if (!f.is_valid()) return;
    const LeafItems& items = items_[x];
    const auto vertices = items.vertices();
    if (vertices.empty()) return;
    std::array<Sign, LeafItems::kMostVertices> sides;
    bool has_both = false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      sides[i] = side_of(vertices[i], plane(f));
      has_both |= sides[i] == Sign::Zero || sides[i] != sides[0];
    }
    if (!has_both) return;
    for (std::size_t i = 0; i < items.own_vertices().size(); ++i) {
      if (sides[i] == Sign::Zero) test(vertices[i], f);
    }
    for (const LeafEdge& e : items.edges()) {
      if (sides[e.from] * sides[e.to] == Sign::Negative) test(e.edge, f, triangles_[y]);
    }
  }

  /// Tests a vertex in the plane of a facet. It may be a listed inner vertex or on the boundary.
  void test(VertexId v, FacetId f) {
    if (c_.vertex_facet[v] == f || is_on_boundary(v, f)) return;
    const FacetPlace place = place_in_facet(c_, f, points_, at(v), step_);
    if (place.on.is_valid()) return note(kVertexInEdge, v, SpaceComplex::edge_of(place.on));
    if (place.is_inside) note(kVertexInFacet, v, f);
  }
  /// Whether an edge at the vertex bounds the facet.
  bool is_on_boundary(VertexId v, FacetId f) const {
    const auto star = c_.star_of(v);
    return std::any_of(star.begin(), star.end(), [&](HalfedgeId h) { return has_use(h, f); });
  }
  /// Whether the edge bounds the facet.
  bool has_use(HalfedgeId h, FacetId f) const {
    const UseId first = c_.edge_use[h.value() / 2];
    if (!first.is_valid()) return false;
    UseId u = first;
    do {
      if (facet(u) == f) return true;
      u = c_.use_radial[u];
    } while (u != first);
    return false;
  }

  /// Tests an edge whose ends are strictly on both sides of the facet's plane.
  void test(EdgeId e, FacetId f, const Triangle& triangle) {
    if (surely_passes_by(e, triangle)) return;
    // The point is constructed and located exactly. If it is on an edge g of the facet, either it
    // is a vertex inside of e, or both edges cross.
    const SpacePoint x = crossing(e, plane(f));
    const FacetPlace place = place_in_facet(c_, f, points_, x, step_);
    if (place.on.is_valid()) {
      const EdgeId g = SpaceComplex::edge_of(place.on);
      for (const VertexId v : {end(g, 0), end(g, 1)}) {
        if (equal(points_, x, at(v))) return note(kVertexInEdge, v, e);
      }
      return note(kEdgesCross, e, g);
    }
    if (place.is_inside) note(kEdgeThroughFacet, e, f);
  }
  /// Whether an edge passes a triangle of input points on the outside. This is the case if its line
  /// passes two sides in different directions.
  bool surely_passes_by(EdgeId e, const Triangle& t) const {
    if (!t.is_valid()) return false;
    std::array<const Point3*, 5> p{};
    const std::array<VertexId, 5> vertices{end(e, 0), end(e, 1), t.corner[0], t.corner[1],
                                           t.corner[2]};
    for (std::size_t i = 0; i < 5; ++i) {
      const SpacePoint x = at(vertices[i]);
      if (!x.is_input()) return false;
      p[i] = &c_.planes().point(x.input());
    }
    const Sign a = orient3d(*p[0], *p[1], *p[2], *p[3]), b = orient3d(*p[0], *p[1], *p[3], *p[4]);
    return a * b == Sign::Negative || a * orient3d(*p[0], *p[1], *p[4], *p[2]) == Sign::Negative;
  }
  /// Returns the point in which an edge passes a plane.
  SpacePoint crossing(EdgeId e, PlaneId p) {
    const auto& [first, second] = c_.edge_planes[e];
    return points_.add(first, second, p);
  }

  // ---- the other edges

  /// Edges with their boxes.
  struct Edges {
    std::vector<EdgeId> edge;
    std::vector<Box3> box;
  };
  void add(Edges& edges, EdgeId e) const {
    edges.edge.push_back(e);
    edges.box.push_back(box_of(c_, e));
  }
  /// Whether `holds` is true for all uses around an edge; true for a free edge.
  template <class Holds>
  bool all_uses(UseId first, Holds holds) const {
    if (!first.is_valid()) return true;
    UseId u = first;
    do {
      if (!holds(u)) return false;
      u = c_.use_radial[u];
    } while (u != first);
    return true;
  }
  /// Collects the edges that are not tested completely against facets.
  void gather_edges() {
    all_of<EdgeId>(c_.edge_count(), [this](EdgeId e) {
      const UseId first = c_.edge_use[e];
      if (all_uses(first, [&](UseId u) { return plane(u) == plane(first); })) add(flat_, e);
      if (all_uses(first, [this](UseId u) { return is_triangle_[facet(u)] == 0; })) {
        add(untried_, e);
      }
      return true;
    });
  }

  /// Tests all vertices against the edges that have not been tested against a triangle.
  void test_vertices_on_edges() {
    if (untried_.edge.empty()) return;
    const BoxTree tree(untried_.box);
    all_of<VertexId>(c_.vertex_count(), [&](VertexId v) {
      tree.for_each_meeting(box_of(c_, v), [&](std::uint32_t i) {
        step_();
        if (lies_inside(v, untried_.edge[i])) note(kVertexInEdge, v, untried_.edge[i]);
      });
      return true;
    });
  }
  /// Whether a vertex lies strictly inside an edge.
  bool lies_inside(VertexId v, EdgeId e) const {
    const auto& [p, q] = c_.edge_planes[e];
    if (v == end(e, 0) || v == end(e, 1)) return false;
    return side_of(v, p) == Sign::Zero && side_of(v, q) == Sign::Zero && is_between_ends(e, at(v));
  }
  /// Whether x, a point on the line of e, is strictly between its ends.
  bool is_between_ends(EdgeId e, SpacePoint x) const {
    const auto& [p, q] = c_.edge_planes[e];
    return order_along_line(points_, p, q, at(end(e, 0)), x) == Sign::Positive &&
           order_along_line(points_, p, q, x, at(end(e, 1))) == Sign::Positive;
  }

  /// Tests edges whose facets lie in one plane against each other.
  void test_flat_edges() {
    BoxTree(flat_.box).for_each_pair_inside([this](std::uint32_t i, std::uint32_t j) {
      step_();
      if (cross(flat_.edge[i], flat_.edge[j])) note(kEdgesCross, flat_.edge[i], flat_.edge[j]);
    });
  }
  /// Whether two edges cross in one point inside of both. If they do, one of them passes a plane of
  /// the other.
  bool cross(EdgeId e, EdgeId g) {
    const auto& [p, q] = c_.edge_planes[e];
    for (const auto& [first, second] : {std::pair{p, q}, std::pair{q, p}}) {
      if (side_of(end(g, 0), first) * side_of(end(g, 1), first) != Sign::Negative) continue;
      // The edge g passes the plane `first` through e in x. Both edges cross if x lies on the line
      // of e, between its ends.
      const SpacePoint x = crossing(g, first);
      return side(points_, x, second) == Sign::Zero && is_between_ends(e, x);
    }
    return false;
  }

  Point3Table points_;  ///< The points of the complex, and crossings.
  ContactLeaves leaves_;
  LeafCache items_;
  std::vector<Triangle> triangles_;          ///< One entry for each leaf.
  std::vector<std::uint32_t> corner_begin_;  ///< Starts in corner_, one more than leaves.
  std::vector<VertexId> corner_;
  IdVector<FacetId, std::uint8_t> is_triangle_;  ///< Whether each facet is such a triangle.
  Edges untried_;  ///< Edges against which no triangle has tested vertices.
  Edges flat_;     ///< Edges whose facets all lie in one plane.
  Kind worst_ = kNothing;
};

}  // namespace

std::optional<SpaceFlaw> audit_meeting(const SpaceComplex& complex,
                                       std::span<const std::uint8_t> has_fan, Context& context) {
  return MeetingAudit(complex, has_fan, context).run();
}

}  // namespace plumb
