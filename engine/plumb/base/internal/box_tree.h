// Boxes of doubles in space and a tree over them, which finds the boxes that meet a box, a ray, or
// the boxes of another tree.
//
// Answers are about the boxes alone. For exact answers a caller gives boxes that surely contain
// what they stand for, and tests exactly what is found.
//
// Main flow of building:
//  1. codes      the code of a box is the cell of its middle on a grid of 2^21 cells for each axis,
//                with the bits of the axes interleaved
//  2. sort       a radix sort by code makes neighbours in the order neighbours in space. Runs of
//                one code are sorted again on a finer grid of their own.
//  3. nodes      four consecutive boxes make a leaf, two consecutive nodes the node above them
//
// The tree is full, so a node is its level and its place there, and nothing is linked. Building
// takes O(n) for each 2^21-fold step of scale in the places of the boxes, which is nearly always
// one, and about 60 ns a box. The tree takes 76 bytes a box.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace plumb {

/// The closed box low <= x <= high. Bounds may be infinite. A default-constructed one is empty.
struct Box3 {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  std::array<double, 3> low = {kInfinity, kInfinity, kInfinity};      ///< The least coordinates.
  std::array<double, 3> high = {-kInfinity, -kInfinity, -kInfinity};  ///< The greatest ones.

  /// Whether the boxes have a common point. Requires that neither is empty.
  bool meets(const Box3& b) const {
    return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] &&
           b.low[1] <= high[1] && low[2] <= b.high[2] && b.low[2] <= high[2];
  }
  /// Grows to the least box that contains both.
  void add(const Box3& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = b.low[i] < low[i] ? b.low[i] : low[i];
      high[i] = b.high[i] > high[i] ? b.high[i] : high[i];
    }
  }
  /// Returns the sum of the three sides.
  double extent() const { return (high[0] - low[0]) + (high[1] - low[1]) + (high[2] - low[2]); }
  friend bool operator==(const Box3&, const Box3&) = default;
};

/// The rays o + t d, t >= 0, of all points o of one box and all vectors d of another. The
/// direction's bounds are finite; it may be one vector, such as an axis.
struct BoxRay {
  Box3 origin;     ///< The points o.
  Box3 direction;  ///< The vectors d.
};

/// Whether a ray may meet the box at some t <= limit. If so, sets `entry` to a lower bound of every
/// such t.
bool can_enter(const BoxRay& ray, const Box3& box, double limit, double& entry);

/// A tree over boxes. Const members may be called from several threads at once.
class BoxTree {
 public:
  BoxTree() = default;
  /// Builds the tree over boxes[0], boxes[1], ... Requires at most 2^32 - 4 boxes, none of them
  /// empty, and no NaNs. The order in which queries visit boxes depends on nothing but the boxes.
  explicit BoxTree(std::span<const Box3> boxes);

  std::size_t size() const { return order_.size(); }
  bool is_empty() const { return order_.empty(); }
  /// Returns the least box that contains all boxes.
  Box3 bounds() const { return is_empty() ? Box3{} : node({top(), 0}); }

  /// Calls visit(i) for every box i that meets `query`, which must not be empty. If visit returns
  /// bool, the first false ends the query.
  template <class Visit>
  void for_each_meeting(const Box3& query, Visit&& visit) const;

  /// Calls visit(i, j) for every box i of `a` and j of `b` that meet.
  template <class Visit>
  static void for_each_pair(const BoxTree& a, const BoxTree& b, Visit&& visit);

  /// Calls visit(i, j) for every two different boxes that meet, once for each pair, in some order.
  template <class Visit>
  void for_each_pair_inside(Visit&& visit) const;

  /// Part of the pairs of boxes of two trees.
  class Part;
  /// Returns the work of for_each_pair() in about so many parts, which depend on the boxes and the
  /// number alone.
  static std::vector<Part> parts(const BoxTree& a, const BoxTree& b, std::size_t about);
  template <class Visit>
  static void for_each_pair(const BoxTree& a, const BoxTree& b, const Part& part, Visit&& visit);

  /// Calls limit = visit(i, entry) for each box that the ray may enter at some t <= limit, starting
  /// with the given limit. `entry` bounds t from below. Nearer nodes come first, so that a falling
  /// limit spares the rest; the boxes themselves do not come in an exact order.
  template <class Visit>
  void for_each_along(const BoxRay& ray, double limit, Visit&& visit) const;

 private:
  static constexpr std::size_t kLeaf = 4;
  static constexpr std::size_t kMostLevels = 32;

  /// A node. Leaves have level 0.
  struct Node {
    std::uint32_t level;
    std::uint32_t at;
    Node child(std::uint32_t i) const { return {level - 1, 2 * at + i}; }
  };
  static bool opens_first(const BoxTree& a, Node m, const BoxTree& b, Node n) {
    return n.level == 0 || (m.level > 0 && a.node(m).extent() >= b.node(n).extent());
  }
  /// Nodes still to be visited, in reverse order. Going down leaves at most one for each level.
  template <class Item>
  struct Stack {
    std::array<Item, 2 * kMostLevels> items;
    std::size_t size = 0;
    void push(const Item& item) { items[size++] = item; }
    Item pop() { return items[--size]; }
  };
  struct Entry {
    Node node;
    double at;
  };

  std::uint32_t top() const { return static_cast<std::uint32_t>(level_begin_.size() - 1); }
  const Box3& node(Node n) const { return nodes_[level_begin_[n.level] + n.at]; }
  void make_nodes();

  template <class Visit>
  static void descend(const BoxTree& a, Node m, const BoxTree& b, Node n, Visit& visit);
  template <class Visit>
  void descend_inside(Node n, Visit& visit) const;
  template <class Visit>
  static void meet_leaves(const BoxTree& a, Node m, const BoxTree& b, Node n, Visit& visit);

  std::vector<std::uint32_t> order_;      // The numbers of the boxes, neighbours together.
  std::vector<Box3> boxes_;               // In that order; filled up with boxes that meet nothing.
  std::vector<Box3> nodes_;               // Level by level, each filled up to an even number.
  std::vector<std::size_t> level_begin_;  // Where each level begins in nodes_.
};

class BoxTree::Part {
 private:
  friend class BoxTree;
  Part(Node m, Node n) : m_(m), n_(n) {}
  Node m_;
  Node n_;
};

template <class Visit>
void BoxTree::for_each_pair(const BoxTree& a, const BoxTree& b, const Part& part, Visit&& visit) {
  descend(a, part.m_, b, part.n_, visit);
}

template <class Visit>
void BoxTree::for_each_meeting(const Box3& query, Visit&& visit) const {
  if (is_empty()) return;
  Stack<Node> left;
  left.push({top(), 0});
  while (left.size > 0) {
    const Node n = left.pop();
    if (!node(n).meets(query)) continue;
    if (n.level > 0) {
      left.push(n.child(1));
      left.push(n.child(0));
      continue;
    }
    for (std::size_t i = n.at * kLeaf; i < (n.at + 1) * kLeaf; ++i) {
      if (!boxes_[i].meets(query)) continue;
      if constexpr (std::is_same_v<std::invoke_result_t<Visit&, std::uint32_t>, bool>) {
        if (!visit(order_[i])) return;
      } else {
        visit(order_[i]);
      }
    }
  }
}

template <class Visit>
void BoxTree::for_each_pair(const BoxTree& a, const BoxTree& b, Visit&& visit) {
  if (a.is_empty() || b.is_empty()) return;
  const Node m{a.top(), 0}, n{b.top(), 0};
  if (a.node(m).meets(b.node(n))) descend(a, m, b, n, visit);
}

// The larger node is opened first, so that a small dense tree inside a leaf of the other is not
// opened for nothing.
template <class Visit>
void BoxTree::descend(const BoxTree& a, Node m, const BoxTree& b, Node n, Visit& visit) {
  if (m.level == 0 && n.level == 0) return meet_leaves(a, m, b, n, visit);
  const bool opens_m = opens_first(a, m, b, n);
  for (std::uint32_t i = 0; i < 2; ++i) {
    if (opens_m) {
      if (a.node(m.child(i)).meets(b.node(n))) descend(a, m.child(i), b, n, visit);
    } else if (a.node(m).meets(b.node(n.child(i)))) {
      descend(a, m, b, n.child(i), visit);
    }
  }
}

template <class Visit>
void BoxTree::for_each_pair_inside(Visit&& visit) const {
  if (!is_empty()) descend_inside({top(), 0}, visit);
}

template <class Visit>
void BoxTree::descend_inside(Node n, Visit& visit) const {
  if (!node(n).meets(node(n))) return;  // The node only fills up its level.
  if (n.level > 0) {
    const Node m = n.child(0), o = n.child(1);
    descend_inside(m, visit);
    descend_inside(o, visit);
    if (node(m).meets(node(o))) descend(*this, m, *this, o, visit);
    return;
  }
  for (std::size_t i = n.at * kLeaf; i < (n.at + 1) * kLeaf; ++i) {
    for (std::size_t j = i + 1; j < (n.at + 1) * kLeaf; ++j) {
      if (boxes_[i].meets(boxes_[j])) visit(order_[i], order_[j]);
    }
  }
}

template <class Visit>
void BoxTree::meet_leaves(const BoxTree& a, Node m, const BoxTree& b, Node n, Visit& visit) {
  for (std::size_t i = m.at * kLeaf; i < (m.at + 1) * kLeaf; ++i) {
    if (!a.boxes_[i].meets(b.node(n))) continue;
    for (std::size_t j = n.at * kLeaf; j < (n.at + 1) * kLeaf; ++j) {
      if (a.boxes_[i].meets(b.boxes_[j])) visit(a.order_[i], b.order_[j]);
    }
  }
}

template <class Visit>
void BoxTree::for_each_along(const BoxRay& ray, double limit, Visit&& visit) const {
  double entry = 0;
  if (is_empty() || !can_enter(ray, bounds(), limit, entry)) return;
  Stack<Entry> left;
  left.push({{top(), 0}, entry});
  while (left.size > 0) {
    const Entry next = left.pop();
    if (next.at > limit) continue;
    const Node n = next.node;
    if (n.level > 0) {
      Entry first{n.child(0), 0}, second{n.child(1), 0};
      const bool takes_first = can_enter(ray, node(first.node), limit, first.at);
      const bool takes_second = can_enter(ray, node(second.node), limit, second.at);
      const bool is_swapped = takes_first && takes_second && second.at < first.at;
      if (is_swapped) std::swap(first, second);
      if (takes_second) left.push(second);
      if (takes_first) left.push(first);
      continue;
    }
    for (std::size_t i = n.at * kLeaf; i < (n.at + 1) * kLeaf; ++i) {
      if (can_enter(ray, boxes_[i], limit, entry)) limit = visit(order_[i], entry);
    }
  }
}

}  // namespace plumb
