// The ordered list of bundles under the sweep line: a treap in flat arrays, threaded as a list.
//
// Order is positional: nodes are placed next to known neighbours, never compared by a stored key,
// so the caller's geometry may change (at crossings) as long as it re-places what changes. Cost:
// expected O(1) for insert and erase next to a known node, O(log n) for a search.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/predicates/sign.h"

namespace plumb {

using StatusNode = StrongId<struct StatusNodeTag>;

class SweepStatus {
 public:
  StatusNode first() const { return first_; }
  StatusNode next(StatusNode n) const { return nodes_[n.value()].next; }
  StatusNode prev(StatusNode n) const { return nodes_[n.value()].prev; }

  /// The curve that names the node's bundle.
  SegmentId segment(StatusNode n) const { return nodes_[n.value()].segment; }
  void set_segment(StatusNode n, SegmentId s) { nodes_[n.value()].segment = s; }

  /// A new node directly above `below` (at the very bottom when `below` is invalid).
  StatusNode insert_above(StatusNode below, SegmentId s);
  void erase(StatusNode n);

  /// Where a point lies among the bundles.
  struct Location {
    StatusNode below;  ///< highest node below the point, if any
    StatusNode on;     ///< a node through the point, if any (then `below` is not set)
  };

  /// Locates the point for which `side(segment)` answers Positive when it lies above that segment.
  template <class Side>
  Location locate(const Side& side) const {
    Location found;
    for (StatusNode n = root_; n.is_valid();) {
      const Node& node = nodes_[n.value()];
      const Sign s = side(node.segment);
      if (s == Sign::Zero) return {StatusNode(), n};
      if (s == Sign::Positive) found.below = n;
      n = s == Sign::Positive ? node.right : node.left;
    }
    return found;
  }

 private:
  struct Node {
    StatusNode parent, left, right, prev, next;
    SegmentId segment;
    std::uint32_t priority = 0;
  };

  StatusNode allocate(SegmentId s);
  void attach(StatusNode n, StatusNode below);
  void thread(StatusNode n, StatusNode below);
  void sift_up(StatusNode n);
  void rotate_up(StatusNode n);
  void replace_child(StatusNode parent, StatusNode old_child, StatusNode new_child);

  Node& at(StatusNode n) { return nodes_[n.value()]; }

  std::vector<Node> nodes_;
  std::vector<StatusNode> free_;
  StatusNode root_;
  StatusNode first_;
  std::uint64_t random_state_ = 0x9E3779B97F4A7C15ULL;
};

}  // namespace plumb
