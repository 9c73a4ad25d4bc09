// Part 2 of audit(): points, lines and planes, one cell and its neighbours at a time.
//
// Planes of a table and points of vertices are distinct; ends of edges lie on both planes; the
// direction of each edge agrees with its planes; edges of a facet lie in its plane; facets turn
// counter-clockwise around edges; directions around a vertex are distinct and its corners neither
// cross nor hold an edge. So every sphere map is drawn without crossings. Around a vertex with a
// fan (mesh_topology.h), the corners need no test. Other vertices cost O(d^2) for d edges.
//
// Notation: directions in a plane n are sign (n x m) for another plane m of the line. Seen from the
// positive side of n, s (n x m) turns to t (n x k) counter-clockwise exactly when s t det3(n, m, k)
// is positive.
//
// Equality is found by fingerprints (docs/design/planes-first.md, "Fingerprints"): different
// fingerprints prove different objects, so only cells with equal fingerprints are compared exactly.
//
// Declared in plumb/space/audit/audit_parts.h.
// Tested by tests/space/space_audit_test.cpp.

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/audit/audit_parts.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {
namespace {

/// Part 2.
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

  /// An item with its fingerprint.
  struct Keyed {
    Fingerprint print;
    std::uint32_t item;
  };
  /// Returns the items whose fingerprint occurs more than once, sorted by fingerprint, and possibly
  /// some more items. If an item is alone in the slot of its low bits, there is no equal item.
  /// Therefore few items have to be sorted.
  static std::vector<Keyed> with_equal_prints(std::span<const Fingerprint> prints) {
    std::vector<std::uint8_t> seen(std::bit_ceil(8 * prints.size() + 1));
    const auto place = [&](Fingerprint print) -> std::uint8_t& {
      return seen[print & (seen.size() - 1)];
    };
    for (const Fingerprint print : prints) {
      std::uint8_t& times = place(print);
      times = times == 0 ? 1 : 2;
    }
    std::vector<Keyed> items;
    for (std::uint32_t i = 0; i < prints.size(); ++i) {
      if (place(prints[i]) == 2) items.push_back({prints[i], i});
    }
    std::ranges::stable_sort(items, {}, &Keyed::print);
    return items;
  }
  /// Returns a pair of equal items among those with the same fingerprint. is_before() orders them,
  /// and are_equal() compares them. Returns nothing if there is no such pair.
  template <class Before, class Equal>
  static std::optional<std::pair<std::uint32_t, std::uint32_t>> find_equal(std::vector<Keyed> items,
                                                                           const Before& is_before,
                                                                           const Equal& are_equal) {
    for (auto first = items.begin(), last = first; first != items.end(); first = last) {
      while (last != items.end() && last->print == first->print) ++last;
      if (last - first > 2) std::sort(first, last, is_before);
      const auto equal = std::adjacent_find(first, last, are_equal);
      if (equal != last) return std::minmax(equal->item, std::next(equal)->item);
    }
    return std::nullopt;
  }

  /// Whether planes have different coefficients.
  bool has_distinct_planes() {
    const PlaneTable& planes = c_.planes();
    std::vector<Fingerprint> prints(planes.size());
    for (std::uint32_t i = 0; i < prints.size(); ++i) prints[i] = planes.fingerprint(PlaneId(i));
    const auto key = [&](const Keyed& k) {
      step_();
      return std::pair(planes.is_frame(PlaneId(k.item)), planes.primitive(PlaneId(k.item)));
    };
    const auto equal = find_equal(
        with_equal_prints(prints), [&](const Keyed& p, const Keyed& q) { return key(p) < key(q); },
        [&](const Keyed& p, const Keyed& q) { return key(p) == key(q); });
    if (!equal) return true;
    return fail("planes are different",
                "planes " + std::to_string(equal->first) + ", " + std::to_string(equal->second));
  }

  /// Whether vertices have different points. Equal points have equal fingerprints.
  bool has_distinct_vertices() {
    const auto point = [this](const Keyed& k) {
      step_();
      return at(VertexId(k.item));
    };
    const auto equal_vertices = find_equal(
        with_equal_prints(prints_of_vertices()),
        [&](const Keyed& v, const Keyed& w) {
          return compare_xyz(c_.points(), point(v), point(w)) == Sign::Negative;
        },
        [&](const Keyed& v, const Keyed& w) { return equal(c_.points(), point(v), point(w)); });
    if (!equal_vertices) return true;
    const auto [v, w] = *equal_vertices;
    return fail_at("vertices have different points", VertexId(v), VertexId(w));
  }

  /// Returns the fingerprint of each vertex's point, with a checkpoint after each block.
  std::vector<Fingerprint> prints_of_vertices() {
    constexpr std::size_t kBlock = 4096;
    std::vector<Fingerprint> prints;
    prints.reserve(c_.vertex_count());
    while (prints.size() < c_.vertex_count()) {
      step_.checkpoint();
      const std::size_t count = std::min(kBlock, c_.vertex_count() - prints.size());
      const auto block =
          fingerprints(c_.points(), std::span(c_.vertex_point).subspan(prints.size(), count));
      prints.insert(prints.end(), block.begin(), block.end());
    }
    return prints;
  }

  /// Whether a vertex lies on a plane.
  bool lies_on(VertexId v, PlaneId p) const {
    const SpacePoint x = at(v);
    if (x.is_input() && c_.planes().source(p).has_point(x.input())) return true;
    return side(c_.points(), x, p) == Sign::Zero;
  }
  bool are_parallel(PlaneId p, PlaneId q) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (minor_sign(c_.planes(), p, q, axis) != Sign::Zero) return false;
    }
    return true;
  }

  /// Whether every edge lies on both its planes and has the direction that they determine. If all
  /// uses lie in the planes of their facets, the ends of an edge lie in those planes without
  /// another test.
  bool has_true_edges() {
    are_uses_flat_ = have_uses_their_planes();
    return all_of<EdgeId>(c_.edge_count(), [this](EdgeId e) {
      const auto& [p, q] = c_.edge_planes[e];
      const bool lies_in_both = are_uses_flat_ && has_facet_in(e, p) && has_facet_in(e, q);
      return (p != q && lies_in_both && runs_forward(e)) || is_true_edge(e);
    });
  }
  /// Checks one edge, and reports its flaw.
  bool is_true_edge(EdgeId e) {
    const auto& [p, q] = c_.edge_planes[e];
    if (!require(p != q && !are_parallel(p, q), "the planes of an edge cross", e)) return false;
    for (const std::uint32_t h : {2 * e.value(), 2 * e.value() + 1}) {
      const VertexId v = c_.origin[h];
      if (!require(lies_on(v, p) && lies_on(v, q), "the ends of an edge lie on its planes", e, v)) {
        return false;
      }
    }
    return require(runs_forward(e), "an edge runs as its planes say", e);
  }
  /// Whether half-edge 2e has the direction n_p x n_q. It never has if the planes are parallel.
  /// Requires ends that lie on its planes.
  bool runs_forward(EdgeId e) const {
    const auto& [p, q] = c_.edge_planes[e];
    const SpacePoint from = at(c_.origin[2 * e.value()]), to = at(c_.origin[2 * e.value() + 1]);
    const PointBox start = c_.points().box(from), end = c_.points().box(to);
    std::size_t axis = 0;  // The axis along which the ends are farthest apart.
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::fabs(end.mid[i] - start.mid[i]) > std::fabs(end.mid[axis] - start.mid[axis]))
        axis = i;
    }
    const FilteredSign rises = rung::compare_axis_filter(end, start, axis);
    if (is_decided(rises)) return decided(rises) == minor_sign(c_.planes(), p, q, axis);
    return order_along_line(c_.points(), p, q, from, to) == Sign::Positive;
  }
  /// Whether one of the first two facets around the edge lies in a plane.
  bool has_facet_in(EdgeId e, PlaneId p) const {
    const UseId u = c_.edge_use[e];
    return u.is_valid() && (plane(u) == p || plane(c_.use_radial[u]) == p);
  }

  /// Whether a use begins in the plane of its facet. The next use of its cycle begins where this
  /// use ends.
  bool lies_in_its_plane(UseId u) const { return lies_on(c_.use_origin(u), plane(u)); }
  bool have_uses_their_planes() const {
    return all_of<UseId>(c_.use_count(), [this](UseId u) { return lies_in_its_plane(u); });
  }
  bool has_uses_in_their_planes() {
    return are_uses_flat_ || all_of<UseId>(c_.use_count(), [this](UseId u) {
             return require(lies_in_its_plane(u), "the edges of a facet lie in its plane", u,
                            facet(u));
           });
  }

  // ---- around an edge

  /// Returns the turn from the facet of one use to the facet of another use, about half-edge 2e.
  /// The turn between facets is the turn between their normals. At uses of 2e + 1, the normals are
  /// reversed.
  Sign turn_about_edge(EdgeId e, UseId u, UseId w) const {
    const auto& [p, q] = c_.edge_planes[e];
    const Sign turn = turn_about_line(c_.planes(), p, q, plane(u), plane(w));
    return is_reverse(u) == is_reverse(w) ? turn : -turn;
  }
  bool is_reverse(UseId u) const { return SpaceComplex::is_reverse(halfedge(u)); }
  /// Returns the class of the turn from u to w: 0 for no turn, 1 for less than a half turn, 2 for a
  /// half turn, 3 for more.
  int turn_class(EdgeId e, UseId u, UseId w) const {
    const Sign turn = turn_about_edge(e, u, w);
    if (turn != Sign::Zero) return turn == Sign::Positive ? 1 : 3;
    return is_reverse(u) == is_reverse(w) ? 0 : 2;
  }

  bool has_turning_rings() {
    return all_of<EdgeId>(c_.edge_count(), [this](EdgeId e) {
      return !c_.edge_use[e].is_valid() || has_turning_ring(e);
    });
  }
  /// Whether the radial cycle of an edge turns counter-clockwise exactly once. This is always the
  /// case for two facets in different planes.
  bool has_turning_ring(EdgeId e) {
    const UseId first = c_.edge_use[e], second = c_.use_radial[first];
    if (c_.use_radial[second] == first && plane(first) != plane(second)) return true;
    UseId before = first;
    int turned_before = 0;
    for (UseId u = second; u != first; u = c_.use_radial[u]) {
      step_();
      const int turned = turn_class(e, first, u);
      const bool is_after =
          turned > turned_before ||
          (turned == turned_before && turn_about_edge(e, before, u) == Sign::Positive);
      if (!require(turned != 0 && is_after, "facets turn counter-clockwise around an edge", e, u)) {
        return false;
      }
      before = u;
      turned_before = turned;
    }
    return true;
  }

  // ---- around a vertex

  /// The direction sign (n x n_m) in a plane n.
  struct DirectionInPlane {
    PlaneId m;
    Sign sign;
    DirectionInPlane opposite() const { return {m, -sign}; }
  };
  /// Returns the sign of a coordinate of a half-edge's direction.
  Sign coordinate_sign(HalfedgeId h, std::size_t axis) const {
    const auto& [p, q] = c_.edge_planes[h.value() / 2];
    const Sign s = minor_sign(c_.planes(), p, q, axis);
    return SpaceComplex::is_reverse(h) ? -s : s;
  }
  DirectionInPlane direction_in_plane(PlaneId n, HalfedgeId h) const {
    const OtherPlane m = other_plane(c_, SpaceComplex::edge_of(h), n);
    return {m.plane, SpaceComplex::is_reverse(h) ? -m.turn : m.turn};
  }
  Sign turn_in_plane(PlaneId n, DirectionInPlane a, DirectionInPlane b) const {
    return a.sign * b.sign * det3_sign(c_.planes(), n, a.m, b.m);
  }
  /// Whether two directions on one line are opposite.
  bool are_opposite(PlaneId n, DirectionInPlane a, DirectionInPlane b) const {
    std::size_t axis = 0;
    while (minor_sign(c_.planes(), n, a.m, axis) == Sign::Zero) ++axis;
    return a.sign * minor_sign(c_.planes(), n, a.m, axis) !=
           b.sign * minor_sign(c_.planes(), n, b.m, axis);
  }
  /// Returns the class of the counter-clockwise turn from a to b: 0 for no turn, 1 for less than a
  /// half turn, 2 for a half turn, 3 for more.
  int turn_class(PlaneId n, DirectionInPlane a, DirectionInPlane b) const {
    const Sign turn = turn_in_plane(n, a, b);
    if (turn != Sign::Zero) return turn == Sign::Positive ? 1 : 3;
    return are_opposite(n, a, b) ? 2 : 0;
  }

  /// Whether the sphere map of every vertex is drawn without crossings. Around a vertex with a fan,
  /// directions differ and corners lie side by side, so no test is needed.
  bool has_sound_stars() {
    return all_of<VertexId>(c_.vertex_count(), [this](VertexId v) {
      if (has_fan_[v.value()] != 0) return true;
      const std::vector<UseId> corners = corners_at(v);
      return has_distinct_directions(v) && has_undivided_corners(v, corners) &&
             has_corners_apart(v, corners) && has_undivided_disk(v, corners);
    });
  }

  bool lies_on(HalfedgeId h, PlaneId p) const { return lies_on(c_.target(h), p); }

  /// Whether the edges leave a vertex in different directions. On one line, there are at most two
  /// edges, in opposite directions.
  bool has_distinct_directions(VertexId v) {
    const auto star = c_.star_of(v);
    for (std::size_t i = 0; i < star.size(); ++i) {
      for (std::size_t j = i + 1; j < star.size(); ++j) {
        const HalfedgeId g = star[i], h = star[j];
        step_();
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

  /// Returns the uses that leave the vertex, sorted by plane.
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
      u = c_.use_radial[u];
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
  /// Whether corners of one plane, visited in counter-clockwise order, each end at the next edge.
  /// In this case, no edge divides a corner, and no two corners overlap.
  bool has_undivided_corners_in_plane(VertexId v, const std::vector<UseId>& corners) {
    const PlaneId n = plane(corners.front());
    const std::vector<HalfedgeId> around = edges_in_plane(v, n, halfedge(corners.front()));
    UseId inside;
    for (std::size_t i = 0; i <= around.size(); ++i) {
      step_();
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
  /// Returns the edges at v in a plane, counter-clockwise from `first` on.
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
    result.reserve(edges.size());
    for (const auto& edge : edges) result.push_back(edge.first);
    return result;
  }

  /// Whether a direction in the plane of a corner lies strictly inside of the corner. If the end of
  /// a corner is its beginning, the corner is a full turn.
  bool holds(UseId corner, DirectionInPlane d) const {
    const PlaneId n = plane(corner);
    const DirectionInPlane from = direction_in_plane(n, halfedge(corner));
    const DirectionInPlane to = direction_in_plane(n, corner_end(corner));
    const int at = turn_class(n, from, d), end = turn_class(n, from, to);
    if (at == 0 || end == 0) return at != 0;
    return at != end ? at < end : turn_in_plane(n, d, to) == Sign::Positive;
  }

  /// Whether no two corners cross. Corners in different planes have at most the two directions of
  /// the common line of the planes in common.
  bool has_corners_apart(VertexId v, const std::vector<UseId>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        step_();
        if (!require(!cross(corners[i], corners[j]), "corners do not cross", v, corners[i],
                     corners[j])) {
          return false;
        }
      }
    }
    return true;
  }
  /// Whether corners in different planes have a direction strictly inside both.
  bool cross(UseId u, UseId w) const {
    const PlaneId n = plane(u), m = plane(w);
    if (n == m) return false;
    // The two products satisfy n x m = -(m x n).
    const DirectionInPlane in_n{m, Sign::Positive}, in_m{n, Sign::Negative};
    return (holds(u, in_n) && holds(w, in_m)) ||
           (holds(u, in_n.opposite()) && holds(w, in_m.opposite()));
  }

  /// Whether no edge and no corner at a vertex inside of a facet passes that facet.
  bool has_undivided_disk(VertexId v, const std::vector<UseId>& corners) {
    const FacetId f = c_.vertex_facet[v];
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

  std::span<const std::uint8_t> has_fan_;  ///< Whether each vertex has a fan.
  bool are_uses_flat_ = false;             ///< Whether all lie in the planes of their facets.
};

}  // namespace

std::optional<SpaceFlaw> audit_places(const SpaceComplex& complex,
                                      std::span<const std::uint8_t> has_fan, Context& context) {
  return PlaceAudit(complex, has_fan, context).run();
}

}  // namespace plumb
