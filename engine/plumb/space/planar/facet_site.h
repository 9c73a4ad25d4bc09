// Where a point of a facet's plane lies: on a vertex, on an edge, in the facet, or outside of it.
//
// Notation, in the plane of facet f with normal n
//   x         the point
//   sections  two planes through x that meet f's plane in x alone. `above` and `beside` are the
//             sides of a vertex on them; of coordinate planes that is a comparison of coordinates
//   ray       leaves x within the first section, to the positive side of the second
//   d         direction of an edge; Q its other plane: d = s (n x n_Q), s = +-1. Left of d, seen
//             along -n, is the side of Q that s is not: (n x (n x n_Q)).n_Q = (n.n_Q)^2 - n^2 n_Q^2
//             < 0
//
// Main flow: along every cycle
//  1. a vertex on both sections is x; an edge within the first section holds x between ends beside
//     it
//  2. an edge whose ends are above and not above x is cut by the ray's line; x on Q: it holds x
//  3. the cut lies on the ray if x is to the left of an edge that runs up, or right of one that
//     runs down: x is inside if an odd number do. (A facet on both sides of an edge counts it
//     twice.)
// Last the vertices inside the facet.
//
// Cost: O(corners of the facet); a comparison for each, two for those close to the ray's line.
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

/// A plane of the edge that is not `plane`, and the direction of half-edge 2e.
struct OtherPlane {
  PlaneId plane;
  Sign turn;  ///< half-edge 2e runs along turn * (n x n_plane), n the normal of the plane given
};
/// Requires an edge that lies in `plane`.
OtherPlane other_plane(const SpaceComplex& complex, EdgeId e, PlaneId plane);

/// The side of a half-edge, in the plane n of a facet, on which a point of that plane lies:
/// Positive is left, seen from the positive side of n. The half-edge runs along s (n x m); to the
/// left of it, along n x (n x m) = n (n.m) - m (n.n), the value of m falls when s is positive. The
/// point is of the complex, or of a copy of its table with more points.
Sign side_in_plane(const SpaceComplex& complex, PlaneId n, HalfedgeId h, const Point3Table& points,
                   SpacePoint x);

/// A point with coordinates: its sections are two coordinate planes, shifted.
class PointPlace {
 public:
  PointPlace(const SpaceComplex& complex, FacetId f, SpacePoint x)
      : complex_(complex),
        point_(x),
        axis_(steepest(complex.planes().row(complex.facet_plane[f.value()]))) {
    turn_ = sign_of(complex.planes().row(complex.facet_plane[f.value()]).n[axis_]);
  }
  Sign above(VertexId v) const { return compare(v, (axis_ + 2) % 3); }
  Sign beside(VertexId v) const { return compare(v, (axis_ + 1) % 3); }
  Sign side(PlaneId q) const { return plumb::side(complex_.points(), point_, q); }
  Sign turn() const { return turn_; }

 private:
  /// The largest component of a normal is surely not zero (PlaneRow).
  static std::size_t steepest(const PlaneRow& row) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::fabs(row.n[i]) > std::fabs(row.n[best])) best = i;
    }
    return best;
  }
  Sign compare(VertexId v, std::size_t axis) const {
    return compare_axis(complex_.points(), complex_.vertex_point[v.value()], point_, axis);
  }

  const SpaceComplex& complex_;
  SpacePoint point_;
  std::size_t axis_;
  Sign turn_;
};

/// Where the line of planes p and q cuts the facet's plane (it must, in one point), without that
/// point.
class CrossingPlace {
 public:
  CrossingPlace(const SpaceComplex& complex, FacetId f, PlaneId p, PlaneId q)
      : complex_(complex),
        planes_{p, q, complex.facet_plane[f.value()]},
        det3_(det3_sign(complex.planes(), p, q, planes_[2])) {}
  Sign above(VertexId v) const { return side_of(v, planes_[0]); }
  Sign beside(VertexId v) const { return side_of(v, planes_[1]); }
  Sign side(PlaneId q) const {
    return det4_sign(complex_.planes(), planes_[0], planes_[1], planes_[2], q) * det3_;
  }
  Sign turn() const { return -det3_; }

 private:
  Sign side_of(VertexId v, PlaneId q) const {
    return plumb::side(complex_.points(), complex_.vertex_point[v.value()], q);
  }

  const SpaceComplex& complex_;
  std::array<PlaneId, 3> planes_;
  Sign det3_;
};

/// The vertex, edge or facet itself that holds a point of the facet's plane; invalid: outside.
/// `Place` is one of the above, or has the same members for another kind of point:
///   above(v), beside(v)  sides of a vertex on the two sections
///   side(q)              the side of x on plane q
///   turn()               the sign of (n_beside x n_above).n
template <class Place>
SpaceItem facet_site(const SpaceComplex& complex, FacetId f, const Place& x);

/// Of a point that lies on the facet's plane.
inline SpaceItem facet_site(const SpaceComplex& complex, FacetId f, SpacePoint x) {
  return facet_site(complex, f, PointPlace(complex, f, x));
}
/// Of the common point of the facet's plane, p and q.
inline SpaceItem facet_site(const SpaceComplex& complex, FacetId f, PlaneId p, PlaneId q) {
  return facet_site(complex, f, CrossingPlace(complex, f, p, q));
}

namespace detail {

/// The walk along the boundary.
template <class Place>
class SiteWalk {
 public:
  SiteWalk(const SpaceComplex& complex, FacetId f, const Place& x)
      : complex_(complex), facet_(f), plane_(complex.facet_plane[f.value()]), place_(x) {}

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
    Sign beside;  // known (and not zero) where above is zero
  };

  /// The vertex or edge of the cycle that holds x.
  SpaceItem along(UseId first) {
    Corner from{}, to{};
    if (is_at(complex_.use_origin(first), from)) return from.vertex;
    UseId u = first;
    do {
      const UseId next = complex_.use_next[u.value()];
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

  bool is_at(VertexId v, Corner& corner) const {
    corner = {v, place_.above(v), Sign::Zero};
    if (corner.above != Sign::Zero) return false;
    corner.beside = place_.beside(v);
    return corner.beside == Sign::Zero;
  }

  /// Does the edge hold x? Otherwise counts its cut with the ray.
  bool crosses(UseId u, const Corner& from, const Corner& to) {
    const bool runs_up = to.above == Sign::Positive;
    if (!runs_up && from.above != Sign::Positive)
      return false;  // touches the ray's line from below
    const HalfedgeId h = complex_.use_halfedge[u.value()];
    const OtherPlane other = other_plane(complex_, SpaceComplex::edge_of(h), plane_);
    Sign left = -(place_.side(other.plane) * other.turn);
    if (left == Sign::Zero) return true;
    if (SpaceComplex::is_reverse(h)) left = -left;
    if ((left == place_.turn()) == runs_up) is_inside_ = !is_inside_;
    return false;
  }

  EdgeId edge_of(UseId u) const { return SpaceComplex::edge_of(complex_.use_halfedge[u.value()]); }

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

// Boundary cycles of facets in their plane: which run around a facet, which around a hole.

/// The sign of the sine of the corner of the use: Positive below half a turn, Negative above, Zero
/// at half a turn and at a full one (at the end of a slit).
Sign corner_sign(const SpaceComplex& complex, UseId u);

/// Does the cycle bound its facet from outside (rather than a hole)? Decided at its least vertex:
/// there a corner of more than half a turn belongs to a hole. O(length).
bool is_outer(const SpaceComplex& complex, UseId cycle);

/// The sign l in n_r x n_s = l (n_p x n_q), of pairs of planes that share the direction of their
/// lines. Not Zero.
Sign same_direction(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

// Which facet of a plane holds a hole or a point: the region that all facets of the plane make up
// is swept once.
//
// Notation: a cycle is given by one of its uses; hole, outer: is_outer() (facet_site.h)
//
// Main flow of nest_cycles():
//  1. vertices of all cycles and the points, seen along an axis, with a directed edge for each use
//  2. a sweep (triangulate.h) finds the edge just below each point where none ends
//  3. the least point of a hole has none: where the edge below it belongs to a hole, both lie in
//     one facet, and the least point of that one comes before; else its cycle is the outer one
//     looked for. A point inside a facet likewise.
//
// Cost: O(n log n) for n uses and points. Memory: 200 bytes a use or point, charged.

struct CycleNesting {
  /// Per cycle: the outer cycle of its facet, as an index of cycles; of an outer one itself.
  std::vector<std::uint32_t> of_cycle;
  /// Per point: the outer cycle of the facet that it lies in.
  std::vector<std::uint32_t> of_point;
};

/// All boundary cycles of all facets of a plane, and points that lie inside facets there. Requires
/// facets that do not overlap; of the complex no more than uses, the edges' origins and the
/// vertices' points. Stops the program where a hole or point has no facet around it. Throws what
/// the context throws.
CycleNesting nest_cycles(const SpaceComplex& complex, PlaneId plane, std::span<const UseId> cycles,
                         std::span<const VertexId> points, Context& context);

}  // namespace plumb
