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

  /// Returns a point that is left, lies in the least closed box around `corners`, and satisfies
  /// `accepts`. Returns kNone if there is none.
  template <class Accepts>
  std::uint32_t find_in_box(std::span<const Point2> corners, const Accepts& accepts) const;
  /// Does the same for three corners.
  template <class Accepts>
  std::uint32_t find_in_box(const Point2 (&corners)[3], const Accepts& accepts) const {
    return find_in_box(std::span<const Point2>(corners), accepts);
  }

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
std::uint32_t CornerTree::find_in_box(std::span<const Point2> corners,
                                      const Accepts& accepts) const {
  if (order_.empty()) return kNone;
  const Box box = box_around(corners);
  // Each level leaves at most one node open, and halving ends after 32 levels.
  Node open[64];
  std::size_t size = 0;
  open[size++] = root();
  while (size > 0) {
    const Node node = open[--size];
    if (count_[node.index] == 0 || !meets(box_[node.index], box)) continue;
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
