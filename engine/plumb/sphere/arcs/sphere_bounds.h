// Bounds of the points and arcs of a map, taken on the unit sphere, and a tree over such bounds.
// Internal.
//
// Bounds are computed in doubles, from the rows of planes and their error bounds. They are a
// filter, which decides nothing. An arc shorter than a half-circle reaches beyond its ends along a
// direction n only if n . x grows at its start and falls at its end; then it may go as far as its
// circle does.
//
// Boxes along the axes alone fail where many long arcs run side by side, as on a cone with many
// ridges: each box meets a share of all others. So a node of the tree has, besides, a slab across
// the circle of one of its arcs, which is as thin as its arcs lie close to each other. A query that
// is an arc is searched only where its plane goes.
//
// Cost: building takes O(n log n). A query takes O(log n + what it finds) for arcs that lie side by
// side, and O(n) in the worst case.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// A ball that contains an exact unit vector.
struct UnitBall {
  std::array<double, 3> middle;  ///< The computed vector.
  double radius;                 ///< A bound for the distance from the exact direction.
};

/// Returns a ball around the direction of an exact vector, of any length, with |v - exact| <=
/// error.
UnitBall unit_ball(const std::array<double, 3>& v, double error);
/// Returns a ball around the normal of the circle.
UnitBall ball_of(const PlaneTable& planes, PlaneId circle);
UnitBall ball_of(const PlaneTable& planes, SphereDirection u);  ///< Returns a ball around u.

/// The way around a circle from one of its directions, counter-clockwise about the normal, in
/// radians.
struct UnitWay {
  UnitBall normal;  ///< The normal of the circle.
  UnitBall start;   ///< The direction where the way starts.

  bool is_sharp() const {
    return start.radius + normal.radius < 1e-6;
  }  ///< Whether the errors are small; otherwise the results below are of little use.
  /// Returns the direction after a turn by `angle`.
  UnitBall at(double angle) const;
  /// Returns the angle of a direction, from -pi to pi, within slack(at). Requires that the exact
  /// direction lies on the circle.
  double angle_of(const UnitBall& at) const;
  /// Returns a bound of the error of angle_of(at).
  double slack(const UnitBall& at) const {
    return 4 * (at.radius + start.radius + normal.radius) + 1e-13;
  }
};

/// A bound of a point or an arc.
struct SphereBound {
  /// What is bounded: a point, an arc shorter than a half-circle, or a longer one by its circle.
  enum class Kind : std::uint8_t { Point, ShortArc, Circle };

  Kind kind;        ///< The kind, which determines the balls that are set.
  UnitBall from;    ///< The point, or the start of a short arc.
  UnitBall to;      ///< The end of a short arc, counter-clockwise about `normal`.
  UnitBall normal;  ///< The normal of an arc's circle.
};

/// Returns the bounds of the points of a map, followed by the bounds of its arcs.
std::vector<SphereBound> bounds_of(const PlaneTable& planes, const SphereMap& map);

/// A tree over bounds, which finds the bounds that may meet a given bound.
class SphereBoundTree {
 public:
  /// Builds the tree in O(n log n).
  explicit SphereBoundTree(std::vector<SphereBound> bounds);

  /// Calls visit(i) for every bound i that may have a direction in common with `query`.
  template <class Visit>
  void for_each_meeting(const SphereBound& query, Visit&& visit) const {
    find_meeting(query, [&](std::uint32_t i) {
      visit(i);
      return true;
    });
  }
  /// Does the same until visit(i) returns false. Returns whether all were visited.
  template <class Visit>
  bool find_meeting(const SphereBound& query, Visit&& visit) const {
    return nodes_.empty() ||
           descend(0, 0, static_cast<std::uint32_t>(order_.size()), query_of(query), visit);
  }

 private:
  struct Interval {
    double low, high;
    bool meets(const Interval& other) const { return low <= other.high && other.low <= high; }
  };
  struct Node {
    Box3 box;
    std::array<double, 3> across;  ///< The normal of the slab; zero if there is none.
    Interval slab;                 ///< Bounds across . x over the node.
  };
  struct Query {
    const SphereBound& bound;
    Box3 box;
    std::array<double, 3> across;  ///< The normal of an arc; zero for a point.
    double slack;                  ///< Bounds |across . x| on the arc.
  };

  static constexpr std::uint32_t kLeaf = 4;

  static Interval extent(const SphereBound& bound, const std::array<double, 3>& n);
  static Box3 box_of(const SphereBound& bound);
  static Query query_of(const SphereBound& bound);
  static bool meets_plane(const Box3& box, const Query& query);
  static bool may_meet(const Node& node, const Query& query) {
    return node.box.meets(query.box) && meets_plane(node.box, query) &&
           node.slab.meets(extent(query.bound, node.across));
  }
  bool may_meet(std::uint32_t item, const Query& query) const;
  Node node_over(std::uint32_t begin, std::uint32_t end) const;
  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  /// Visits the bounds below a node that may meet the query. The node has the bounds order_[begin
  /// .. end) and the children 2 node + 1 and 2 node + 2.
  template <class Visit>
  bool descend(std::uint32_t node, std::uint32_t begin, std::uint32_t end, const Query& query,
               Visit& visit) const {
    if (!may_meet(nodes_[node], query)) return true;
    if (end - begin <= kLeaf) {
      for (std::uint32_t i = begin; i < end; ++i) {
        if (may_meet(order_[i], query) && !visit(order_[i])) return false;
      }
      return true;
    }
    const std::uint32_t middle = begin + (end - begin) / 2;
    return descend(2 * node + 1, begin, middle, query, visit) &&
           descend(2 * node + 2, middle, end, query, visit);
  }

  std::vector<SphereBound> bounds_;
  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace plumb
