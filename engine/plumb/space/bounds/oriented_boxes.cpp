// A tree of oriented boxes: how its nodes are made, divided and compared.
//
// The axes of a node are the principal axes of the corners of its triangles, so that thin triangles
// side by side get thin boxes. Axes, middles and halves are computed in doubles; correctness relies
// on one invariant: the box of a node contains all corners of its triangles, in spite of rounding.
// Halves are widened by the radii of the corners' boxes and by 2^-40 of the distances, far more
// than the roundings of some 100 operations at 2^-53 each; comparisons add the same share as slack.
// If anything is not finite, a comparison says that the boxes are not apart.
//
// Division first separates a large group, then long triangles from short ones, then halves along
// the axis of largest spread; each node has at least one triangle in both parts, so there are fewer
// than 2 n nodes.
//
// Tested by tests/space/mesh_crossings_test.cpp.

#include "plumb/space/bounds/oriented_boxes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/space/complex/space_boxes.h"

namespace plumb {
namespace {

// A bound for roundings, relative to the terms of the sum.
constexpr double kSlack = 0x1p-40;
// The bound exceeds the loss if subnormal numbers are flushed.
constexpr double kTiny = 0x1p-1000;
constexpr std::uint32_t kGroupShare = 4;  // A large group is more than a quarter of a node.
// Long triangles, and short triangles, are more than an eighth of a node.
constexpr std::uint32_t kLongShare = 8;

/// Returns the sum of magnitudes, which is at least the Euclidean length.
double length(const Vector3& a) { return std::fabs(a[0]) + std::fabs(a[1]) + std::fabs(a[2]); }
Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

OrientedBoxTree::OrientedBoxTree(std::span<const Triangle> triangles,
                                 std::span<const std::uint32_t> groups,
                                 const std::function<void()>& on_step)
    : order_(triangles.size()),
      key_(triangles.size()),
      groups_(groups.begin(), groups.end()),
      count_(groups.size(), 0) {
  std::iota(order_.begin(), order_.end(), 0U);
  length_.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    length_.push_back(
        std::max({length(minus(t[1].mid, t[0].mid)), length(minus(t[2].mid, t[1].mid)),
                  length(minus(t[0].mid, t[2].mid))}));
  }
  // If leaves have one triangle, there are at most so many nodes.
  nodes_.reserve(2 * triangles.size());
  if (!triangles.empty())
    add_node(triangles, 0, static_cast<std::uint32_t>(triangles.size()), on_step);
}

/// Adds a node and all below it, and returns its number.
std::uint32_t OrientedBoxTree::add_node(std::span<const Triangle> triangles, std::uint32_t begin,
                                        std::uint32_t end, const std::function<void()>& on_step) {
  for (std::uint32_t i = begin; i < end && on_step; ++i) on_step();
  const auto n = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(box_around(triangles, begin, end));
  const LargestGroup largest = largest_group(begin, end);
  if (largest.count == end - begin) nodes_[n].group = largest.group;
  if (end - begin <= kLeaf) return n;
  const std::uint32_t middle = split(triangles, nodes_[n], largest);
  add_node(triangles, begin, middle, on_step);
  const std::uint32_t second = add_node(triangles, middle, end, on_step);
  nodes_[n].second = second;
  return n;
}

/// Returns a node with its box: principal axes of the corners' covariance, then the middle of the
/// extents along them, then the halves, with slack.
OrientedBoxTree::Node OrientedBoxTree::box_around(std::span<const Triangle> triangles,
                                                  std::uint32_t begin, std::uint32_t end) const {
  const auto for_corners = [&](const auto& visit) {
    for (std::uint32_t i = begin; i < end; ++i) {
      for (const PointBox& corner : triangles[order_[i]]) visit(corner);
    }
  };
  Node node{{}, {}, {}, {}, begin, end, 0, kNoGroup};
  const double share = 1 / (3.0 * (end - begin));
  for_corners([&](const PointBox& p) {
    for (std::size_t k = 0; k < 3; ++k) node.middle[k] += share * p.mid[k];
  });
  Matrix3 covariance{};
  for_corners([&](const PointBox& p) {
    const Vector3 d = minus(p.mid, node.middle);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) covariance[i][j] += d[i] * d[j];
    }
  });
  node.axis = principal_axes(covariance);
  Vector3 low{}, high{};  // The mean of the corners is not the middle of the box.
  for_corners([&](const PointBox& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = dot(node.axis[k], minus(p.mid, node.middle));
      low[k] = std::min(low[k], at);
      high[k] = std::max(high[k], at);
    }
  });
  for (std::size_t k = 0; k < 3; ++k) {
    const double shift = (low[k] + high[k]) / 2;
    for (std::size_t i = 0; i < 3 && std::isfinite(shift); ++i) {
      node.middle[i] += shift * node.axis[k][i];
    }
  }
  double reach = 0, radius = 0;
  for_corners([&](const PointBox& p) {
    const Vector3 d = minus(p.mid, node.middle);
    for (std::size_t k = 0; k < 3; ++k) {
      node.half[k] = std::max(node.half[k], std::fabs(dot(node.axis[k], d)));
    }
    node.box.add(box_of(p));
    reach = std::max(reach, length(d));
    radius = std::max(radius, p.radius);
  });
  for (double& half : node.half) half += 2 * radius + kSlack * (reach + radius) + kTiny;
  return node;
}

/// Returns the group with the most triangles of a node. O(triangles of the node): counts are
/// cleared by walking them again.
OrientedBoxTree::LargestGroup OrientedBoxTree::largest_group(std::uint32_t begin,
                                                             std::uint32_t end) {
  LargestGroup largest;
  for (std::uint32_t i = begin; i < end; ++i) {
    const std::uint32_t group = group_of(order_[i]);
    if (group == kNoGroup || ++count_[group] <= largest.count) continue;
    largest = {group, count_[group]};
  }
  for (std::uint32_t i = begin; i < end; ++i) {
    if (group_of(order_[i]) != kNoGroup) count_[group_of(order_[i])] = 0;
  }
  return largest;
}

/// Divides a node, and returns where its second part begins. If a group is a large part of the
/// node, it is separated from the rest. Otherwise, if there are both long and short triangles, long
/// triangles are separated from short ones, because the boxes of the short ones would be as long as
/// those of the long ones. Otherwise, the node is divided into two halves.
std::uint32_t OrientedBoxTree::split(std::span<const Triangle> triangles, const Node& node,
                                     const LargestGroup& largest) {
  const std::uint32_t size = node.end - node.begin;
  const auto first = order_.begin() + node.begin, last = order_.begin() + node.end;
  if (largest.count < size && kGroupShare * largest.count > size) {
    std::partition(first, last, [&](std::uint32_t i) { return group_of(i) == largest.group; });
    return node.begin + largest.count;
  }
  const double half = *std::ranges::max_element(node.half);
  const auto is_long = [&](std::uint32_t i) { return length_[i] > half; };
  const auto count = static_cast<std::uint32_t>(std::count_if(first, last, is_long));
  if (kLongShare * count > size && kLongShare * (size - count) > size) {
    std::partition(first, last, is_long);
    return node.begin + count;
  }
  const std::uint32_t middle = node.begin + size / 2;
  halve(triangles, node, middle);
  return middle;
}

/// Divides a node by the sums of corners along the axis on which these are spread most. This need
/// not be the longest axis, because long triangles that lie side by side are separated across the
/// longest axis.
void OrientedBoxTree::halve(std::span<const Triangle> triangles, const Node& node,
                            std::uint32_t middle) {
  const auto sum = [&](std::uint32_t i, std::size_t axis) {
    double value = 0;
    for (const PointBox& corner : triangles[i]) {
      value += dot(node.axis[axis], minus(corner.mid, node.middle));
    }
    return std::isfinite(value) ? value : 0;
  };
  std::size_t widest = 0;
  double width = -1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = Box3::kInfinity, high = -Box3::kInfinity;
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const double value = sum(order_[i], axis);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (high - low > width) width = high - low, widest = axis;
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) key_[order_[i]] = sum(order_[i], widest);
  const auto at = [this](std::uint32_t i) { return order_.begin() + i; };
  std::nth_element(at(node.begin), at(middle), at(node.end),
                   [this](std::uint32_t i, std::uint32_t j) {
                     return key_[i] != key_[j] ? key_[i] < key_[j] : i < j;
                   });
}

/// Returns the axis along which the box of a node is longest.
const Vector3& OrientedBoxTree::longest_axis(const Node& node) {
  const auto longest = std::ranges::max_element(node.half) - node.half.begin();
  return node.axis[static_cast<std::size_t>(longest)];
}

// Along an axis, the boxes are apart if the distance of their middles exceeds the sum of their half
// extents. A comparison with a NaN is false, so the boxes do not count as apart.
bool OrientedBoxTree::are_apart(const Node& m, const Node& n) {
  const Vector3 d = minus(n.middle, m.middle);
  const double slack = kSlack * (length(d) + m.size() + n.size()) + kTiny;
  Matrix3 cosine;
  for (std::size_t i = 0; i < 3; ++i) {
    double reach = m.half[i] + slack;
    for (std::size_t j = 0; j < 3; ++j) {
      cosine[i][j] = std::fabs(dot(m.axis[i], n.axis[j]));
      reach += n.half[j] * cosine[i][j];
    }
    if (std::fabs(dot(m.axis[i], d)) > reach) return true;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    double reach = n.half[j] + slack;
    for (std::size_t i = 0; i < 3; ++i) reach += m.half[i] * cosine[i][j];
    if (std::fabs(dot(n.axis[j], d)) > reach) return true;
  }
  // The direction across both longest axes separates long thin boxes that are skew.
  const Vector3 across = cross(longest_axis(m), longest_axis(n));
  double reach = slack;
  for (std::size_t i = 0; i < 3; ++i) {
    reach += m.half[i] * std::fabs(dot(across, m.axis[i]));
    reach += n.half[i] * std::fabs(dot(across, n.axis[i]));
  }
  return std::fabs(dot(across, d)) > reach;
}

}  // namespace plumb
