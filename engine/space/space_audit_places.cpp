// Step 2 of audit(): points, lines and planes, one item and its neighbours at a time.
//
// Directions in a plane n are sign (n x m) for another plane m of the line. Seen from the positive side
// of n, s (n x m) turns to t (n x k) counter-clockwise exactly when s t det3(n, m, k) is positive.
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_audit_parts.h"

namespace plumb {
namespace {

class PlaceAudit : SpaceAuditPart {
 public:
  PlaceAudit(const SpaceComplex& complex, std::span<const std::uint8_t> has_fan, Context& context)
      : SpaceAuditPart(complex, context, 1), has_fan_(has_fan) {}

  std::optional<SpaceFlaw> run() {
    static_cast<void>(has_distinct_planes() && has_distinct_vertices() && has_true_edges() &&
                      has_uses_in_their_planes() && has_turning_rings() && has_sound_stars());
    return flaw_;
  }

 private:
  // ---- planes and points

  bool has_distinct_planes() {
    const PlaneTable& planes = c_.planes();
    std::vector<std::uint32_t> order(planes.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t i) { return planes.fingerprint(PlaneId(i)); };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      const PlaneId p(order[i]), q(order[i + 1]);
      if (planes.fingerprint(p) != planes.fingerprint(q)) continue;
      if (planes.is_frame(p) == planes.is_frame(q) && planes.primitive(p) == planes.primitive(q)) {
        return fail("planes are different",
                    "planes " + std::to_string(p.value()) + ", " + std::to_string(q.value()));
      }
    }
    return true;
  }

  /// Equal points have equal fingerprints.
  bool has_distinct_vertices() {
    std::vector<std::pair<Fingerprint, VertexId>> order(c_.vertex_count());
    for (std::uint32_t v = 0; v < order.size(); ++v) {
      step_();
      order[v] = {fingerprint(c_.points(), at(VertexId(v))), VertexId(v)};
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto& [print, v] = order[i];
      for (std::size_t j = i + 1; j < order.size() && order[j].first == print; ++j) {
        const VertexId w = order[j].second;
        if (!require(!equal(c_.points(), at(v), at(w)), "vertices have different points", v, w)) {
          return false;
        }
      }
    }
    return true;
  }

  bool lies_on(VertexId v, PlaneId p) const { return side(c_.points(), at(v), p) == Sign::Zero; }
  bool are_parallel(PlaneId p, PlaneId q) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (minor_sign(c_.planes(), p, q, axis) != Sign::Zero) return false;
    }
    return true;
  }

  bool has_true_edges() {
    for (std::uint32_t i = 0; i < c_.edge_count(); ++i) {
      const EdgeId e(i);
      const auto& [p, q] = c_.edge_planes[i];
      const VertexId from = c_.origin[2 * i], to = c_.origin[2 * i + 1];
      if (!require(p != q && !are_parallel(p, q), "the planes of an edge cross", e)) return false;
      for (const VertexId v : {from, to}) {
        if (!require(lies_on(v, p) && lies_on(v, q), "the ends of an edge lie on its planes", e,
                     v)) {
          return false;
        }
      }
      if (!require(order_along_line(c_.points(), p, q, at(from), at(to)) == Sign::Positive,
                   "an edge runs as its planes say", e)) {
        return false;
      }
    }
    return true;
  }

  bool has_uses_in_their_planes() {
    for (std::uint32_t i = 0; i < c_.use_count(); ++i) {
      const UseId u(i);  // where it ends the next one of its cycle begins
      if (!require(lies_on(c_.use_origin(u), plane(u)), "the edges of a facet lie in its plane", u,
                   facet(u))) {
        return false;
      }
    }
    return true;
  }

  // ---- around an edge

  /// From the facet of one use to that of another, about half-edge 2e. Facets turn as their normals do,
  /// pointing the other way at uses of 2e + 1.
  Sign turn_about_edge(EdgeId e, UseId u, UseId w) const {
    const auto& [p, q] = c_.edge_planes[e.value()];
    const Sign turn = turn_about_line(c_.planes(), p, q, plane(u), plane(w));
    return is_reverse(u) == is_reverse(w) ? turn : -turn;
  }
  bool is_reverse(UseId u) const { return SpaceComplex::is_reverse(halfedge(u)); }
  /// 0: the same, 1: below half a turn, 2: half a turn, 3: more.
  int turn_class(EdgeId e, UseId u, UseId w) const {
    const Sign turn = turn_about_edge(e, u, w);
    if (turn != Sign::Zero) return turn == Sign::Positive ? 1 : 3;
    return is_reverse(u) == is_reverse(w) ? 0 : 2;
  }

  bool has_turning_rings() {
    for (std::uint32_t e = 0; e < c_.edge_count(); ++e) {
      if (c_.edge_use[e].is_valid() && !has_turning_ring(EdgeId(e))) return false;
    }
    return true;
  }
  bool has_turning_ring(EdgeId e) {
    const UseId first = c_.edge_use[e.value()];
    UseId before = first;
    for (UseId u = c_.use_radial[first.value()]; u != first; u = c_.use_radial[u.value()]) {
      const int turned = turn_class(e, first, u);
      const int turned_before = turn_class(e, first, before);
      const bool is_after =
          turned > turned_before ||
          (turned == turned_before && turn_about_edge(e, before, u) == Sign::Positive);
      if (!require(turned != 0 && is_after, "facets turn counter-clockwise around an edge", e, u)) {
        return false;
      }
      before = u;
    }
    return true;
  }

  // ---- around a vertex

  struct DirectionInPlane {
    PlaneId m;
    Sign sign;
    DirectionInPlane opposite() const { return {m, -sign}; }
  };
  Sign coordinate_sign(HalfedgeId h, std::size_t axis) const {
    const auto& [p, q] = c_.edge_planes[h.value() / 2];
    const Sign s = minor_sign(c_.planes(), p, q, axis);
    return SpaceComplex::is_reverse(h) ? -s : s;
  }
  DirectionInPlane direction_in_plane(PlaneId n, HalfedgeId h) const {
    const auto& [p, q] = c_.edge_planes[h.value() / 2];
    const PlaneId m = p == n ? q : p;
    std::size_t axis = 0;
    while (coordinate_sign(h, axis) == Sign::Zero) ++axis;
    return {m, coordinate_sign(h, axis) * minor_sign(c_.planes(), n, m, axis)};
  }
  Sign turn_in_plane(PlaneId n, DirectionInPlane a, DirectionInPlane b) const {
    return a.sign * b.sign * det3_sign(c_.planes(), n, a.m, b.m);
  }
  /// Of two directions on one line.
  bool are_opposite(PlaneId n, DirectionInPlane a, DirectionInPlane b) const {
    std::size_t axis = 0;
    while (minor_sign(c_.planes(), n, a.m, axis) == Sign::Zero) ++axis;
    return a.sign * minor_sign(c_.planes(), n, a.m, axis) !=
           b.sign * minor_sign(c_.planes(), n, b.m, axis);
  }
  /// From a to b, counter-clockwise: 0: no turn, 1: below half a turn, 2: half a turn, 3: more.
  int turn_class(PlaneId n, DirectionInPlane a, DirectionInPlane b) const {
    const Sign turn = turn_in_plane(n, a, b);
    if (turn != Sign::Zero) return turn == Sign::Positive ? 1 : 3;
    return are_opposite(n, a, b) ? 2 : 0;
  }

  /// Around a vertex with a fan directions differ, and triangles lie side by side.
  bool has_sound_stars() {
    for (std::uint32_t v = 0; v < c_.vertex_count(); ++v) {
      if (has_fan_[v] != 0 && !c_.vertex_facet[v].is_valid()) continue;
      const std::vector<UseId> corners = corners_at(VertexId(v));
      if (!has_distinct_directions(VertexId(v)) || !has_undivided_corners(VertexId(v), corners) ||
          !has_corners_apart(VertexId(v), corners) || !has_undivided_disk(VertexId(v), corners)) {
        return false;
      }
    }
    return true;
  }

  bool lies_on(HalfedgeId h, PlaneId p) const { return lies_on(c_.target(h), p); }

  /// One line through the vertex leaves it in at most two directions.
  bool has_distinct_directions(VertexId v) {
    const auto star = c_.star_of(v);
    for (std::size_t i = 0; i < star.size(); ++i) {
      for (std::size_t j = i + 1; j < star.size(); ++j) {
        const HalfedgeId g = star[i], h = star[j];
        if (!is_on_line_of(g, h)) continue;
        if (!require(leave_oppositely(g, h), "edges leave a vertex in different directions", v, g,
                     h)) {
          return false;
        }
      }
    }
    return true;
  }
  bool is_on_line_of(HalfedgeId g, HalfedgeId h) const {
    const auto& [p, q] = c_.edge_planes[g.value() / 2];
    return lies_on(h, p) && lies_on(h, q);
  }
  bool leave_oppositely(HalfedgeId g, HalfedgeId h) const {
    std::size_t axis = 0;
    while (coordinate_sign(g, axis) == Sign::Zero) ++axis;
    return coordinate_sign(g, axis) == -coordinate_sign(h, axis);
  }

  /// The uses that leave the vertex, by plane.
  std::vector<UseId> corners_at(VertexId v) const {
    std::vector<UseId> corners;
    for (const HalfedgeId h : c_.star_of(v)) add_corners(h, corners);
    std::sort(corners.begin(), corners.end(),
              [&](UseId u, UseId w) { return plane(u) < plane(w); });
    return corners;
  }
  void add_corners(HalfedgeId h, std::vector<UseId>& corners) const {
    const UseId first = c_.edge_use[h.value() / 2];
    if (!first.is_valid()) return;
    UseId u = first;
    do {
      if (halfedge(u) == h) corners.push_back(u);
      u = c_.use_radial[u.value()];
    } while (u != first);
  }

  bool has_undivided_corners(VertexId v, const std::vector<UseId>& corners) {
    for (auto first = corners.begin(); first != corners.end();) {
      const auto last =
          std::find_if(first, corners.end(), [&](UseId u) { return plane(u) != plane(*first); });
      if (!has_undivided_corners_in_plane(v, {first, last})) return false;
      first = last;
    }
    return true;
  }
  /// Corners of one plane, met in counter-clockwise order: each ends at the edge that comes next.
  bool has_undivided_corners_in_plane(VertexId v, const std::vector<UseId>& corners) {
    const PlaneId n = plane(corners.front());
    const std::vector<HalfedgeId> around = edges_in_plane(v, n, halfedge(corners.front()));
    UseId inside;
    for (std::size_t i = 0; i <= around.size(); ++i) {
      const HalfedgeId h = around[i % around.size()];
      if (!require(!inside.is_valid() || corner_end(inside) == h,
                   "a corner turns to the next edge in its plane", v, inside, h)) {
        return false;
      }
      const auto starting =
          std::find_if(corners.begin(), corners.end(), [&](UseId u) { return halfedge(u) == h; });
      inside = starting == corners.end() ? UseId() : *starting;
    }
    return true;
  }
  /// Counter-clockwise from `first` on.
  std::vector<HalfedgeId> edges_in_plane(VertexId v, PlaneId n, HalfedgeId first) const {
    std::vector<std::pair<HalfedgeId, DirectionInPlane>> edges;
    for (const HalfedgeId h : c_.star_of(v)) {
      if (lies_on(h, n)) edges.emplace_back(h, direction_in_plane(n, h));
    }
    const DirectionInPlane start = direction_in_plane(n, first);
    std::sort(edges.begin(), edges.end(), [&](const auto& g, const auto& h) {
      const int a = turn_class(n, start, g.second), b = turn_class(n, start, h.second);
      return a != b ? a < b : turn_in_plane(n, g.second, h.second) == Sign::Positive;
    });
    std::vector<HalfedgeId> result;
    for (const auto& edge : edges) result.push_back(edge.first);
    return result;
  }

  /// Does a direction in the plane of a corner lie strictly inside it?
  bool holds(UseId corner, DirectionInPlane d) const {
    const PlaneId n = plane(corner);
    const DirectionInPlane from = direction_in_plane(n, halfedge(corner));
    const DirectionInPlane to = direction_in_plane(n, corner_end(corner));
    const int at = turn_class(n, from, d), end = turn_class(n, from, to);
    if (at == 0 || end == 0) return at != 0;
    return at != end ? at < end : turn_in_plane(n, d, to) == Sign::Positive;
  }

  /// Corners in different planes have at most the two directions of their common line in common.
  bool has_corners_apart(VertexId v, const std::vector<UseId>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        if (!require(!cross(corners[i], corners[j]), "corners do not cross", v, corners[i],
                     corners[j])) {
          return false;
        }
      }
    }
    return true;
  }
  bool cross(UseId u, UseId w) const {
    const PlaneId n = plane(u), m = plane(w);
    if (n == m) return false;
    const DirectionInPlane in_n{m, Sign::Positive}, in_m{n, Sign::Negative};  // n x m = -(m x n)
    return (holds(u, in_n) && holds(w, in_m)) ||
           (holds(u, in_n.opposite()) && holds(w, in_m.opposite()));
  }

  bool has_undivided_disk(VertexId v, const std::vector<UseId>& corners) {
    const FacetId f = c_.vertex_facet[v.value()];
    if (!f.is_valid()) return true;
    if (!require(lies_on(v, plane(f)), "a vertex inside a facet lies in its plane", v, f)) {
      return false;
    }
    for (const HalfedgeId h : c_.star_of(v)) {
      if (!require(!lies_on(h, plane(f)), "no edge leaves a vertex within the facet around it", v,
                   h)) {
        return false;
      }
    }
    for (const UseId u : corners) {
      const DirectionInPlane common{plane(f), Sign::Positive};
      if (!require(!holds(u, common) && !holds(u, common.opposite()),
                   "no corner passes the facet around its vertex", v, u)) {
        return false;
      }
    }
    return true;
  }

  std::span<const std::uint8_t> has_fan_;  ///< per vertex
};

}  // namespace

std::optional<SpaceFlaw> audit_places(const SpaceComplex& complex,
                                      std::span<const std::uint8_t> has_fan, Context& context) {
  return PlaceAudit(complex, has_fan, context).run();
}

}  // namespace plumb
