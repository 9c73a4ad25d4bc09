// What a ray meets, one element after the other.
//
// Main flow: the ray is always at one of three kinds of place, and each step leads to the next one:
//  at a vertex   the direction among its edges, by bisection: along one of them, or into a face
//  on an edge    across it, into the trapezoid at that place, by bisection; or along it to its end
//  in a face     from trapezoid to trapezoid until an edge or a vertex is met: O(1) for each
//
// Cost: O(log n) for each vertex and edge met, and O(1) for each trapezoid.
#pragma once

#include "plumb/plane/query/plane_trapezoids.h"
#include "plumb/predicates/plane/query2.h"

namespace plumb {

class RayWalk {
 public:
  /// Keeps references.
  RayWalk(const PlaneComplex& complex, const PlaneLocator& locator,
          const PlaneTrapezoids& trapezoids, const QueryRay2& ray);

  /// The element at hand: first the one at the origin.
  const PlaneLocation& here() const { return here_; }
  /// The first point of it on the ray; of a face or edge that does not contain that point, the
  /// infimum.
  RationalPoint2 point() const;
  /// Moves on to the next element; false when the ray goes on in this one for ever.
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
  // The last place met: a vertex, the crossing of an edge, or else the origin.
  VertexId at_vertex_;
  EdgeId at_edge_;
  TrapezoidId trapezoid_;  // in a face; invalid at the start
  bool is_along_ = false;  // on an edge: does the ray run along it?
};

}  // namespace plumb
