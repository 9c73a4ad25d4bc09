#include "plumb/plane/sweep.h"

#include <algorithm>
#include <vector>

#include "plumb/plane/sweep_curves.h"
#include "plumb/plane/sweep_queue.h"
#include "plumb/plane/sweep_status.h"

namespace plumb {
namespace {

constexpr std::size_t kEventsPerCheckpoint = 4096;

class Sweep {
 public:
  Sweep(const PlanePointsView& points, std::span<const SweepCurve> curves,
        std::span<const std::uint32_t> stops, SweepVisitor& visitor, Context& context)
      : points_(points),
        curves_(points, curves, stops),
        queue_(curves_),
        visitor_(visitor),
        context_(context) {
    collect_starts();
  }

  void run();

 private:
  void collect_starts();
  bool start_unbounded();
  bool end_unbounded();
  bool handle_event();

  bool plain_event(std::uint32_t v);
  bool take_enders(std::uint32_t v);
  bool order_plain_starters(std::uint32_t v);
  bool place_without_enders();

  bool general_event();
  void find_seed();
  void take_all_through();
  void collect_incoming();
  void collect_outgoing();
  void order_starters();
  void merge_starters();
  void append_outgoing(SegmentId s, bool joins_previous);

  bool vertical_start();
  bool vertical_end();

  void replace_in_status();
  void bind_bundle(std::size_t first, std::size_t last, StatusNode node);
  void test_neighbours(StatusNode below, StatusNode above);
  bool report(SweepPlace kind, bool plain);

  bool contains_event(SegmentId s) const;
  Sign side_of_event(SegmentId s) const;
  const SweepQueue::Place& place() const { return queue_.place(); }

  std::span<const SegmentId> starts(std::uint32_t v) const {
    return {starts_.data() + start_begin_[v], starts_.data() + start_begin_[v + 1]};
  }

  PlanePointsView points_;
  SweepCurves curves_;
  SweepQueue queue_;
  SweepVisitor& visitor_;
  Context& context_;

  std::vector<std::uint32_t> start_begin_;  // per point, into starts_
  std::vector<SegmentId> starts_;           // by left end, zero-length ones included
  std::vector<SegmentId> left_unbounded_;   // not vertical
  std::vector<std::uint32_t> ender_count_;  // per point
  std::vector<SegmentId> ender_;            // per point: one curve ending there
  std::vector<char> is_marked_;             // per point: something else touches it
  std::vector<StatusNode> node_;            // per curve, while active
  std::vector<SegmentId> chain_;            // per curve: the next one of its bundle

  SweepStatus status_;

  // The event at hand.
  std::vector<StatusNode> through_;  // bundles through it, bottom to top
  StatusNode below_;                 // the node next below, if any
  std::vector<SweepIncidence> incoming_;
  std::vector<SweepIncidence> outgoing_;
  std::vector<SegmentId> starters_;
  std::vector<SweepIncidence> continuing_;  // above to below, as they leave
  std::vector<SegmentId> zero_length_;
};

// ---------------------------------------------------------------- set-up

void Sweep::collect_starts() {
  start_begin_.assign(points_.size() + 1, 0);
  ender_count_.assign(points_.size(), 0);
  ender_.assign(points_.size(), SegmentId());
  is_marked_.assign(points_.size(), 0);
  node_.assign(curves_.size(), StatusNode());
  chain_.assign(curves_.size(), SegmentId());
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const SegmentId s(i);
    const auto& c = curves_[s];
    if (c.has_left()) {
      ++start_begin_[c.left + 1];
    } else if (!curves_.is_vertical(s)) {
      left_unbounded_.push_back(s);
    }
    if (curves_.is_zero_length(s)) {
      is_marked_[c.left] = is_marked_[c.right] = 1;
    } else if (c.has_right()) {
      ++ender_count_[c.right];
      ender_[c.right] = s;
    }
  }
  for (std::size_t v = 0; v < points_.size(); ++v) start_begin_[v + 1] += start_begin_[v];
  starts_.resize(start_begin_.back());
  std::vector<std::uint32_t> fill(start_begin_.begin(), start_begin_.end() - 1);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const auto& c = curves_[SegmentId(i)];
    if (c.has_left()) starts_[fill[c.left]++] = SegmentId(i);
  }
}

// ---------------------------------------------------------------- events in order

void Sweep::run() {
  visitor_.on_start(curves_);
  if (!start_unbounded()) return;
  for (std::size_t events = 0; queue_.advance(); ++events) {
    if (events % kEventsPerCheckpoint == 0) {
      context_.checkpoint("sweep", queue_.done(), queue_.total());
    }
    if (!handle_event()) return;
  }
  end_unbounded();
}

bool Sweep::handle_event() {
  if (place().kind == SweepPlace::VerticalStart) return vertical_start();
  if (place().kind == SweepPlace::VerticalEnd) return vertical_end();
  const bool may_be_plain = place().points.size() == 1 && place().crossings.empty() &&
                            is_marked_[place().points.front()] == 0;
  return may_be_plain ? plain_event(place().points.front()) : general_event();
}

// ---------------------------------------------------------------- ends at infinity

bool Sweep::start_unbounded() {
  if (left_unbounded_.empty()) return true;
  std::sort(left_unbounded_.begin(), left_unbounded_.end(), [this](SegmentId s, SegmentId t) {
    if (s == t) return false;
    const Sign order = curves_.order_at_left_infinity(s, t);
    return order == Sign::Positive || (order == Sign::Zero && s < t);
  });
  outgoing_.clear();
  for (const SegmentId s : left_unbounded_) {
    const bool joins = !outgoing_.empty() &&
                       curves_.order_at_left_infinity(outgoing_.back().segment, s) == Sign::Zero;
    append_outgoing(s, joins);
  }
  replace_in_status();
  // Unlike curves that leave a point, these may still meet each other.
  for (StatusNode n = status_.first(); n.is_valid(); n = status_.next(n)) {
    test_neighbours(n, status_.next(n));
  }
  return report(SweepPlace::LeftInfinity, false);
}

bool Sweep::end_unbounded() {
  through_.clear();
  below_ = StatusNode();
  for (StatusNode n = status_.first(); n.is_valid(); n = status_.next(n)) through_.push_back(n);
  if (through_.empty()) return true;
  collect_incoming();
  outgoing_.clear();
  return report(SweepPlace::RightInfinity, false);
}

bool Sweep::vertical_start() {
  through_.clear();
  incoming_.clear();
  outgoing_.clear();
  below_ = StatusNode();
  for (const SegmentId s : place().verticals) append_outgoing(s, true);
  replace_in_status();
  return report(SweepPlace::VerticalStart, false);
}

bool Sweep::vertical_end() {
  through_.assign(1, node_[place().verticals.front().value()]);
  below_ = status_.prev(through_.front());
  collect_incoming();
  outgoing_.clear();
  replace_in_status();
  return report(SweepPlace::VerticalEnd, false);
}

// ---------------------------------------------------------------- plain events

// Falls back to the general event as soon as an overlap or a contact shows up.
bool Sweep::plain_event(std::uint32_t v) {
  through_.clear();
  const bool is_placed = ender_count_[v] > 0 ? take_enders(v) : place_without_enders();
  if (!is_placed || !order_plain_starters(v)) return general_event();
  replace_in_status();
  return report(SweepPlace::Point, true);
}

bool Sweep::take_enders(std::uint32_t v) {
  StatusNode n = node_[ender_[v].value()];
  const auto ends_here = [&](StatusNode node) {
    return node.is_valid() && curves_[status_.segment(node)].right == v;
  };
  while (ends_here(status_.prev(n))) n = status_.prev(n);
  below_ = status_.prev(n);
  incoming_.clear();
  for (; ends_here(n); n = status_.next(n)) {
    const SegmentId s = status_.segment(n);
    if (chain_[s.value()].is_valid()) return false;
    incoming_.push_back({s, static_cast<std::uint32_t>(incoming_.size())});
    through_.push_back(n);
  }
  return through_.size() == ender_count_[v];
}

bool Sweep::place_without_enders() {
  incoming_.clear();
  const auto location = status_.locate([&](SegmentId s) { return side_of_event(s); });
  below_ = location.below;
  return !location.on.is_valid();
}

bool Sweep::order_plain_starters(std::uint32_t v) {
  const auto starting = starts(v);
  starters_.assign(starting.begin(), starting.end());
  bool all_different = true;
  std::sort(starters_.begin(), starters_.end(), [&](SegmentId s, SegmentId t) {
    if (s == t) return false;
    const Sign turn = curves_.direction_order(s, t);
    if (turn == Sign::Zero) all_different = false;
    return turn == Sign::Positive;
  });
  if (!all_different) return false;
  outgoing_.clear();
  for (const SegmentId s : starters_) {
    outgoing_.push_back({s, static_cast<std::uint32_t>(outgoing_.size())});
  }
  return true;
}

// ---------------------------------------------------------------- all other events

bool Sweep::general_event() {
  take_all_through();
  collect_incoming();
  order_starters();
  collect_outgoing();
  replace_in_status();
  return report(SweepPlace::Point, false);
}

bool Sweep::contains_event(SegmentId s) const {
  if (place().is_point() && curves_.ends_at(s, place().rank)) return true;
  return side_of_event(s) == Sign::Zero;
}

Sign Sweep::side_of_event(SegmentId s) const {
  if (place().is_point()) return curves_.side(s, place().points.front());
  const SweepQueue::PendingCrossing& crossing = place().crossings.front();
  if (s == crossing.lower || s == crossing.upper) return Sign::Zero;
  return curves_.side(s, crossing.point);
}

// Any node through the event, or none and below_ set.
void Sweep::find_seed() {
  through_.clear();
  for (const std::uint32_t v : place().points) {
    if (ender_count_[v] > 0) through_.assign(1, node_[ender_[v].value()]);
  }
  if (!place().crossings.empty()) {
    through_.assign(1, node_[place().crossings.front().lower.value()]);
  }
  if (!through_.empty()) return;
  const auto location = status_.locate([&](SegmentId s) { return side_of_event(s); });
  if (location.on.is_valid()) through_.assign(1, location.on);
  below_ = location.below;
}

void Sweep::take_all_through() {
  find_seed();
  if (through_.empty()) return;
  StatusNode low = through_.front();
  const auto passes = [&](StatusNode n) {
    return n.is_valid() && contains_event(status_.segment(n));
  };
  while (passes(status_.prev(low))) low = status_.prev(low);
  below_ = status_.prev(low);
  through_.clear();
  do {
    through_.push_back(low);
    low = status_.next(low);
  } while (passes(low));
}

void Sweep::collect_incoming() {
  incoming_.clear();
  for (std::size_t bundle = 0; bundle < through_.size(); ++bundle) {
    for (SegmentId s = status_.segment(through_[bundle]); s.is_valid(); s = chain_[s.value()]) {
      incoming_.push_back({s, static_cast<std::uint32_t>(bundle)});
    }
  }
}

void Sweep::order_starters() {
  starters_.clear();
  zero_length_.clear();
  for (const std::uint32_t v : place().points) {
    for (const SegmentId s : starts(v)) {
      (curves_.is_zero_length(s) ? zero_length_ : starters_).push_back(s);
    }
  }
  std::sort(starters_.begin(), starters_.end(), [&](SegmentId s, SegmentId t) {
    const Sign turn = curves_.direction_order(s, t);
    return turn == Sign::Positive || (turn == Sign::Zero && s < t);
  });
}

void Sweep::append_outgoing(SegmentId s, bool joins_previous) {
  const std::uint32_t previous = outgoing_.empty() ? 0 : outgoing_.back().bundle;
  const bool opens = !joins_previous && !outgoing_.empty();
  outgoing_.push_back({s, opens ? previous + 1 : previous});
}

// What continues leaves in the reverse order of its arrival: no arithmetic. Starters are merged in.
void Sweep::collect_outgoing() {
  continuing_.clear();
  for (auto i = incoming_.rbegin(); i != incoming_.rend(); ++i) {
    const bool ends_here = place().is_point() && curves_.ends_at(i->segment, place().rank);
    if (!ends_here) continuing_.push_back(*i);
  }
  merge_starters();
}

void Sweep::merge_starters() {
  outgoing_.clear();
  std::size_t c = 0;
  std::size_t s = 0;
  const auto starts_next = [&] {
    if (c == continuing_.size() || s == starters_.size()) return c == continuing_.size();
    return curves_.direction_order(starters_[s], continuing_[c].segment) == Sign::Positive;
  };
  while (c < continuing_.size() || s < starters_.size()) {
    const SegmentId next = starts_next() ? starters_[s++] : continuing_[c++].segment;
    const bool joins =
        !outgoing_.empty() && curves_.direction_order(outgoing_.back().segment, next) == Sign::Zero;
    append_outgoing(next, joins);
  }
}

// ---------------------------------------------------------------- status

void Sweep::replace_in_status() {
  const std::size_t bundles = outgoing_.empty() ? 0 : outgoing_.back().bundle + 1;
  for (std::size_t i = bundles; i < through_.size(); ++i) status_.erase(through_[i]);
  StatusNode last = below_;
  for (std::size_t i = 0, bundle = 0; i < outgoing_.size(); ++bundle) {
    std::size_t end = i;
    while (end < outgoing_.size() && outgoing_[end].bundle == bundle) ++end;
    const StatusNode node = bundle < through_.size()
                                ? through_[bundle]
                                : status_.insert_above(last, outgoing_[i].segment);
    bind_bundle(i, end, node);
    if (bundle == 0) test_neighbours(below_, node);
    last = node;
    i = end;
  }
  const StatusNode above = last.is_valid() ? status_.next(last) : status_.first();
  test_neighbours(last, above);
}

void Sweep::bind_bundle(std::size_t first, std::size_t last, StatusNode node) {
  status_.set_segment(node, outgoing_[first].segment);
  for (std::size_t i = first; i < last; ++i) {
    const SegmentId s = outgoing_[i].segment;
    node_[s.value()] = node;
    chain_[s.value()] = i + 1 < last ? outgoing_[i + 1].segment : SegmentId();
  }
}

void Sweep::test_neighbours(StatusNode below, StatusNode above) {
  if (!below.is_valid() || !above.is_valid()) return;
  const SegmentId lower = status_.segment(below);
  const SegmentId upper = status_.segment(above);
  const auto meeting = curves_.next_meeting(lower, upper);
  if (meeting.kind == SweepCurves::Meeting::AtEnd) is_marked_[meeting.end] = 1;
  if (meeting.kind == SweepCurves::Meeting::Crossing) queue_.add_crossing(lower, upper);
}

bool Sweep::report(SweepPlace kind, bool plain) {
  SweepEvent event;
  event.place = kind;
  event.points = place().points;
  const bool is_crossing = kind == SweepPlace::Point && place().points.empty();
  event.crossing = is_crossing ? &place().crossings.front().point : nullptr;
  event.incoming = incoming_;
  event.outgoing = outgoing_;
  if (kind == SweepPlace::Point && !plain) event.zero_length = zero_length_;
  if (below_.is_valid()) event.below = status_.segment(below_);
  event.plain = plain;
  return visitor_.on_event(event);
}

}  // namespace

void sweep(const PlanePointsView& points, std::span<const SweepCurve> curves,
           std::span<const std::uint32_t> stops, SweepVisitor& visitor, Context& context) {
  Sweep(points, curves, stops, visitor, context).run();
}

void sweep(const PointTable2& points, std::span<const SweepSegment> segments, SweepVisitor& visitor,
           Context& context) {
  std::vector<SweepCurve> curves;
  curves.reserve(segments.size());
  for (const SweepSegment& s : segments) curves.push_back({s.from, s.to, s.from, s.to});
  sweep(points, curves, {}, visitor, context);
}

}  // namespace plumb
