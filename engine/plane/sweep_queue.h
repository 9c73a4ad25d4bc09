// The events of a sweep in lexicographic order: sorted end points, crossings found on the way, and
// the ends of vertical curves at infinity.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/sweep_curves.h"

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

}  // namespace plumb
