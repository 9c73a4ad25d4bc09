// Rounding against exact arithmetic in Boost's own rationals, and against known corner cases.
#include "plumb/predicates/rounding.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumb {
namespace {

Rational power(int exponent) {
  const Integer p = Integer(1) << std::abs(exponent);
  return exponent < 0 ? Rational(1, p) : Rational(p);
}

TEST(Rounding, SubnormalsRoundOnce) {
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(nearest_double(power(-1074)), least);
  EXPECT_EQ(nearest_double(power(-1075)), 0.0);
  EXPECT_EQ(nearest_double(power(-1075) * 3), 2 * least);
  EXPECT_EQ(nearest_double(power(-1075) + power(-3000)), least);
  // Just above the tie at 53 bits it is below the tie of the subnormal: one rounding gives 2.
  EXPECT_EQ(nearest_double(power(-1075) * 5 - power(-2000)), 2 * least);
}

TEST(Rounding, Overflow) {
  const double inf = std::numeric_limits<double>::infinity();
  const double max = std::numeric_limits<double>::max();
  EXPECT_EQ(nearest_double(power(1024)), inf);
  EXPECT_EQ(nearest_double(-power(1024) + power(970)), -inf);
  EXPECT_EQ(nearest_double(power(1024) - power(970) - 1), max);
  EXPECT_EQ(round_to_double(power(5000), Rounding::Down).value, max);
  EXPECT_EQ(round_to_double(power(5000), Rounding::Up).value, inf);
}

TEST(Rounding, DecimalText) {
  EXPECT_EQ(decimal_text(Rational(0), 5), "0");
  EXPECT_EQ(decimal_text(Rational(1, 3), 5), "0.33333");
  EXPECT_EQ(decimal_text(Rational(-25, 2), 5), "-12.5");
  EXPECT_EQ(decimal_text(Rational(3, 20), 1), "0.2");
  EXPECT_EQ(decimal_text(Rational(1, 4), 1), "0.2");
  EXPECT_EQ(decimal_text(Rational(999999, 1), 5), "1e+6");
  EXPECT_EQ(decimal_text(Rational(999999, 1), 6), "999999");
  EXPECT_EQ(decimal_text(Rational(1, 4000), 3), "0.00025");
}

TEST(Rounding, ExactText) {
  EXPECT_EQ(exact_text(Rational(-4, 6)), "-2/3");
  EXPECT_EQ(exact_text(Rational(6, 3)), "2");
}

}  // namespace
}  // namespace plumb
