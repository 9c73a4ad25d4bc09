// What surely holds the points and arcs of a map, taken on the unit sphere, and a tree over such
// bounds. Internal.
//
// In doubles, from the rows of planes and their error bounds: a filter, which decides nothing. An
// arc shorter than a half-circle reaches beyond its ends along a direction n only where n . x grows
// at one end and falls at the other; then it may go as far as its circle does.
//
// Boxes along the axes alone fail where many long arcs run side by side, as on a cone with many
// ridges: each box meets a share of all others. So a node of the tree has, besides, a slab across
// the circle of one of its arcs, which is as thin as its arcs lie close to each other. A query that
// is an arc is looked for only where its plane goes.
//
// Building: O(n log n). A query: O(log n + what it finds) for arcs that lie side by side; worst
// O(n).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/sphere/sphere_map.h"

namespace plumb {

/// The unit vector meant lies within `radius` of `middle`.
struct UnitBall {
  std::array<double, 3> middle;
  double radius;
};

/// |v - meant| <= error, the one meant of any length.
UnitBall unit_ball(const std::array<double, 3>& v, double error);
UnitBall ball_of(const PlaneTable& planes, PlaneId circle);  ///< Of its normal.
UnitBall ball_of(const PlaneTable& planes, SphereDirection u);

/// The way around a circle from one of its directions, counter-clockwise about the normal, in
/// radians.
struct UnitWay {
  UnitBall normal;
  UnitBall start;

  bool is_sharp() const {
    return start.radius + normal.radius < 1e-6;
  }  ///< Else nothing below says much.
  UnitBall at(double angle) const;
  /// From -pi to pi, within slack(at); requires a direction on the circle.
  double angle_of(const UnitBall& at) const;
  double slack(const UnitBall& at) const {
    return 4 * (at.radius + start.radius + normal.radius) + 1e-13;
  }
};

struct SphereBound {
  enum class Kind : std::uint8_t { Point, ShortArc, Circle };

  Kind kind;
  UnitBall from;    ///< of a point: it
  UnitBall to;      ///< of a short arc, counter-clockwise about `normal`
  UnitBall normal;  ///< of an arc
};

/// Of the points, then of the arcs.
std::vector<SphereBound> bounds_of(const PlaneTable& planes, const SphereMap& map);

class SphereBoundTree {
 public:
  explicit SphereBoundTree(std::vector<SphereBound> bounds);

  /// visit(i) for every bound i that may have a direction in common with `query`.
  template <class Visit>
  void for_each_meeting(const SphereBound& query, Visit&& visit) const {
    find_meeting(query, [&](std::uint32_t i) {
      visit(i);
      return true;
    });
  }
  /// The same, as long as visit(i) says so. Did it to the end?
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
    std::array<double, 3> across;  ///< zero: no slab
    Interval slab;
  };
  struct Query {
    const SphereBound& bound;
    Box3 box;
    std::array<double, 3> across;  ///< of an arc its normal; zero: no plane
    double slack;                  ///< |across . x| on it
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

  /// Node `node` has the bounds order_[begin .. end); its children are 2 node + 1 and 2 node + 2.
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
