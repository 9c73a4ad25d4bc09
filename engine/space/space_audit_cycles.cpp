// Step 3 of audit(): the boundary cycles of facets in their planes.
#include <algorithm>

#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_audit_parts.h"

namespace plumb {
namespace {

/// An axis along which the plane is not seen as a point: its coordinate varies in the plane.
std::size_t varying_axis(const PlaneTable& planes, PlaneId plane) {
  constexpr std::array<PlaneId, 3> kAcross = {kPlaneX, kPlaneY, kPlaneZ};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (minor_sign(planes, plane, kAcross[axis], i) != Sign::Zero) return axis;
    }
  }
  return 2;
}

/// The side of a half-edge, in the plane n of a facet, on which a point of that plane lies: Positive is
/// left, seen from the positive side of n. The half-edge runs along s (n x m); to the left of it, along
/// n x (n x m) = n (n.m) - m (n.n), the value of m falls when s is positive.
Sign side_in_plane(const SpaceComplex& complex, PlaneId n, HalfedgeId h, const Point3Table& points,
                   SpacePoint x) {
  const auto& [p, q] = complex.edge_planes[h.value() / 2];
  const PlaneId m = p == n ? q : p;
  std::size_t axis = 0;
  while (minor_sign(complex.planes(), p, q, axis) == Sign::Zero) ++axis;
  Sign s = minor_sign(complex.planes(), p, q, axis) * minor_sign(complex.planes(), n, m, axis);
  if (SpaceComplex::is_reverse(h)) s = -s;
  return -(s * side(points, x, m));
}

class CycleAudit : SpaceAuditPart {
 public:
  CycleAudit(const SpaceComplex& complex, Context& context) : SpaceAuditPart(complex, context, 2) {}

  std::optional<SpaceFlaw> run() {
    cycle_at_.assign(c_.vertex_count(), UseId());
    for (std::uint32_t f = 0; f < c_.facet_count(); ++f) {
      if (!has_cycles_apart(FacetId(f)) || !has_cycles_in_order(FacetId(f)) ||
          !has_holes_inside(FacetId(f))) {
        break;
      }
    }
    return flaw_;
  }

 private:
  /// A connected facet has one cycle for each connected part of its boundary.
  bool has_cycles_apart(FacetId f) {
    for (const UseId cycle : c_.cycles_of(f)) {
      const bool apart = all_of_cycle(cycle, [&](UseId u) {
        UseId& known = cycle_at_[c_.use_origin(u).value()];
        const bool is_new = !known.is_valid() || facet(known) != f || known == cycle;
        known = cycle;
        return is_new;
      });
      if (!require(apart, "cycles of a facet have no common vertex", f, cycle)) return false;
    }
    return true;
  }

  VertexId least_vertex(UseId cycle) const {
    VertexId least = c_.use_origin(cycle);
    all_of_cycle(cycle, [&](UseId u) {
      const VertexId v = c_.use_origin(u);
      if (compare_xyz(c_.points(), at(v), at(least)) == Sign::Negative) least = v;
      return true;
    });
    return least;
  }

  /// At the least vertex all edges leave within half a turn. Around a hole one corner there is more than
  /// that, around the facet none is.
  bool is_outer(UseId cycle) const {
    const VertexId least = least_vertex(cycle);
    return all_of_cycle(cycle, [&](UseId u) {
      if (c_.use_origin(u) != least) return true;
      const VertexId end = c_.target(corner_end(u));
      return side_in_plane(c_, plane(u), halfedge(u), c_.points(), at(end)) == Sign::Positive;
    });
  }

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

  bool has_holes_inside(FacetId f) {
    const auto cycles = c_.cycles_of(f);
    for (const UseId hole : cycles.subspan(1)) {
      const SpacePoint x = at(c_.use_origin(hole));
      for (const UseId other : cycles) {
        if (other == hole) continue;
        const FacetPlace place = place_in_cycle(c_, other, c_.points(), x, step_);
        if (!require(!place.on.is_valid() && place.is_inside == (other == cycles.front()),
                     "a hole lies in its facet and in no other hole", f, hole)) {
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

  std::vector<UseId> cycle_at_;  ///< per vertex: the last cycle seen there
};

}  // namespace

namespace {

/// Does x, on the line of the half-edge, lie between its ends or on one of them?
bool is_along(const SpaceComplex& complex, HalfedgeId h, const Point3Table& points, SpacePoint x) {
  const std::array<PlaneId, 2>& planes = complex.edge_planes[h.value() / 2];
  const auto order = [&](SpacePoint from, SpacePoint to) {
    return order_along_line(points, planes[0], planes[1], from, to);
  };
  const HalfedgeId forward(h.value() & ~1U);
  return order(complex.vertex_point[complex.origin[forward.value()].value()], x) !=
             Sign::Negative &&
         order(x, complex.vertex_point[complex.target(forward).value()]) != Sign::Negative;
}

}  // namespace

// Crossings of the half-line of x along which one coordinate keeps its value: half-edges that reach above
// that value pass x on its left, those that return below it on its right.
FacetPlace place_in_cycle(const SpaceComplex& complex, UseId cycle, const Point3Table& points,
                          SpacePoint x, SpaceAuditSteps& step) {
  const PlaneId n = complex.facet_plane[complex.use_facet[cycle.value()].value()];
  const std::size_t axis = varying_axis(complex.planes(), n);
  const auto order = [&](VertexId v) {
    return compare_axis(points, complex.vertex_point[v.value()], x, axis);
  };
  FacetPlace place;
  UseId u = cycle;
  Sign from = order(complex.use_origin(u));
  do {
    step();
    const HalfedgeId h = complex.use_halfedge[u.value()];
    const Sign to = order(complex.target(h));
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
    u = complex.use_next[u.value()];
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
