// The sweep of segments, rays and lines, with constructed end points and stops, against brute
// force: every event, everything at it, and every order.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "generate/curve_scenes.h"
#include "generate/test_share.h"
#include "plumb/plane/sweep/sweep_curves.h"

namespace plumb::testing::sweep_unbounded_test {
namespace {

// Where an event is, in the order of events.
struct Place {
  int infinity = 0;  // -1: the left, +1: the right one
  BigRational x = 0;
  int vertical = 0;  // -1: below all points of x, +1: above them
  BigRational y = 0;
  friend bool operator<(const Place& p, const Place& q) {
    return std::tie(p.infinity, p.x, p.vertical, p.y) < std::tie(q.infinity, q.x, q.vertical, q.y);
  }
  friend bool operator==(const Place&, const Place&) = default;
  bool is_point() const { return infinity == 0 && vertical == 0; }
  ExactPoint point() const { return {x, y}; }
};

Place place_of(const ExactPoint& p) { return {0, p.x, 0, p.y}; }

// A curve turned to run from left to right.
struct Directed {
  TestCurve curve;
  explicit Directed(const TestCurve& c) : curve(c) {
    if (!(c.b < c.a)) return;
    std::swap(curve.a, curve.b);
    std::swap(curve.from, curve.to);
  }
  bool is_point() const { return curve.is_point(); }
  bool is_vertical() const { return curve.a.x == curve.b.x; }
  Place left() const {
    if (curve.from) return place_of(*curve.from);
    return is_vertical() ? Place{0, curve.a.x, -1, 0} : Place{-1, 0, 0, 0};
  }
  Place right() const {
    if (curve.to) return place_of(*curve.to);
    return is_vertical() ? Place{0, curve.a.x, +1, 0} : Place{+1, 0, 0, 0};
  }
  bool passes(const Place& p) const { return !p.is_point() || curve.contains(p.point()); }
  // Is it there just left (right) of p?
  bool comes_in(const Place& p) const {
    return !is_point() && left() < p &&
           (p == right() || (p.is_point() && passes(p) && p < right()));
  }
  bool goes_out(const Place& p) const {
    return !is_point() && p < right() && (p == left() || (p.is_point() && passes(p) && left() < p));
  }
  BigRational height(const BigRational& x) const {
    return curve.a.y + (x - curve.a.x) * (curve.b.y - curve.a.y) / (curve.b.x - curve.a.x);
  }
  // > 0: the other is steeper.
  BigRational turn_to(const Directed& other) const {
    const TestCurve& s = curve;
    const TestCurve& t = other.curve;
    return (s.b.x - s.a.x) * (t.b.y - t.a.y) - (s.b.y - s.a.y) * (t.b.x - t.a.x);
  }
};

std::set<Place> places_of(const CurveScene& scene, const std::vector<ExactPoint>& stops) {
  std::set<Place> places;
  for (const ExactPoint& p : stops) places.insert(place_of(p));
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    const Directed s(scene.curves[i]);
    places.insert(s.left());
    places.insert(s.right());
    for (std::size_t j = 0; j < i; ++j) {
      if (s.is_point() || scene.curves[j].is_point()) continue;
      const auto p = crossing_of(s.curve, scene.curves[j]);
      if (p && s.curve.contains(*p) && scene.curves[j].contains(*p)) places.insert(place_of(*p));
    }
  }
  return places;
}

class Recorder final : public SweepVisitor {
 public:
  Recorder(const CurveScene& scene, const EngineScene& engine)
      : engine_(engine), members_(scene.curves.size()) {
    for (const TestCurve& c : scene.curves) curves_.emplace_back(c);
    used_.insert(engine.isolated.begin(), engine.isolated.end());
    for (const SweepCurve& c : engine.curves) used_.insert({c.from, c.to});
    used_.erase(SweepCurve::kUnbounded);
  }

  bool on_event(const SweepEvent& event) override {
    const Place p = place_of_event(event);
    if (!seen_.empty()) {
      EXPECT_LT(seen_.back(), p) << "events in their order";
    }
    seen_.push_back(p);
    members_.update(event);
    check_points(event, p);
    check_curves(event, p);
    check_order(members_.incoming(), p, -1);
    check_order(members_.outgoing(), p, +1);
    check_bundles(event);
    check_below(event, p);
    return true;
  }

  const std::vector<Place>& seen() const { return seen_; }

 private:
  Place place_of_event(const SweepEvent& event) const {
    switch (event.place) {
      case SweepPlace::LeftInfinity:
        return {-1, 0, 0, 0};
      case SweepPlace::RightInfinity:
        return {+1, 0, 0, 0};
      case SweepPlace::VerticalStart:
        return {0, curves_[event.outgoing.front().value()].curve.a.x, -1, 0};
      case SweepPlace::VerticalEnd:
        return {0, curves_[event.incoming.front().value()].curve.a.x, +1, 0};
      default:
        break;
    }
    if (event.points.empty())
      return place_of(exact_of(exact(engine_.points.inputs, *event.crossing)));
    return place_of(exact_of(exact(engine_.points, event.points.front())));
  }

  void check_points(const SweepEvent& event, const Place& p) const {
    std::vector<std::uint32_t> listed(event.points.begin(), event.points.end());
    std::sort(listed.begin(), listed.end());
    std::vector<std::uint32_t> expected;
    for (const std::uint32_t i : used_) {
      if (p.is_point() && exact_of(exact(engine_.points, i)) == p.point()) expected.push_back(i);
    }
    EXPECT_EQ(listed, expected);
  }

  void check_curves(const SweepEvent& event, const Place& p) const {
    std::multiset<SegmentId> in, out, zero;
    for (const SweepIncidence& i : members_.incoming()) in.insert(i.segment);
    for (const SweepIncidence& i : members_.outgoing()) out.insert(i.segment);
    for (const SegmentId s : event.zero_length) zero.insert(s);
    bool starts_or_ends = true;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const Directed& c = curves_[i];
      EXPECT_EQ(in.count(SegmentId(i)), c.comes_in(p) ? 1U : 0U) << "curve " << i;
      EXPECT_EQ(out.count(SegmentId(i)), c.goes_out(p) ? 1U : 0U) << "curve " << i;
      EXPECT_EQ(zero.count(SegmentId(i)), c.is_point() && c.left() == p ? 1U : 0U);
      starts_or_ends = starts_or_ends && !(c.comes_in(p) && c.goes_out(p));
    }
    if (event.plain) {
      EXPECT_TRUE(event.points.size() == 1 && starts_or_ends);
      EXPECT_EQ(event.incoming.size(), in.size());
      EXPECT_EQ(event.outgoing.size(), out.size());
    }
  }

  // Bottom to top: right of a place slopes grow, left of it they fall.
  void check_order(std::span<const SweepIncidence> around, const Place& p, int direction) const {
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (i == 0) {
        EXPECT_EQ(around[0].bundle, 0U);
        continue;
      }
      const Directed& s = curves_[around[i - 1].segment.value()];
      const Directed& t = curves_[around[i].segment.value()];
      BigRational up = s.turn_to(t) * direction;
      if (p.infinity != 0) {  // seen from the place
        up = s.turn_to(t) == 0 ? t.height(0) - s.height(0) : s.turn_to(t) * p.infinity;
      }
      EXPECT_GE(up, 0);
      EXPECT_EQ(around[i].bundle, around[i - 1].bundle + (up == 0 ? 0 : 1));
    }
  }

  // A bundle comes in as it went out, under the same name.
  void check_bundles(const SweepEvent& event) {
    for (const auto& [name, members] : bundles_of(event.incoming, members_.incoming())) {
      EXPECT_TRUE(members.contains(name));
      EXPECT_EQ(live_[name], members);
      live_.erase(name);
    }
    for (const auto& [name, members] : bundles_of(event.outgoing, members_.outgoing())) {
      EXPECT_TRUE(members.contains(name));
      live_[name] = members;
    }
  }

  static std::map<SegmentId, std::set<SegmentId>> bundles_of(
      std::span<const SegmentId> names, std::span<const SweepIncidence> around) {
    std::map<SegmentId, std::set<SegmentId>> bundles;
    for (const SweepIncidence& i : around) bundles[names[i.bundle]].insert(i.segment);
    EXPECT_EQ(bundles.size(), names.size());
    return bundles;
  }

  bool lies_below(const Directed& c, const Place& p) const {
    if (p.infinity != 0 || p.vertical < 0 || c.is_point() || c.is_vertical()) return false;
    if (!(c.left() < p && p < c.right())) return false;
    return p.vertical > 0 || c.height(p.x) < p.y;
  }

  void check_below(const SweepEvent& event, const Place& p) const {
    const Directed* highest = nullptr;
    for (const Directed& c : curves_) {
      if (lies_below(c, p) && (!highest || highest->height(p.x) < c.height(p.x))) highest = &c;
    }
    ASSERT_EQ(event.below.is_valid(), highest != nullptr);
    if (!highest) return;
    const Directed& below = curves_[event.below.value()];
    ASSERT_TRUE(lies_below(below, p));
    EXPECT_EQ(below.height(p.x), highest->height(p.x));
    EXPECT_TRUE(live_.contains(event.below)) << "the name of its bundle";
    check_nothing_between(below, p);
  }

  // Where several curves below meet at x, the one that is on top just left (or right) of it.
  void check_nothing_between(const Directed& below, const Place& p) const {
    for (const Directed& c : curves_) {
      if (!lies_below(c, p) || c.height(p.x) != below.height(p.x)) continue;
      EXPECT_GE(c.turn_to(below), 0) << "steeper curves are above by now";
    }
  }

  const EngineScene& engine_;
  SweepMembers members_;
  std::vector<Directed> curves_;
  std::set<std::uint32_t> used_;
  std::map<SegmentId, std::set<SegmentId>> live_;  // bundles between two events, by name
  std::vector<Place> seen_;
};

void expect_right(const CurveScene& scene, std::uint64_t seed) {
  SCOPED_TRACE(to_text(scene));
  const EngineScene engine = to_engine(scene, seed);
  Recorder recorder(scene, engine);
  Context context;
  sweep(engine.points, engine.curves, engine.isolated, recorder, context);
  const std::set<Place> expected = places_of(scene, scene.isolated);
  EXPECT_EQ(std::vector<Place>(expected.begin(), expected.end()) == recorder.seen(), true)
      << "events: " << recorder.seen().size() << ", not " << expected.size();
}

std::string name_of_kind(const ::testing::TestParamInfo<SceneKind>& tested) {
  static constexpr const char* kNames[] = {"Grid", "Concurrent", "Fractions", "Wild"};
  return kNames[static_cast<int>(tested.param)];
}

class SweepUnbounded : public ::testing::TestWithParam<SceneKind> {};

// Wide exponents make the oracle slow.
TEST_P(SweepUnbounded, MatchesBruteForce) {
  const bool is_wild = GetParam() == SceneKind::Wild;
  const std::uint64_t rounds = share_of(is_wild ? 40 : 500);
  for (std::uint64_t seed = 0; seed < rounds && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const std::uint32_t curves = 1 + static_cast<std::uint32_t>(seed) % (is_wild ? 6 : 12);
    expect_right(random_curves(GetParam(), curves, seed), seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SweepUnbounded, ::testing::ValuesIn(kSceneKinds), name_of_kind);

}  // namespace
}  // namespace plumb::testing::sweep_unbounded_test
