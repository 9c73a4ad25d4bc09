#include "plumb/plane/sweep_queue.h"

#include <algorithm>

namespace plumb {
namespace {

// Heap order: std::push_heap keeps the greatest first, so "less" means "later".
struct Later {
  const PointTable2& points;
  bool operator()(const SweepQueue::PendingCrossing& p,
                  const SweepQueue::PendingCrossing& q) const {
    return compare_xy(points, p.point, q.point) == Sign::Positive;
  }
};

}  // namespace

SweepQueue::SweepQueue(const SweepCurves& curves) : curves_(curves) { collect_verticals(); }

void SweepQueue::collect_verticals() {
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const SegmentId s(i);
    const auto& c = curves_[s];
    if ((c.has_left() && c.has_right()) || !curves_.is_vertical(s)) continue;
    if (!c.has_left()) starts_.order.push_back(s);
    if (!c.has_right()) ends_.order.push_back(s);
  }
  sort_by_x(starts_);
  sort_by_x(ends_);
}

void SweepQueue::sort_by_x(Verticals& verticals) const {
  std::sort(verticals.order.begin(), verticals.order.end(), [this](SegmentId s, SegmentId t) {
    const Sign by_x = compare_x(curves_.points(), curves_[s].a, curves_[t].a);
    return by_x == Sign::Negative || (by_x == Sign::Zero && s < t);
  });
}

bool SweepQueue::advance() {
  place_.kind = SweepPlace::Point;
  place_.rank = PointRanks::kUnused;
  place_.points.clear();
  place_.crossings.clear();
  place_.verticals.clear();
  if ((starts_.left() || ends_.left()) && advance_to_vertical()) return true;
  const bool points_left = cursor_ < curves_.ranks().order.size();
  if (!points_left && heap_.empty()) return false;
  Sign first = Sign::Positive;  // of the next crossing against the next point
  if (!heap_.empty()) {
    first = points_left
                ? compare_xy(curves_.points(), heap_.front().point, curves_.ranks().order[cursor_])
                : Sign::Negative;
  }
  if (first != Sign::Negative) gather_equal_points();
  if (first != Sign::Positive) gather_equal_crossings();
  return true;
}

// A start comes before the points of its x, an end after them; at equal x the start is first.
bool SweepQueue::advance_to_vertical() {
  if (is_next(starts_, SweepPlace::VerticalStart)) {
    const bool end_is_earlier =
        ends_.left() && compare_x(curves_.points(), curves_[ends_.next()].a,
                                  curves_[starts_.next()].a) == Sign::Negative;
    if (!end_is_earlier) {
      take_verticals(starts_, SweepPlace::VerticalStart);
      return true;
    }
  }
  if (!is_next(ends_, SweepPlace::VerticalEnd)) return false;
  take_verticals(ends_, SweepPlace::VerticalEnd);
  return true;
}

bool SweepQueue::is_next(const Verticals& verticals, SweepPlace kind) const {
  if (!verticals.left()) return false;
  const std::uint32_t x = curves_[verticals.next()].a;
  const auto precedes = [kind](Sign of_other) {
    return of_other == Sign::Positive ||
           (of_other == Sign::Zero && kind == SweepPlace::VerticalStart);
  };
  const auto& order = curves_.ranks().order;
  if (cursor_ < order.size() && !precedes(compare_x(curves_.points(), order[cursor_], x))) {
    return false;
  }
  return heap_.empty() || precedes(compare_x(curves_.points(), heap_.front().point, x));
}

void SweepQueue::take_verticals(Verticals& verticals, SweepPlace kind) {
  place_.kind = kind;
  const std::uint32_t x = curves_[verticals.next()].a;
  while (verticals.left() &&
         compare_x(curves_.points(), curves_[verticals.next()].a, x) == Sign::Zero) {
    place_.verticals.push_back(verticals.order[verticals.cursor++]);
  }
}

void SweepQueue::gather_equal_points() {
  const PointRanks& ranks = curves_.ranks();
  place_.rank = curves_.rank(ranks.order[cursor_]);
  while (cursor_ < ranks.order.size() && curves_.rank(ranks.order[cursor_]) == place_.rank) {
    place_.points.push_back(ranks.order[cursor_++]);
  }
}

void SweepQueue::gather_equal_crossings() {
  pop_crossing();
  while (!heap_.empty() && compare_xy(curves_.points().inputs(), heap_.front().point,
                                      place_.crossings.front().point) == Sign::Zero) {
    pop_crossing();
  }
}

void SweepQueue::pop_crossing() {
  std::pop_heap(heap_.begin(), heap_.end(), Later{curves_.points().inputs()});
  place_.crossings.push_back(heap_.back());
  heap_.pop_back();
}

void SweepQueue::add_crossing(SegmentId lower, SegmentId upper) {
  heap_.push_back({curves_.crossing(lower, upper), lower, upper});
  std::push_heap(heap_.begin(), heap_.end(), Later{curves_.points().inputs()});
}

}  // namespace plumb
