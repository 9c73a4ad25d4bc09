// Ranks of points, order and meetings of curves, and the members of bundles.
//
// Points are sorted once, input points by keys of their nearest doubles: rounding is monotone, so
// different keys have the order of the exact points, and exact comparison is needed only for equal
// keys. One orientation sign decides where two neighbours of the status meet next
// (docs/design/sweep.md, Neighbours).
//
// Tested by tests/plane/sweep_test.cpp and tests/plane/sweep_unbounded_test.cpp.

#include "plumb/plane/sweep/sweep_curves.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/arithmetic/double_bits.h"

namespace plumb {
namespace {

// A point with keys that are nearly always sufficient. Rounding is monotone, so different keys have
// the order of the exact points. Equal keys imply equal points only if all input points are
// doubles.
struct KeyedPoint {
  std::uint64_t x;
  std::uint64_t y;
  std::uint32_t point;
};

class KeyOrder {
 public:
  explicit KeyOrder(const PlanePointsView& points)
      : points_(points), exact_keys_(points.inputs().all_double()) {}

  Sign compare(const KeyedPoint& p, const KeyedPoint& q) const {
    if (p.x != q.x) return p.x < q.x ? Sign::Negative : Sign::Positive;
    if (!exact_keys_) return compare_xy(points_, p.point, q.point);
    if (p.y != q.y) return p.y < q.y ? Sign::Negative : Sign::Positive;
    return Sign::Zero;
  }

 private:
  const PlanePointsView& points_;
  bool exact_keys_;
};

// Compares points exactly. Crossings have no keys, because their approximations are not monotone.
class PredicateOrder {
 public:
  explicit PredicateOrder(const PlanePointsView& points) : points_(points) {}

  Sign compare(const KeyedPoint& p, const KeyedPoint& q) const {
    return compare_xy(points_, p.point, q.point);
  }

 private:
  const PlanePointsView& points_;
};

std::vector<KeyedPoint> keyed_points(const PlanePointsView& points, const std::vector<char>& used) {
  std::vector<KeyedPoint> keyed;
  keyed.reserve(static_cast<std::size_t>(std::count(used.begin(), used.end(), char{1})));
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (used[i] == 0) continue;
    const Point2 p = points.is_input(i) ? points.inputs().approx(i) : Point2{};
    keyed.push_back({ordered_key(p.x), ordered_key(p.y), i});
  }
  return keyed;
}

// Sorts the points, where equal points are sorted by index. Gives each point the position of the
// first point that is equal to it.
template <class Order>
PointRanks rank_by(const Order& order, std::vector<KeyedPoint> keyed, std::size_t point_count,
                   const Context* context) {
  constexpr std::uint64_t kStepsPerCheckpoint = std::uint64_t{1} << 16;
  std::uint64_t steps = 0;
  const auto is_less = [&](const KeyedPoint& p, const KeyedPoint& q) {
    if (++steps % kStepsPerCheckpoint == 0 && context != nullptr) context->check_limits("sweep");
    const Sign s = order.compare(p, q);
    return s == Sign::Negative || (s == Sign::Zero && p.point < q.point);
  };
  // The points of a complex have this order.
  if (!std::is_sorted(keyed.begin(), keyed.end(), is_less)) {
    std::sort(keyed.begin(), keyed.end(), is_less);
  }
  PointRanks ranks;
  ranks.order.resize(keyed.size());
  ranks.rank.assign(point_count, PointRanks::kUnused);
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    ranks.order[i] = keyed[i].point;
    const bool equals_previous = i > 0 && order.compare(keyed[i - 1], keyed[i]) == Sign::Zero;
    ranks.rank[keyed[i].point] =
        equals_previous ? ranks.rank[keyed[i - 1].point] : static_cast<std::uint32_t>(i);
  }
  return ranks;
}

}  // namespace

PointRanks rank_points(const PlanePointsView& points, const std::vector<char>& used,
                       const Context* context) {
  std::vector<KeyedPoint> keyed = keyed_points(points, used);
  const bool only_inputs = keyed.empty() || points.is_input(keyed.back().point);
  return only_inputs ? rank_by(KeyOrder(points), std::move(keyed), points.size(), context)
                     : rank_by(PredicateOrder(points), std::move(keyed), points.size(), context);
}

SweepCurves::SweepCurves(const PlanePointsView& points, std::span<const SweepCurve> curves,
                         std::span<const std::uint32_t> stops, const Context* context)
    : points_(points) {
  std::vector<char> used(points.size(), 0);
  for (const SweepCurve& c : curves) {
    if (c.from != SweepCurve::kUnbounded) used[c.from] = 1;
    if (c.to != SweepCurve::kUnbounded) used[c.to] = 1;
  }
  for (const std::uint32_t stop : stops) used[stop] = 1;
  ranks_ = rank_points(points_, used, context);
  curves_.reserve(curves.size());
  for (const SweepCurve& c : curves) curves_.push_back(left_to_right(c));
}

/// For bounded curves, the ranks of the ends determine the direction. For other curves, two points
/// of the line determine it.
SweepCurves::Curve SweepCurves::left_to_right(const SweepCurve& c) const {
  const bool is_bounded = c.from != SweepCurve::kUnbounded && c.to != SweepCurve::kUnbounded;
  const bool forward = is_bounded ? rank(c.from) <= rank(c.to)
                                  : compare_xy(points_.inputs(), c.a, c.b) == Sign::Negative;
  return forward ? Curve{c.from, c.to, c.a, c.b} : Curve{c.to, c.from, c.b, c.a};
}

bool SweepCurves::is_zero_length(SegmentId s) const {
  const Curve& c = curves_[s];
  return c.has_left() && c.has_right() && rank(c.left) == rank(c.right);
}

bool SweepCurves::is_vertical(SegmentId s) const {
  const Curve& c = curves_[s];
  return compare_x(points_, c.a, c.b) == Sign::Zero;
}

Sign SweepCurves::direction_order(SegmentId s, SegmentId t) const {
  if (s == t) return Sign::Zero;
  const Curve& c = curves_[s];
  const Curve& d = curves_[t];
  if (c.a == d.a) return orient2d(points_.inputs(), c.a, c.b, d.b);
  return cross_sign(points_.inputs(), c.a, c.b, d.a, d.b);
}

Sign SweepCurves::order_at_left_infinity(SegmentId s, SegmentId t) const {
  const Sign turn = direction_order(s, t);
  return turn != Sign::Zero ? -turn : side(s, (*this)[t].a);
}

// Two curves meet further right if and only if the one that ends first does not end strictly on its
// own side of the other. An infinite curve ends after a finite one. This holds for a vertical one,
// too: what lies to the right of an infinite vertical lower curve lies below it. Two infinite
// curves meet if the lower one is steeper.
SweepCurves::NextMeeting SweepCurves::next_meeting(SegmentId lower, SegmentId upper) const {
  const Curve& l = curves_[lower];
  const Curve& u = curves_[upper];
  if (!l.has_right() && !u.has_right()) {
    const bool steeper = direction_order(lower, upper) == Sign::Negative;
    return {steeper ? Meeting::Crossing : Meeting::None, 0};
  }
  const bool both_end = l.has_right() && u.has_right();
  // The event at that place has both curves.
  if (both_end && rank(l.right) == rank(u.right)) return {};
  const bool lower_ends_first = both_end ? rank(l.right) < rank(u.right) : l.has_right();
  const std::uint32_t end = lower_ends_first ? l.right : u.right;
  const Sign own_side = lower_ends_first ? -side(upper, end) : side(lower, end);
  if (own_side == Sign::Positive) return {};
  return {own_side == Sign::Zero ? Meeting::AtEnd : Meeting::Crossing, end};
}

Crossing2 SweepCurves::crossing(SegmentId lower, SegmentId upper) const {
  const Curve& l = curves_[lower];
  const Curve& u = curves_[upper];
  return make_crossing(points_.inputs(), l.a, l.b, u.a, u.b);
}

void SweepMembers::update(const SweepEvent& event) {
  list_incoming(event);
  list_outgoing(event);
}

// The curves of a bundle form a list. For the curve that is the name of the bundle, head_ has the
// first curve of this list. A bundle from a plain event has only that curve.
void SweepMembers::list_incoming(const SweepEvent& event) {
  incoming_.clear();
  begin_.assign(1, 0);
  for (std::size_t i = 0; i < event.incoming.size(); ++i) {
    const SegmentId head = head_[event.incoming[i].value()];
    for (SegmentId s = head.is_valid() ? head : event.incoming[i]; s.is_valid(); s = next_[s]) {
      incoming_.push_back({s, static_cast<std::uint32_t>(i)});
    }
    begin_.push_back(incoming_.size());
  }
  for (const SegmentId s : event.ends) is_ended_[s] = 1;
}

// The members of an outgoing bundle are the members of the incoming bundle that do not end,
// followed by the curves that start. Their list is made again for the curve that is now the name of
// the bundle.
void SweepMembers::list_outgoing(const SweepEvent& event) {
  outgoing_.clear();
  for (std::size_t i = 0; i < event.outgoing.size(); ++i) {
    const auto bundle = static_cast<std::uint32_t>(i);
    const std::size_t first = outgoing_.size();
    if (const std::uint32_t in = event.came_from(i); in != SweepEvent::kNew) {
      for (std::size_t k = begin_[in]; k < begin_[in + 1]; ++k) {
        const SegmentId s = incoming_[k].segment;
        if (is_ended_[s] == 0) outgoing_.push_back({s, bundle});
      }
    }
    for (const SegmentId s : event.starting_in(i)) outgoing_.push_back({s, bundle});
    head_[event.outgoing[i].value()] = outgoing_[first].segment;
    for (std::size_t k = first; k < outgoing_.size(); ++k) {
      const bool is_last = k + 1 == outgoing_.size();
      next_[outgoing_[k].segment] = is_last ? SegmentId() : outgoing_[k + 1].segment;
    }
  }
}

}  // namespace plumb
