// The predicates on rationals: equal to those on doubles where both apply, and right on fractions.
#include "plumb/predicates/rational_predicates.h"

#include <gtest/gtest.h>

#include "plumb/predicates/input_predicates.h"
#include "predicate_cases.h"
#include "predicate_oracle.h"

namespace plumb::test::rational_predicates_test {
namespace {

RationalPoint2 rational(const std::array<double, 2>& p) { return {Rational(p[0]), Rational(p[1])}; }
RationalPoint3 rational(const std::array<double, 3>& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}

template <std::size_t N, std::size_t D, class Predicate>
void check(Predicate predicate) {
  Cases<N, D> cases(11);
  for (int i = 0; i < 2000; ++i) {
    const auto t = cases.make(static_cast<Family>(i % static_cast<int>(Family::kCount)));
    const Sign sign = std::apply([&](const auto&... p) { return predicate(rational(p)...); }, t);
    ASSERT_EQ(static_cast<int>(sign), oracle_sign(t)) << i;
  }
}

TEST(RationalPredicates, AgreeWithTheOracleOnDoubles) {
  check<3, 2>([](const auto&... p) { return orient2d(p...); });
  check<4, 3>([](const auto&... p) { return orient3d(p...); });
  check<4, 2>([](const auto&... p) { return incircle(p...); });
  check<5, 3>([](const auto&... p) { return insphere(p...); });
}

/// As on doubles, which have an oracle of their own; no end is the origin here.
TEST(RationalPredicates, CrossSignIsThatOfDoubles) {
  Cases<3, 2> cases(12);
  for (int i = 0; i < 2000; ++i) {
    const auto family = static_cast<Family>(i % static_cast<int>(Family::kCount));
    const auto s = cases.make(family);
    const auto t = cases.make(family);
    const auto& end = i % 2 == 0 ? s[2] : t[1];
    ASSERT_EQ(cross_sign(rational(s[0]), rational(s[1]), rational(t[0]), rational(end)),
              cross_sign(Point2{s[0][0], s[0][1]}, Point2{s[1][0], s[1][1]},
                         Point2{t[0][0], t[0][1]}, Point2{end[0], end[1]}))
        << i;
  }
}

Rational third(int n) { return {n, 3}; }

TEST(RationalPredicates, AreExactOnFractions) {
  const RationalPoint2 o{0, 0}, a{third(1), {1, 7}}, b{third(2), {2, 7}};
  const Rational tiny(Integer(1), Integer(1) << 5000);
  EXPECT_EQ(orient2d(o, a, b), Sign::Zero);
  EXPECT_EQ(orient2d(o, a, {b.x, b.y + tiny}), Sign::Positive);
  EXPECT_EQ(orient2d(o, a, {b.x, b.y - tiny}), Sign::Negative);
  EXPECT_EQ(cross_sign(o, a, a, b), Sign::Zero);
  EXPECT_EQ(cross_sign(o, a, b, {third(3), Rational(3, 7) + tiny}), Sign::Positive);
}

TEST(RationalPredicates, KnowTheUnitCircleAndSphere) {
  const RationalPoint2 a{1, 0}, b{{3, 5}, {4, 5}}, c{0, 1}, d{{-5, 13}, {-12, 13}};
  EXPECT_EQ(incircle(a, b, c, d), Sign::Zero);
  EXPECT_EQ(incircle(a, b, c, {Rational(d.x / 2), d.y}), Sign::Positive);
  EXPECT_EQ(incircle(a, b, c, {Rational(d.x * 2), d.y}), Sign::Negative);
  const RationalPoint3 p{1, 0, 0}, q{0, 1, 0}, r{0, 0, 1}, s{{2, 3}, {1, 3}, {-2, 3}};
  const RationalPoint3 e{{2, 7}, {-3, 7}, {6, 7}}, inside{0, 0, 0};
  EXPECT_EQ(insphere(p, q, r, s, e), Sign::Zero);
  EXPECT_EQ(insphere(p, q, r, s, inside), orient3d(p, q, r, s));
}

}  // namespace
}  // namespace plumb::test::rational_predicates_test
