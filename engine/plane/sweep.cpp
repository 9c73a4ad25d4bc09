#include "plumb/plane/sweep.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/plane/point_ranks.h"
#include "plumb/plane/sweep_status.h"

namespace plumb {
namespace {

constexpr std::size_t kEventsPerCheckpoint = 4096;

struct PendingCrossing {
  Crossing2 point;
  SegmentId lower;
  SegmentId upper;
};

// The place of an event: an end point (any of the equal ones), or an implicit crossing.
struct EventPlace {
  std::uint32_t point = 0;
  std::uint32_t rank = PointRanks::kUnused;  // kUnused: a mere crossing
  const PendingCrossing* crossing = nullptr;
};

class Sweep {
 public:
  Sweep(const PointTable2& points, std::span<const SweepSegment> segments, SweepVisitor& visitor,
        Context& context)
      : points_(points), visitor_(visitor), context_(context) {
    orient_segments(segments);
    collect_starts();
  }

  void run();

 private:
  struct Ends {
    std::uint32_t left;
    std::uint32_t right;
  };

  void orient_segments(std::span<const SweepSegment> segments);
  void collect_starts();

  bool next_event();
  void gather_equal_points();
  void gather_equal_crossings();
  void pop_crossing();

  bool plain_event(std::uint32_t v);
  bool take_enders(std::uint32_t v);
  bool order_plain_starters(std::uint32_t v);
  bool place_without_enders(std::uint32_t v);

  bool general_event();
  void find_seed();
  void take_all_through();
  void collect_incoming();
  void collect_outgoing();
  void order_starters();
  void merge_starters();
  void append_outgoing(SegmentId s, bool joins_previous);

  void replace_in_status();
  void bind_bundle(std::size_t first, std::size_t last, StatusNode node);
  void test_neighbours(StatusNode below, StatusNode above);
  bool report(bool plain);

  bool is_zero_length(SegmentId s) const { return rank(ends(s).left) == rank(ends(s).right); }
  bool contains_event(SegmentId s) const;
  Sign side_of_event(SegmentId s) const;
  Sign direction_order(SegmentId s, SegmentId t) const;

  const Ends& ends(SegmentId s) const { return ends_[s.value()]; }
  std::uint32_t rank(std::uint32_t point) const { return ranks_.rank[point]; }
  std::span<const SegmentId> starts(std::uint32_t v) const {
    return {starts_.data() + start_begin_[v], starts_.data() + start_begin_[v + 1]};
  }

  const PointTable2& points_;
  SweepVisitor& visitor_;
  Context& context_;

  PointRanks ranks_;
  std::vector<Ends> ends_;                  // per segment
  std::vector<std::uint32_t> start_begin_;  // per point, into starts_
  std::vector<SegmentId> starts_;           // by left end, zero-length ones included
  std::vector<std::uint32_t> ender_count_;  // per point
  std::vector<SegmentId> ender_;            // per point: one segment ending there
  std::vector<char> is_marked_;             // per point: something else touches it
  std::vector<StatusNode> node_;            // per segment, while active
  std::vector<SegmentId> chain_;            // per segment: the next one of its bundle

  SweepStatus status_;
  std::vector<PendingCrossing> queue_;  // a heap, least crossing first
  std::size_t cursor_ = 0;              // into ranks_.order

  // The event at hand.
  EventPlace place_;
  std::vector<std::uint32_t> here_;         // end points
  std::vector<PendingCrossing> crossings_;  // pending crossings equal to it
  std::vector<StatusNode> through_;         // bundles through it, bottom to top
  StatusNode below_;                        // the node next below, if any
  std::vector<SweepIncidence> incoming_;
  std::vector<SweepIncidence> outgoing_;
  std::vector<SegmentId> starters_;
  std::vector<SweepIncidence> continuing_;  // above to below, as they leave
  std::vector<SegmentId> zero_length_;
};

// ---------------------------------------------------------------- set-up

void Sweep::orient_segments(std::span<const SweepSegment> segments) {
  std::vector<char> used(points_.size(), 0);
  for (const SweepSegment& s : segments) used[s.from] = used[s.to] = 1;
  ranks_ = rank_points(points_, used);
  ends_.reserve(segments.size());
  for (const SweepSegment& s : segments) {
    const bool forward = rank(s.from) <= rank(s.to);
    ends_.push_back(forward ? Ends{s.from, s.to} : Ends{s.to, s.from});
  }
}

void Sweep::collect_starts() {
  start_begin_.assign(points_.size() + 1, 0);
  ender_count_.assign(points_.size(), 0);
  ender_.assign(points_.size(), SegmentId());
  is_marked_.assign(points_.size(), 0);
  node_.assign(ends_.size(), StatusNode());
  chain_.assign(ends_.size(), SegmentId());
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const SegmentId s(i);
    ++start_begin_[ends(s).left + 1];
    if (is_zero_length(s)) {
      is_marked_[ends(s).left] = is_marked_[ends(s).right] = 1;
      continue;
    }
    ++ender_count_[ends(s).right];
    ender_[ends(s).right] = s;
  }
  for (std::size_t v = 0; v < points_.size(); ++v) start_begin_[v + 1] += start_begin_[v];
  starts_.resize(ends_.size());
  std::vector<std::uint32_t> fill(start_begin_.begin(), start_begin_.end() - 1);
  for (std::size_t i = 0; i < ends_.size(); ++i) starts_[fill[ends_[i].left]++] = SegmentId(i);
}

// ---------------------------------------------------------------- events in order

// Heap order: std::push_heap keeps the greatest first, so "less" means "later".
struct Later {
  const PointTable2& points;
  bool operator()(const PendingCrossing& p, const PendingCrossing& q) const {
    return compare_xy(points, p.point, q.point) == Sign::Positive;
  }
};

void Sweep::run() {
  for (std::size_t events = 0; next_event(); ++events) {
    if (events % kEventsPerCheckpoint == 0) {
      context_.checkpoint("sweep", cursor_, ranks_.order.size());
    }
    const bool may_be_plain =
        here_.size() == 1 && crossings_.empty() && is_marked_[here_.front()] == 0;
    if (!(may_be_plain ? plain_event(here_.front()) : general_event())) return;
  }
}

bool Sweep::next_event() {
  here_.clear();
  crossings_.clear();
  place_ = EventPlace();
  const bool points_left = cursor_ < ranks_.order.size();
  if (!points_left && queue_.empty()) return false;
  Sign first = Sign::Positive;  // of the next crossing against the next point
  if (!queue_.empty()) {
    first = points_left ? compare_xy(points_, queue_.front().point, ranks_.order[cursor_])
                        : Sign::Negative;
  }
  if (first != Sign::Negative) gather_equal_points();
  if (first != Sign::Positive) gather_equal_crossings();
  return true;
}

void Sweep::gather_equal_points() {
  place_.point = ranks_.order[cursor_];
  place_.rank = rank(place_.point);
  while (cursor_ < ranks_.order.size() && rank(ranks_.order[cursor_]) == place_.rank) {
    here_.push_back(ranks_.order[cursor_++]);
  }
}

void Sweep::gather_equal_crossings() {
  pop_crossing();
  while (!queue_.empty() &&
         compare_xy(points_, queue_.front().point, crossings_.front().point) == Sign::Zero) {
    pop_crossing();
  }
  place_.crossing = &crossings_.front();
}

void Sweep::pop_crossing() {
  std::pop_heap(queue_.begin(), queue_.end(), Later{points_});
  crossings_.push_back(queue_.back());
  queue_.pop_back();
}

// ---------------------------------------------------------------- plain events

// Falls back to the general event as soon as an overlap or a contact shows up.
bool Sweep::plain_event(std::uint32_t v) {
  through_.clear();
  const bool is_placed = ender_count_[v] > 0 ? take_enders(v) : place_without_enders(v);
  if (!is_placed || !order_plain_starters(v)) return general_event();
  replace_in_status();
  return report(true);
}

bool Sweep::take_enders(std::uint32_t v) {
  StatusNode n = node_[ender_[v].value()];
  const auto ends_here = [&](StatusNode node) {
    return node.is_valid() && ends(status_.segment(node)).right == v;
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

bool Sweep::place_without_enders(std::uint32_t) {
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
    const Sign turn = orient2d(points_, v, ends(s).right, ends(t).right);
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
  return report(false);
}

bool Sweep::contains_event(SegmentId s) const {
  if (place_.rank != PointRanks::kUnused && rank(ends(s).right) == place_.rank) return true;
  return side_of_event(s) == Sign::Zero;
}

Sign Sweep::side_of_event(SegmentId s) const {
  if (place_.rank != PointRanks::kUnused) {
    return orient2d(points_, ends(s).left, ends(s).right, place_.point);
  }
  if (s == place_.crossing->lower || s == place_.crossing->upper) return Sign::Zero;
  return orient2d(points_, ends(s).left, ends(s).right, place_.crossing->point);
}

// Any node through the event, or none and below_ set.
void Sweep::find_seed() {
  through_.clear();
  for (const std::uint32_t v : here_) {
    if (ender_count_[v] > 0) through_.assign(1, node_[ender_[v].value()]);
  }
  if (!crossings_.empty()) through_.assign(1, node_[crossings_.front().lower.value()]);
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

Sign Sweep::direction_order(SegmentId s, SegmentId t) const {
  if (s == t) return Sign::Zero;
  return cross_sign(points_, ends(s).left, ends(s).right, ends(t).left, ends(t).right);
}

void Sweep::order_starters() {
  starters_.clear();
  zero_length_.clear();
  for (const std::uint32_t v : here_) {
    for (const SegmentId s : starts(v)) (is_zero_length(s) ? zero_length_ : starters_).push_back(s);
  }
  std::sort(starters_.begin(), starters_.end(), [&](SegmentId s, SegmentId t) {
    const Sign turn = direction_order(s, t);
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
    const std::uint32_t end = ends(i->segment).right;
    const bool ends_here = place_.rank != PointRanks::kUnused && rank(end) == place_.rank;
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
    return direction_order(starters_[s], continuing_[c].segment) == Sign::Positive;
  };
  while (c < continuing_.size() || s < starters_.size()) {
    const SegmentId next = starts_next() ? starters_[s++] : continuing_[c++].segment;
    const bool joins =
        !outgoing_.empty() && direction_order(outgoing_.back().segment, next) == Sign::Zero;
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

// `lower` lies below `upper` just right of the event. They meet further right if and only if the
// one that ends first does not end strictly on its own side of the other.
void Sweep::test_neighbours(StatusNode below, StatusNode above) {
  if (!below.is_valid() || !above.is_valid()) return;
  const SegmentId lower = status_.segment(below);
  const SegmentId upper = status_.segment(above);
  const Ends& l = ends(lower);
  const Ends& u = ends(upper);
  if (rank(l.right) == rank(u.right)) return;  // they end together: the event sees both
  const bool lower_ends_first = rank(l.right) < rank(u.right);
  const std::uint32_t end = lower_ends_first ? l.right : u.right;
  const Sign side = lower_ends_first ? -orient2d(points_, u.left, u.right, end)
                                     : orient2d(points_, l.left, l.right, end);
  if (side == Sign::Positive) return;
  if (side == Sign::Zero) {
    is_marked_[end] = 1;
    return;
  }
  queue_.push_back({make_crossing(points_, l.left, l.right, u.left, u.right), lower, upper});
  std::push_heap(queue_.begin(), queue_.end(), Later{points_});
}

bool Sweep::report(bool plain) {
  SweepEvent event;
  event.points = here_;
  event.crossing = here_.empty() ? &place_.crossing->point : nullptr;
  event.incoming = incoming_;
  event.outgoing = outgoing_;
  if (!plain) event.zero_length = zero_length_;
  if (below_.is_valid()) event.below = status_.segment(below_);
  event.plain = plain;
  return visitor_.on_event(event);
}

}  // namespace

void sweep(const PointTable2& points, std::span<const SweepSegment> segments, SweepVisitor& visitor,
           Context& context) {
  Sweep(points, segments, visitor, context).run();
}

}  // namespace plumb
