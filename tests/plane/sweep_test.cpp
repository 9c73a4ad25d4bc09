// The sweep against brute force in rationals: every event, everything at it, and every order.
#include "plumb/plane/sweep/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "generate/test_share.h"
#include "plumb/plane/sweep/sweep_curves.h"

namespace plumb::sweep_test {
namespace {

using Q = boost::multiprecision::cpp_rational;
using Place = std::pair<Q, Q>;

Q to_q(const Rational& r) {
  return Q(boost::multiprecision::cpp_int(numerator(r).str()),
           boost::multiprecision::cpp_int(denominator(r).str()));
}

struct Scene {
  PointTable2 points;
  std::vector<Place> places;  // the same points, independently
  std::vector<SweepSegment> segments;

  void add_point(int x, int y, int denominator) {
    places.emplace_back(Q(x, denominator), Q(y, denominator));
    if (denominator == 1) {
      points.push_back({static_cast<double>(x), static_cast<double>(y)});
    } else {
      points.push_back(Rational(x, denominator), Rational(y, denominator));
    }
  }
};

struct Line {
  Place left;
  Place right;
  explicit Line(const Scene& scene, SegmentId s)
      : left(std::min(scene.places[scene.segments[s.value()].from],
                      scene.places[scene.segments[s.value()].to])),
        right(std::max(scene.places[scene.segments[s.value()].from],
                       scene.places[scene.segments[s.value()].to])) {}

  // > 0: p lies above the line (to its left).
  Q side(const Place& p) const {
    return (right.first - left.first) * (p.second - left.second) -
           (right.second - left.second) * (p.first - left.first);
  }
  bool contains(const Place& p) const { return left <= p && p <= right && side(p) == 0; }
  Q cross(const Line& other) const {
    return (right.first - left.first) * (other.right.second - other.left.second) -
           (right.second - left.second) * (other.right.first - other.left.first);
  }
};

// All places where something happens: end points and crossings of lines.
std::set<Place> brute_force_places(const Scene& scene) {
  std::set<Place> found;
  for (std::size_t i = 0; i < scene.segments.size(); ++i) {
    const Line s(scene, SegmentId(i));
    found.insert({s.left, s.right});
    for (std::size_t j = 0; j < i; ++j) {
      const Line t(scene, SegmentId(j));
      const Q w = s.cross(t);
      if (w == 0) continue;
      const Q u = ((t.left.first - s.left.first) * (t.right.second - t.left.second) -
                   (t.left.second - s.left.second) * (t.right.first - t.left.first)) /
                  w;
      const Place p(s.left.first + u * (s.right.first - s.left.first),
                    s.left.second + u * (s.right.second - s.left.second));
      if (s.contains(p) && t.contains(p)) found.insert(p);
    }
  }
  return found;
}

class Recorder final : public SweepVisitor {
 public:
  explicit Recorder(const Scene& scene) : scene_(scene), members_(scene.segments.size()) {}

  bool on_event(const SweepEvent& event) override {
    const Place p = place_of(event);
    if (!seen_.empty()) {
      EXPECT_LT(seen_.back(), p) << "events in lexicographic order";
    }
    seen_.push_back(p);
    members_.update(event);
    check_membership(event, p);
    check_order(members_.incoming(), -1);
    check_order(members_.outgoing(), +1);
    check_names(event);
    check_below(event, p);
    return true;
  }

  const std::vector<Place>& seen() const { return seen_; }

 private:
  Place place_of(const SweepEvent& event) const {
    if (!event.points.empty()) return scene_.places[event.points.front()];
    const RationalPoint2 q = exact(scene_.points, *event.crossing);
    return {to_q(q.x), to_q(q.y)};
  }

  void check_membership(const SweepEvent& event, const Place& p) const {
    std::set<SegmentId> in, out, zero, points_here;
    for (const SweepIncidence& i : members_.incoming()) in.insert(i.segment);
    for (const SweepIncidence& i : members_.outgoing()) out.insert(i.segment);
    for (const SegmentId s : event.zero_length) zero.insert(s);
    for (std::size_t i = 0; i < scene_.segments.size(); ++i) {
      const SegmentId s(i);
      const Line line(scene_, s);
      const bool here = line.contains(p);
      const bool is_zero = line.left == line.right;
      EXPECT_EQ(in.contains(s), here && !is_zero && line.left < p);
      EXPECT_EQ(out.contains(s), here && !is_zero && p < line.right);
      EXPECT_EQ(zero.contains(s), here && is_zero);
    }
    std::size_t expected = 0;
    std::set<std::uint32_t> used;
    for (const SweepSegment& s : scene_.segments) used.insert({s.from, s.to});
    for (const std::uint32_t v : used) expected += scene_.places[v] == p ? 1 : 0;
    EXPECT_EQ(event.points.size(), expected);
  }

  // Bottom to top: to the right of an event slopes grow, to the left they fall.
  void check_order(std::span<const SweepIncidence> around, int direction) const {
    for (std::size_t i = 0; i + 1 < around.size(); ++i) {
      const Q turn = Line(scene_, around[i].segment).cross(Line(scene_, around[i + 1].segment));
      if (around[i].bundle == around[i + 1].bundle) {
        EXPECT_EQ(turn, 0);
      } else {
        EXPECT_GT(turn * direction, 0);
        EXPECT_EQ(around[i].bundle + 1, around[i + 1].bundle);
      }
    }
  }

  // A bundle is named by one of its segments that reaches furthest.
  void check_names(const SweepEvent& event) const {
    const auto check = [&](std::span<const SegmentId> names,
                           std::span<const SweepIncidence> members) {
      ASSERT_EQ(names.size(), members.empty() ? 0 : members.back().bundle + 1);
      std::set<SegmentId> found;
      for (const SweepIncidence& i : members) {
        const SegmentId name = names[i.bundle];
        EXPECT_LE(Line(scene_, i.segment).right, Line(scene_, name).right);
        if (i.segment == name) found.insert(name);
      }
      EXPECT_EQ(found.size(), names.size());
    };
    check(event.incoming, members_.incoming());
    check(event.outgoing, members_.outgoing());
  }

  // The segment next below: none other lies between, just left or right of the vertical through p.
  void check_below(const SweepEvent& event, const Place& p) const {
    const auto lies_below = [&](SegmentId s) {
      const Line line(scene_, s);
      return line.left < p && p < line.right && line.side(p) > 0;
    };
    if (event.below.is_valid()) {
      EXPECT_TRUE(lies_below(event.below));
    }
    for (std::size_t i = 0; i < scene_.segments.size(); ++i) {
      const SegmentId s(i);
      if (!lies_below(s)) continue;
      ASSERT_TRUE(event.below.is_valid());
      EXPECT_GE(height(event.below, p), height(s, p));
    }
  }

  // Where the line meets the vertical through p; for a vertical line its upper end.
  Q height(SegmentId s, const Place& p) const {
    const Line line(scene_, s);
    if (line.left.first == line.right.first) return line.right.second;
    return line.left.second + (p.first - line.left.first) * (line.right.second - line.left.second) /
                                  (line.right.first - line.left.first);
  }

  const Scene& scene_;
  SweepMembers members_;
  std::vector<Place> seen_;
};

void expect_right(const Scene& scene) {
  Recorder recorder(scene);
  Context context;
  sweep(scene.points, scene.segments, recorder, context);
  std::set<Place> expected = brute_force_places(scene);
  EXPECT_EQ(std::vector<Place>(expected.begin(), expected.end()), recorder.seen());
}

Scene random_scene(std::mt19937_64& random, int points, int segments, int range, int denominator) {
  Scene scene;
  std::uniform_int_distribution<int> coordinate(0, range);
  std::uniform_int_distribution<std::uint32_t> index(0, static_cast<std::uint32_t>(points - 1));
  for (int i = 0; i < points; ++i) {
    const int d = denominator > 1 && i % 2 == 0 ? denominator : 1;
    scene.add_point(coordinate(random), coordinate(random), d);
  }
  for (int i = 0; i < segments; ++i) {
    const std::uint32_t a = index(random);
    const std::uint32_t b = index(random);
    if (a != b) scene.segments.push_back({a, b});
  }
  return scene;
}

// Tiny grids: overlaps, concurrent segments, equal points and zero lengths are the rule.
TEST(Sweep, MatchesBruteForceOnTinyGrids) {
  std::mt19937_64 random(20261121);
  for (std::uint64_t round = 0; round < testing::share_of(3000) && !HasFailure(); ++round) {
    const int range = 1 + static_cast<int>(round % 6);
    const int count = 2 + static_cast<int>(round % 13);
    SCOPED_TRACE(round);
    expect_right(random_scene(random, 2 + count, count, range, 1));
  }
}

TEST(Sweep, MatchesBruteForceWithFractions) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 500 && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    expect_right(random_scene(random, 8, 9, 1 + round % 8, 3));
  }
}

TEST(Sweep, MatchesBruteForceInGeneralPosition) {
  std::mt19937_64 random(11);
  for (std::uint64_t round = 0; round < testing::share_of(60) && !HasFailure(); ++round) {
    SCOPED_TRACE(round);
    expect_right(random_scene(random, 50, 25, 1000000, 1));
  }
}

TEST(Sweep, StopsWhenTheVisitorSaysSo) {
  class Once final : public SweepVisitor {
   public:
    bool on_event(const SweepEvent&) override { return ++calls < 2; }
    int calls = 0;
  };
  std::mt19937_64 random(1);
  const Scene scene = random_scene(random, 20, 10, 100, 1);
  Once visitor;
  Context context;
  sweep(scene.points, scene.segments, visitor, context);
  EXPECT_EQ(visitor.calls, 2);
}

TEST(Sweep, HonoursAStopRequest) {
  std::mt19937_64 random(1);
  const Scene scene = random_scene(random, 20, 10, 100, 1);
  Recorder recorder(scene);
  std::stop_source stop;
  stop.request_stop();
  Context context({}, stop.get_token());
  EXPECT_ANY_THROW(sweep(scene.points, scene.segments, recorder, context));
}

}  // namespace
}  // namespace plumb::sweep_test
