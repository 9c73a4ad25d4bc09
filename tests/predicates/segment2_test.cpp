// Segments against brute force in Boost cpp_int, as doubles and as rationals, and the identities
// the header promises. PLUMB_CASES=n: about n answers.
#include "plumb/predicates/segment2.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>

#include "float_environment.h"
#include "generate/test_share.h"
#include "plane_families.h"
#include "plane_oracle.h"
#include "plumb/predicates/rounding.h"

namespace plumb::segment2_test {
namespace {

// ---------------------------------------------------------------- brute force

/// Closed segment a-b of the oracle: is c on it, by the sign of a dot product?
bool is_on(const PlaneOracle& o, std::size_t a, std::size_t b, std::size_t c) {
  if (o.orient2d(a, b, c) != Sign::Zero) return false;
  const OraclePoint &p = o.point(a), &q = o.point(b), &r = o.point(c);
  return (p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y) <= 0;
}

bool are_equal(const PlaneOracle& o, std::size_t a, std::size_t b) {
  return o.point(a).x == o.point(b).x && o.point(a).y == o.point(b).y;
}

/// By which ends of 0-1 and 2-3 lie on the other, and by Cramer's parameters when none does.
SegmentRelation brute_relation(const PlaneOracle& o) {
  const std::array on_other = {is_on(o, 2, 3, 0), is_on(o, 2, 3, 1), is_on(o, 0, 1, 2),
                               is_on(o, 0, 1, 3)};
  const int of_first = on_other[0] + on_other[1], of_second = on_other[2] + on_other[3];
  const bool share =
      are_equal(o, 0, 2) || are_equal(o, 0, 3) || are_equal(o, 1, 2) || are_equal(o, 1, 3);
  if (of_first == 2 && of_second == 2) return SegmentRelation::Equal;
  if (of_second == 2) return SegmentRelation::Covers;
  if (of_first == 2) return SegmentRelation::IsCovered;
  if (of_first == 1 && of_second == 1) {
    return share ? SegmentRelation::ShareEndpoint : SegmentRelation::Overlap;
  }
  if (of_first == 1) return SegmentRelation::Touches;
  if (of_second == 1) return SegmentRelation::IsTouched;
  const OracleInteger den = o.cross(0, 1, 2, 3);
  if (den == 0) return SegmentRelation::Disjoint;
  const auto is_inside = [](const OracleInteger& num, const OracleInteger& of) {
    return of > 0 ? (num > 0 && num < of) : (num < 0 && num > of);
  };
  return is_inside(o.cross(0, 2, 2, 3), den) && is_inside(o.cross(0, 2, 0, 1), den)
             ? SegmentRelation::Cross
             : SegmentRelation::Disjoint;
}

LineRelation brute_line_relation(const PlaneOracle& o) {
  const int first = static_cast<int>(o.orient2d(0, 1, 2));
  const int second = static_cast<int>(o.orient2d(0, 1, 3));
  constexpr std::array kByBoth = {LineRelation::Right,   LineRelation::TouchesFromRight,
                                  LineRelation::Crosses, LineRelation::TouchesFromRight,
                                  LineRelation::Inside,  LineRelation::TouchesFromLeft,
                                  LineRelation::Crosses, LineRelation::TouchesFromLeft,
                                  LineRelation::Left};
  return kByBoth[static_cast<std::size_t>(3 * (first + 1) + second + 1)];
}

PlaceOnSegment brute_place(const PlaneOracle& o, std::size_t p) {
  if (are_equal(o, 0, p)) return PlaceOnSegment::Source;
  if (are_equal(o, 1, p)) return PlaceOnSegment::Target;
  return is_on(o, 0, 1, p) ? PlaceOnSegment::Inside : PlaceOnSegment::Off;
}

// ---------------------------------------------------------------- cases

struct Score {
  std::uint64_t asked = 0;
  std::uint64_t wrong = 0;
  std::array<std::uint64_t, 9> relations{};

  void check(bool right) {
    ++asked;
    wrong += !right;
  }
};

template <class Point>
void check_segments(const PlaneOracle& o, const std::vector<Point>& p, Score& score) {
  const BasicSegment2<Point> s{p[0], p[1]}, t{p[2], p[3]};
  const SegmentRelation expected = brute_relation(o);
  ++score.relations[static_cast<std::size_t>(expected)];
  score.check(relation(s, t) == expected);
  score.check(relation_to_line(s, t) == brute_line_relation(o));
  for (std::size_t i = 2; i < 8; ++i) score.check(place_on(s, p[i]) == brute_place(o, i));
  const auto m = meeting_point(s, t);
  score.check(m.has_value() == meet_in_a_point(expected));
  if (m && o.cross(0, 1, 2, 3) != 0) {
    const OraclePoint q = o.meet(0, 1, 2, 3);
    score.check(exact_text(m->x) == OracleRational(q.x, q.w).str() &&
                exact_text(m->y) == OracleRational(q.y, q.w).str());
  }
}

/// The points as doubles, when they are.
std::optional<std::vector<Point2>> as_doubles(const EightPoints& points) {
  std::vector<Point2> r;
  for (const RationalPoint2& p : points) {
    const RoundedDouble x = round_to_double(p.x), y = round_to_double(p.y);
    if (x.error != Sign::Zero || y.error != Sign::Zero) return std::nullopt;
    r.push_back({x.value, y.value});
  }
  return r;
}

/// Segments 0-1 and 2-3 of points that repeat: three in four cases have a point in common or all on
/// one line.
void make_degenerate(TestRandom& random, EightPoints& p) {
  const auto kind = random() % 4;
  if (kind == 0) p[2] = p[random() % 2];
  if (kind == 1) p[3] = {2 * p[1].x - p[0].x, 2 * p[1].y - p[0].y};
  if (kind != 2) return;
  for (std::size_t i = 2; i < 8; ++i) {
    const int m = static_cast<int>(random() % 5) - 1;
    p[i] = {p[0].x + m * (p[1].x - p[0].x) / 2, p[0].y + m * (p[1].y - p[0].y) / 2};
  }
}

void check_case(const EightPoints& points, Score& score, testing_environment::Setting mode) {
  if (points[0] == points[1] || points[2] == points[3]) return;
  const PlaneOracle oracle(points);
  const auto doubles = as_doubles(points);
  const testing_environment::Scope scope(mode);
  check_segments(oracle, points, score);
  if (doubles) check_segments(oracle, *doubles, score);
}

class Segment2Families : public ::testing::TestWithParam<PlaneFamily> {};

TEST_P(Segment2Families, NoWrongAnswer) {
  const std::uint64_t wanted = testing::case_count(200000) / plane_families().size();
  const auto modes = testing_environment::kSettings;
  TestRandom random(20250102);
  Score score;
  for (std::size_t round = 0; score.asked < wanted; ++round) {
    EightPoints points = GetParam().make(random);
    make_degenerate(random, points);
    check_case(points, score, modes[round % modes.size()]);
    ASSERT_EQ(score.wrong, 0u) << GetParam().name << ", seed 20250102, round " << round;
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, Segment2Families, ::testing::ValuesIn(plane_families()));

TEST(Segment2, EveryRelationOccurs) {
  TestRandom random(1);
  Score score;
  for (int i = 0; i < 3000; ++i) {
    EightPoints points = plane_families().front().make(random);
    make_degenerate(random, points);
    check_case(points, score, testing_environment::kSettings[0]);
  }
  for (const std::uint64_t n : score.relations) EXPECT_GT(n, 10u);
}

// ---------------------------------------------------------------- identities

Segment2 some_segment() {
  const auto coordinate = rc::gen::inRange(-3, 4);
  const auto s = *rc::gen::container<std::array<int, 4>>(coordinate);
  RC_PRE(s[0] != s[2] || s[1] != s[3]);
  return {{double(s[0]), double(s[1])}, {double(s[2]), double(s[3])}};
}

Segment2 reversed(const Segment2& s) { return {s.target, s.source}; }

TEST(Laws, RelationMirrorsAndForgetsDirections) {
  EXPECT_TRUE(rc::check([] {
    const Segment2 s = some_segment(), t = some_segment();
    RC_ASSERT(relation(s, t) == mirrored(relation(t, s)));
    RC_ASSERT(relation(s, t) == relation(reversed(s), t));
    RC_ASSERT(relation(s, t) == relation(s, reversed(t)));
    RC_ASSERT(relation(s, s) == SegmentRelation::Equal);
    RC_ASSERT(meeting_point(s, t) == meeting_point(reversed(t), s));
  }));
}

TEST(Laws, ReversalSwapsEndsAndSides) {
  EXPECT_TRUE(rc::check([] {
    const Segment2 s = some_segment(), t = some_segment();
    RC_ASSERT(place_on(s, s.source) == PlaceOnSegment::Source);
    RC_ASSERT(place_on(reversed(s), s.source) == PlaceOnSegment::Target);
    RC_ASSERT((place_on(s, t.source) == PlaceOnSegment::Inside) ==
              (place_on(reversed(s), t.source) == PlaceOnSegment::Inside));
    RC_ASSERT((relation_to_line(s, t) == LineRelation::Left) ==
              (relation_to_line(reversed(s), t) == LineRelation::Right));
    RC_ASSERT(relation_to_line(s, t) == relation_to_line(s, reversed(t)));
    RC_ASSERT(relation_to_line(s, s) == LineRelation::Inside);
  }));
}

TEST(Laws, OrderAlongFollowsTheParameter) {
  EXPECT_TRUE(rc::check([] {
    const Segment2 s = some_segment();
    const int m = *rc::gen::inRange(-5, 6), n = *rc::gen::inRange(-5, 6);
    const auto at = [&](int k) {
      return Point2{s.source.x + k * (s.target.x - s.source.x),
                    s.source.y + k * (s.target.y - s.source.y)};
    };
    RC_ASSERT(compare_along(s, at(m), at(n)) == sign_of(m - n));
    RC_ASSERT(compare_along(reversed(s), at(m), at(n)) == sign_of(n - m));
  }));
}

}  // namespace
}  // namespace plumb::segment2_test
