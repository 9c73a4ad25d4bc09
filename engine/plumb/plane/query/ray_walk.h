// A walk along a ray through a complex of the plane, from cell to cell.
//
// The ray is always in one of three kinds of place, and each step leads to the next one:
//  at a vertex   bisection finds the direction among its edges: along one of them, or into a face
//  on an edge    the ray crosses it into the trapezoid at that place, found by bisection, or runs
//                along it to its end
//  in a face     the ray goes from trapezoid to trapezoid until it meets an edge or a vertex
//
// Cost: O(log n) for each vertex and edge that is met, and O(1) for each trapezoid.
#pragma once

#include "plumb/plane/query/plane_trapezoids.h"
#include "plumb/predicates/plane/query2.h"

namespace plumb {

/// One walk.
class RayWalk {
 public:
  /// Starts at the origin of the ray. Keeps references to all arguments.
  RayWalk(const PlaneComplex& complex, const PlaneLocator& locator,
          const PlaneTrapezoids& trapezoids, const QueryRay2& ray);

  /// Returns the cell at hand. The first cell is the cell of the origin.
  const PlaneLocation& here() const { return here_; }
  /// Returns the first point of the ray in that cell, or, for a face or edge that the ray enters
  /// from its boundary, the point where it does.
  RationalPoint2 point() const;
  /// Moves on to the next cell; returns false if the ray stays in this one for ever.
  bool advance();

 private:
  bool leave_vertex();
  bool leave_edge();
  bool leave_face();
  bool go_along(EdgeId e);

  void enter(VertexId v);
  void enter(EdgeId e);
  void enter(FaceId f);
  void enter_gap(VertexId v, std::span<const EdgeId> edges, std::size_t edges_below);

  bool meets_before_wall(EdgeId e, bool is_top, VertexId wall) const;
  Sign side_of(VertexId wall) const;
  bool is_left_of(EdgeId crossed, VertexId wall) const;
  bool is_start_left_of(VertexId wall) const;
  TrapezoidId beside(EdgeId e, bool is_above) const;
  Sign turn_from(EdgeId e) const;

  const PlaneComplex& complex_;
  PlanePointsView points_;
  const PlaneLocator& locator_;
  const PlaneTrapezoids& trapezoids_;
  const QueryRay2& ray_;

  PlaneLocation here_;
  // The last place that was met: a vertex, the crossing of an edge, or else the origin.
  VertexId at_vertex_;
  EdgeId at_edge_;
  TrapezoidId trapezoid_;  // The trapezoid, in a face; not valid at the start.
  bool is_along_ = false;  // Whether the ray runs along the edge at hand.
};

}  // namespace plumb
