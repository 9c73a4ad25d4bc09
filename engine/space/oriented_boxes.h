// The pairs of triangles that come close to each other among many thin ones that run in many directions, where boxes along
// any one set of axes nearly all meet: a tree whose every node has a box along its own part of the triangles.
//
// Main flow of building: the principal axes of all corners (principal_axes.h) and the extents along them are the box; halves
// on either side of the median along the axis on which the triangles' middles are spread most are the nodes below.
//
// Two boxes are apart where they are along one of their six axes. (Nine more directions, across an axis of each, would
// tell all cases.) Before, boxes along the coordinate axes are compared: those need no slack.
//
// Notation: a box holds every middle + sum t_k axis_k with |t_k| <= half_k. Axes are unit vectors at right angles but for
// some 100 roundings; halves have been widened by 2^-40 of the way to the farthest corner, which pays for that, and the
// same share of all that is summed pays in a comparison.
//
// Cost: O(n log n) to build, about 1 us a triangle; a comparison ~30 ns. Memory: 260 bytes a triangle, and 96 for its corners.
// Source: Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/point3_table.h"
#include "plumb/space/principal_axes.h"

namespace plumb {

class OrientedBoxTree {
 public:
  using Triangle = std::array<PointBox, 3>;  ///< by boxes of its corners, finite or not

  explicit OrientedBoxTree(std::span<const Triangle> triangles);

  /// visit(i, j) for all pairs of triangles that meet, and of others that are near; each pair once. on_step() is called
  /// for each pair of nodes that is looked at.
  template <class Visit, class OnStep>
  void for_each_pair_inside(Visit&& visit, OnStep&& on_step) const {
    if (!nodes_.empty()) descend_inside(0, visit, on_step);
  }

 private:
  static constexpr std::uint32_t kLeaf = 2;

  struct Node {
    Box3 box;  ///< along the coordinate axes
    Vector3 middle;
    Matrix3 axis;
    Vector3 half;
    std::uint32_t begin;  ///< into order_
    std::uint32_t end;
    std::uint32_t second;  ///< the second node below, the first comes next; 0: a leaf
    bool is_leaf() const { return second == 0; }
    double size() const { return half[0] + half[1] + half[2]; }
  };

  std::uint32_t add_node(std::span<const Triangle> triangles, std::uint32_t begin,
                         std::uint32_t end);
  Node box_around(std::span<const Triangle> triangles, std::uint32_t begin,
                  std::uint32_t end) const;
  void halve(std::span<const Triangle> triangles, const Node& node, std::uint32_t middle);
  static bool are_apart(const Node& m, const Node& n);

  template <class Visit, class OnStep>
  void descend_inside(std::uint32_t n, Visit& visit, OnStep& on_step) const;
  template <class Visit, class OnStep>
  void descend(std::uint32_t m, std::uint32_t n, Visit& visit, OnStep& on_step) const;

  std::vector<std::uint32_t> order_;
  std::vector<double> key_;  // per triangle: a place along an axis of the node at hand
  std::vector<Node> nodes_;  // each before those below it
};

template <class Visit, class OnStep>
void OrientedBoxTree::descend_inside(std::uint32_t n, Visit& visit, OnStep& on_step) const {
  const Node& node = nodes_[n];
  if (!node.is_leaf()) {
    descend_inside(n + 1, visit, on_step);
    descend_inside(node.second, visit, on_step);
    return descend(n + 1, node.second, visit, on_step);
  }
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    for (std::uint32_t j = i + 1; j < node.end; ++j) visit(order_[i], order_[j]);
  }
}

template <class Visit, class OnStep>
void OrientedBoxTree::descend(std::uint32_t m, std::uint32_t n, Visit& visit,
                              OnStep& on_step) const {
  const Node &a = nodes_[m], &b = nodes_[n];
  on_step();
  if (!a.box.meets(b.box) || are_apart(a, b)) return;
  if (a.is_leaf() && b.is_leaf()) {
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
      for (std::uint32_t j = b.begin; j < b.end; ++j) visit(order_[i], order_[j]);
    }
  } else if (b.is_leaf() || (!a.is_leaf() && a.size() >= b.size())) {
    descend(m + 1, n, visit, on_step);
    descend(a.second, n, visit, on_step);
  } else {
    descend(m, n + 1, visit, on_step);
    descend(m, b.second, visit, on_step);
  }
}

}  // namespace plumb
