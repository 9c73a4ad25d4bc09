// PlanePoints, QueryPoint2 and RationalSum against exact rationals, in every floating-point mode.
#include "plumb/predicates/plane_points.h"

#include <gtest/gtest.h>

#include "float_environment.h"
#include "plane_families.h"
#include "plumb/predicates/query_point2.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rational_sum.h"
#include "plumb/predicates/segment2.h"

namespace plumb {
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

class Families : public testing::TestWithParam<PlaneFamily> {};

TEST_P(Families, OrderAndSidesAreThoseOfTheRationals) {
  TestRandom random(20261121);
  const std::uint64_t rounds = case_count(10);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const EightPoints given = GetParam().make(random);
    const PlanePoints exact_points = points_of(given);
    std::vector<RationalPoint2> truth;
    for (std::uint32_t i = 0; i < exact_points.size(); ++i) truth.push_back(exact(exact_points, i));
    for (std::size_t i = 0; i < given.size(); ++i) ASSERT_EQ(truth[i], given[i]);
    for (const testing_environment::Setting& mode : testing_environment::kSettings) {
      const testing_environment::Scope scope(mode);
      check_all(points_of(given), truth);
      if (HasFatalFailure()) FAIL() << GetParam().name << ", round " << round << ", " << mode.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Plane, Families, testing::ValuesIn(plane_families()));

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

}  // namespace
}  // namespace plumb
