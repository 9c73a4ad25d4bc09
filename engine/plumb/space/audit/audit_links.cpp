// Parts 1 and 3 of audit(): arrays and ids, and the boundary cycles of facets in their planes.
//
// Part 1 reads arrays and ids alone. Each check reads only data whose existence an earlier check
// has confirmed. So a complex from an untrusted file cannot make a check read out of bounds.
//
// Part 3 requires parts 1 and 2: edges and corners are sound around every vertex. Then a facet has
// one cycle for each connected part of its boundary; the first cycle is the outer cycle. The others
// are holes inside it, and no hole lies in another hole. The direction of a cycle is decided at its
// least vertex, where all edges leave within a half turn. In a cycle around a hole, one corner at
// this vertex is larger than a half turn. In an outer cycle, no corner is. That cycles do not cross
// each other or themselves is the subject of part 4.
//
// The position of a point relative to a cycle is found by counting, along a half-line on which one
// coordinate is constant, the edges that pass it. The walk is independent of facet_site(), which
// the algorithms use; they share predicates only.
//
// Declared in plumb/space/audit/audit_parts.h.
// Tested by tests/space/space_audit_test.cpp.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/audit/audit_parts.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {
namespace {

/// Part 1: arrays and ids. This part reads no other data.
class LinkAudit : SpaceAuditPart {
 public:
  LinkAudit(const SpaceComplex& complex, Context& context) : SpaceAuditPart(complex, context, 0) {}

  std::optional<SpaceFlaw> run() {
    // Each check reads only data whose existence the earlier checks have confirmed.
    static_cast<void>(has_right_sizes() && has_marks() && names_tables() && names_items() &&
                      has_edges_with_two_ends() && has_stars() && has_linked_uses() &&
                      has_radial_cycles() && has_boundary_cycles() && has_inner_vertices() &&
                      has_volumes_where_needed());
    return flaw_;
  }

 private:
  // ---- sizes and ids

  /// Whether arrays have one entry for each cell, and lists cover their arrays.
  bool has_right_sizes() {
    const std::size_t v = c_.vertex_count(), e = c_.edge_count(), u = c_.use_count(),
                      f = c_.facet_count();
    const bool right =
        c_.tables && c_.vertex_mark.size() == v && c_.vertex_volume.size() == v &&
        c_.vertex_facet.size() == v && c_.edge_mark.size() == e && c_.edge_use.size() == e &&
        c_.edge_volume.size() == e && c_.origin.size() == 2 * e && c_.use_next.size() == u &&
        c_.use_prev.size() == u && c_.use_radial.size() == u && c_.use_facet.size() == u &&
        c_.facet_mark.size() == f && c_.facet_volume.size() == f && c_.facet_origin.size() == f;
    return require(right, "arrays have one entry for each item") &&
           require(c_.volume_count() > 0, "there is a volume") &&
           require(has_rows(c_.star_begin, v, c_.star.size()) &&
                       has_rows(c_.cycle_begin, f, c_.cycle.size()) &&
                       has_rows(c_.inner_begin, f, c_.inner.size()),
                   "lists cover their arrays");
  }
  /// Whether `begin` has the starts of the given number of rows, and the rows cover all entries.
  static bool has_rows(const std::vector<std::uint32_t>& begin, std::size_t rows,
                       std::size_t entries) {
    return begin.size() == rows + 1 && begin.front() == 0 && begin.back() == entries &&
           std::is_sorted(begin.begin(), begin.end());
  }

  bool has_marks() {
    for (const std::vector<Mark>* marks : std::initializer_list<const std::vector<Mark>*>{
             &c_.vertex_mark, &c_.edge_mark, &c_.facet_mark, &c_.volume_mark}) {
      const bool known =
          std::all_of(marks->begin(), marks->end(), [](Mark m) { return m <= kBeyond; });
      if (!require(known, "marks are 0, 1 or beyond")) return false;
    }
    return true;
  }

  /// Whether vertices, edges and facets refer to points and planes that exist.
  bool names_tables() {
    const std::size_t planes = c_.planes().size(), inputs = c_.planes().points().size(),
                      points = c_.points().size();
    const auto is_plane = [&](PlaneId p) { return p.value() < planes; };
    return all_of<VertexId>(c_.vertex_count(),
                            [&](VertexId v) {
                              const SpacePoint p = at(v);
                              const bool known =
                                  p.is_valid() &&
                                  (p.is_input() ? p.input().value() < inputs : p.index() < points);
                              return require(known, "a vertex has a point", v);
                            }) &&
           all_of<EdgeId>(c_.edge_count(),
                          [&](EdgeId e) {
                            const auto& [p, q] = c_.edge_planes[e];
                            return require(is_plane(p) && is_plane(q), "an edge has two planes", e);
                          }) &&
           all_of<FacetId>(c_.facet_count(), [&](FacetId f) {
             return require(is_plane(plane(f)), "a facet has a plane", f);
           });
  }

  /// Whether all ids are below `end`, or invalid if that is allowed. The number after that of an
  /// invalid id is 0, so one pass without branches decides.
  template <class Id>
  static bool are_below(const std::vector<Id>& ids, std::size_t end, bool may_be_invalid) {
    std::uint32_t least_after = ~std::uint32_t{0}, most_after = 0;
    for (const Id id : ids) {
      const std::uint32_t after = id.value() + 1;
      most_after = std::max(most_after, after);
      least_after = std::min(least_after, after);
    }
    return most_after <= end && (may_be_invalid || least_after > 0);
  }
  bool names_items() {
    bool right = are_below(c_.star, c_.origin.size(), false) &&
                 are_below(c_.origin, c_.vertex_count(), false) &&
                 are_below(c_.edge_use, c_.use_count(), true) &&
                 are_below(c_.use_halfedge, c_.origin.size(), false) &&
                 are_below(c_.use_next, c_.use_count(), false) &&
                 are_below(c_.use_prev, c_.use_count(), false) &&
                 are_below(c_.use_radial, c_.use_count(), false) &&
                 are_below(c_.use_facet, c_.facet_count(), false) &&
                 are_below(c_.cycle, c_.use_count(), false) &&
                 are_below(c_.inner, c_.vertex_count(), false) &&
                 are_below(c_.vertex_facet, c_.facet_count(), true) &&
                 are_below(c_.vertex_volume, c_.volume_count(), true) &&
                 are_below(c_.edge_volume, c_.volume_count(), true);
    for (const auto& sides : c_.facet_volume) {
      for (const VolumeId v : sides) right = right && v.is_valid() && v.value() < c_.volume_count();
    }
    return require(right, "ids name items that are there");
  }

  // ---- links

  bool has_edges_with_two_ends() {
    return all_of<EdgeId>(c_.edge_count(), [this](EdgeId e) {
      return require(c_.origin[2 * e.value()] != c_.origin[2 * e.value() + 1],
                     "an edge has two ends", e);
    });
  }

  /// Whether every half-edge is in the star of its origin, once.
  bool has_stars() {
    IdVector<HalfedgeId, std::uint8_t> is_listed(c_.origin.size());
    const auto has_star = [&](VertexId v) {
      for (const HalfedgeId h : c_.star_of(v)) {
        if (!require(c_.origin[h] == v, "a star holds what leaves its vertex", v, h) ||
            !require(is_listed[h]++ == 0, "a star lists a half-edge once", v, h)) {
          return false;
        }
      }
      return true;
    };
    return all_of<VertexId>(c_.vertex_count(), has_star) &&
           require(c_.star.size() == c_.origin.size(), "each half-edge is in a star");
  }

  /// Whether next and prev are inverse to each other, consecutive uses share an end, and cycles
  /// stay in their facet.
  bool has_linked_uses() {
    return all_of<UseId>(c_.use_count(), [this](UseId u) {
      const UseId next = c_.use_next[u];
      return require(c_.use_prev[next] == u, "prev undoes next", u) &&
             require(c_.use_origin(next) == c_.target(halfedge(u)),
                     "a use starts where the one before ends", u, next) &&
             require(facet(next) == facet(u), "a cycle stays with its facet", u, next);
    });
  }

  /// Whether the uses of each edge make one radial cycle.
  bool has_radial_cycles() {
    IdVector<UseId, std::uint8_t> is_reached(c_.use_count());
    return all_of<EdgeId>(c_.edge_count(),
                          [&](EdgeId e) {
                            const UseId first = c_.edge_use[e];
                            return !first.is_valid() || has_radial_cycle(e, first, is_reached);
                          }) &&
           are_all_reached(is_reached, "the radial cycle of an edge has all its uses");
  }
  bool has_radial_cycle(EdgeId e, UseId first, IdVector<UseId, std::uint8_t>& is_reached) {
    UseId u = first;
    do {
      step_();
      if (!require(SpaceComplex::edge_of(halfedge(u)) == e, "a radial cycle stays at its edge", e,
                   u) ||
          !require(is_reached[u]++ == 0, "a radial cycle returns to its start", e, u)) {
        return false;
      }
      u = c_.use_radial[u];
    } while (u != first);
    return true;
  }

  bool are_all_reached(const std::vector<std::uint8_t>& is_reached, const char* invariant) {
    const auto missing = std::ranges::find(is_reached, 0);
    return missing == is_reached.end() ||
           fail_at(invariant, UseId(static_cast<std::size_t>(missing - is_reached.begin())));
  }

  /// Whether every use is on one listed cycle of its facet.
  bool has_boundary_cycles() {
    IdVector<UseId, std::uint8_t> is_reached(c_.use_count());
    const auto has_cycles = [&](FacetId f) {
      if (!require(!c_.cycles_of(f).empty(), "a facet has a boundary", f)) return false;
      for (const UseId first : c_.cycles_of(f)) {
        if (!require(facet(first) == f, "a facet lists its own cycles", f, first) ||
            !require(is_reached[first] == 0, "a facet lists a cycle once", f, first)) {
          return false;
        }
        all_of_cycle(first, [&](UseId u) { return is_reached[u] = 1; });
      }
      return true;
    };
    return all_of<FacetId>(c_.facet_count(), has_cycles) &&
           are_all_reached(is_reached, "each use is on a cycle of its facet");
  }

  // ---- free parts

  /// Whether facets list exactly the vertices inside them.
  bool has_inner_vertices() {
    std::size_t inside = 0;
    for (const FacetId f : c_.vertex_facet) inside += f.is_valid() ? 1U : 0U;
    IdVector<VertexId, std::uint8_t> is_listed(c_.vertex_count());
    const auto has_own = [&](FacetId f) {
      for (const VertexId v : c_.inner_of(f)) {
        if (!require(c_.vertex_facet[v] == f, "a facet lists the vertices inside it", f, v) ||
            !require(is_listed[v]++ == 0, "a facet lists an inner vertex once", f, v)) {
          return false;
        }
      }
      return true;
    };
    return all_of<FacetId>(c_.facet_count(), has_own) &&
           require(inside == c_.inner.size(), "a vertex inside a facet is listed there");
  }

  /// Whether free edges and isolated vertices, and no others, name a volume.
  bool has_volumes_where_needed() {
    const auto has_one = [this](EdgeId e) {
      return require(c_.edge_use[e].is_valid() != c_.edge_volume[e].is_valid(),
                     "an edge has uses or lies in a volume", e);
    };
    return all_of<EdgeId>(c_.edge_count(), has_one) &&
           all_of<VertexId>(c_.vertex_count(), [this](VertexId v) {
             const bool is_alone = c_.star_of(v).empty() && !c_.vertex_facet[v].is_valid();
             return require(is_alone == c_.vertex_volume[v].is_valid(),
                            "a vertex alone lies in a volume", v);
           });
  }
};

}  // namespace

std::optional<SpaceFlaw> audit_links(const SpaceComplex& complex, Context& context) {
  return LinkAudit(complex, context).run();
}

// Part 3: the boundary cycles of facets.

namespace {

/// Returns an axis whose coordinate varies in the plane: the plane is not across it.
std::size_t varying_axis(const PlaneTable& planes, PlaneId plane) {
  constexpr std::array<PlaneId, 3> kAcross = {kPlaneX, kPlaneY, kPlaneZ};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (minor_sign(planes, plane, kAcross[axis], i) != Sign::Zero) return axis;
    }
  }
  return 2;
}

/// Part 3: the boundary cycles of facets in their planes.
class CycleAudit : SpaceAuditPart {
 public:
  CycleAudit(const SpaceComplex& complex, Context& context) : SpaceAuditPart(complex, context, 2) {}

  std::optional<SpaceFlaw> run() {
    cycle_at_.assign(c_.vertex_count(), UseId());
    all_of<FacetId>(c_.facet_count(), [this](FacetId f) {
      return has_cycles_apart(f) && has_cycles_in_order(f) && has_holes_inside(f);
    });
    return flaw_;
  }

 private:
  /// Whether the cycles of a facet have no common vertex: a connected facet has one cycle for each
  /// connected part of its boundary.
  bool has_cycles_apart(FacetId f) {
    if (c_.cycles_of(f).size() == 1) return true;
    for (const UseId cycle : c_.cycles_of(f)) {
      const bool apart = all_of_cycle(cycle, [&](UseId u) {
        // Facets are checked one after the other, so an entry of another facet is out of date.
        UseId& known = cycle_at_[c_.use_origin(u)];
        const bool is_new = !known.is_valid() || facet(known) != f || known == cycle;
        known = cycle;
        return is_new;
      });
      if (!require(apart, "cycles of a facet have no common vertex", f, cycle)) return false;
    }
    return true;
  }

  /// Returns the lexicographically least vertex of a cycle.
  VertexId least_vertex(UseId cycle) const {
    VertexId least = c_.use_origin(cycle);
    all_of_cycle(cycle, [&](UseId u) {
      const VertexId v = c_.use_origin(u);
      if (compare_xyz(c_.points(), at(v), at(least)) == Sign::Negative) least = v;
      return true;
    });
    return least;
  }

  /// Whether a cycle is around its facet, not around a hole. At the least vertex, all edges leave
  /// within a half turn. In a cycle around a hole, one corner there exceeds a half turn; in a cycle
  /// around the facet, none does. In a triangle, any corner decides.
  bool is_outer(UseId cycle) const {
    if (is_triangle(cycle)) return defines_plane(cycle) || is_convex(cycle);
    const VertexId least = least_vertex(cycle);
    return all_of_cycle(cycle, [&](UseId u) { return c_.use_origin(u) != least || is_convex(u); });
  }
  /// Whether the cycle of the use has three uses.
  bool is_triangle(UseId u) const { return c_.use_next[c_.use_next[c_.use_next[u]]] == u; }
  /// Whether the plane is defined by the triangle's corners in their order. In this case, they are
  /// counter-clockwise, and no sign is computed.
  bool defines_plane(UseId u) const {
    const PlaneSource& source = c_.planes().source(plane(u));
    if (source.is_explicit()) return false;
    std::array<std::uint32_t, 3> input;
    for (std::uint32_t& p : input) {
      const SpacePoint x = at(c_.use_origin(u));
      if (!x.is_input()) return false;
      p = x.input().value();
      u = c_.use_next[u];
    }
    const std::array<std::uint32_t, 3>& ccw = source.code;
    return input == ccw || input == std::array{ccw[1], ccw[2], ccw[0]} ||
           input == std::array{ccw[2], ccw[0], ccw[1]};
  }
  /// Whether the corner of the use is below half a turn.
  bool is_convex(UseId u) const {
    const VertexId end = c_.target(corner_end(u));
    return side_in_plane(c_, plane(u), halfedge(u), c_.points(), at(end)) == Sign::Positive;
  }

  /// Whether the first cycle runs around the facet and all others run around holes.
  bool has_cycles_in_order(FacetId f) {
    const auto cycles = c_.cycles_of(f);
    if (!require(is_outer(cycles.front()), "the first cycle runs around its facet", f))
      return false;
    for (const UseId hole : cycles.subspan(1)) {
      if (!require(!is_outer(hole), "a cycle after the first runs around a hole", f, hole))
        return false;
    }
    return true;
  }

  /// Whether the holes of a facet lie inside it and apart, and its inner vertices inside it. Since
  /// cycles have no common vertex and, by part 4, do not cross, one vertex decides for a whole
  /// hole.
  bool has_holes_inside(FacetId f) {
    const auto cycles = c_.cycles_of(f);
    if (cycles.size() > 1) {
      // A vertex of a hole is tested only against the cycles whose boxes contain it.
      const BoxTree tree(boxes_of(cycles));
      for (std::uint32_t hole = 1; hole < cycles.size(); ++hole) {
        if (!require(is_inside_and_apart(cycles, hole, tree),
                     "a hole lies in its facet and in no other hole", f, cycles[hole])) {
          return false;
        }
      }
    }
    for (const VertexId v : c_.inner_of(f)) {
      if (!require(place_in_facet(c_, f, c_.points(), at(v), step_).is_inside,
                   "an inner vertex lies inside its facet", f, v)) {
        return false;
      }
    }
    return true;
  }

  /// Returns the box of each cycle.
  std::vector<Box3> boxes_of(std::span<const UseId> cycles) const {
    std::vector<Box3> boxes;
    boxes.reserve(cycles.size());
    for (const UseId cycle : cycles) {
      Box3& box = boxes.emplace_back();
      all_of_cycle(cycle, [&](UseId u) {
        box.add(box_of(c_, c_.use_origin(u)));
        return true;
      });
    }
    return boxes;
  }
  /// Whether a vertex of the hole lies inside of the first cycle. For every other cycle, it must
  /// lie outside of the cycle or of its box.
  bool is_inside_and_apart(std::span<const UseId> cycles, std::uint32_t hole, const BoxTree& tree) {
    const VertexId v = c_.use_origin(cycles[hole]);
    bool is_inside = false, is_apart = true;
    tree.for_each_meeting(box_of(c_, v), [&](std::uint32_t i) {
      if (i == hole) return true;
      const FacetPlace place = place_in_cycle(c_, cycles[i], c_.points(), at(v), step_);
      if (i == 0) return is_inside = place.is_inside;
      return is_apart = !place.on.is_valid() && !place.is_inside;
    });
    return is_inside && is_apart;
  }

  IdVector<VertexId, UseId> cycle_at_;  ///< The last cycle seen at each vertex.
};

/// Whether x, a point on the line of the half-edge, lies between its ends or on one of them.
bool is_along(const SpaceComplex& complex, HalfedgeId h, const Point3Table& points, SpacePoint x) {
  const std::array<PlaneId, 2>& planes = complex.edge_planes[h.value() / 2];
  const auto order = [&](SpacePoint from, SpacePoint to) {
    return order_along_line(points, planes[0], planes[1], from, to);
  };
  const HalfedgeId forward(h.value() & ~1U);
  return order(complex.vertex_point[complex.origin[forward]], x) != Sign::Negative &&
         order(x, complex.vertex_point[complex.target(forward)]) != Sign::Negative;
}

}  // namespace

// Counts crossings with the half-line from x along which one coordinate is constant. A half-edge
// that rises above that value passes x on its left, and a half-edge that returns below it passes x
// on its right. Vertices at that value count as below it, so that every passage counts once.
FacetPlace place_in_cycle(const SpaceComplex& complex, UseId cycle, const Point3Table& points,
                          SpacePoint x, SpaceAuditSteps& step) {
  const PlaneId n = complex.facet_plane[complex.use_facet[cycle]];
  const std::size_t axis = varying_axis(complex.planes(), n);
  const auto order = [&](VertexId v) {
    return compare_axis(points, complex.vertex_point[v], x, axis);
  };
  FacetPlace place;
  UseId u = cycle;
  Sign from = order(complex.use_origin(u));
  do {
    step();
    const HalfedgeId h = complex.use_halfedge[u];
    const Sign to = order(complex.target(h));
    // An edge that is strictly on one side does not pass the half-line. Any other edge may contain
    // x or pass the half-line.
    if (from == Sign::Zero || from != to) {
      const Sign left = side_in_plane(complex, n, h, points, x);
      const bool is_level = from == Sign::Zero && to == Sign::Zero;
      if (left == Sign::Zero && (!is_level || is_along(complex, h, points, x))) return {false, h};
      const bool rises = to == Sign::Positive;
      if ((from == Sign::Positive) != rises && left == (rises ? Sign::Positive : Sign::Negative)) {
        place.is_inside = !place.is_inside;
      }
    }
    from = to;
    u = complex.use_next[u];
  } while (u != cycle);
  return place;
}

FacetPlace place_in_facet(const SpaceComplex& complex, FacetId f, const Point3Table& points,
                          SpacePoint x, SpaceAuditSteps& step) {
  FacetPlace place;
  for (const UseId cycle : complex.cycles_of(f)) {
    const FacetPlace here = place_in_cycle(complex, cycle, points, x, step);
    if (here.on.is_valid()) return here;
    place.is_inside = place.is_inside != here.is_inside;
  }
  return place;
}

std::optional<SpaceFlaw> audit_cycles(const SpaceComplex& complex, Context& context) {
  return CycleAudit(complex, context).run();
}

}  // namespace plumb
