// Finds pairs of triangles that are close to each other, among many thin triangles that run in many
// directions. Nearly all boxes of such triangles meet for every choice of common axes. So in this
// tree, the box of each node has axes that suit the triangles of the node.
//
// Main flow of building: the principal axes of all corners (space_boxes.h) and the extents along
// them make the box of a node. Below it are two nodes:
//  1. a group    of triangles within which no pairs are asked for (triangle_crossing.h), if it is a
//                large part, and the rest
//  2. the long   triangles, if there are some, and the short ones, whose boxes would otherwise be
//                as long
//  3. halves     on either side of the median along the axis on which the triangles' middles are
//                spread most
//
// Two boxes are apart if they are apart along one of their six axes, or along the direction
// orthogonal to the longest axes of both boxes. This direction separates needles that pass each
// other. (Eight more directions, across an axis of each, would decide all cases.) Boxes along the
// coordinate axes are compared before; those need no slack.
//
// Notation: a box holds every middle + sum t_k axis_k with |t_k| <= half_k. Axes are unit vectors
// at right angles up to some 100 roundings. Halves have been widened by 2^-40 of the distance to
// the farthest corner, which covers that, and the same share of all that is summed covers the
// roundings of a comparison.
//
// Cost: O(n log n) to build, about 1 us a triangle; a comparison about 30 ns. Memory: 300 bytes a
// triangle, 420 at most, and 96 for its corners. Source: S. Gottschalk, M. Lin, D. Manocha,
// OBBTree: a hierarchical structure for rapid interference detection, SIGGRAPH (1996).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/space/point3_table.h"
#include "plumb/space/complex/space_boxes.h"

namespace plumb {

/// The tree.
class OrientedBoxTree {
 public:
  using Triangle = std::array<PointBox, 3>;  ///< The boxes of its corners, finite or not.

  static constexpr std::uint32_t kNoGroup = ~std::uint32_t{0};  ///< Names no group.

  /// Builds the tree. `groups` has for each triangle the number of its group, less than the number
  /// of triangles, or kNoGroup; if it is empty, no triangle has a group. on_step() is called for
  /// each triangle of each node.
  explicit OrientedBoxTree(std::span<const Triangle> triangles,
                           std::span<const std::uint32_t> groups = {},
                           const std::function<void()>& on_step = {});

  /// Calls visit(i, j) for all pairs of triangles that meet, and for some that are near, except
  /// pairs of one group; each pair once. on_step() is called for each pair of nodes that is
  /// compared.
  template <class Visit, class OnStep>
  void for_each_pair_inside(Visit&& visit, OnStep&& on_step) const {
    if (!nodes_.empty()) descend_inside(0, visit, on_step);
  }

  /// Calls visit(i, j) for all triangles i of `a` and j of `b` that meet, and for some that are
  /// near; each pair once. Groups have no influence. on_step() is called for each pair of nodes
  /// that is compared.
  template <class Visit, class OnStep>
  static void for_each_pair(const OrientedBoxTree& a, const OrientedBoxTree& b, Visit&& visit,
                            OnStep&& on_step) {
    const auto take_all = [&](std::uint32_t i, std::uint32_t j) { visit(i, j); };
    const auto never = [](const Node&, const Node&) { return false; };
    if (!a.nodes_.empty() && !b.nodes_.empty()) descend(a, 0, b, 0, never, take_all, on_step);
  }

 private:
  static constexpr std::uint32_t kLeaf = 2;

  /// A node with the triangles order_[begin], ..., order_[end - 1].
  struct Node {
    Box3 box;  ///< The box along the coordinate axes.
    Vector3 middle;
    Matrix3 axis;
    Vector3 half;
    std::uint32_t begin;  ///< Its first triangle in order_.
    std::uint32_t end;
    std::uint32_t second;  ///< The second node below it, 0 for a leaf. The first one comes next.
    std::uint32_t group;   ///< The group of all its triangles, or kNoGroup.
    bool is_leaf() const { return second == 0; }
    double size() const { return half[0] + half[1] + half[2]; }
    bool is_with(const Node& n) const { return group != kNoGroup && group == n.group; }
  };
  /// The group with the most triangles of a node.
  struct LargestGroup {
    std::uint32_t group = kNoGroup;
    std::uint32_t count = 0;
  };

  std::uint32_t add_node(std::span<const Triangle> triangles, std::uint32_t begin,
                         std::uint32_t end, const std::function<void()>& on_step);
  Node box_around(std::span<const Triangle> triangles, std::uint32_t begin,
                  std::uint32_t end) const;
  LargestGroup largest_group(std::uint32_t begin, std::uint32_t end);
  std::uint32_t split(std::span<const Triangle> triangles, const Node& node,
                      const LargestGroup& largest);
  void halve(std::span<const Triangle> triangles, const Node& node, std::uint32_t middle);
  std::uint32_t group_of(std::uint32_t triangle) const {
    return groups_.empty() ? kNoGroup : groups_[triangle];
  }
  /// Visits a pair of triangles, unless they are in one group.
  template <class Visit>
  void take(std::uint32_t i, std::uint32_t j, Visit& visit) const {
    if (group_of(i) == kNoGroup || group_of(i) != group_of(j)) visit(i, j);
  }
  static const Vector3& longest_axis(const Node& node);
  static bool are_apart(const Node& m, const Node& n);

  template <class Visit, class OnStep>
  void descend_inside(std::uint32_t n, Visit& visit, OnStep& on_step) const;
  /// Visits the pairs of one triangle in each of two nodes, unless is_left_out(node, node).
  template <class IsLeftOut, class Visit, class OnStep>
  static void descend(const OrientedBoxTree& x, std::uint32_t m, const OrientedBoxTree& y,
                      std::uint32_t n, const IsLeftOut& is_left_out, const Visit& visit,
                      OnStep& on_step);

  std::vector<std::uint32_t> order_;
  std::vector<double> key_;            // The place of each triangle along an axis of the node.
  std::vector<double> length_;         // The longest side of each triangle, by coordinate axes.
  std::vector<std::uint32_t> groups_;  // The group of each triangle.
  std::vector<std::uint32_t> count_;   // The triangles of each group in the node at hand.
  std::vector<Node> nodes_;            // The nodes, each before those below it.
};

// Visits the pairs of triangles within one node.
template <class Visit, class OnStep>
void OrientedBoxTree::descend_inside(std::uint32_t n, Visit& visit, OnStep& on_step) const {
  const Node& node = nodes_[n];
  if (node.is_with(node)) return;
  if (!node.is_leaf()) {
    descend_inside(n + 1, visit, on_step);
    descend_inside(node.second, visit, on_step);
    const auto is_one_group = [](const Node& a, const Node& b) { return a.is_with(b); };
    const auto take_pair = [&](std::uint32_t i, std::uint32_t j) { take(i, j, visit); };
    return descend(*this, n + 1, *this, node.second, is_one_group, take_pair, on_step);
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    for (std::uint32_t j = i + 1; j < node.end; ++j) take(order_[i], order_[j], visit);
  }
}

// The larger node is opened.
template <class IsLeftOut, class Visit, class OnStep>
void OrientedBoxTree::descend(const OrientedBoxTree& x, std::uint32_t m, const OrientedBoxTree& y,
                              std::uint32_t n, const IsLeftOut& is_left_out, const Visit& visit,
                              OnStep& on_step) {
  const Node &a = x.nodes_[m], &b = y.nodes_[n];
  on_step();
  if (is_left_out(a, b) || !a.box.meets(b.box) || are_apart(a, b)) return;
  const auto go_on = [&](std::uint32_t first, std::uint32_t second) {
    descend(x, first, y, second, is_left_out, visit, on_step);
  };
  if (a.is_leaf() && b.is_leaf()) {
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
      for (std::uint32_t j = b.begin; j < b.end; ++j) visit(x.order_[i], y.order_[j]);
    }
  } else if (b.is_leaf() || (!a.is_leaf() && a.size() >= b.size())) {
    go_on(m + 1, n);
    go_on(a.second, n);
  } else {
    go_on(m, n + 1);
    go_on(m, b.second);
  }
}

}  // namespace plumb
