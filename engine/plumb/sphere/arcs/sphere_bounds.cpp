// Bounds of points and arcs of a sphere map on the unit sphere, and a tree over them.
//
// A direction is the cross product of two rows of doubles, normalized, in a ball whose radius
// covers the errors of the rows and all roundings. The extent of an arc along a unit vector n is
// the extent of its ends. If n . x may have its maximum or minimum inside the arc, the extent of
// the circle is used instead. The tree halves the items along the longest axis of their centres; a
// node keeps a box and a slab across the circle of one of its arcs.
//
// Everything here errs to the safe side: in spite of rounding, a bound contains its point or arc.
// So the tree may report pairs that do not meet, but omits no pair that meets. Nothing is decided
// here (docs/design/sphere.md, Cost).
//
// Tested by tests/sphere/sphere_overlay_test.cpp and tests/sphere/sphere_locator_test.cpp.

#include "plumb/sphere/arcs/sphere_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/sphere/arcs/sphere_arcs.h"

namespace plumb {
namespace {

using Vector = std::array<double, 3>;

constexpr double kRounding = 1e-14;  // The value exceeds the roundings of any computation below.

/// Returns an upper bound of the extent of the circle of a normal along a unit vector. The extent
/// is the sine of the angle between the two.
double reach(const UnitBall& normal, const Vector& n) {
  const double along = std::max(0.0, std::fabs(dot(normal.middle, n)) - normal.radius - kRounding);
  return std::sqrt(std::max(0.0, 1 - along * along)) + kRounding;
}

/// Whether an arc is shorter than a half-circle, exactly.
bool is_short(const PlaneTable& planes, const SphereMap& map, std::uint32_t arc) {
  return !map.is_loop(arc) && turn_on(planes, map.circle[arc], origin_place(planes, map, 2 * arc),
                                      origin_place(planes, map, 2 * arc + 1)) == TurnClass::Left;
}

}  // namespace

/// The middle v / |v| is off by at most 2 error / |v|. If v is hardly longer than its error, the
/// ball contains the whole sphere.
UnitBall unit_ball(const Vector& v, double error) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 8 * error)) return {{0, 0, 0}, 1};
  return {{v[0] / length, v[1] / length, v[2] / length}, 2 * error / length + kRounding};
}

UnitBall ball_of(const PlaneTable& planes, PlaneId circle) {
  const PlaneRow& row = planes.row(circle);
  return unit_ball(row.n, static_cast<double>(row.normal_error));
}

/// A component of the cross product is off by at most the sum of the errors (plane_signs.cpp).
UnitBall ball_of(const PlaneTable& planes, SphereDirection u) {
  const PlaneRow& p = planes.row(u.p);
  const PlaneRow& q = planes.row(u.q);
  const double errors = static_cast<double>(p.normal_error) + static_cast<double>(q.normal_error);
  return unit_ball(cross(p.n, q.n), 4 * errors);
}

/// Returns S cos a + (N x S) sin a for the start S and the normal N, with their errors.
UnitBall UnitWay::at(double angle) const {
  const Vector ahead = cross(normal.middle, start.middle);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  UnitBall ball{{}, 2 * (start.radius + normal.radius) + kRounding};
  for (std::size_t i = 0; i < 3; ++i) ball.middle[i] = c * start.middle[i] + s * ahead[i];
  return ball;
}

double UnitWay::angle_of(const UnitBall& at) const {
  return std::atan2(dot(cross(normal.middle, start.middle), at.middle),
                    dot(start.middle, at.middle));
}

std::vector<SphereBound> bounds_of(const PlaneTable& planes, const SphereMap& map) {
  std::vector<SphereBound> bounds;
  bounds.reserve(map.direction.size() + map.arc_count());
  for (const SphereDirection u : map.direction) {
    bounds.push_back({SphereBound::Kind::Point, ball_of(planes, u), {}, {}});
  }
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    const UnitBall normal = ball_of(planes, map.circle[a]);
    if (is_short(planes, map, a)) {
      bounds.push_back({SphereBound::Kind::ShortArc, bounds[map.origin[2 * a]].from,
                        bounds[map.target(2 * a)].from, normal});
    } else {
      bounds.push_back({SphereBound::Kind::Circle, {}, {}, normal});
    }
  }
  return bounds;
}

/// Returns the extent of n . x over the bound, for a unit vector n or zero. Along a short arc the
/// derivative of n . x is n . (N x x): only if it may be positive at the start and negative at the
/// end does the maximum lie inside, and the circle's reach is taken; likewise for the minimum.
SphereBoundTree::Interval SphereBoundTree::extent(const SphereBound& bound, const Vector& n) {
  if (bound.kind == SphereBound::Kind::Circle) {
    const double far = reach(bound.normal, n);
    return {-far, far};
  }
  const double from = dot(n, bound.from.middle);
  const double at_ends = bound.from.radius + kRounding;
  Interval result{from - at_ends, from + at_ends};
  if (bound.kind == SphereBound::Kind::Point) return result;
  const double to = dot(n, bound.to.middle);
  result.low = std::min(result.low, to - bound.to.radius - kRounding);
  result.high = std::max(result.high, to + bound.to.radius + kRounding);
  const double grows_from = dot(n, cross(bound.normal.middle, bound.from.middle));
  const double grows_to = dot(n, cross(bound.normal.middle, bound.to.middle));
  const double slack = 2 * (bound.normal.radius + bound.from.radius + bound.to.radius) + kRounding;
  if (grows_from > -slack && grows_to < slack)
    result.high = std::max(result.high, reach(bound.normal, n));
  if (grows_from < slack && grows_to > -slack)
    result.low = std::min(result.low, -reach(bound.normal, n));
  return result;
}

Box3 SphereBoundTree::box_of(const SphereBound& bound) {
  Box3 box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector n{};
    n[axis] = 1;
    const Interval along = extent(bound, n);
    box.low[axis] = along.low;
    box.high[axis] = along.high;
  }
  return box;
}

SphereBoundTree::SphereBoundTree(std::vector<SphereBound> bounds)
    : bounds_(std::move(bounds)), order_(bounds_.size()) {
  boxes_.reserve(bounds_.size());
  for (const SphereBound& bound : bounds_) boxes_.push_back(box_of(bound));
  std::iota(order_.begin(), order_.end(), std::uint32_t{0});
  if (!order_.empty()) build(0, 0, static_cast<std::uint32_t>(order_.size()));
}

SphereBoundTree::Query SphereBoundTree::query_of(const SphereBound& bound) {
  if (bound.kind == SphereBound::Kind::Point) return {bound, box_of(bound), {0, 0, 0}, 0};
  return {bound, box_of(bound), bound.normal.middle, bound.normal.radius + kRounding};
}

/// Whether the box may contain a vector x with |across . x| <= slack.
bool SphereBoundTree::meets_plane(const Box3& box, const Query& query) {
  double middle = 0;
  double reach = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    middle += query.across[i] * (box.low[i] + box.high[i]);
    reach += std::fabs(query.across[i]) * (box.high[i] - box.low[i]);
  }
  return std::fabs(middle) <= reach + 2 * query.slack + kRounding;
}

/// Whether an item may meet the query. Besides their boxes, each of two arcs must meet the plane of
/// the other's circle, as an arc lies where n . x = 0 for its normal n.
bool SphereBoundTree::may_meet(std::uint32_t item, const Query& query) const {
  if (!boxes_[item].meets(query.box)) return false;
  const SphereBound& bound = bounds_[item];
  const auto meets_plane = [](const SphereBound& arc, const SphereBound& other) {
    if (arc.kind == SphereBound::Kind::Point) return true;
    const double slack = arc.normal.radius + kRounding;
    return Interval{-slack, slack}.meets(extent(other, arc.normal.middle));
  };
  return meets_plane(bound, query.bound) && meets_plane(query.bound, bound);
}

/// The slab is across the circle of the first arc from the middle on; items near each other tend to
/// lie along it.
SphereBoundTree::Node SphereBoundTree::node_over(std::uint32_t begin, std::uint32_t end) const {
  Node node{boxes_[order_[begin]], {}, {0, 0}};
  for (std::uint32_t i = begin + 1; i < end; ++i) node.box.add(boxes_[order_[i]]);
  for (std::uint32_t i = begin + (end - begin) / 2; i < end; ++i) {
    const SphereBound& bound = bounds_[order_[i]];
    if (bound.kind == SphereBound::Kind::Point) continue;
    node.across = bound.normal.middle;
    break;
  }
  node.slab = extent(bounds_[order_[begin]], node.across);
  for (std::uint32_t i = begin + 1; i < end; ++i) {
    const Interval more = extent(bounds_[order_[i]], node.across);
    node.slab = {std::min(node.slab.low, more.low), std::max(node.slab.high, more.high)};
  }
  return node;
}

/// Splits the items in two halves by their centres along the axis where these spread most.
void SphereBoundTree::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  if (nodes_.size() <= node) nodes_.resize(node + 1);
  const std::uint32_t middle = begin + (end - begin) / 2;
  if (end - begin > kLeaf) {
    const auto centre = [&](std::uint32_t i, std::size_t axis) {
      return boxes_[i].low[axis] + boxes_[i].high[axis];
    };
    Box3 centres;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t item = order_[i];
      const std::array<double, 3> at{centre(item, 0), centre(item, 1), centre(item, 2)};
      centres.add(Box3{at, at});
    }
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (centres.high[i] - centres.low[i] > centres.high[axis] - centres.low[axis]) axis = i;
    }
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
        [&](std::uint32_t i, std::uint32_t j) { return centre(i, axis) < centre(j, axis); });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
  }
  nodes_[node] = node_over(begin, end);
}

}  // namespace plumb
