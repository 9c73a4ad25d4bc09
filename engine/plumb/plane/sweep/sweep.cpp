// The plane sweep over segments, rays and lines, for all degeneracies.
//
// Events come in lexicographic order: sorted end points, crossings found on the way, ends of
// vertical curves at infinity. Invariant S: after each event, the status is the list of bundles
// just right of it, from bottom to top; and any two neighbours have been tested: if they meet
// further right, their crossing is in the queue, or the end point where they touch is marked.
// docs/design/sweep.md proves from it that every event is reported (Lemma 1).
//
// A plain event has one point, no overlap and no mark. Nothing passes through it, so only the
// curves that start there are sorted, and the status is searched only if none ends there. Every
// other event is handled in general: all bundles through it are taken from the status, the bundles
// that go on are put back in reverse order, and starting curves are merged in by direction. A
// bundle is represented by its curve that ends last, so that the end of this curve is an event of
// its own.
//
// Tested by tests/plane/sweep_test.cpp and tests/plane/sweep_unbounded_test.cpp.

#include "plumb/plane/sweep/sweep.h"

#include <algorithm>
#include <vector>

#include "plumb/plane/sweep/sweep_curves.h"
#include "plumb/plane/sweep/sweep_structures.h"

namespace plumb {
namespace {

constexpr std::size_t kEventsPerCheckpoint = 4096;
constexpr std::uint64_t kStepsPerCheckpoint = std::uint64_t{1} << 16;

/// One sweep with its queue and status.
class Sweep {
 public:
  Sweep(const PlanePointsView& points, std::span<const SweepCurve> curves,
        std::span<const std::uint32_t> stops, SweepVisitor& visitor, Context& context)
      : points_(points),
        curves_(points, curves, stops, &context),
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
  void order_starters();
  void group_ends();
  void merge_starters();
  void leave(SegmentId bundle, std::uint32_t came_from);
  void start_bundle(std::size_t starter);
  void join_bundle(std::size_t starter);

  void clear_event();
  bool vertical_start();
  bool vertical_end();

  void replace_in_status();
  void bind_bundle(SegmentId bundle, StatusNode node);
  void test_neighbours(StatusNode below, StatusNode above);
  bool report(SweepPlace kind, bool plain);

  /// Counts steps within an event, because millions of curves may meet at one event.
  void count_step() {
    if (++steps_ % kStepsPerCheckpoint == 0) context_.check_limits("sweep");
  }

  StatusNode node(SegmentId s) const { return active_[active_[s].key].node; }
  bool contains_event(SegmentId s) const;
  Sign side_of_event(SegmentId s) const;
  const SweepQueue::Place& place() const { return queue_.place(); }

  std::span<const SegmentId> starts(std::uint32_t v) const {
    return {starts_.data() + start_begin_[v], starts_.data() + start_begin_[v + 1]};
  }
  std::span<const SegmentId> enders(std::uint32_t v) const {
    return {enders_.data() + ender_begin_[v], enders_.data() + ender_begin_[v + 1]};
  }

  /// The data about a curve between its start and its end. The key of a bundle is the curve that
  /// opened it, even after that curve has ended. `node` and `arrival` are set only for keys.
  struct Active {
    SegmentId key;    // The key of the curve's bundle.
    StatusNode node;  // The node of the bundle.
    // The place of the bundle among the incoming bundles of the current event.
    std::uint32_t arrival = 0;
  };

  PlanePointsView points_;
  SweepCurves curves_;
  SweepQueue queue_;
  SweepVisitor& visitor_;
  Context& context_;
  std::uint64_t steps_ = 0;

  // For each point, the index in starts_ at which its curves begin.
  std::vector<std::uint32_t> start_begin_;
  // The curves by left end, including those of zero length.
  std::vector<SegmentId> starts_;
  // The curves from the left infinity, without vertical curves.
  std::vector<SegmentId> left_unbounded_;
  // For each point, the index in enders_ at which its curves begin.
  std::vector<std::uint32_t> ender_begin_;
  // The curves by right end, without those of zero length.
  std::vector<SegmentId> enders_;
  // Whether each point is known to have a curve of length zero, or to lie inside of a curve.
  std::vector<char> is_marked_;
  IdVector<SegmentId, Active> active_;  // One entry for each curve.

  SweepStatus status_;

  // The current event.
  std::vector<StatusNode> through_;  // The bundles through the event, from bottom to top.
  StatusNode below_;                 // The nearest node below the event, if there is one.
  std::vector<SegmentId> incoming_;
  std::vector<SegmentId> outgoing_;
  std::vector<SegmentId> starters_;
  std::vector<SegmentId> ends_;
  std::vector<std::uint32_t> ends_end_;    // One entry for each incoming bundle (SweepEvent).
  std::vector<std::uint32_t> starts_end_;  // One entry for each outgoing bundle.
  std::vector<std::uint32_t> arrived_as_;  // One entry for each outgoing bundle.
  std::vector<SegmentId> zero_length_;
};

// ---------------------------------------------------------------- set-up

/// Groups the curves by their ends with counting sorts.
void Sweep::collect_starts() {
  start_begin_.assign(points_.size() + 1, 0);
  ender_begin_.assign(points_.size() + 1, 0);
  is_marked_.assign(points_.size(), 0);
  active_.resize(curves_.size());
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const SegmentId s(i);
    const auto& c = curves_[s];
    active_[i].key = s;
    if (c.has_left()) {
      ++start_begin_[c.left + 1];
    } else if (!curves_.is_vertical(s)) {
      left_unbounded_.push_back(s);
    }
    if (curves_.is_zero_length(s)) {
      is_marked_[c.left] = is_marked_[c.right] = 1;
    } else if (c.has_right()) {
      ++ender_begin_[c.right + 1];
    }
  }
  for (std::size_t v = 0; v < points_.size(); ++v) {
    start_begin_[v + 1] += start_begin_[v];
    ender_begin_[v + 1] += ender_begin_[v];
  }
  starts_.resize(start_begin_.back());
  enders_.resize(ender_begin_.back());
  std::vector<std::uint32_t> fill(start_begin_.begin(), start_begin_.end() - 1);
  std::vector<std::uint32_t> fill_ends(ender_begin_.begin(), ender_begin_.end() - 1);
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    const SegmentId s(i);
    const auto& c = curves_[s];
    if (c.has_left()) starts_[fill[c.left]++] = s;
    if (c.has_right() && !curves_.is_zero_length(s)) enders_[fill_ends[c.right]++] = s;
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

/// Processes the current event. Returns whether the visitor wants more events.
bool Sweep::handle_event() {
  if (place().kind == SweepPlace::VerticalStart) return vertical_start();
  if (place().kind == SweepPlace::VerticalEnd) return vertical_end();
  const bool may_be_plain = place().points.size() == 1 && place().crossings.empty() &&
                            is_marked_[place().points.front()] == 0;
  return may_be_plain ? plain_event(place().points.front()) : general_event();
}

// ---------------------------------------------------------------- ends at infinity

void Sweep::clear_event() {
  through_.clear();
  below_ = StatusNode();
  for (auto* list : {&incoming_, &outgoing_, &starters_, &ends_, &zero_length_}) list->clear();
  for (auto* list : {&ends_end_, &starts_end_, &arrived_as_}) list->clear();
}

/// All curves from the left infinity enter in one event, sorted by their order there. Curves on the
/// same line form a bundle.
bool Sweep::start_unbounded() {
  if (left_unbounded_.empty()) return true;
  clear_event();
  std::sort(left_unbounded_.begin(), left_unbounded_.end(), [this](SegmentId s, SegmentId t) {
    count_step();
    if (s == t) return false;
    const Sign order = curves_.order_at_left_infinity(s, t);
    return order == Sign::Positive || (order == Sign::Zero && s < t);
  });
  starters_ = left_unbounded_;
  for (std::size_t i = 0; i < starters_.size(); ++i) {
    const bool joins =
        i > 0 && curves_.order_at_left_infinity(starters_[i - 1], starters_[i]) == Sign::Zero;
    joins ? join_bundle(i) : start_bundle(i);
  }
  replace_in_status();
  // Unlike curves that leave the same point, these curves may still meet each other.
  for (StatusNode n = status_.first(); n.is_valid(); n = status_.next(n)) {
    test_neighbours(n, status_.next(n));
  }
  return report(SweepPlace::LeftInfinity, false);
}

bool Sweep::end_unbounded() {
  clear_event();
  for (StatusNode n = status_.first(); n.is_valid(); n = status_.next(n)) through_.push_back(n);
  if (through_.empty()) return true;
  collect_incoming();
  return report(SweepPlace::RightInfinity, false);
}

bool Sweep::vertical_start() {
  clear_event();
  starters_ = place().verticals;
  start_bundle(0);
  for (std::size_t i = 1; i < starters_.size(); ++i) join_bundle(i);
  replace_in_status();
  return report(SweepPlace::VerticalStart, false);
}

bool Sweep::vertical_end() {
  clear_event();
  through_.assign(1, node(place().verticals.front()));
  below_ = status_.prev(through_.front());
  collect_incoming();
  replace_in_status();
  return report(SweepPlace::VerticalEnd, false);
}

// ---------------------------------------------------------------- plain events

// Processes an event as plain, or as a general event if an overlap or a contact is found.
bool Sweep::plain_event(std::uint32_t v) {
  through_.clear();
  incoming_.clear();
  const bool is_placed = enders(v).empty() ? place_without_enders() : take_enders(v);
  if (!is_placed || !order_plain_starters(v)) return general_event();
  replace_in_status();
  return report(SweepPlace::Point, true);
}

// Collects the nodes of the curves that end here, which are neighbours. Returns false if there are
// fewer nodes than curves, because some curves share a bundle or are in a bundle that continues.
bool Sweep::take_enders(std::uint32_t v) {
  StatusNode n = node(enders(v).front());
  const auto ends_here = [&](StatusNode candidate) {
    return candidate.is_valid() && curves_[status_.segment(candidate)].right == v;
  };
  while (ends_here(status_.prev(n))) n = status_.prev(n);
  below_ = status_.prev(n);
  for (; ends_here(n); n = status_.next(n)) {
    incoming_.push_back(status_.segment(n));
    through_.push_back(n);
  }
  return through_.size() == enders(v).size();
}

// Finds the place in the status of a point at which no curve ends. Returns false if the point lies
// on a bundle.
bool Sweep::place_without_enders() {
  const auto location = status_.locate([&](SegmentId s) { return side_of_event(s); });
  below_ = location.below;
  return !location.on.is_valid();
}

// Sorts the curves that start here. Returns false if two of them have the same direction.
bool Sweep::order_plain_starters(std::uint32_t v) {
  const auto starting = starts(v);
  outgoing_.assign(starting.begin(), starting.end());
  bool all_different = true;
  std::sort(outgoing_.begin(), outgoing_.end(), [&](SegmentId s, SegmentId t) {
    count_step();
    if (s == t) return false;
    const Sign turn = curves_.direction_order(s, t);
    if (turn == Sign::Zero) all_different = false;
    return turn == Sign::Positive;
  });
  return all_different;
}

// ---------------------------------------------------------------- all other events

bool Sweep::general_event() {
  take_all_through();
  collect_incoming();
  group_ends();
  order_starters();
  merge_starters();
  replace_in_status();
  return report(SweepPlace::Point, false);
}

// Whether the event lies on a bundle. In most cases, the ranks decide.
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

// Finds any node through the event. If there is none, sets below_.
void Sweep::find_seed() {
  through_.clear();
  for (const std::uint32_t v : place().points) {
    if (!enders(v).empty()) through_.assign(1, node(enders(v).front()));
  }
  if (!place().crossings.empty()) {
    through_.assign(1, node(place().crossings.front().lower));
  }
  if (!through_.empty()) return;
  const auto location = status_.locate([&](SegmentId s) { return side_of_event(s); });
  if (location.on.is_valid()) through_.assign(1, location.on);
  below_ = location.below;
}

// The bundles through the event are consecutive in the status.
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
  for (const StatusNode n : through_) incoming_.push_back(status_.segment(n));
}

// Groups the curves that end here by bundle, with a counting sort.
void Sweep::group_ends() {
  ends_.clear();
  ends_end_.assign(incoming_.size() + 1, 0);
  if (!place().is_point() || incoming_.empty()) return;
  const auto arrival = [&](SegmentId s) -> std::uint32_t& {
    return active_[active_[s].key].arrival;
  };
  for (std::uint32_t i = 0; i < incoming_.size(); ++i) arrival(incoming_[i]) = i;
  for (const std::uint32_t v : place().points) {
    for (const SegmentId s : enders(v)) ++ends_end_[arrival(s) + 1];
  }
  for (std::size_t i = 0; i < incoming_.size(); ++i) ends_end_[i + 1] += ends_end_[i];
  ends_.resize(ends_end_.back());
  for (const std::uint32_t v : place().points) {
    for (const SegmentId s : enders(v)) ends_[ends_end_[arrival(s)]++] = s;
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
    count_step();
    const Sign turn = curves_.direction_order(s, t);
    return turn == Sign::Positive || (turn == Sign::Zero && s < t);
  });
}

/// Appends an outgoing bundle. The bundle arrived as an incoming bundle, or is new.
void Sweep::leave(SegmentId bundle, std::uint32_t came_from) {
  outgoing_.push_back(bundle);
  arrived_as_.push_back(came_from);
  starts_end_.push_back(starts_end_.empty() ? 0 : starts_end_.back());
}

void Sweep::start_bundle(std::size_t starter) {
  leave(starters_[starter], SweepEvent::kNew);
  ++starts_end_.back();
}

/// Adds a starting curve to the last outgoing bundle. If the curve ends later, it becomes the name
/// of the bundle.
void Sweep::join_bundle(std::size_t starter) {
  const SegmentId s = starters_[starter];
  active_[s].key = active_[outgoing_.back()].key;
  if (curves_.reaches_further(s, outgoing_.back())) outgoing_.back() = s;
  ++starts_end_.back();
}

// The bundles that continue leave in the reverse order of their arrival, because the event is a
// common point of them. This needs no arithmetic. Starting curves are merged into this order.
// Starting curves with the direction of a bundle come after this bundle.
void Sweep::merge_starters() {
  outgoing_.clear();
  arrived_as_.clear();
  starts_end_.clear();
  const auto goes_on = [&](SegmentId bundle) {
    return !place().is_point() || !curves_.ends_at(bundle, place().rank);
  };
  std::size_t s = 0;
  const auto take_starters_below = [&](SegmentId bundle) {
    while (
        s < starters_.size() &&
        (!bundle.is_valid() || curves_.direction_order(starters_[s], bundle) == Sign::Positive)) {
      const bool joins = !outgoing_.empty() &&
                         curves_.direction_order(outgoing_.back(), starters_[s]) == Sign::Zero;
      joins ? join_bundle(s) : start_bundle(s);
      ++s;
      count_step();
    }
  };
  for (std::size_t i = incoming_.size(); i-- > 0;) {
    if (!goes_on(incoming_[i])) continue;
    take_starters_below(incoming_[i]);
    leave(incoming_[i], static_cast<std::uint32_t>(i));
  }
  take_starters_below(SegmentId());
}

// ---------------------------------------------------------------- status

void Sweep::replace_in_status() {
  // At a place inside of one bundle, the node, its name and its neighbours do not change, and the
  // neighbours have been tested before. Another test would add their crossing to the queue once for
  // every such place.
  if (through_.size() == 1 && outgoing_.size() == 1 && incoming_.front() == outgoing_.front())
    return;
  for (std::size_t i = outgoing_.size(); i < through_.size(); ++i) status_.erase(through_[i]);
  StatusNode last = below_;
  for (std::size_t i = 0; i < outgoing_.size(); ++i) {
    const StatusNode n =
        i < through_.size() ? through_[i] : status_.insert_above(last, outgoing_[i]);
    bind_bundle(outgoing_[i], n);
    if (i == 0) test_neighbours(below_, n);
    last = n;
  }
  const StatusNode above = last.is_valid() ? status_.next(last) : status_.first();
  test_neighbours(last, above);
}

void Sweep::bind_bundle(SegmentId bundle, StatusNode n) {
  status_.set_segment(n, bundle);
  active_[active_[bundle].key].node = n;
}

/// Keeps Invariant S for two new neighbours.
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
  event.ends = plain ? incoming_ : ends_;
  event.starts = plain ? outgoing_ : starters_;
  if (!plain) {
    event.arrived_as = arrived_as_;
    event.ends_end = ends_end_;
    event.starts_end = starts_end_;
    event.zero_length = zero_length_;
  }
  if (below_.is_valid()) event.below = status_.segment(below_);
  event.plain = plain;
  return visitor_.on_event(event);
}

}  // namespace

bool SweepEvent::has_ends_only() const {
  return starts.size() == outgoing.size() && ends.size() == incoming.size() &&
         std::ranges::all_of(arrived_as, [](std::uint32_t a) { return a == kNew; });
}

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
