// Doubles as integers, against exact rationals.
#include "plumb/predicates/arithmetic/double_bits.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "plumb/predicates/rational.h"

namespace plumb::double_bits_test {
namespace {

double random_finite(std::mt19937_64& rng) {
  for (;;) {
    const auto v = std::bit_cast<double>(rng());
    if (is_finite(v)) return v;
  }
}

Rational power_of_two(int e) {
  const Integer p = Integer(1) << std::abs(e);
  return e < 0 ? Rational(Integer(1), p) : Rational(p, Integer(1));
}

const std::vector<double>& hard_doubles() {
  static const std::vector<double> values = {0.0,
                                             -0.0,
                                             1.0,
                                             -1.0,
                                             5e-324,
                                             -5e-324,
                                             0x1p-1022,
                                             0x0.8p-1022,
                                             -0x1p-1022,
                                             0x0.fffffffffffffp-1022,
                                             0x1.fffffffffffffp1023,
                                             -0x1.fffffffffffffp1023,
                                             3.0,
                                             0x1p52,
                                             0x1p53 - 1,
                                             0.1,
                                             6.0};
  return values;
}

TEST(Decompose, GivesTheValueWithAnOddMantissa) {
  std::mt19937_64 rng(1);
  std::vector<double> values = hard_doubles();
  for (int i = 0; i < 5000; ++i) values.push_back(random_finite(rng));
  for (const double v : values) {
    const Decomposed d = decompose(v);
    EXPECT_EQ(Rational(Integer(d.mantissa)) * power_of_two(d.exponent), Rational(v)) << v;
    EXPECT_TRUE(d.mantissa % 2 != 0 || d == Decomposed{}) << v;
  }
}

TEST(OrderedKey, OrdersLikeTheReals) {
  std::mt19937_64 rng(2);
  std::vector<double> values = hard_doubles();
  for (int i = 0; i < 200; ++i) values.push_back(random_finite(rng));
  for (int i = 0; i < 50; ++i) values.push_back(std::nextafter(values[rng() % 17], 0.5));
  for (const double a : values) {
    EXPECT_EQ(sign_of_double(a), sign_of(a));
    for (const double b : values) {
      EXPECT_EQ(compare(a, b), a < b ? Sign::Negative : a > b ? Sign::Positive : Sign::Zero);
      EXPECT_EQ(is_less(a, b), a < b);
      EXPECT_EQ(is_equal(a, b), a == b);
    }
  }
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_less(0x1.fffffffffffffp1023, infinity));
  EXPECT_TRUE(is_less(-infinity, -0x1.fffffffffffffp1023));
  EXPECT_FALSE(is_finite(infinity));
  EXPECT_FALSE(is_finite(std::nan("")));
}

template <int L>
Rational value_of(const Fixed<L>& x) {
  Integer r = 0;
  for (int i = L; i-- > 0;) r = (r << 64) + Integer(x.limb(i));
  if (x.sign() == Sign::Negative) r -= Integer(1) << (64 * L);
  return Rational(r);
}

/// Random doubles within `spread` binades somewhere in the whole range.
std::vector<double> random_set(std::mt19937_64& rng, int spread) {
  const int base = static_cast<int>(rng() % 2000) - 1074;
  std::vector<double> values;
  for (int i = 0; i < 6; ++i) {
    const auto m = static_cast<double>(static_cast<std::int64_t>(rng()) >> (11 + rng() % 53));
    const double v = std::ldexp(m, base - 40 + static_cast<int>(rng()) % (spread + 1));
    values.push_back(is_finite(v) ? v : 1.0);
  }
  values.push_back(0.0);
  return values;
}

TEST(Grid, HoldsEveryValueAsAnInteger) {
  std::mt19937_64 rng(3);
  int narrow = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::vector<double> values = random_set(rng, i % 2 == 0 ? 8 : 100);
    Grid grid;
    for (const double v : values) grid.add(v);
    narrow += grid.bits() <= 63;
    for (const double v : values) {
      const Rational n = Rational(v) / power_of_two(grid.low());
      EXPECT_EQ(denominator(n), 1);
      EXPECT_LT(abs(n), power_of_two(grid.bits()));
      if (grid.bits() <= 63) {
        EXPECT_EQ(Rational(Integer(grid.to_int64(v))), n);
      }
      if (grid.bits() <= 255) {
        EXPECT_EQ(value_of(grid.to_fixed<4>(v)), n);
      }
    }
  }
  EXPECT_GT(narrow, 500);
}

TEST(Grid, MeasuresBits) {
  EXPECT_EQ(Grid({0.0, -0.0}).bits(), 0);
  EXPECT_EQ(Grid({1.0, 2.0, 3.0}).bits(), 2);
  EXPECT_EQ(Grid({4.0, -8.0}).bits(), 2);
  EXPECT_EQ(Grid({4.0, -8.0}).low(), 2);
  EXPECT_EQ(Grid({5e-324, 0x1.fffffffffffffp1023}).bits(), 2098);
  EXPECT_EQ(Grid({5e-324}).low(), -1074);
}

}  // namespace
}  // namespace plumb::double_bits_test
