// PointTable2 and Crossing2 against Boost cpp_int, every rung, in every floating-point mode.
// PLUMB_CASES=n: about n predicate answers instead of the short run.
#include "plumb/predicates/point_table2.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "float_environment.h"
#include "generate/test_share.h"
#include "plane_families.h"
#include "plane_oracle.h"
#include "plumb/predicates/rounding.h"

namespace plumb::point_table2_test {
namespace {

/// What the predicates below must answer for one set of eight points.
struct Answers {
  Sign compare01 = Sign::Zero, compare45 = Sign::Zero, orient012 = Sign::Zero;
  Sign orient456 = Sign::Zero, cross0123 = Sign::Zero;
  Sign first_against_4 = Sign::Zero, first_against_0 = Sign::Zero;
  Sign first_against_second = Sign::Zero, first_at_45 = Sign::Zero, second_at_01 = Sign::Zero;
  std::optional<OraclePoint> first = {}, second = {};  ///< crossings 01 x 23 and 45 x 67
};

Answers ask(const PlaneOracle& o) {
  Answers a;
  a.compare01 = compare_xy(o.point(0), o.point(1));
  a.compare45 = compare_xy(o.point(4), o.point(5));
  a.orient012 = o.orient2d(0, 1, 2);
  a.orient456 = o.orient2d(4, 5, 6);
  a.cross0123 = sign_of(o.cross(0, 1, 2, 3));
  if (a.cross0123 != Sign::Zero) a.first = o.meet(0, 1, 2, 3);
  if (o.cross(4, 5, 6, 7) != 0) a.second = o.meet(4, 5, 6, 7);
  if (a.first) {
    a.first_against_4 = compare_xy(*a.first, o.point(4));
    a.first_against_0 = compare_xy(*a.first, o.point(0));
    if (a.compare45 != Sign::Zero) a.first_at_45 = o.orient2d(4, 5, *a.first);
  }
  if (a.second && a.compare01 != Sign::Zero) a.second_at_01 = o.orient2d(0, 1, *a.second);
  if (a.first && a.second) a.first_against_second = compare_xy(*a.first, *a.second);
  return a;
}

PointTable2 table(const EightPoints& points) {
  PointTable2 t;
  for (const RationalPoint2& p : points) t.push_back(p.x, p.y);
  return t;
}

/// Counts answers and the wrong ones among them.
struct Score {
  std::uint64_t asked = 0;
  std::uint64_t wrong = 0;
  std::uint64_t by_filter = 0;
  std::uint64_t by_exact = 0;

  void check(Sign expected, Sign full, FilteredSign filter, FilteredSign exact, Sign big) {
    ++asked;
    by_filter += is_decided(filter);
    by_exact += is_decided(exact);
    const bool right = full == expected && big == expected &&
                       (!is_decided(filter) || decided(filter) == expected) &&
                       (!is_decided(exact) || decided(exact) == expected);
    wrong += !right;
  }
};

void check_points(const PointTable2& t, const Answers& a, Score& score) {
  constexpr FilteredSign kNone = FilteredSign::Unsure;
  score.check(a.compare01, compare_xy(t, 0, 1), rung::compare_xy_filter(t, 0, 1), kNone,
              rung::compare_xy_big(t, 0, 1));
  score.check(a.compare45, compare_xy(t, 4, 5), rung::compare_xy_filter(t, 4, 5), kNone,
              rung::compare_xy_big(t, 4, 5));
  score.check(a.orient012, orient2d(t, 0, 1, 2), rung::orient2d_filter(t, 0, 1, 2), kNone,
              rung::orient2d_big(t, 0, 1, 2));
  score.check(a.orient456, orient2d(t, 4, 5, 6), rung::orient2d_filter(t, 4, 5, 6), kNone,
              rung::orient2d_big(t, 4, 5, 6));
  score.check(a.cross0123, cross_sign(t, 0, 1, 2, 3), rung::cross_sign_filter(t, 0, 1, 2, 3), kNone,
              rung::cross_sign_big(t, 0, 1, 2, 3));
}

void check_against_point(const PointTable2& t, const Crossing2& p, std::uint32_t i, Sign expected,
                         Score& score) {
  score.check(expected, compare_xy(t, p, i), rung::compare_xy_filter(t, p, i),
              rung::compare_xy_exact(t, p, i), rung::compare_xy_big(t, p, i));
}

void check_side(const PointTable2& t, std::uint32_t i, std::uint32_t j, const Crossing2& p,
                Sign expected, Score& score) {
  score.check(expected, orient2d(t, i, j, p), rung::orient2d_filter(t, i, j, p),
              rung::orient2d_exact(t, i, j, p), rung::orient2d_big(t, i, j, p));
}

void check_crossings(const PointTable2& t, const Answers& a, Score& score) {
  if (a.first) {
    const Crossing2 p = make_crossing(t, 0, 1, 2, 3);
    check_against_point(t, p, 4, a.first_against_4, score);
    check_against_point(t, p, 0, a.first_against_0, score);
    if (a.compare45 != Sign::Zero) check_side(t, 4, 5, p, a.first_at_45, score);
  }
  if (a.second && a.compare01 != Sign::Zero) {
    check_side(t, 0, 1, make_crossing(t, 4, 5, 6, 7), a.second_at_01, score);
  }
  if (a.first && a.second) {
    const Crossing2 p = make_crossing(t, 0, 1, 2, 3), q = make_crossing(t, 4, 5, 6, 7);
    score.check(a.first_against_second, compare_xy(t, p, q), rung::compare_xy_filter(p, q),
                rung::compare_xy_exact(t, p, q), rung::compare_xy_big(t, p, q));
  }
}

/// Is the crossing within its radius, exactly?
void check_box(const PointTable2& t, const Crossing2& p, Score& score) {
  ++score.asked;
  if (std::isinf(p.radius)) return;
  const RationalPoint2 e = exact(t, p);
  const Rational r = exact_rational(p.radius);
  score.wrong += abs(e.x - exact_rational(p.x)) > r || abs(e.y - exact_rational(p.y)) > r;
}

void check_text(const RationalPoint2& p, const OraclePoint& o, Score& score) {
  ++score.asked;
  score.wrong += exact_text(p.x) != OracleRational(o.x, o.w).str() ||
                 exact_text(p.y) != OracleRational(o.y, o.w).str();
}

void check_exact_points(const PointTable2& t, const EightPoints& points, const Answers& a,
                        Score& score) {
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    ++score.asked;
    const Point2 near = t.approx(i);
    const bool is_double =
        exact_rational(near.x) == points[i].x && exact_rational(near.y) == points[i].y;
    score.wrong += t.exact(i) != points[i] || t.is_double(i) != is_double;
  }
  if (a.first) check_text(exact(t, make_crossing(t, 0, 1, 2, 3)), *a.first, score);
}

/// Everything about one set of points; in all modes if asked, else in the default mode.
void check_case(const EightPoints& points, bool in_all_modes, Score& score) {
  const Answers answers = ask(PlaneOracle(points));
  const PointTable2 t = table(points);
  for (const testing_environment::Setting mode : testing_environment::kSettings) {
    Crossing2 p{};
    {
      const testing_environment::Scope scope(mode);
      check_points(t, answers, score);
      check_crossings(t, answers, score);
      if (answers.first) p = make_crossing(t, 0, 1, 2, 3);
    }
    if (answers.first) check_box(t, p, score);
    if (!in_all_modes) break;
  }
  if (in_all_modes) check_exact_points(t, points, answers, score);
}

class PointTable2Families : public ::testing::TestWithParam<PlaneFamily> {};

TEST_P(PointTable2Families, NoWrongAnswerOnAnyRung) {
  const std::uint64_t wanted = testing::case_count(600000) / plane_families().size();
  TestRandom random(20250101);
  Score score;
  for (int round = 0; score.asked < wanted; ++round) {
    check_case(GetParam().make(random), round % 4 == 0, score);
    ASSERT_EQ(score.wrong, 0u) << GetParam().name << ", seed 20250101, round " << round;
  }
  std::printf("%-36s asked %9lu  wrong %lu  filter %9lu  exact %9lu\n", GetParam().name.c_str(),
              score.asked, score.wrong, score.by_filter, score.by_exact);
}

INSTANTIATE_TEST_SUITE_P(Plane, PointTable2Families, ::testing::ValuesIn(plane_families()));

/// A rung that never answers would pass the test above.
TEST(Rungs, AnswerWhereTheyShould) {
  TestRandom random(7);
  Score generic, near;
  for (int i = 0; i < 200; ++i) {
    check_case(plane_families()[2].make(random), false, generic);
    check_case(plane_families()[4].make(random), false, near);
  }
  EXPECT_GT(generic.by_filter, generic.asked * 8 / 10);
  EXPECT_GT(near.by_exact, near.asked * 4 / 10);
}

TEST(PointTable2, NegativeZeroIsZero) {
  PointTable2 t;
  t.push_back({-0.0, 0.0});
  EXPECT_FALSE(std::signbit(t.approx(0).x));
}

TEST(PointTable2, ClampsWhatNoDoubleReaches) {
  constexpr double kMax = std::numeric_limits<double>::max();
  PointTable2 t;
  t.push_back(Rational(-(Integer(1) << 2000)), Rational(1, Integer(1) << 2000));
  t.push_back({-kMax, 0.0});
  EXPECT_EQ(t.approx(0), (Point2{-kMax, 0.0}));
  EXPECT_FALSE(t.is_double(0));
  EXPECT_TRUE(t.is_double(1));
  EXPECT_EQ(compare_xy(t, 0, 1), Sign::Negative);
}

TEST(PointTable2, ExactDoublesStayDoubles) {
  PointTable2 t;
  t.push_back(Rational(1, 4), Rational(Integer(1) << 1000));
  EXPECT_TRUE(t.all_double());
}

// ---------------------------------------------------------------- laws

using Coordinates = std::array<std::pair<int, int>, 8>;

/// Few values: coincidences are the rule. Every third point is a fraction.
PointTable2 law_table(const Coordinates& coordinates) {
  PointTable2 t;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const int w = i % 3 == 2 ? 3 : 1;
    t.push_back(Rational(coordinates[i].first, w), Rational(coordinates[i].second, w));
  }
  return t;
}

Coordinates some_coordinates() {
  const auto one = rc::gen::inRange(-4, 5);
  return *rc::gen::container<Coordinates>(rc::gen::pair(one, one));
}

/// All crossings of the lines 01, 23, 45, 67.
std::vector<Crossing2> crossings(const PointTable2& t) {
  std::vector<Crossing2> r;
  for (std::uint32_t a = 0; a < 8; a += 2) {
    for (std::uint32_t c = a + 2; c < 8; c += 2) {
      if (cross_sign(t, a, a + 1, c, c + 1) == Sign::Zero) continue;
      r.push_back(make_crossing(t, a, a + 1, c, c + 1));
    }
  }
  return r;
}

TEST(Laws, SwapsFlipAndShiftsKeep) {
  EXPECT_TRUE(rc::check([] {
    const PointTable2 t = law_table(some_coordinates());
    RC_ASSERT(compare_xy(t, 0, 1) == -compare_xy(t, 1, 0));
    RC_ASSERT(orient2d(t, 0, 1, 2) == -orient2d(t, 1, 0, 2));
    RC_ASSERT(orient2d(t, 0, 1, 2) == orient2d(t, 1, 2, 0));
    RC_ASSERT(cross_sign(t, 0, 1, 2, 3) == -cross_sign(t, 2, 3, 0, 1));
    RC_ASSERT(cross_sign(t, 0, 1, 0, 2) == orient2d(t, 0, 1, 2));
  }));
}

TEST(Laws, CrossingsAreTotallyOrdered) {
  EXPECT_TRUE(rc::check([] {
    const PointTable2 t = law_table(some_coordinates());
    std::vector<Crossing2> c = crossings(t);
    std::sort(c.begin(), c.end(), [&](const Crossing2& p, const Crossing2& q) {
      return compare_xy(t, p, q) == Sign::Negative;
    });
    for (std::size_t i = 0; i < c.size(); ++i) {
      RC_ASSERT(compare_xy(t, c[i], c[i]) == Sign::Zero);
      for (std::size_t j = i + 1; j < c.size(); ++j) {
        RC_ASSERT(compare_xy(t, c[i], c[j]) != Sign::Positive);
        RC_ASSERT(compare_xy(t, c[i], c[j]) == -compare_xy(t, c[j], c[i]));
      }
    }
  }));
}

TEST(Laws, CrossingsOrderWithPoints) {
  EXPECT_TRUE(rc::check([] {
    const PointTable2 t = law_table(some_coordinates());
    for (const Crossing2& p : crossings(t)) {
      for (const Crossing2& q : crossings(t)) {
        for (std::uint32_t i = 0; i < 8; ++i) {
          const bool between =
              compare_xy(t, p, i) == Sign::Negative && compare_xy(t, q, i) == Sign::Positive;
          RC_ASSERT(!between || compare_xy(t, p, q) == Sign::Negative);
        }
      }
    }
  }));
}

/// The same lines by other points and in another order make the same point.
TEST(Laws, OneCrossingHasManyNames) {
  EXPECT_TRUE(rc::check([] {
    const Coordinates coordinates = some_coordinates();
    PointTable2 t = law_table(coordinates);
    for (std::uint32_t i = 0; i < 8; ++i) {
      const RationalPoint2 p = t.exact(i);
      t.push_back(p.x, p.y);
    }
    for (const Crossing2& p : crossings(t)) {
      const Crossing2 q = make_crossing(t, p.d + 8, p.c + 8, p.a + 8, p.b + 8);
      RC_ASSERT(compare_xy(t, p, q) == Sign::Zero);
      RC_ASSERT(exact(t, p) == exact(t, q));
      RC_ASSERT(orient2d(t, p.a + 8, p.b + 8, p) == Sign::Zero);
      for (const auto& [i, j] : {std::pair(p.a, p.b), {p.b, p.a}, {p.c, p.d}, {p.d, p.c}}) {
        RC_ASSERT(orient2d(t, i, j, p) == Sign::Zero);
      }
    }
  }));
}

/// Lines that begin in the same points are not the same lines.
TEST(Laws, OrderAgreesWithCoordinates) {
  EXPECT_TRUE(rc::check([] {
    const PointTable2 t = law_table(some_coordinates());
    RC_PRE(cross_sign(t, 0, 1, 2, 3) != Sign::Zero);
    const Crossing2 p = make_crossing(t, 0, 1, 2, 3);
    const RationalPoint2 at = exact(t, p);
    for (std::uint32_t i = 4; i < 8; ++i) {
      for (const auto& [a, b, c, d] :
           {std::array{0U, 1U, 2U, i}, {0U, 1U, i, 3U}, {0U, i, 2U, 3U}, {i, 1U, 2U, 3U}}) {
        if (cross_sign(t, a, b, c, d) == Sign::Zero) continue;
        const Crossing2 q = make_crossing(t, a, b, c, d);
        const RationalPoint2 other = exact(t, q);
        const int x = at.x.compare(other.x);
        RC_ASSERT(compare_xy(t, p, q) == sign_of(x != 0 ? x : at.y.compare(other.y)));
      }
      for (const std::uint32_t end : {0U, 1U, 2U, 3U}) {
        const RationalPoint2 u = t.exact(end), v = t.exact(i);
        const Rational turn = (v.x - u.x) * (at.y - u.y) - (v.y - u.y) * (at.x - u.x);
        if (u != v) RC_ASSERT(orient2d(t, end, i, p) == sign_of(turn.sign()));
      }
    }
  }));
}

/// What takes long numbers does not change what follows.
TEST(Laws, LongNumbersLeaveNoTrace) {
  const Rational big(Integer(1) << 3000), little(1, Integer(1) << 3000);
  PointTable2 t;
  t.push_back(-big, little);
  t.push_back(big, -little);
  t.push_back(little, -big);
  t.push_back(little * 2, big);
  for (const Point2& p : {Point2{0, 0}, {3, 1}, {0, 1}, {3, 0}}) t.push_back(p);
  const Crossing2 p = make_crossing(t, 0, 1, 2, 3), q = make_crossing(t, 4, 5, 6, 7);
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(rung::compare_xy_big(t, p, 5), Sign::Negative);
    EXPECT_EQ(rung::compare_xy_big(t, q, 5), Sign::Negative);
    EXPECT_EQ(rung::compare_xy_big(t, p, q), Sign::Negative);
    EXPECT_EQ(rung::orient2d_big(t, 4, 5, q), Sign::Zero);
  }
}

TEST(Laws, LinesThroughAPointCrossThere) {
  EXPECT_TRUE(rc::check([] {
    const PointTable2 t = law_table(some_coordinates());
    RC_PRE(orient2d(t, 0, 1, 2) != Sign::Zero);
    const Crossing2 p = make_crossing(t, 0, 1, 2, 0);
    RC_ASSERT(compare_xy(t, p, 0) == Sign::Zero);
    for (std::uint32_t i = 3; i < 8; ++i) {
      RC_ASSERT(compare_xy(t, p, i) == compare_xy(t, 0, i));
      if (compare_xy(t, i, 1) != Sign::Zero) {
        RC_ASSERT(orient2d(t, i, 1, p) == orient2d(t, i, 1, 0));
      }
    }
  }));
}

}  // namespace
}  // namespace plumb::point_table2_test
