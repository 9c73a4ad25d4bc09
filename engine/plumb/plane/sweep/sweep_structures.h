// The two data structures of a sweep: the queue of events and the status.
//
// The queue gives the events in lexicographic order: sorted end points, crossings found on the way,
// and the ends of vertical curves at infinity.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/plane/sweep/sweep_curves.h"
#include "plumb/predicates/sign.h"

namespace plumb {

/// The events of a sweep. See the head of this file.
class SweepQueue {
 public:
  /// A crossing that has been found and not yet been reached.
  struct PendingCrossing {
    Crossing2 point;  ///< The place of the crossing.
    SegmentId lower;  ///< The bundle that is the lower one before it.
    SegmentId upper;  ///< The bundle that is the upper one before it.
  };

  /// The event at hand. Points and crossings are at one place; vertical ends come alone.
  struct Place {
    SweepPlace kind = SweepPlace::Point;       ///< A point or a vertical end.
    std::uint32_t rank = PointRanks::kUnused;  ///< The rank of the points; kUnused without any.
    std::vector<std::uint32_t> points;         ///< Equal end points.
    std::vector<PendingCrossing> crossings;    ///< Equal crossings.
    std::vector<SegmentId> verticals;          ///< Coincident vertical curves, for vertical ends.
    /// Whether there is an end point or stop.
    bool is_point() const { return rank != PointRanks::kUnused; }
  };

  /// Makes the queue of these curves, to which it keeps a reference.
  explicit SweepQueue(const SweepCurves& curves);

  /// Moves on to the next event; returns false if there is none. The left and the right infinity
  /// are not in the queue.
  bool advance();
  const Place& place() const { return place_; }
  /// Adds the crossing of two neighbours of the status. O(log n).
  void add_crossing(SegmentId lower, SegmentId upper);

  std::size_t done() const { return cursor_; }
  std::size_t total() const { return curves_.ranks().order.size(); }

 private:
  // Vertical ends at infinity by x. A group of equal x is one event.
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
  std::vector<PendingCrossing> heap_;  // The least crossing comes first.
  std::size_t cursor_ = 0;             // The next point in ranks().order.
  Verticals starts_;
  Verticals ends_;
  Place place_;
};

// The status is the ordered list of bundles that the sweep line meets: a treap in flat arrays,
// threaded as a list.
//
// The order is one of positions: nodes are placed next to known neighbours and never compared by a
// stored key. So the geometry may change at crossings, as long as the sweep replaces the curves
// whose order changes. Cost: expected O(1) for insert and erase next to a known node, expected
// O(log n) for a search. Source: R. G. Seidel, C. R. Aragon, Randomized search trees, Algorithmica
// 16 (1996).

using StatusNode = StrongId<struct StatusNodeTag>;

/// The bundles that the sweep line meets.
class SweepStatus {
 public:
  StatusNode first() const { return first_; }
  StatusNode next(StatusNode n) const { return nodes_[n].next; }
  StatusNode prev(StatusNode n) const { return nodes_[n].prev; }

  /// Returns the curve that names the node's bundle.
  SegmentId segment(StatusNode n) const { return nodes_[n].segment; }
  void set_segment(StatusNode n, SegmentId s) { nodes_[n].segment = s; }

  /// Inserts a node directly above `below`, or at the very bottom if `below` is not valid.
  StatusNode insert_above(StatusNode below, SegmentId s);
  /// Removes a node, which may be used again later.
  void erase(StatusNode n);

  /// The position of a point among the bundles.
  struct Location {
    StatusNode below;  ///< The highest node below the point, if any.
    StatusNode on;     ///< A node through the point, if any; `below` is then not set.
  };

  /// Locates the point for which side(segment) returns its side of a curve: Positive above it.
  template <class Side>
  Location locate(const Side& side) const {
    Location found;
    for (StatusNode n = root_; n.is_valid();) {
      const Node& node = nodes_[n];
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

  Node& at(StatusNode n) { return nodes_[n]; }

  IdVector<StatusNode, Node> nodes_;
  std::vector<StatusNode> free_;
  StatusNode root_;
  StatusNode first_;
  std::uint64_t random_state_ = 0x9E3779B97F4A7C15ULL;
};

}  // namespace plumb
