// The events of a sweep in lexicographic order: sorted end points, crossings found on the way, and
// the ends of vertical curves at infinity.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/plane/sweep/sweep_curves.h"
#include "plumb/predicates/sign.h"

namespace plumb {

class SweepQueue {
 public:
  struct PendingCrossing {
    Crossing2 point;
    SegmentId lower;
    SegmentId upper;
  };

  /// The event at hand. Points and crossings are at one place; vertical ends come alone.
  struct Place {
    SweepPlace kind = SweepPlace::Point;
    std::uint32_t rank = PointRanks::kUnused;  ///< kUnused: a mere crossing
    std::vector<std::uint32_t> points;         ///< equal end points
    std::vector<PendingCrossing> crossings;    ///< equal crossings
    std::vector<SegmentId> verticals;          ///< coincident vertical curves, for vertical ends
    bool is_point() const { return rank != PointRanks::kUnused; }
  };

  /// Keeps a reference to `curves`.
  explicit SweepQueue(const SweepCurves& curves);

  /// Moves on to the next event; false when there is none. Curves from the left and to the right
  /// infinity are not events.
  bool advance();
  const Place& place() const { return place_; }
  void add_crossing(SegmentId lower, SegmentId upper);

  std::size_t done() const { return cursor_; }
  std::size_t total() const { return curves_.ranks().order.size(); }

 private:
  // Vertical ends at infinity, by x: a group of equal x is one event.
  struct Verticals {
    std::vector<SegmentId> order;
    std::size_t cursor = 0;
    bool left() const { return cursor < order.size(); }
    SegmentId next() const { return order[cursor]; }
  };

  void collect_verticals();
  void sort_by_x(Verticals& verticals) const;
  bool advance_to_vertical();
  bool is_next(const Verticals& verticals, SweepPlace kind) const;
  void take_verticals(Verticals& verticals, SweepPlace kind);
  void gather_equal_points();
  void gather_equal_crossings();
  void pop_crossing();

  const SweepCurves& curves_;
  std::vector<PendingCrossing> heap_;  // least crossing first
  std::size_t cursor_ = 0;             // into ranks().order
  Verticals starts_;
  Verticals ends_;
  Place place_;
};

// The ordered list of bundles under the sweep line: a treap in flat arrays, threaded as a list.
//
// Order is positional: nodes are placed next to known neighbours, never compared by a stored key,
// so the caller's geometry may change (at crossings) as long as it re-places what changes. Cost:
// expected O(1) for insert and erase next to a known node, O(log n) for a search.

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
