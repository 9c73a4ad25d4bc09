// The status of the sweep against a plain vector under random insertions, removals and searches,
// and the queue of events against sorting all places in rationals.
// The queue holds curves, which libraries hide; tests are compiled without hiding anything.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wattributes"
#include "plumb/plane/sweep/sweep_structures.h"
#pragma GCC diagnostic pop

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::sweep_structures_test {

/// Bottom to top, from either end, what the status says must be what the model says.
void expect_alike(const SweepStatus& status, const std::vector<StatusNode>& model) {
  std::vector<StatusNode> upward, downward;
  for (StatusNode n = status.first(); n.is_valid(); n = status.next(n)) upward.push_back(n);
  EXPECT_EQ(upward, model);
  if (model.empty()) return;
  for (StatusNode n = model.back(); n.is_valid(); n = status.prev(n)) downward.push_back(n);
  std::ranges::reverse(downward);
  EXPECT_EQ(downward, model);
}

TEST(SweepStructures, StatusIsAListInWhichPlacesAreFound) {
  testing::Dice dice(1);
  for (int round = 0; round < 20; ++round) {
    SweepStatus status;
    std::vector<StatusNode> model;
    std::vector<std::size_t> place(4096);  // in the model, of the curve that names a node
    for (int step = 0; step < 150; ++step) {
      const bool grows = model.empty() || dice.below(step < 100 ? 3 : 2) != 0;
      const std::size_t at = dice.below(model.size() + (grows ? 1 : 0));
      const auto where = model.begin() + static_cast<std::ptrdiff_t>(at);
      if (grows) {
        const StatusNode below = at == 0 ? StatusNode() : model[at - 1];
        const SegmentId s(static_cast<std::size_t>(step));
        const StatusNode n = status.insert_above(below, s);
        EXPECT_EQ(status.segment(n), s);
        EXPECT_EQ(std::ranges::count(model, n), 0);
        model.insert(where, n);
      } else {
        status.erase(*where);
        model.erase(where);
      }
      if (dice.below(3) == 0 && !model.empty()) {  // bundles are renamed
        const StatusNode n = model[dice.below(model.size())];
        status.set_segment(n, SegmentId(static_cast<std::size_t>(1000 + step)));
        EXPECT_EQ(status.segment(n), SegmentId(static_cast<std::size_t>(1000 + step)));
      }
      expect_alike(status, model);
      for (std::size_t i = 0; i < model.size(); ++i) place[status.segment(model[i]).value()] = i;
      // Place 2 i + 1 is on node i, place 2 i just below it.
      const std::size_t wanted = dice.below(2 * model.size() + 1);
      const auto found = status.locate([&](SegmentId s) {
        return sign_of(static_cast<int>(wanted) - static_cast<int>(2 * place[s.value()] + 1));
      });
      if (wanted % 2 == 1) {
        EXPECT_EQ(found.on, model[wanted / 2]);
        EXPECT_FALSE(found.below.is_valid());
      } else {
        EXPECT_FALSE(found.on.is_valid());
        EXPECT_EQ(found.below, wanted == 0 ? StatusNode() : model[wanted / 2 - 1]);
      }
    }
  }
}

/// Insertions at one end only: the worst order for a tree that is not balanced.
TEST(SweepStructures, StatusStaysShallow) {
  SweepStatus status;
  std::vector<StatusNode> model;
  for (std::size_t i = 0; i < 4096; ++i) {
    model.push_back(status.insert_above(i == 0 ? StatusNode() : model.back(), SegmentId(i)));
  }
  for (std::size_t i = 0; i < 4096; i += 100) {
    int asked = 0;
    const auto found = status.locate([&](SegmentId s) {
      ++asked;
      return sign_of(static_cast<int>(i) - static_cast<int>(s.value()));
    });
    EXPECT_EQ(found.on, model[i]);
    EXPECT_LT(asked, 80);  // of 4096; a random treap has depth 2 ln n on average
  }
}

/// Kinds of places, in their order at one x.
struct Kind {
  static constexpr int kStart = 0, kPoint = 1, kEnd = 2;
};

/// A place of the queue, in the order that the sweep needs: at one x upright curves come up from
/// infinity first, then points by y, then upright curves leave.
struct Event {
  Rational x;
  int kind;
  Rational y;
  std::set<std::uint32_t> points;
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> crossings;
  std::set<std::uint32_t> verticals;

  bool is_same_place(const Event& e) const { return x == e.x && kind == e.kind && y == e.y; }
  friend bool operator<(const Event& p, const Event& q) {
    if (p.x != q.x) return p.x < q.x;
    return p.kind != q.kind ? p.kind < q.kind : p.y < q.y;
  }
  friend bool operator==(const Event&, const Event&) = default;
};

Event event_at(const RationalPoint2& p) { return {p.x, Kind::kPoint, p.y, {}, {}, {}}; }

void merge(std::vector<Event>& events, const Event& event) {
  const auto same =
      std::ranges::find_if(events, [&](const Event& e) { return e.is_same_place(event); });
  if (same == events.end()) {
    events.push_back(event);
    return;
  }
  same->points.insert(event.points.begin(), event.points.end());
  same->crossings.insert(event.crossings.begin(), event.crossings.end());
  same->verticals.insert(event.verticals.begin(), event.verticals.end());
}

TEST(SweepStructures, QueueHasAllPlacesInOrder) {
  testing::Dice dice(2);
  constexpr std::uint32_t kNoEnd = SweepCurve::kUnbounded;
  for (int round = 0; round < 150; ++round) {
    PointTable2 points;
    for (int i = 0; i < 7; ++i) {
      points.push_back(Rational(dice.between(0, 4)) / 2, Rational(dice.between(0, 4)) / 3);
    }
    std::vector<SweepCurve> given;
    std::vector<Event> expected;
    std::set<std::uint32_t> used;
    while (given.size() < 7) {
      const std::uint32_t a = dice.below(points.size()), b = dice.below(points.size());
      if (compare_xy(points, a, b) != Sign::Negative) continue;
      const std::uint32_t from = dice.below(3) == 0 ? kNoEnd : a;
      const std::uint32_t to = dice.below(3) == 0 ? kNoEnd : b;
      const auto s = static_cast<std::uint32_t>(given.size());
      given.push_back({from, to, a, b});
      for (const std::uint32_t end : {from, to}) {
        if (end != kNoEnd) used.insert(end);
      }
      if (points.exact(a).x != points.exact(b).x) continue;
      const Rational x = points.exact(a).x;
      if (from == kNoEnd) merge(expected, {x, Kind::kStart, 0, {}, {}, {s}});
      if (to == kNoEnd) merge(expected, {x, Kind::kEnd, 0, {}, {}, {s}});
    }
    const std::vector<std::uint32_t> stops{dice.below(points.size())};
    used.insert(stops.front());
    for (const std::uint32_t p : used) {
      Event event = event_at(points.exact(p));
      event.points.insert(p);
      merge(expected, event);
    }
    const SweepCurves curves(points, given, stops);
    SweepQueue queue(curves);
    for (std::uint32_t s = 0; s < given.size(); ++s) {
      for (std::uint32_t t = 0; t < s; ++t) {
        const SweepCurve &p = given[s], &q = given[t];
        if (dice.below(2) == 0 || cross_sign(points, p.a, p.b, q.a, q.b) == Sign::Zero) continue;
        queue.add_crossing(SegmentId(s), SegmentId(t));
        Event event = event_at(exact(points, make_crossing(points, p.a, p.b, q.a, q.b)));
        event.crossings.insert({s, t});
        merge(expected, event);
      }
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(queue.total(), used.size());
    std::size_t done = 0;
    for (const Event& event : expected) {
      ASSERT_TRUE(queue.advance());
      const SweepQueue::Place& place = queue.place();
      Event found{event.x, Kind::kPoint, event.y, {}, {}, {}};
      if (place.kind == SweepPlace::VerticalStart) found.kind = Kind::kStart;
      if (place.kind == SweepPlace::VerticalEnd) found.kind = Kind::kEnd;
      found.points.insert(place.points.begin(), place.points.end());
      for (const auto& c : place.crossings) {
        found.crossings.insert({c.lower.value(), c.upper.value()});
      }
      for (const SegmentId s : place.verticals) found.verticals.insert(s.value());
      EXPECT_TRUE(found == event);
      EXPECT_EQ(place.is_point(), !event.points.empty());
      done += event.points.size();
      EXPECT_EQ(queue.done(), done);
    }
    EXPECT_FALSE(queue.advance());
  }
}

}  // namespace plumb::sweep_structures_test
