// Where a point of a facet's plane lies: on a vertex, on an edge, in the facet, or outside of it.
// The second part says which boundary cycles run around a facet and which around a hole, and in
// which facet of a plane a hole or a point lies.
//
// Notation, in the plane of facet f with normal n
//   x         the point
//   sections  two planes through x that meet f's plane in x alone. `above` and `beside` are the
//             sides of a vertex on them; for coordinate planes that is a comparison of coordinates
//   ray       leaves x within the first section, to the positive side of the second
//   d         direction of an edge; Q its other plane: d = s (n x n_Q), s = +-1. Left of d, seen
//             along -n, is the side of Q that s is not: (n x (n x n_Q)).n_Q = (n.n_Q)^2 - n^2 n_Q^2
//             < 0
//
// Main flow of facet_site(), along every cycle:
//  1. corners  a vertex on both sections is x; an edge within the first section holds x between
//              ends beside it
//  2. cuts     an edge whose ends are above and not above x is cut by the ray's line; if x is on Q,
//              the edge holds x
//  3. parity   the cut lies on the ray if x is to the left of an edge that runs up, or right of one
//              that runs down; x is inside if an odd number of cuts do. (A facet on both sides of
//              an edge counts it twice.)
//  4. inner    last, the vertices inside the facet are compared with x
//
// Cost: O(corners of the facet): a comparison for each, two for those close to the ray's line.
// Facets of many corners that are asked often get slabs (contact_leaves.h).
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A plane of an edge that is not the given one, and the direction of half-edge 2e by it.
struct OtherPlane {
  PlaneId plane;  ///< The other plane.
  Sign turn;  ///< Half-edge 2e runs along turn * (n x n_plane) for the normal n of the given one.
};
/// Returns a plane of the edge that is not `plane`. Requires an edge that lies in `plane`.
OtherPlane other_plane(const SpaceComplex& complex, EdgeId e, PlaneId plane);

/// Returns the side of a half-edge, in the plane n of a facet, on which a point of that plane lies:
/// Positive is left, seen from the positive side of n. The half-edge runs along s (n x m); to the
/// left of it, along n x (n x m) = n (n.m) - m (n.n), the value of m falls when s is positive. The
/// point is one of the complex, or of a copy of its table with more points.
Sign side_in_plane(const SpaceComplex& complex, PlaneId n, HalfedgeId h, const Point3Table& points,
                   SpacePoint x);

/// The place of a point with coordinates. Its sections are two coordinate planes, shifted.
class PointPlace {
 public:
  /// Requires a point of the complex's tables on the facet's plane.
  PointPlace(const SpaceComplex& complex, FacetId f, SpacePoint x)
      : complex_(complex),
        point_(x),
        axis_(steepest(complex.planes().row(complex.facet_plane[f]))) {
    turn_ = sign_of(complex.planes().row(complex.facet_plane[f]).n[axis_]);
  }
  /// Returns the side of a vertex on the first section.
  Sign above(VertexId v) const { return compare(v, (axis_ + 2) % 3); }
  /// Returns the side of a vertex on the second section.
  Sign beside(VertexId v) const { return compare(v, (axis_ + 1) % 3); }
  /// Returns the side of the point on a plane.
  Sign side(PlaneId q) const { return plumb::side(complex_.points(), point_, q); }
  /// Returns the sign of (n_beside x n_above).n.
  Sign turn() const { return turn_; }

 private:
  /// Returns the axis of the largest component of a normal, which surely is not zero (PlaneRow).
  static std::size_t steepest(const PlaneRow& row) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::fabs(row.n[i]) > std::fabs(row.n[best])) best = i;
    }
    return best;
  }
  Sign compare(VertexId v, std::size_t axis) const {
    return compare_axis(complex_.points(), complex_.vertex_point[v], point_, axis);
  }

  const SpaceComplex& complex_;
  SpacePoint point_;
  std::size_t axis_;
  Sign turn_;
};

/// The place where the line of planes p and q cuts the facet's plane, without that point. Requires
/// that the line cuts the plane in one point.
class CrossingPlace {
 public:
  CrossingPlace(const SpaceComplex& complex, FacetId f, PlaneId p, PlaneId q)
      : complex_(complex),
        planes_{p, q, complex.facet_plane[f]},
        det3_(det3_sign(complex.planes(), p, q, planes_[2])) {}
  /// Returns the side of a vertex on the first section, which is p.
  Sign above(VertexId v) const { return side_of(v, planes_[0]); }
  /// Returns the side of a vertex on the second section, which is q.
  Sign beside(VertexId v) const { return side_of(v, planes_[1]); }
  /// Returns the side of the point on a plane.
  Sign side(PlaneId q) const {
    return det4_sign(complex_.planes(), planes_[0], planes_[1], planes_[2], q) * det3_;
  }
  /// Returns the sign of (n_beside x n_above).n.
  Sign turn() const { return -det3_; }

 private:
  Sign side_of(VertexId v, PlaneId q) const {
    return plumb::side(complex_.points(), complex_.vertex_point[v], q);
  }

  const SpaceComplex& complex_;
  std::array<PlaneId, 3> planes_;
  Sign det3_;
};

/// Returns the vertex, edge or facet that holds a point of the facet's plane; an invalid item if
/// the point lies outside. `Place` is one of the above, or has the same members for another kind of
/// point:
///   above(v), beside(v)  sides of a vertex on the two sections
///   side(q)              the side of x on plane q
///   turn()               the sign of (n_beside x n_above).n
template <class Place>
SpaceItem facet_site(const SpaceComplex& complex, FacetId f, const Place& x);

/// Returns the cell that holds a point on the facet's plane.
inline SpaceItem facet_site(const SpaceComplex& complex, FacetId f, SpacePoint x) {
  return facet_site(complex, f, PointPlace(complex, f, x));
}
/// Returns the cell that holds the common point of the facet's plane, p and q.
inline SpaceItem facet_site(const SpaceComplex& complex, FacetId f, PlaneId p, PlaneId q) {
  return facet_site(complex, f, CrossingPlace(complex, f, p, q));
}

namespace detail {

/// The walk along the boundary.
template <class Place>
class SiteWalk {
 public:
  SiteWalk(const SpaceComplex& complex, FacetId f, const Place& x)
      : complex_(complex), facet_(f), plane_(complex.facet_plane[f]), place_(x) {}

  SpaceItem run() {
    for (const UseId first : complex_.cycles_of(facet_)) {
      if (const SpaceItem item = along(first); item.is_valid()) return item;
    }
    if (!is_inside_) return {};
    for (const VertexId v : complex_.inner_of(facet_)) {
      if (place_.above(v) == Sign::Zero && place_.beside(v) == Sign::Zero) return v;
    }
    return facet_;
  }

 private:
  struct Corner {
    VertexId vertex;
    Sign above;
    Sign beside;  // Known, and not zero, if above is zero.
  };

  /// Returns the vertex or edge of the cycle that holds x, or an invalid item.
  SpaceItem along(UseId first) {
    Corner from{}, to{};
    if (is_at(complex_.use_origin(first), from)) return from.vertex;
    UseId u = first;
    do {
      const UseId next = complex_.use_next[u];
      if (is_at(complex_.use_origin(next), to)) return to.vertex;
      if (from.above == to.above) {
        if (from.above == Sign::Zero && from.beside != to.beside) return edge_of(u);
      } else if (crosses(u, from, to)) {
        return edge_of(u);
      }
      from = to;
      u = next;
    } while (u != first);
    return {};
  }

  /// Computes the signs of a vertex and returns whether it is at x.
  bool is_at(VertexId v, Corner& corner) const {
    corner = {v, place_.above(v), Sign::Zero};
    if (corner.above != Sign::Zero) return false;
    corner.beside = place_.beside(v);
    return corner.beside == Sign::Zero;
  }

  /// Whether the edge holds x. Otherwise its cut with the ray is counted.
  bool crosses(UseId u, const Corner& from, const Corner& to) {
    const bool runs_up = to.above == Sign::Positive;
    // It touches the ray's line from below.
    if (!runs_up && from.above != Sign::Positive) return false;
    const HalfedgeId h = complex_.use_halfedge[u];
    const OtherPlane other = other_plane(complex_, SpaceComplex::edge_of(h), plane_);
    Sign left = -(place_.side(other.plane) * other.turn);
    if (left == Sign::Zero) return true;
    if (SpaceComplex::is_reverse(h)) left = -left;
    if ((left == place_.turn()) == runs_up) is_inside_ = !is_inside_;
    return false;
  }

  EdgeId edge_of(UseId u) const { return SpaceComplex::edge_of(complex_.use_halfedge[u]); }

  const SpaceComplex& complex_;
  FacetId facet_;
  PlaneId plane_;
  const Place& place_;
  bool is_inside_ = false;
};

}  // namespace detail

template <class Place>
SpaceItem facet_site(const SpaceComplex& complex, FacetId f, const Place& x) {
  return detail::SiteWalk<Place>(complex, f, x).run();
}

// Boundary cycles of facets in their plane.

/// Returns the sign of the sine of the corner of the edge use (Weiler): Positive below half a turn,
/// Negative above, Zero at half a turn and at a full one (at the end of a slit).
Sign corner_sign(const SpaceComplex& complex, UseId u);

/// Whether the cycle bounds its facet from outside, and not a hole. It is decided by the sign of
/// its area or, if this is unknown, at its least vertex: there a corner of more than half a turn
/// belongs to a hole. O(length).
bool is_outer(const SpaceComplex& complex, UseId cycle);

/// Returns the sign of l in n_r x n_s = l (n_p x n_q), for pairs of planes whose lines have the
/// same direction; never Zero.
Sign same_direction(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

// The facet of a plane that holds a hole or a point, for all holes and points at once: the region
// that all facets of the plane make up is swept once.
//
// Notation: a cycle is given by one of its uses; whether it is outer or a hole says is_outer().
//
// Main flow of nest_cycles():
//  1. show   shows the vertices of all cycles and the points along an axis, with a directed edge
//            for each use
//  2. sweep  finds the edge just below each point at which no edge ends (triangulate.h)
//  3. nest   no edge ends at the least point of a hole. If the edge below it belongs to a hole,
//            both lie in one facet, and the least point of that hole came before; else its cycle is
//            the outer one looked for. A point inside a facet likewise
//
// Cost: O(n log n) for n uses and points. Memory: 200 bytes a use or point, charged. Proof:
// docs/design/boolean.md, step 6 of "The algorithm".

/// The facets in which cycles and points lie.
struct CycleNesting {
  /// The outer cycle of each cycle's facet, as an index of cycles; for an outer cycle itself.
  std::vector<std::uint32_t> of_cycle;
  /// The outer cycle of the facet in which each point lies.
  std::vector<std::uint32_t> of_point;
};

/// Nests all boundary cycles of all facets of a plane, and points that lie inside facets there.
/// Requires facets that do not overlap. Of the complex, it reads only uses, the origins of edges
/// and the points of vertices. Stops the program if a hole or point has no facet around it. Throws
/// the errors of the Context.
CycleNesting nest_cycles(const SpaceComplex& complex, PlaneId plane, std::span<const UseId> cycles,
                         std::span<const VertexId> points, Context& context);

}  // namespace plumb
