#include "plumb/plane/sweep_curves.h"

namespace plumb {

SweepCurves::SweepCurves(const PlanePointsView& points, std::span<const SweepCurve> curves,
                         std::span<const std::uint32_t> stops)
    : points_(points) {
  std::vector<char> used(points.size(), 0);
  for (const SweepCurve& c : curves) {
    if (c.from != SweepCurve::kUnbounded) used[c.from] = 1;
    if (c.to != SweepCurve::kUnbounded) used[c.to] = 1;
  }
  for (const std::uint32_t stop : stops) used[stop] = 1;
  ranks_ = rank_points(points_, used);
  curves_.reserve(curves.size());
  for (const SweepCurve& c : curves) curves_.push_back(left_to_right(c));
}

SweepCurves::Curve SweepCurves::left_to_right(const SweepCurve& c) const {
  const bool is_bounded = c.from != SweepCurve::kUnbounded && c.to != SweepCurve::kUnbounded;
  const bool forward = is_bounded ? rank(c.from) <= rank(c.to)
                                  : compare_xy(points_.inputs(), c.a, c.b) == Sign::Negative;
  return forward ? Curve{c.from, c.to, c.a, c.b} : Curve{c.to, c.from, c.b, c.a};
}

bool SweepCurves::is_zero_length(SegmentId s) const {
  const Curve& c = curves_[s.value()];
  return c.has_left() && c.has_right() && rank(c.left) == rank(c.right);
}

bool SweepCurves::is_vertical(SegmentId s) const {
  const Curve& c = curves_[s.value()];
  return compare_x(points_, c.a, c.b) == Sign::Zero;
}

Sign SweepCurves::direction_order(SegmentId s, SegmentId t) const {
  if (s == t) return Sign::Zero;
  const Curve& c = curves_[s.value()];
  const Curve& d = curves_[t.value()];
  if (c.a == d.a) return orient2d(points_.inputs(), c.a, c.b, d.b);
  return cross_sign(points_.inputs(), c.a, c.b, d.a, d.b);
}

Sign SweepCurves::order_at_left_infinity(SegmentId s, SegmentId t) const {
  const Sign turn = direction_order(s, t);
  return turn != Sign::Zero ? -turn : side(s, (*this)[t].a);
}

// They meet further right if and only if the one that ends first does not end strictly on its own
// side of the other. An infinite curve ends after a finite one, even a vertical one: to the right
// of an infinite vertical lower curve is below it. Two infinite ones meet if the lower is steeper.
SweepCurves::NextMeeting SweepCurves::next_meeting(SegmentId lower, SegmentId upper) const {
  const Curve& l = curves_[lower.value()];
  const Curve& u = curves_[upper.value()];
  if (!l.has_right() && !u.has_right()) {
    const bool steeper = direction_order(lower, upper) == Sign::Negative;
    return {steeper ? Meeting::Crossing : Meeting::None, 0};
  }
  const bool both_end = l.has_right() && u.has_right();
  if (both_end && rank(l.right) == rank(u.right)) return {};  // the event there sees both
  const bool lower_ends_first = both_end ? rank(l.right) < rank(u.right) : l.has_right();
  const std::uint32_t end = lower_ends_first ? l.right : u.right;
  const Sign own_side = lower_ends_first ? -side(upper, end) : side(lower, end);
  if (own_side == Sign::Positive) return {};
  return {own_side == Sign::Zero ? Meeting::AtEnd : Meeting::Crossing, end};
}

Crossing2 SweepCurves::crossing(SegmentId lower, SegmentId upper) const {
  const Curve& l = curves_[lower.value()];
  const Curve& u = curves_[upper.value()];
  return make_crossing(points_.inputs(), l.a, l.b, u.a, u.b);
}

}  // namespace plumb
