// The curves of a sweep, each turned to run from left to right, and what the sweep asks of two.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/point_ranks.h"
#include "plumb/plane/sweep.h"
#include "plumb/predicates/plane_points.h"

namespace plumb {

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

}  // namespace plumb
