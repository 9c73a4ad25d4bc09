// PlanePoints, QueryPoint2, QueryRay2 and RationalSum against exact rationals, in every
// floating-point mode.
#include "plumb/predicates/plane/plane_points.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "float_environment.h"
#include "generate/test_share.h"
#include "plane_families.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/plane/query2.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/segment2.h"

namespace plumb::plane_points_test {
namespace {

/// The eight points of a case and the crossings of its lines.
PlanePoints points_of(const EightPoints& given) {
  PlanePoints points;
  for (const RationalPoint2& p : given) points.inputs.push_back(p.x, p.y);
  for (std::uint32_t a = 0; a < 8; a += 2) {
    for (std::uint32_t c = a + 2; c < 8; c += 2) {
      if (cross_sign(points.inputs, a, a + 1, c, c + 1) == Sign::Zero) continue;
      points.crossings.push_back(make_crossing(points.inputs, a, a + 1, c, c + 1));
    }
  }
  return points;
}

void check_all(const PlanePoints& points, const std::vector<RationalPoint2>& truth) {
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    const QueryPoint2 q(truth[i]);
    for (std::uint32_t j = 0; j < n; ++j) {
      const Sign by_x = sign_of(truth[i].x.compare(truth[j].x));
      const Sign by_xy = compare_xy(truth[i], truth[j]);
      ASSERT_EQ(compare_x(points, i, j), by_x);
      ASSERT_EQ(compare_xy(points, i, j), by_xy);
      ASSERT_EQ(compare_x(points, j, q), -by_x);
      ASSERT_EQ(compare_xy(points, j, q), -by_xy);
    }
    const Sign side = orient2d(truth[0], truth[1], truth[i]);
    ASSERT_EQ(orient2d(points, 0, 1, i), side);
    ASSERT_EQ(orient2d(points, 0, 1, q), side);
  }
}

/// A ray from one point towards another, given by their numbers, and what the rationals say of it.
struct RayTruth {
  struct Line {
    std::uint32_t a, b;
    Sign turn;
    RationalPoint2 meeting;  // if turn is not Zero
  };

  RationalPoint2 origin, direction;
  std::vector<Sign> side;  // per point
  std::vector<Line> lines;
};

Rational cross(const RationalPoint2& p, const RationalPoint2& q, const RationalPoint2& r,
               const RationalPoint2& s) {
  return (q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x);
}

RayTruth ray_truth(const std::vector<RationalPoint2>& points, std::uint32_t from,
                   std::uint32_t to) {
  const RationalPoint2 &p = points[from], &q = points[to];
  RayTruth truth{p, {q.x - p.x, q.y - p.y}, {}, {}};
  const bool is_turned = compare_xy(p, q) == Sign::Positive;
  const auto turned = [&](const Rational& r) {
    const Sign s = sign_of(r.sign());
    return is_turned ? -s : s;
  };
  for (const RationalPoint2& r : points) truth.side.push_back(turned(cross(p, q, p, r)));
  for (const auto& [a, b] : {std::pair{0U, 1U}, {3U, 2U}, {4U, 5U}, {6U, 7U}}) {
    const Rational at_a = cross(p, q, p, points[a]);
    const Rational at_b = cross(p, q, p, points[b]);
    RayTruth::Line line{a, b, turned(at_a - at_b), {}};
    if (line.turn != Sign::Zero) {
      const Rational t = at_a / (at_a - at_b);
      line.meeting = {points[a].x + t * (points[b].x - points[a].x),
                      points[a].y + t * (points[b].y - points[a].y)};
    }
    truth.lines.push_back(line);
  }
  return truth;
}

std::vector<RayTruth> ray_truths(const std::vector<RationalPoint2>& points) {
  std::vector<RayTruth> truths;
  for (const auto& [from, to] : {std::pair{0U, 3U}, {5U, 2U}, {7U, 6U}}) {
    if (points[from] != points[to]) truths.push_back(ray_truth(points, from, to));
  }
  return truths;
}

void check_ray(const PlanePoints& points, const std::vector<RationalPoint2>& truth,
               const RayTruth& given) {
  const QueryRay2 ray(given.origin, given.direction);
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) ASSERT_EQ(side(points, ray, i), given.side[i]);
  for (const RayTruth::Line& line : given.lines) {
    ASSERT_EQ(turn(points, line.a, line.b, ray), line.turn);
    if (line.turn == Sign::Zero) continue;
    ASSERT_EQ(crossing(points, ray, line.a, line.b), line.meeting);
    for (std::uint32_t i = 0; i < n; ++i) {
      ASSERT_EQ(compare_crossing_x(points, ray, line.a, line.b, i),
                sign_of(line.meeting.x.compare(truth[i].x)));
      ASSERT_EQ(compare_crossing_xy(points, ray, line.a, line.b, i),
                compare_xy(line.meeting, truth[i]));
    }
  }
}

class PlanePointFamilies : public ::testing::TestWithParam<PlaneFamily> {};

TEST_P(PlanePointFamilies, OrderAndSidesAreThoseOfTheRationals) {
  TestRandom random(20261121);
  const std::uint64_t rounds = testing::case_count(10);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const EightPoints given = GetParam().make(random);
    const PlanePoints exact_points = points_of(given);
    std::vector<RationalPoint2> truth;
    for (std::uint32_t i = 0; i < exact_points.size(); ++i) truth.push_back(exact(exact_points, i));
    for (std::size_t i = 0; i < given.size(); ++i) ASSERT_EQ(truth[i], given[i]);
    const std::vector<RayTruth> rays = ray_truths(truth);
    for (const testing_environment::Setting& mode : testing_environment::kSettings) {
      const testing_environment::Scope scope(mode);
      const PlanePoints points = points_of(given);
      check_all(points, truth);
      for (const RayTruth& ray : rays) check_ray(points, truth, ray);
      if (HasFatalFailure()) FAIL() << GetParam().name << ", round " << round << ", " << mode.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, PlanePointFamilies, ::testing::ValuesIn(plane_families()));

TEST(PlanePoints, CrossingsAreNumberedAfterInputs) {
  PlanePoints points;
  for (const Point2 p : {Point2{0, 0}, Point2{2, 2}, Point2{0, 2}, Point2{2, 0}}) {
    points.inputs.push_back(p);
  }
  points.crossings.push_back(make_crossing(points.inputs, 0, 1, 2, 3));
  const PlanePointsView view = points;
  EXPECT_TRUE(view.is_input(3));
  EXPECT_FALSE(view.is_input(4));
  EXPECT_EQ(exact(view, 4), (RationalPoint2{1, 1}));
  EXPECT_EQ(compare_x(view, 4, 0), Sign::Positive);
}

/// Doubles and others, before and after the first that is none.
std::vector<RationalPoint2> mixed_points() {
  return {{1, 2}, {Rational(1, 3), 5}, {-4, 0}, {Rational(-7, 5), Rational(2, 9)}, {6, 6}};
}

PointTable2 table(const std::vector<RationalPoint2>& points) {
  PointTable2 t;
  for (const RationalPoint2& p : points) t.push_back(p.x, p.y);
  return t;
}

TEST(PlanePoints, ApproximationsAreThoseOfInputsAndCrossings) {
  PlanePoints points;
  for (const Point2 p : {Point2{0, 0}, {4, 4}, {0, 4}, {4, 0}}) points.inputs.push_back(p);
  points.crossings.push_back(make_crossing(points.inputs, 0, 1, 2, 3));
  EXPECT_EQ(approx(points, 1), (Point2{4, 4}));
  EXPECT_EQ(approx(points, 4), (Point2{2, 2}));
}

TEST(PointTable2, AppendKeepsBothTables) {
  const std::vector<std::vector<RationalPoint2>> tables = {{}, {{3, 4}, {5, 6}}, mixed_points()};
  for (const auto& first : tables) {
    for (const auto& second : tables) {
      PointTable2 t = table(first);
      t.append(table(second));
      ASSERT_EQ(t.size(), first.size() + second.size());
      for (std::uint32_t i = 0; i < t.size(); ++i) {
        EXPECT_EQ(t.exact(i), i < first.size() ? first[i] : second[i - first.size()]);
      }
    }
  }
}

TEST(PointTable2, SubsetKeepsTheChosenInOrder) {
  const std::vector<RationalPoint2> points = mixed_points();
  const PointTable2 t = table(points);
  for (unsigned chosen = 0; chosen < 32; ++chosen) {
    std::vector<std::uint8_t> keep;
    std::vector<RationalPoint2> kept;
    for (unsigned i = 0; i < 5; ++i) {
      keep.push_back((chosen >> i) & 1U);
      if (keep.back() != 0) kept.push_back(points[i]);
    }
    const PointTable2 s = t.subset(keep);
    ASSERT_EQ(s.size(), kept.size());
    for (std::uint32_t i = 0; i < s.size(); ++i) EXPECT_EQ(s.exact(i), kept[i]);
  }
}

TEST(RationalSum, IsTheSumWhateverTheNumberOfTerms) {
  Rational expected = 0;
  RationalSum sum;
  EXPECT_EQ(sum.total(), 0);
  for (int i = 1; i < 70; ++i) {
    const Rational term(i % 2 == 0 ? i : -i, 2 * i + 1);
    expected += term;
    sum.add(term);
    ASSERT_EQ(sum.total(), expected) << i << " terms";
  }
}

// Denominators without common factors, with small ones, with long ones, powers of 2, all the same.
TEST(RationalSum, OfFractionsIsTheSameInLowestTerms) {
  std::mt19937_64 random(7);
  std::size_t watched = 0;
  const auto watch = [&] { ++watched; };
  EXPECT_EQ(sum_of_fractions({}, watch), 0);
  for (int round = 0; round < 200; ++round) {
    std::vector<Rational> terms;
    RationalSum expected;
    const int count = 1 + static_cast<int>(random() % 40);
    for (int i = 0; i < count; ++i) {
      Integer below = 1 + random() % (round % 2 == 0 ? 40 : 1'000'000'007);
      if (round % 3 == 0) below *= below;
      if (round % 5 == 0) below <<= random() % 70;
      if (round % 7 == 0) below = 90;
      if (round % 4 == 0) below *= Integer(random() | 1U);
      const Integer above = Integer(random()) - Integer(std::uint64_t{1} << 63U);
      terms.emplace_back(above, below);
      expected.add(terms.back());
    }
    const Rational sum = sum_of_fractions(terms, watch);
    ASSERT_EQ(sum, expected.total()) << "round " << round;
    ASSERT_EQ(gcd(numerator(sum), denominator(sum)), 1) << "round " << round;
  }
  EXPECT_GT(watched, 0U);
}

}  // namespace
}  // namespace plumb::plane_points_test
