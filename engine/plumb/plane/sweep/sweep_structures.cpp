// The queue and the status of a sweep.
//
// The queue merges three sorted sequences: end points by rank, a heap of crossings, and the
// vertical ends at infinity. The start of a vertical at the bottom comes before all points of its
// x, its end at the top after them; this is the order of the ends around the plane
// (docs/design/frame.md, Lemma 1).
//
// The status is a treap: a binary tree in the order of positions and a heap in the order of random
// priorities, which keeps it balanced in expectation. Nodes are also linked in a list, so
// neighbours cost O(1), and an insertion next to a known node needs no search, only expected O(1)
// rotations.
//
// Tested by tests/plane/sweep_test.cpp and tests/plane/sweep_unbounded_test.cpp.

#include "plumb/plane/sweep/sweep_structures.h"

#include <algorithm>
#include <utility>

namespace plumb {
namespace {

// The order of the heap: std::push_heap() keeps the greatest first, so "less" means "later".
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
  Sign first = Sign::Positive;  // The order of the next crossing and the next point.
  if (!heap_.empty()) {
    first = points_left
                ? compare_xy(curves_.points(), heap_.front().point, curves_.ranks().order[cursor_])
                : Sign::Negative;
  }
  if (first != Sign::Negative) gather_equal_points();
  if (first != Sign::Positive) gather_equal_crossings();
  return true;
}

// Processes the next vertical ends if they precede all other events. A start precedes the points of
// its x, and an end follows them. At equal x, the start is first.
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

// Whether the next vertical ends of one kind precede the next point and the next crossing.
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

namespace {

// One step of splitmix64 (G. L. Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number
// generators, OOPSLA 2014). The fixed start makes runs repeatable.
std::uint32_t next_random(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15ULL);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<std::uint32_t>(z >> 32U);
}

}  // namespace

StatusNode SweepStatus::allocate(SegmentId s) {
  StatusNode n(nodes_.size());
  if (free_.empty()) {
    nodes_.emplace_back();
  } else {
    n = free_.back();
    free_.pop_back();
    at(n) = Node();
  }
  at(n).segment = s;
  at(n).priority = next_random(random_state_);
  return n;
}

StatusNode SweepStatus::insert_above(StatusNode below, SegmentId s) {
  const StatusNode n = allocate(s);
  attach(n, below);
  thread(n, below);
  sift_up(n);
  return n;
}

// Links the node into the free child slot between `below` and its successor. One of the two has
// this slot: of two neighbours in the order, one is below the other in the tree, and has no child
// on that side.
void SweepStatus::attach(StatusNode n, StatusNode below) {
  if (below.is_valid() && !at(below).right.is_valid()) {
    at(below).right = n;
    at(n).parent = below;
    return;
  }
  const StatusNode above = below.is_valid() ? at(below).next : first_;
  if (!above.is_valid()) {
    root_ = n;
    return;
  }
  at(above).left = n;
  at(n).parent = above;
}

// Links the node into the list.
void SweepStatus::thread(StatusNode n, StatusNode below) {
  const StatusNode above = below.is_valid() ? at(below).next : first_;
  at(n).prev = below;
  at(n).next = above;
  if (above.is_valid()) at(above).prev = n;
  if (below.is_valid()) {
    at(below).next = n;
  } else {
    first_ = n;
  }
}

void SweepStatus::sift_up(StatusNode n) {
  while (at(n).parent.is_valid() && at(at(n).parent).priority < at(n).priority) rotate_up(n);
}

// Exchanges a node and its parent. The order of positions does not change.
void SweepStatus::rotate_up(StatusNode n) {
  const StatusNode p = at(n).parent;
  const StatusNode grandparent = at(p).parent;
  const bool is_left = at(p).left == n;
  const StatusNode inner = is_left ? at(n).right : at(n).left;
  (is_left ? at(p).left : at(p).right) = inner;
  if (inner.is_valid()) at(inner).parent = p;
  (is_left ? at(n).right : at(n).left) = p;
  at(p).parent = n;
  at(n).parent = grandparent;
  replace_child(grandparent, p, n);
}

void SweepStatus::replace_child(StatusNode parent, StatusNode old_child, StatusNode new_child) {
  if (!parent.is_valid()) {
    root_ = new_child;
  } else if (at(parent).left == old_child) {
    at(parent).left = new_child;
  } else {
    at(parent).right = new_child;
  }
}

// Rotates the node down until it has at most one child. This child then takes its place.
void SweepStatus::erase(StatusNode n) {
  while (at(n).left.is_valid() && at(n).right.is_valid()) {
    const StatusNode l = at(n).left;
    const StatusNode r = at(n).right;
    rotate_up(at(l).priority > at(r).priority ? l : r);
  }
  const StatusNode child = at(n).left.is_valid() ? at(n).left : at(n).right;
  if (child.is_valid()) at(child).parent = at(n).parent;
  replace_child(at(n).parent, n, child);
  const StatusNode below = at(n).prev;
  const StatusNode above = at(n).next;
  if (above.is_valid()) at(above).prev = below;
  (below.is_valid() ? at(below).next : first_) = above;
  free_.push_back(n);
}

}  // namespace plumb
