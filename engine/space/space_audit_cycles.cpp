// Step 3 of audit(): the boundary cycles of facets in their planes.
#include <array>
#include <span>
#include <vector>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/facet_site.h"
#include "plumb/space/space_audit_parts.h"
#include "plumb/space/space_boxes.h"

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
  /// A connected facet has one cycle for each connected part of its boundary.
  bool has_cycles_apart(FacetId f) {
    if (c_.cycles_of(f).size() == 1) return true;
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
  /// that, around the facet none is. Of a triangle any corner tells.
  bool is_outer(UseId cycle) const {
    if (is_triangle(cycle)) return defines_plane(cycle) || is_convex(cycle);
    const VertexId least = least_vertex(cycle);
    return all_of_cycle(cycle, [&](UseId u) { return c_.use_origin(u) != least || is_convex(u); });
  }
  bool is_triangle(UseId u) const {
    return c_.use_next[c_.use_next[c_.use_next[u.value()].value()].value()] == u;
  }
  /// Is the plane defined as that of the triangle's corners, as they come?
  bool defines_plane(UseId u) const {
    const PlaneSource& source = c_.planes().source(plane(u));
    if (source.is_explicit()) return false;
    std::array<std::uint32_t, 3> input;
    for (std::uint32_t& p : input) {
      const SpacePoint x = at(c_.use_origin(u));
      if (!x.is_input()) return false;
      p = x.input().value();
      u = c_.use_next[u.value()];
    }
    const std::array<std::uint32_t, 3>& ccw = source.code;
    return input == ccw || input == std::array{ccw[1], ccw[2], ccw[0]} ||
           input == std::array{ccw[2], ccw[0], ccw[1]};
  }
  /// Is the corner of the use below half a turn?
  bool is_convex(UseId u) const {
    const VertexId end = c_.target(corner_end(u));
    return side_in_plane(c_, plane(u), halfedge(u), c_.points(), at(end)) == Sign::Positive;
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
    if (cycles.size() > 1) {
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
  /// A vertex of the hole lies in the first cycle, and beyond the box of another one or outside of it.
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
