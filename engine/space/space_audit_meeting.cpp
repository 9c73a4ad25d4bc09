// Step 4 of audit(): nothing meets but at common vertices and edges.
//
// Rings and corners have been checked: near a vertex or edge nothing overlaps that contains it. So two
// items overlap only if somewhere a vertex lies inside an edge or a facet, two edges cross inside both,
// or an edge passes through a facet: a common segment of two facets ends in one of these.
#include <algorithm>
#include <cmath>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_audit_parts.h"

namespace plumb {
namespace {

class MeetingAudit : SpaceAuditPart {
 public:
  explicit MeetingAudit(const SpaceComplex& complex)
      : SpaceAuditPart(complex), points_(complex.points()) {}

  std::optional<SpaceFlaw> run() {
    make_boxes();
    const BoxTree vertices(vertex_box_), edges(edge_box_), facets(facet_box_);
    const auto unless_failed = [this](auto check) {
      return [this, check](std::uint32_t i, std::uint32_t j) {
        if (!flaw_) check(i, j);
      };
    };
    BoxTree::for_each_pair(vertices, edges, unless_failed([this](std::uint32_t v, std::uint32_t e) {
                             require(!lies_inside(VertexId(v), EdgeId(e)),
                                     "no vertex lies inside an edge", VertexId(v), EdgeId(e));
                           }));
    BoxTree::for_each_pair(edges, edges, unless_failed([this](std::uint32_t e, std::uint32_t g) {
                             require(e >= g || !cross(EdgeId(e), EdgeId(g)), "edges do not cross",
                                     EdgeId(e), EdgeId(g));
                           }));
    BoxTree::for_each_pair(
        vertices, facets, unless_failed([this](std::uint32_t v, std::uint32_t f) {
          require(!lies_unlisted_in(VertexId(v), FacetId(f)),
                  "no vertex lies inside a facet unlisted", VertexId(v), FacetId(f));
        }));
    BoxTree::for_each_pair(edges, facets, unless_failed([this](std::uint32_t e, std::uint32_t f) {
                             require(!passes_through(EdgeId(e), FacetId(f)),
                                     "no edge passes through a facet", EdgeId(e), FacetId(f));
                           }));
    return flaw_;
  }

 private:
  // ---- boxes

  void make_boxes() {
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v)
      vertex_box_.push_back(box_of(VertexId(v)));
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      edge_box_.push_back(vertex_box_[c_.origin[2 * e].value()]);
      edge_box_.back().add(vertex_box_[c_.origin[2 * e + 1].value()]);
    }
    facet_box_.resize(c_.facet_count());
    for (std::uint32_t u = 0; u < c_.use_count(); ++u) {
      facet_box_[c_.use_facet[u].value()].add(vertex_box_[c_.use_origin(UseId(u)).value()]);
    }
  }

  Box3 box_of(VertexId v) const {
    const PointBox point = c_.points().box(at(v));
    Box3 box;
    for (std::size_t i = 0; i < 3; ++i) {
      const double low = point.mid[i] - point.radius, high = point.mid[i] + point.radius;
      box.low[i] = std::isnan(low) ? -Box3::kInfinity : std::nextafter(low, -Box3::kInfinity);
      box.high[i] = std::isnan(high) ? Box3::kInfinity : std::nextafter(high, Box3::kInfinity);
    }
    return box;
  }

  // ---- tests

  Sign side_of(VertexId v, PlaneId p) const { return side(points_, at(v), p); }
  VertexId end(EdgeId e, std::uint32_t i) const { return c_.origin[2 * e.value() + i]; }

  /// Is x, a point of the line of e, strictly between its ends?
  bool is_between_ends(EdgeId e, SpacePoint x) const {
    const auto& [p, q] = c_.edge_planes[e.value()];
    return order_along_line(points_, p, q, at(end(e, 0)), x) == Sign::Positive &&
           order_along_line(points_, p, q, x, at(end(e, 1))) == Sign::Positive;
  }

  bool lies_inside(VertexId v, EdgeId e) const {
    const auto& [p, q] = c_.edge_planes[e.value()];
    if (v == end(e, 0) || v == end(e, 1)) return false;
    return side_of(v, p) == Sign::Zero && side_of(v, q) == Sign::Zero && is_between_ends(e, at(v));
  }

  bool passes(EdgeId e, PlaneId p) const {
    const Sign from = side_of(end(e, 0), p), to = side_of(end(e, 1), p);
    return from != Sign::Zero && from == -to;
  }
  /// Where an edge that passes a plane does so.
  SpacePoint crossing(EdgeId e, PlaneId p) {
    const auto& [first, second] = c_.edge_planes[e.value()];
    return points_.add(first, second, p);
  }

  /// In one point inside both: then one passes a plane of the other.
  bool cross(EdgeId e, EdgeId g) {
    const auto& [p, q] = c_.edge_planes[e.value()];
    for (const auto& [first, second] : {std::pair{p, q}, std::pair{q, p}}) {
      if (!passes(g, first)) continue;
      const SpacePoint x = crossing(g, first);
      return side(points_, x, second) == Sign::Zero && is_between_ends(e, x);
    }
    return false;
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

  bool lies_unlisted_in(VertexId v, FacetId f) const {
    return c_.vertex_facet[v.value()] != f && side_of(v, plane(f)) == Sign::Zero &&
           !is_on_boundary(v, f) && contains(c_, f, points_, at(v));
  }

  bool passes_through(EdgeId e, FacetId f) {
    return passes(e, plane(f)) && contains(c_, f, points_, crossing(e, plane(f)));
  }

  Point3Table points_;  ///< those of the complex and crossings
  std::vector<Box3> vertex_box_;
  std::vector<Box3> edge_box_;
  std::vector<Box3> facet_box_;
};

}  // namespace

std::optional<SpaceFlaw> audit_meeting(const SpaceComplex& complex) {
  return MeetingAudit(complex).run();
}

}  // namespace plumb
