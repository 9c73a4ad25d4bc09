// A k-d tree over points from which points can be removed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/point.h"
#include "plumb/predicates/strong_id.h"

namespace plumb {

/// Points that are found by boxes. Every node halves its points, so a node is given by its range of
/// points; nodes count the points that are left, so that removed points cost nothing.
class CornerTree {
 public:
  CornerTree() = default;
  /// Builds the tree. O(n log n).
  explicit CornerTree(std::vector<Point2> points);

  /// Removes a point. Requires that it is left. O(log n).
  void remove(std::uint32_t i);

  /// Returns a point that is left and satisfies `accepts`. Returns kNone if there is none. Requires
  /// that all accepted points lie in the closed triangle abc, which runs counter-clockwise.
  template <class Accepts>
  std::uint32_t find_in_triangle(Point2 a, Point2 b, Point2 c, const Accepts& accepts) const;

 private:
  static constexpr std::uint32_t kLeaf = 8;

  struct Box {
    Point2 low;
    Point2 high;
  };
  /// A node: its points are order_[begin], ..., order_[end - 1].
  struct Node {
    std::size_t index;
    std::uint32_t begin;
    std::uint32_t end;
    bool is_leaf() const { return end - begin <= kLeaf; }
    std::uint32_t middle() const { return begin + (end - begin) / 2; }
    Node lower() const { return {2 * index + 1, begin, middle()}; }
    Node upper() const { return {2 * index + 2, middle(), end}; }
  };

  Node root() const { return {0, 0, static_cast<std::uint32_t>(order_.size())}; }
  void build(Node node);
  static Box box_around(std::span<const Point2> points);
  static bool is_right_of(const Box& box, Point2 a, Point2 b);
  static bool meets(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
  }

  std::vector<Point2> points_;
  std::vector<std::uint32_t> order_;  // The points, in the order of the leaves.
  std::vector<std::uint32_t> rank_;   // For each point, its place in order_.
  std::vector<std::uint8_t> is_left_;
  std::vector<Box> box_;              // For each node, the box around its points.
  std::vector<std::uint32_t> count_;  // For each node, the number of points that are left.
};

template <class Accepts>
std::uint32_t CornerTree::find_in_triangle(Point2 a, Point2 b, Point2 c,
                                           const Accepts& accepts) const {
  if (order_.empty()) return kNone;
  const Point2 corners[3] = {a, b, c};
  const Box box = box_around(corners);
  // Each level leaves at most one node open, and halving ends after 32 levels.
  Node open[64];
  std::size_t size = 0;
  open[size++] = root();
  while (size > 0) {
    const Node node = open[--size];
    if (count_[node.index] == 0 || !meets(box_[node.index], box)) continue;
    const Box& inner = box_[node.index];
    if (is_right_of(inner, a, b) || is_right_of(inner, b, c) || is_right_of(inner, c, a)) continue;
    if (!node.is_leaf()) {
      open[size++] = node.upper();
      open[size++] = node.lower();
      continue;
    }
    for (std::uint32_t r = node.begin; r < node.end; ++r) {
      const std::uint32_t i = order_[r];
      if (is_left_[i] != 0 && meets({points_[i], points_[i]}, box) && accepts(i)) return i;
    }
  }
  return kNone;
}

}  // namespace plumb
