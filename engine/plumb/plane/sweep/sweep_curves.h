// The curves of a sweep with the ranks of their ends, the questions that a sweep asks about two
// curves, and lists of the curves in the bundles of an event.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/sweep/point_ranks.h"
#include "plumb/plane/sweep/sweep.h"
#include "plumb/predicates/plane/plane_points.h"

namespace plumb {

/// The curves of a sweep, each turned to run from left to right.
class SweepCurves {
 public:
  /// A curve. Its line a -> b runs to the right, or upward.
  struct Curve {
    std::uint32_t left;   ///< The left end, a point or SweepCurve::kUnbounded.
    std::uint32_t right;  ///< The right end, likewise.
    std::uint32_t a;      ///< An input point of the line.
    std::uint32_t b;      ///< A greater input point of the line.
    bool has_left() const { return left != SweepCurve::kUnbounded; }
    bool has_right() const { return right != SweepCurve::kUnbounded; }
  };

  /// Ranks the ends of all curves and the stops, and turns the curves. The limits of `context`,
  /// which may be null, are checked meanwhile.
  SweepCurves(const PlanePointsView& points, std::span<const SweepCurve> curves,
              std::span<const std::uint32_t> stops, const Context* context = nullptr);

  const PlanePointsView& points() const { return points_; }
  const PointRanks& ranks() const { return ranks_; }
  std::size_t size() const { return curves_.size(); }
  const Curve& operator[](SegmentId s) const { return curves_[s]; }
  std::uint32_t rank(std::uint32_t point) const { return ranks_.rank[point]; }

  /// Whether both ends have the same coordinates.
  bool is_zero_length(SegmentId s) const;
  /// Whether all points of the curve have one abscissa.
  bool is_vertical(SegmentId s) const;
  /// Whether the right end has the given rank.
  bool ends_at(SegmentId s, std::uint32_t rank_of_place) const {
    const Curve& c = curves_[s];
    return c.has_right() && rank(c.right) == rank_of_place;
  }
  /// Whether s ends later than t. Requires curves on one line.
  bool reaches_further(SegmentId s, SegmentId t) const {
    const Curve& c = curves_[s];
    const Curve& d = curves_[t];
    if (!d.has_right()) return false;
    return !c.has_right() || rank(c.right) > rank(d.right);
  }

  /// Returns the side of the line of s on which a point lies; Positive is above.
  Sign side(SegmentId s, std::uint32_t point) const {
    const Curve& c = curves_[s];
    return orient2d(points_, c.a, c.b, point);
  }
  Sign side(SegmentId s, const Crossing2& point) const {
    const Curve& c = curves_[s];
    return orient2d(points_.inputs(), c.a, c.b, point);
  }
  /// Returns Positive if t is steeper than s, Zero if they are parallel.
  Sign direction_order(SegmentId s, SegmentId t) const;
  /// Returns the order at the left infinity of two curves from there: Positive if t lies above s,
  /// Zero if they are on one line.
  Sign order_at_left_infinity(SegmentId s, SegmentId t) const;

  /// Where two curves meet, of which `lower` runs next below `upper`.
  enum class Meeting : std::uint8_t {
    None,      ///< They do not meet further right, or end at equal points.
    Crossing,  ///< They cross inside both.
    AtEnd,     ///< The right end of one, `end`, lies inside the other.
  };
  /// The answer of next_meeting().
  struct NextMeeting {
    Meeting kind = Meeting::None;  ///< The kind of their meeting.
    std::uint32_t end = 0;         ///< The end point, for AtEnd.
  };
  /// Returns where two neighbours of the status meet next. Costs one sign.
  NextMeeting next_meeting(SegmentId lower, SegmentId upper) const;
  /// Returns the common point of the lines of two curves. Requires that they are not parallel.
  Crossing2 crossing(SegmentId lower, SegmentId upper) const;

 private:
  Curve left_to_right(const SweepCurve& curve) const;

  PlanePointsView points_;
  PointRanks ranks_;
  IdVector<SegmentId, Curve> curves_;
};

// All curves of the bundles at an event, for visitors that have to look at every one of them.
//
// The cost of an event is the number of curves at the event, including the curves that pass through
// in a bundle. So n nested segments on one line cost n^2 / 2 in total. Visitors for which the
// changes at an event suffice should ask the event itself.

/// A curve at an event. Curves of equal `bundle` overlap on that side of the event.
struct SweepIncidence {
  SegmentId segment;     ///< The curve.
  std::uint32_t bundle;  ///< The number of its bundle: 0, 1, ... from bottom to top.
};

/// Keeps the lists of the curves in all bundles.
class SweepMembers {
 public:
  static constexpr std::size_t kBytesPerCurve = 9;

  explicit SweepMembers(std::size_t curve_count)
      : next_(curve_count), head_(curve_count), is_ended_(curve_count, 0) {}

  /// Takes an event. Requires every event that is not plain, in order. Plain events may be left
  /// out.
  void update(const SweepEvent& event);

  // The curves at the last event, bottom to top.
  std::span<const SweepIncidence> incoming() const { return incoming_; }
  std::span<const SweepIncidence> outgoing() const { return outgoing_; }

 private:
  void list_incoming(const SweepEvent& event);
  void list_outgoing(const SweepEvent& event);

  IdVector<SegmentId, SegmentId> next_;  // The next curve in the bundle of each curve.
  IdVector<SegmentId, SegmentId>
      head_;  // The first curve of the bundle that a curve names; not valid if
              // the bundle has that curve alone.
  IdVector<SegmentId, char> is_ended_;  // Whether each curve has ended.
  std::vector<SweepIncidence> incoming_;
  std::vector<SweepIncidence> outgoing_;
  std::vector<std::size_t> begin_;  // Where each incoming bundle begins in incoming_; and the end.
};

}  // namespace plumb
