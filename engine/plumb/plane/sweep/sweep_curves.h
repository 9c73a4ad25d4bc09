// Lexicographic ranks of points.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/plane/sweep/sweep.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {

/// The used points in lexicographic order. Points of equal coordinates share the rank of the first.
struct PointRanks {
  static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> order;  ///< used points, sorted; equal points by index
  std::vector<std::uint32_t> rank;   ///< per point: position in `order` of the first equal one
};

/// Ranks the points whose `used` entry is set. O(n log n).
PointRanks rank_points(const PlanePointsView& points, const std::vector<char>& used);

// The curves of a sweep, each turned to run from left to right, and what the sweep asks of two.

class SweepCurves {
 public:
  /// The line a -> b runs to the right, or upward.
  struct Curve {
    std::uint32_t left;  ///< a point, or SweepCurve::kUnbounded; right likewise
    std::uint32_t right;
    std::uint32_t a;
    std::uint32_t b;
    bool has_left() const { return left != SweepCurve::kUnbounded; }
    bool has_right() const { return right != SweepCurve::kUnbounded; }
  };

  SweepCurves(const PlanePointsView& points, std::span<const SweepCurve> curves,
              std::span<const std::uint32_t> stops);

  const PlanePointsView& points() const { return points_; }
  const PointRanks& ranks() const { return ranks_; }
  std::size_t size() const { return curves_.size(); }
  const Curve& operator[](SegmentId s) const { return curves_[s.value()]; }
  std::uint32_t rank(std::uint32_t point) const { return ranks_.rank[point]; }

  bool is_zero_length(SegmentId s) const;
  bool is_vertical(SegmentId s) const;
  bool ends_at(SegmentId s, std::uint32_t rank_of_place) const {
    const Curve& c = curves_[s.value()];
    return c.has_right() && rank(c.right) == rank_of_place;
  }
  /// Does s end later than t? (Of curves on one line.)
  bool reaches_further(SegmentId s, SegmentId t) const {
    const Curve& c = curves_[s.value()];
    const Curve& d = curves_[t.value()];
    if (!d.has_right()) return false;
    return !c.has_right() || rank(c.right) > rank(d.right);
  }

  Sign side(SegmentId s, std::uint32_t point) const {
    const Curve& c = curves_[s.value()];
    return orient2d(points_, c.a, c.b, point);
  }
  Sign side(SegmentId s, const Crossing2& point) const {
    const Curve& c = curves_[s.value()];
    return orient2d(points_.inputs(), c.a, c.b, point);
  }
  /// Positive when t runs steeper than s.
  Sign direction_order(SegmentId s, SegmentId t) const;
  /// Order of two curves from the left infinity there: Positive when t lies above s, Zero when they
  /// are on one line.
  Sign order_at_left_infinity(SegmentId s, SegmentId t) const;

  /// What becomes of two curves of which `lower` runs next below `upper`.
  enum class Meeting : std::uint8_t {
    None,      ///< they do not meet further right, or end at equal points
    Crossing,  ///< inside both
    AtEnd,     ///< at the right end of one, inside the other: `end`
  };
  struct NextMeeting {
    Meeting kind = Meeting::None;
    std::uint32_t end = 0;
  };
  NextMeeting next_meeting(SegmentId lower, SegmentId upper) const;
  Crossing2 crossing(SegmentId lower, SegmentId upper) const;

 private:
  Curve left_to_right(const SweepCurve& curve) const;

  PlanePointsView points_;
  PointRanks ranks_;
  std::vector<Curve> curves_;
};

// All curves of the bundles at an event, for visitors that have to look at every one of them.
//
// An event costs the number of curves there, also of those that pass through in a bundle: of n
// nested segments on one line n^2 / 2 in all. Visitors that can do with what changes at an event
// ask the event itself.

/// A curve at an event; curves of equal `bundle` overlap on that side of the event.
struct SweepIncidence {
  SegmentId segment;
  std::uint32_t bundle;  ///< 0, 1, ... from bottom to top
};

class SweepMembers {
 public:
  static constexpr std::size_t kBytesPerCurve = 9;

  explicit SweepMembers(std::size_t curve_count)
      : next_(curve_count), head_(curve_count), is_ended_(curve_count, 0) {}

  /// To be told of every event that is not plain; plain ones may be left out.
  void update(const SweepEvent& event);

  /// Of the last event told: bottom to top.
  std::span<const SweepIncidence> incoming() const { return incoming_; }
  std::span<const SweepIncidence> outgoing() const { return outgoing_; }

 private:
  void list_incoming(const SweepEvent& event);
  void list_outgoing(const SweepEvent& event);

  std::vector<SegmentId> next_;  // per curve: the next one of its bundle
  std::vector<SegmentId> head_;  // per curve that names a bundle: its first; invalid: just itself
  std::vector<char> is_ended_;   // per curve
  std::vector<SweepIncidence> incoming_;
  std::vector<SweepIncidence> outgoing_;
  std::vector<std::size_t> begin_;  // per incoming bundle, into incoming_; and one more
};

}  // namespace plumb
