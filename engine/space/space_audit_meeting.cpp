// Step 4 of audit(): nothing meets but at common vertices and edges.
//
// Rings, corners and cycles have been checked: near a vertex or edge nothing overlaps that contains it. So two items
// overlap only if somewhere a vertex lies inside an edge or a facet, two edges cross inside both, or an edge passes
// through a facet: a common segment of two facets ends in one of these.
//
// Nearly all of that shows where a vertex or an edge is tested against a closed facet that it is no part of. Else
//
//   a vertex inside an edge    has the edge in facets alone of which it is a corner, none a triangle; or in none
//   edges that cross           have all their facets in the plane of both, or none
//
// and such edges are few. Triangles around a common vertex that has a fan (mesh_fans.h) need no test.
#include <algorithm>
#include <array>
#include <vector>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/meet_leaves.h"
#include "plumb/space/space_audit_parts.h"
#include "plumb/space/space_boxes.h"

namespace plumb {
namespace {

constexpr Box3 kEverywhere{{-Box3::kInfinity, -Box3::kInfinity, -Box3::kInfinity},
                           {Box3::kInfinity, Box3::kInfinity, Box3::kInfinity}};

class MeetingAudit : SpaceAuditPart {
 public:
  MeetingAudit(const SpaceComplex& complex, std::span<const std::uint8_t> has_fan, Context& context)
      : SpaceAuditPart(complex, context, 3),
        points_(complex.points()),
        leaves_(complex, kEverywhere),
        items_(leaves_) {
    find_triangles(has_fan);
  }

  std::optional<SpaceFlaw> run() {
    BoxTree(leaves_.boxes()).for_each_pair_inside([this](std::uint32_t x, std::uint32_t y) {
      step_();
      if (share_fan(x, y)) return;
      test_against_facet(x, y);
      test_against_facet(y, x);
    });
    test_vertices_on_edges();
    test_flat_edges();
    return flaw_;
  }

 private:
  /// The first kind found is told, whatever is found first.
  enum Kind { kVertexInEdge, kEdgesCross, kVertexInFacet, kEdgeThroughFacet, kNothing };
  template <class A, class B>
  void note(Kind kind, A a, B b) {
    static constexpr std::array<const char*, 4> kInvariants{
        "no vertex lies inside an edge", "edges do not cross",
        "no vertex lies inside a facet unlisted", "no edge passes through a facet"};
    if (kind >= worst_) return;
    worst_ = kind;
    fail(kInvariants[kind], name(a) + ", " + name(b));
  }

  // ---- triangles

  struct Triangle {
    std::array<VertexId, 3> corner;
    std::array<bool, 3> has_fan{};
    bool is_valid = false;
  };
  void find_triangles(std::span<const std::uint8_t> fans) {
    triangles_.resize(c_.facet_count());
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (c_.cycles_of(FacetId(f)).size() != 1 || !c_.inner_of(FacetId(f)).empty()) continue;
      const UseId first = c_.cycles_of(FacetId(f))[0];
      UseId u = first;
      for (std::size_t i = 0; i < 3; ++i, u = c_.use_next[u.value()]) {
        triangles_[f].corner[i] = c_.use_origin(u);
        triangles_[f].has_fan[i] = fans[c_.use_origin(u).value()] != 0;
      }
      triangles_[f].is_valid = u == first;
    }
  }
  bool share_fan(std::size_t x, std::size_t y) const {
    if (!leaves_[x].facet.is_valid() || !leaves_[y].facet.is_valid()) return false;
    const Triangle& s = triangles_[leaves_[x].facet.value()];
    const Triangle& t = triangles_[leaves_[y].facet.value()];
    if (!s.is_valid || !t.is_valid) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = s.corner[i];
      if (s.has_fan[i] && (v == t.corner[0] || v == t.corner[1] || v == t.corner[2])) return true;
    }
    return false;
  }

  // ---- against facets

  Sign side_of(VertexId v, PlaneId p) const { return side(points_, at(v), p); }
  VertexId end(EdgeId e, std::uint32_t i) const { return c_.origin[2 * e.value() + i]; }

  /// The vertices and edges of leaf x, and the facet of leaf y.
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
      if (sides[e.from] * sides[e.to] == Sign::Negative) test(e.edge, f);
    }
  }

  void test(VertexId v, FacetId f) {
    if (c_.vertex_facet[v.value()] == f || is_on_boundary(v, f)) return;
    const FacetPlace place = place_in_facet(c_, f, points_, at(v), step_);
    if (place.on.is_valid()) return note(kVertexInEdge, v, SpaceComplex::edge_of(place.on));
    if (place.is_inside) note(kVertexInFacet, v, f);
  }
  bool is_on_boundary(VertexId v, FacetId f) const {
    const auto star = c_.star_of(v);
    return std::any_of(star.begin(), star.end(), [&](HalfedgeId h) { return has_use(h, f); });
  }
  /// Does the edge bound the facet?
  bool has_use(HalfedgeId h, FacetId f) const {
    const UseId first = c_.edge_use[h.value() / 2];
    if (!first.is_valid()) return false;
    UseId u = first;
    do {
      if (facet(u) == f) return true;
      u = c_.use_radial[u.value()];
    } while (u != first);
    return false;
  }

  /// Requires an edge that passes the facet's plane.
  void test(EdgeId e, FacetId f) {
    if (surely_passes_by(e, triangles_[f.value()])) return;
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
  /// Its line passes two sides of the triangle in different directions.
  bool surely_passes_by(EdgeId e, const Triangle& t) const {
    if (!t.is_valid) return false;
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
  /// Where an edge that passes a plane does so.
  SpacePoint crossing(EdgeId e, PlaneId p) {
    const auto& [first, second] = c_.edge_planes[e.value()];
    return points_.add(first, second, p);
  }

  // ---- the other edges

  template <class IsWanted>
  void gather_edges(IsWanted is_wanted) {
    edges_.clear();
    edge_boxes_.clear();
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (!is_wanted(EdgeId(e))) continue;
      edges_.push_back(EdgeId(e));
      edge_boxes_.push_back(box_of(c_, EdgeId(e)));
    }
  }
  template <class Holds>
  bool all_uses(EdgeId e, Holds holds) const {
    const UseId first = c_.edge_use[e.value()];
    if (!first.is_valid()) return true;
    UseId u = first;
    do {
      if (!holds(u)) return false;
      u = c_.use_radial[u.value()];
    } while (u != first);
    return true;
  }

  void test_vertices_on_edges() {
    gather_edges([this](EdgeId e) {
      return all_uses(e, [this](UseId u) { return !triangles_[facet(u).value()].is_valid; });
    });
    const BoxTree tree(edge_boxes_);
    for (std::uint32_t v = 0; v < c_.vertex_count() && !edges_.empty(); ++v) {
      step_();
      tree.for_each_meeting(box_of(c_, VertexId(v)), [&](std::uint32_t i) {
        step_();
        if (lies_inside(VertexId(v), edges_[i])) note(kVertexInEdge, VertexId(v), edges_[i]);
      });
    }
  }
  bool lies_inside(VertexId v, EdgeId e) const {
    const auto& [p, q] = c_.edge_planes[e.value()];
    if (v == end(e, 0) || v == end(e, 1)) return false;
    return side_of(v, p) == Sign::Zero && side_of(v, q) == Sign::Zero && is_between_ends(e, at(v));
  }
  /// Is x, a point of the line of e, strictly between its ends?
  bool is_between_ends(EdgeId e, SpacePoint x) const {
    const auto& [p, q] = c_.edge_planes[e.value()];
    return order_along_line(points_, p, q, at(end(e, 0)), x) == Sign::Positive &&
           order_along_line(points_, p, q, x, at(end(e, 1))) == Sign::Positive;
  }

  void test_flat_edges() {
    gather_edges([this](EdgeId e) {
      const UseId first = c_.edge_use[e.value()];
      return all_uses(e, [&](UseId u) { return plane(u) == plane(first); });
    });
    BoxTree(edge_boxes_).for_each_pair_inside([this](std::uint32_t i, std::uint32_t j) {
      step_();
      if (cross(edges_[i], edges_[j])) note(kEdgesCross, edges_[i], edges_[j]);
    });
  }
  /// In one point inside both: then one passes a plane of the other.
  bool cross(EdgeId e, EdgeId g) {
    const auto& [p, q] = c_.edge_planes[e.value()];
    for (const auto& [first, second] : {std::pair{p, q}, std::pair{q, p}}) {
      if (side_of(end(g, 0), first) * side_of(end(g, 1), first) != Sign::Negative) continue;
      const SpacePoint x = crossing(g, first);
      return side(points_, x, second) == Sign::Zero && is_between_ends(e, x);
    }
    return false;
  }

  Point3Table points_;  ///< those of the complex and crossings
  MeetLeaves leaves_;
  LeafCache items_;
  std::vector<Triangle> triangles_;  ///< per facet
  std::vector<EdgeId> edges_;
  std::vector<Box3> edge_boxes_;
  Kind worst_ = kNothing;
};

}  // namespace

std::optional<SpaceFlaw> audit_meeting(const SpaceComplex& complex,
                                       std::span<const std::uint8_t> has_fan, Context& context) {
  return MeetingAudit(complex, has_fan, context).run();
}

}  // namespace plumb
