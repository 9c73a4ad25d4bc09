// Ranks of points, and how curves lie and meet, against rationals; the members of bundles against
// all curves at each place. Points coincide, and many curves lie on one line.
#include "plumb/plane/sweep/sweep_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::sweep_curves_test {

constexpr std::uint32_t kNoEnd = SweepCurve::kUnbounded;

bool less(const RationalPoint2& p, const RationalPoint2& q) {
  return p.x != q.x ? p.x < q.x : p.y < q.y;
}
Rational turn(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Doubles, and with them thirds if `has_thirds`.
PointTable2 random_points(testing::Dice& dice, std::size_t count, bool has_thirds) {
  PointTable2 points;
  while (points.size() < count) {
    const Rational x = dice.between(0, 3), y = dice.between(-2, 2);
    const Rational by = has_thirds && dice.below(2) == 0 ? 3 : 1;
    points.push_back(x / by, y / by);
  }
  return points;
}

void expect_ranks(const PlanePoints& points, testing::Dice& dice) {
  std::vector<char> used;
  std::vector<RationalPoint2> place;
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    used.push_back(dice.below(4) != 0 ? 1 : 0);
    place.push_back(exact(points, i));
    if (used[i] != 0) order.push_back(i);
  }
  std::ranges::stable_sort(
      order, [&](std::uint32_t i, std::uint32_t j) { return less(place[i], place[j]); });
  const PointRanks ranks = rank_points(points, used);
  EXPECT_EQ(ranks.order, order);
  ASSERT_EQ(ranks.rank.size(), points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto first = std::ranges::find_if(order, [&](auto j) { return place[j] == place[i]; });
    const auto expected = static_cast<std::uint32_t>(first - order.begin());
    EXPECT_EQ(ranks.rank[i], used[i] != 0 ? expected : PointRanks::kUnused);
  }
}

TEST(SweepCurves, RanksAreThoseOfExactPlaces) {
  testing::Dice dice(1);
  for (int round = 0; round < 150; ++round) {
    PlanePoints points{random_points(dice, 12, round % 3 != 0), {}};
    const Rational tiny = Rational(1) / 1000000 / 1000000 / 1000000;  // lost in doubles beside 1
    for (int i = round % 3 == 1 ? 8 : 0; i > 0; --i) {
      points.inputs.push_back(1 + tiny * dice.between(-1, 1), 1 + tiny * dice.between(-1, 1));
    }
    for (int i = round % 2 == 0 ? 8 : 0; i > 0; --i) {
      const auto any = [&] { return dice.below(points.inputs.size()); };
      const std::uint32_t a = any(), b = any(), c = any(), d = any();
      if (cross_sign(points.inputs, a, b, c, d) == Sign::Zero) continue;
      points.crossings.push_back(make_crossing(points.inputs, a, b, c, d));
    }
    expect_ranks(points, dice);
  }
}

/// A curve in rationals.
struct Exact {
  RationalPoint2 a, b;  ///< to the right, or upward
  std::optional<RationalPoint2> left, right;

  bool contains(const RationalPoint2& p) const {
    return turn(a, b, p) == 0 && (!left || !less(p, *left)) && (!right || !less(*right, p));
  }
};

struct Scene {
  PointTable2 points;
  std::vector<SweepCurve> given;
  std::vector<Exact> exact;

  explicit Scene(testing::Dice& dice) : points(random_points(dice, 8, true)) {
    while (given.size() < 8) {
      const std::uint32_t a = dice.below(points.size()), b = dice.below(points.size());
      if (compare_xy(points, a, b) == Sign::Zero) continue;
      const std::uint32_t kind = dice.below(6);
      given.push_back(
          {kind == 0 || kind == 1 ? kNoEnd : a, kind == 0 || kind == 2 ? kNoEnd : b, a, b});
      const SweepCurve& c = given.back();
      const RationalPoint2 p = points.exact(a), q = points.exact(b);
      const std::optional<RationalPoint2> from = c.from == kNoEnd ? std::nullopt : std::optional(p),
                                          to = c.to == kNoEnd ? std::nullopt : std::optional(q);
      exact.push_back(less(p, q) ? Exact{p, q, from, to} : Exact{q, p, to, from});
    }
  }
};

TEST(SweepCurves, RunFromLeftToRight) {
  testing::Dice dice(2);
  for (int round = 0; round < 100; ++round) {
    const Scene scene(dice);
    const SweepCurves curves(scene.points, scene.given, {});
    for (std::size_t i = 0; i < scene.given.size(); ++i) {
      const Exact& e = scene.exact[i];
      const SweepCurves::Curve& c = curves[SegmentId(i)];
      EXPECT_EQ(c.has_left(), e.left.has_value());
      EXPECT_EQ(c.has_right(), e.right.has_value());
      EXPECT_EQ(scene.points.exact(c.a), e.a);
      EXPECT_EQ(scene.points.exact(c.b), e.b);
      if (c.has_left()) {
        EXPECT_EQ(scene.points.exact(c.left), *e.left);
      }
      if (c.has_right()) {
        EXPECT_EQ(scene.points.exact(c.right), *e.right);
      }
      EXPECT_EQ(curves.is_vertical(SegmentId(i)), e.a.x == e.b.x);
      EXPECT_FALSE(curves.is_zero_length(SegmentId(i)));
    }
  }
}

/// Any two curves that do not meet left of a place where both are, one of them above there.
TEST(SweepCurves, MeetWhereTheirLinesCross) {
  testing::Dice dice(3);
  int crossings = 0, ends = 0, none = 0;
  for (int round = 0; round < 300; ++round) {
    const Scene scene(dice);
    const SweepCurves curves(scene.points, scene.given, {});
    for (std::size_t i = 0; i < scene.exact.size(); ++i) {
      for (std::size_t j = 0; j < scene.exact.size(); ++j) {
        const Exact &l = scene.exact[i], &u = scene.exact[j];
        const Rational parallel =
            (l.b.x - l.a.x) * (u.b.y - u.a.y) - (l.b.y - l.a.y) * (u.b.x - u.a.x);
        if (i == j || parallel == 0 || l.a.x == l.b.x || u.a.x == u.b.x) continue;
        const RationalPoint2 at = exact(scene.points, curves.crossing(SegmentId(i), SegmentId(j)));
        EXPECT_TRUE(turn(l.a, l.b, at) == 0 && turn(u.a, u.b, at) == 0);
        // The last left end, or a place left of everything; there u has to be above l.
        Rational x = std::min(at.x, Rational(0)) - 9;
        for (const Exact* e : {&l, &u}) {
          if (e->left) x = std::max(x, e->left->x);
        }
        const auto height = [&](const Exact& e) {
          return e.a.y + (x - e.a.x) * (e.b.y - e.a.y) / (e.b.x - e.a.x);
        };
        const auto reaches = [&](const Exact& e) { return !e.right || e.right->x > x; };
        if (!reaches(l) || !reaches(u) || height(l) >= height(u)) continue;
        const SweepCurves::NextMeeting found = curves.next_meeting(SegmentId(i), SegmentId(j));
        using Meeting = SweepCurves::Meeting;
        const bool do_meet = l.contains(at) && u.contains(at);
        const bool is_end_of_l = l.right && *l.right == at, is_end_of_u = u.right && *u.right == at;
        const bool is_seen = do_meet && !(is_end_of_l && is_end_of_u);
        const Meeting expected = !is_seen                     ? Meeting::None
                                 : is_end_of_l || is_end_of_u ? Meeting::AtEnd
                                                              : Meeting::Crossing;
        EXPECT_EQ(found.kind, expected);
        if (expected == Meeting::AtEnd) {
          EXPECT_EQ(scene.points.exact(found.end), at);
        }
        (expected == Meeting::None ? none : expected == Meeting::AtEnd ? ends : crossings)++;
        EXPECT_EQ(curves.direction_order(SegmentId(i), SegmentId(j)), sign_of(parallel));
        if (l.left || u.left) continue;
        EXPECT_EQ(curves.order_at_left_infinity(SegmentId(i), SegmentId(j)), Sign::Positive);
        EXPECT_EQ(curves.order_at_left_infinity(SegmentId(j), SegmentId(i)), Sign::Negative);
      }
    }
  }
  EXPECT_TRUE(crossings > 50 && ends > 50 && none > 50);
}

/// Asks the members of every place for all curves through it.
class MemberCheck final : public SweepVisitor {
 public:
  explicit MemberCheck(const Scene& scene) : scene_(scene), members_(scene.given.size()) {}

  bool on_event(const SweepEvent& event) override {
    members_.update(event);
    if (event.place != SweepPlace::Point) return true;
    ++events;
    const RationalPoint2 p = event.points.empty() ? exact(scene_.points, *event.crossing)
                                                  : scene_.points.exact(event.points.front());
    std::multiset<SegmentId> incoming, outgoing;
    for (std::size_t i = 0; i < scene_.exact.size(); ++i) {
      const Exact& e = scene_.exact[i];
      if (!e.contains(p)) continue;
      if (!e.left || less(*e.left, p)) incoming.insert(SegmentId(i));
      if (!e.right || less(p, *e.right)) outgoing.insert(SegmentId(i));
    }
    expect_members(members_.incoming(), event.incoming.size(), incoming);
    expect_members(members_.outgoing(), event.outgoing.size(), outgoing);
    return true;
  }
  int events = 0;

 private:
  void expect_members(std::span<const SweepIncidence> found, std::size_t bundles,
                      const std::multiset<SegmentId>& expected) {
    std::multiset<SegmentId> all;
    for (std::size_t k = 0; k < found.size(); ++k) {
      all.insert(found[k].segment);
      const std::uint32_t before = k == 0 ? 0 : found[k - 1].bundle;
      EXPECT_TRUE(found[k].bundle == before || (k > 0 && found[k].bundle == before + 1));
      const Exact &e = scene_.exact[found[k].segment.value()],
                  &f = scene_.exact[found[k == 0 ? 0 : k - 1].segment.value()];
      EXPECT_EQ(turn({0, 0}, {e.b.x - e.a.x, e.b.y - e.a.y}, {f.b.x - f.a.x, f.b.y - f.a.y}) == 0,
                found[k].bundle == before);
    }
    EXPECT_EQ(found.empty() ? 0 : found.back().bundle + 1, bundles);
    EXPECT_EQ(all, expected);
  }

  const Scene& scene_;
  SweepMembers members_;
};

TEST(SweepCurves, MembersAreAllCurvesAtAPlace) {
  testing::Dice dice(4);
  for (int round = 0; round < 100; ++round) {
    const Scene scene(dice);
    MemberCheck check(scene);
    sweep(scene.points, scene.given, {}, check, unlimited_context());
    EXPECT_GT(check.events, 0);
  }
}

}  // namespace plumb::sweep_curves_test
