// Points and rays that users ask about, against the same questions in rational numbers.
#include "plumb/predicates/plane/query2.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <utility>
#include <vector>

#include "float_environment.h"
#include "plumb/predicates/rounding.h"
#include "testing/plumb/testing/dice.h"

namespace plumb::query2_test {

Rational cross(const RationalPoint2& u, const RationalPoint2& v) { return u.x * v.y - u.y * v.x; }
RationalPoint2 minus(const RationalPoint2& p, const RationalPoint2& q) {
  return {p.x - q.x, p.y - q.y};
}
Sign order(const RationalPoint2& p, const RationalPoint2& q) {
  return sign_of(p.x != q.x ? p.x.compare(q.x) : p.y.compare(q.y));
}
bool is_to_the_right(const RationalPoint2& d) { return d.x > 0 || (d.x == 0 && d.y > 0); }

/// Points with equal x, equal points and fractions next to doubles; the last ones are crossings.
PlanePoints random_points(testing::Dice& dice) {
  PlanePoints points;
  const auto coordinate = [&] {
    const Rational whole(dice.between(-2, 2), dice.between(1, 2));
    return dice.below(4) == 0 ? whole + Rational(dice.between(-1, 1), Integer(1) << 70) : whole;
  };
  for (int i = 0; i < 6; ++i) points.inputs.push_back(coordinate(), coordinate());
  for (const auto& [a, c] : {std::pair(0U, 2U), {0U, 4U}, {2U, 4U}}) {
    if (cross_sign(points.inputs, a, a + 1, c, c + 1) == Sign::Zero) continue;
    points.crossings.push_back(make_crossing(points.inputs, a, a + 1, c, c + 1));
  }
  return points;
}

std::vector<RationalPoint2> exact_points(const PlanePoints& points) {
  std::vector<RationalPoint2> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back(exact(points, i));
  return all;
}

TEST(Query2, APointIsADoubleOnlyIfBothCoordinatesAre) {
  const Rational third(1, 3), beyond(Integer(1) << 2000);
  EXPECT_TRUE(QueryPoint2(RationalPoint2{0.5, -7}).is_double());
  EXPECT_FALSE(QueryPoint2(RationalPoint2{third, 1}).is_double());
  EXPECT_FALSE(QueryPoint2(RationalPoint2{1, third}).is_double());
  EXPECT_EQ(QueryPoint2(RationalPoint2{third, 1}).approx(), (Point2{1.0 / 3, 1}));
  const QueryPoint2 far(RationalPoint2{beyond, -beyond});
  EXPECT_FALSE(far.is_double());
  EXPECT_EQ(far.approx(), (Point2{DBL_MAX, -DBL_MAX}));
  EXPECT_EQ(far.exact().x, beyond);
  EXPECT_EQ(QueryPoint2(Point2{0x1p-1074, 3}).exact().x, exact_rational(0x1p-1074));
}

/// Where doubles do not tell two numbers apart, the exact ones do.
TEST(Query2, PointsBeyondAndBetweenDoublesHaveAnOrder) {
  const Rational beyond(Integer(1) << 2000), third(1, 3), bit(1, Integer(1) << 200);
  for (const Rational& x : {beyond, third}) {
    PlanePoints points;
    points.inputs.push_back(x, 0);
    points.inputs.push_back(0, 0);
    for (const auto& [other, expected] :
         {std::pair(x, Sign::Zero), {x + bit, Sign::Negative}, {x - bit, Sign::Positive}}) {
      EXPECT_EQ(compare_x(points, 0, QueryPoint2(RationalPoint2{other, 1})), expected);
      const Sign by_y = expected == Sign::Zero ? Sign::Negative : expected;
      EXPECT_EQ(compare_xy(points, 0, QueryPoint2(RationalPoint2{other, 1})), by_y);
      EXPECT_EQ(compare_xy(points, 0, QueryPoint2(RationalPoint2{other, 0})), expected);
      EXPECT_EQ(orient2d(points, 1, 0, QueryPoint2(RationalPoint2{other, 0})), Sign::Zero);
      EXPECT_EQ(orient2d(points, 1, 0, QueryPoint2(RationalPoint2{other, bit})), Sign::Positive);
    }
  }
}

TEST(Query2, PointsLieWhereTheRationalsSay) {
  testing::Dice dice(1);
  for (int round = 0; round < 40; ++round) {
    const PlanePoints points = random_points(dice);
    const std::vector<RationalPoint2> at = exact_points(points);
    for (const RationalPoint2& p : at) {
      const QueryPoint2 q(p);
      for (std::uint32_t i = 0; i < at.size(); ++i) {
        EXPECT_EQ(compare_x(points, i, q), sign_of(at[i].x.compare(p.x)));
        EXPECT_EQ(compare_xy(points, i, q), order(at[i], p));
      }
      const Rational side = cross(minus(at[1], at[0]), minus(p, at[0]));
      EXPECT_EQ(orient2d(points, 0, 1, q), sign_of(side.sign()));
    }
  }
}

/// Directions of all eight kinds; points on the ray's line, lines through its origin.
TEST(Query2, RaysMeetLinesWhereTheRationalsSay) {
  testing::Dice dice(2);
  int on_line = 0, parallel = 0, through = 0;
  for (int round = 0; round < 300; ++round) {
    const PlanePoints points = random_points(dice);
    const std::vector<RationalPoint2> at = exact_points(points);
    const RationalPoint2& from = at[dice.below(at.size())];
    RationalPoint2 along = minus(at[dice.below(at.size())], from);
    if (dice.below(2) == 0) along = {dice.between(-1, 1), dice.between(-1, 1)};
    if (along.x == 0 && along.y == 0) continue;
    const QueryRay2 ray(from, along);
    EXPECT_EQ(ray.goes_right(), is_to_the_right(along));
    EXPECT_EQ(ray.is_vertical(), along.x == 0);
    EXPECT_TRUE(is_to_the_right(ray.direction().exact()));
    const RationalPoint2 d = is_to_the_right(along) ? along : RationalPoint2{-along.x, -along.y};
    for (std::uint32_t i = 0; i < at.size(); ++i) {
      const Sign expected = sign_of(cross(d, minus(at[i], from)).sign());
      EXPECT_EQ(side(points, ray, i), expected);
      on_line += expected == Sign::Zero ? 1 : 0;
    }
    for (const auto& [a, b] : {std::pair(0U, 1U), {3U, 2U}}) {
      const RationalPoint2 v = minus(at[b], at[a]);
      const Rational den = cross(v, d);
      EXPECT_EQ(turn(points, a, b, ray), sign_of(den.sign()));
      parallel += den == 0 ? 1 : 0;
      if (den == 0) continue;
      const Rational t = cross(minus(from, at[a]), d) / den;  // along a b
      const RationalPoint2 meeting{at[a].x + t * v.x, at[a].y + t * v.y};
      EXPECT_EQ(crossing(points, ray, a, b), meeting);
      for (std::uint32_t i = 0; i < at.size(); ++i) {
        EXPECT_EQ(compare_crossing_x(points, ray, a, b, i), sign_of(meeting.x.compare(at[i].x)));
        EXPECT_EQ(compare_crossing_xy(points, ray, a, b, i), order(meeting, at[i]));
        through += meeting == at[i] ? 1 : 0;
      }
    }
  }
  EXPECT_GT(on_line, 300);
  EXPECT_GT(parallel, 10);
  EXPECT_GT(through, 300);
}

/// Products that are far from zero though a factor is subnormal.
TEST(Query2, SubnormalDirectionsCountWhateverTheEnvironment) {
  const QueryRay2 ray({0, 0}, {exact_rational(0x1p-1030), exact_rational(0x1p-1000)});
  PlanePoints points;
  points.inputs.push_back({0x1p960, 0x1p1000});
  points.inputs.push_back({0, 0});
  for (const testing_environment::Setting& mode : testing_environment::kSettings) {
    const testing_environment::Scope scope(mode);
    // 2^-30 - 2^-40
    EXPECT_EQ(side(points, ray, 0), Sign::Positive) << mode.name;
    EXPECT_EQ(turn(points, 1, 0, ray), Sign::Negative) << mode.name;
  }
}

/// Rounded downward, the denominator 2^1041 becomes the greatest double, and its error stays
/// finite.
TEST(Query2, OverflowDecidesNothingWhateverTheEnvironment) {
  const QueryRay2 ray({0, 0}, {exact_rational(0x1p540), 0});
  PlanePoints points;
  points.inputs.push_back({-0x1p-608, -0x1p500});
  points.inputs.push_back({-0x1p-608, 0x1p500});
  points.inputs.push_back({-0x1p-600, 0});
  for (const testing_environment::Setting& mode : testing_environment::kSettings) {
    const testing_environment::Scope scope(mode);
    EXPECT_EQ(compare_crossing_x(points, ray, 0, 1, 2), Sign::Positive) << mode.name;
    EXPECT_EQ(compare_crossing_xy(points, ray, 0, 1, 2), Sign::Positive) << mode.name;
  }
}

}  // namespace plumb::query2_test
