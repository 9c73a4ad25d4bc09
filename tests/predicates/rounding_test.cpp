// Rounding against its definition in exact arithmetic, against printf (exact in glibc), and in
// corner cases, in every floating-point mode. PLUMB_CASES=n: n values.
#include "plumb/predicates/rounding.h"

#include <gtest/gtest.h>
#include <mpfr.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "float_environment.h"
#include "generate/test_share.h"
#include "plane_families.h"

namespace plumb::rounding_test {
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
  // Just below 3.5 units: at 53 bits it rounds to 3.5, and rounding that again would give 4.
  EXPECT_EQ(nearest_double(power(-1075) * 7 - power(-2000)), 3 * least);
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

// ---------------------------------------------------------------- against the definition

/// The next double up or down by the bits, so that DAZ has no say. Requires finite.
double neighbour(double v, bool up) {
  if (v == 0) return up ? 0x1p-1074 : -0x1p-1074;
  const auto bits = std::bit_cast<std::uint64_t>(v);
  return std::bit_cast<double>((v > 0) == up ? bits + 1 : bits - 1);
}

/// Infinity stands for the next power of two in comparisons of distance, as IEEE 754 has it.
Rational place(double v) {
  if (std::isinf(v)) return v > 0 ? power(1024) : -power(1024);
  return exact_rational(v);
}

bool is_even(double v) { return (std::bit_cast<std::uint64_t>(v) & 1) == 0; }

bool is_nearest(const Rational& q, double v) {
  if (std::isinf(v)) return abs(q) >= power(1024) - power(970);
  const Rational off = abs(place(v) - q);
  for (const bool up : {false, true}) {
    const Rational other = abs(place(neighbour(v, up)) - q);
    if (other < off || (other == off && !is_even(v))) return false;
  }
  return true;
}

bool is_down(const Rational& q, double v) {
  constexpr double kMax = std::numeric_limits<double>::max();
  if (std::isinf(v)) return v < 0 && q < -place(kMax);
  return place(v) <= q && (v == kMax || q < place(neighbour(v, true)));
}

void check_value(const Rational& q, testing_environment::Setting mode) {
  RoundedDouble nearest, down, up;
  {
    const testing_environment::Scope scope(mode);
    nearest = round_to_double(q);
    down = round_to_double(q, Rounding::Down);
    up = round_to_double(q, Rounding::Up);
  }
  ASSERT_TRUE(is_nearest(q, nearest.value)) << q << " to " << nearest.value;
  ASSERT_TRUE(is_down(q, down.value)) << q << " down to " << down.value;
  ASSERT_TRUE(is_down(-q, -up.value)) << q << " up to " << up.value;
  for (const RoundedDouble& r : {nearest, down, up}) {
    ASSERT_FALSE(r.value == 0 && std::signbit(r.value));
    if (std::isinf(r.value)) continue;
    ASSERT_EQ(r.error, sign_of(place(r.value).compare(q)));
  }
}

/// Doubles, points between two doubles, and points beside those; of every size.
Rational some_value(TestRandom& random) {
  double d = 0;
  do d = std::bit_cast<double>(random());
  while (!std::isfinite(d));
  if (random() % 4 == 0) d = std::ldexp(static_cast<double>(random() % 64) - 32, -1074);
  const Rational low = exact_rational(d);
  const Rational step = place(neighbour(d, true)) - low;
  const Rational beside = step * Rational(static_cast<int>(random() % 3) - 1, Integer(1) << 200);
  return low + step * static_cast<int>(random() % 5) / 4 + beside;
}

TEST(Rounding, IsWhatItsDefinitionSays) {
  const auto modes = testing_environment::kSettings;
  TestRandom random(20250103);
  const std::uint64_t cases = testing::case_count(20000);
  for (std::uint64_t i = 0; i < cases; ++i) {
    check_value(some_value(random), modes[i % modes.size()]);
    if (HasFatalFailure()) FAIL() << "seed 20250103, value " << i;
  }
}

TEST(Rounding, DoublesAreTheirOwnNearest) {
  TestRandom random(20250104);
  const auto modes = testing_environment::kSettings;
  for (std::size_t i = 0; i < 20000; ++i) {
    double d = std::bit_cast<double>(random());
    if (i % 2 == 0) d = std::bit_cast<double>(random() >> 12);  // a subnormal
    if (!std::isfinite(d)) continue;
    RoundedDouble r;
    {
      const testing_environment::Scope scope(modes[i % modes.size()]);
      r = round_to_double(exact_rational(d));
    }
    ASSERT_EQ(std::bit_cast<std::uint64_t>(r.value), std::bit_cast<std::uint64_t>(d));
    ASSERT_EQ(r.error, Sign::Zero);
  }
}

// ---------------------------------------------------------------- decimals

/// Reads what decimal_text writes.
Rational parse(const std::string& text) {
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, e);
  long exponent = e == std::string::npos ? 0 : std::stol(text.substr(e + 1));
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  const bool negative = digits.front() == '-';
  digits.erase(0, digits.find_first_not_of("-0"));
  const Rational n{Integer(digits)};
  const Rational scale{Integer(pow(Integer(10), static_cast<unsigned>(std::labs(exponent))))};
  const Rational v = exponent < 0 ? Rational(n / scale) : Rational(n * scale);
  return negative ? Rational(-v) : v;
}

TEST(DecimalText, DoublesAsPrintfHasThem) {
  TestRandom random(20250105);
  for (int i = 0; i < 5000; ++i) {
    double d = std::bit_cast<double>(random());
    if (i % 2 == 0) d = std::ldexp(static_cast<double>(random() % 4096), -6);  // ties
    if (!std::isfinite(d) || d == 0) continue;
    const int digits = 1 + i % 20;
    char expected[64];
    std::snprintf(expected, sizeof expected, "%.*e", digits - 1, d);
    ASSERT_EQ(parse(decimal_text(exact_rational(d), digits)), parse(expected)) << expected;
  }
}

/// |text - q| is at most half a unit of the last of n digits, and on a tie that digit is even.
TEST(DecimalText, FractionsAreWithinHalfAUnit) {
  EXPECT_TRUE(rc::check([] {
    const int p = *rc::gen::inRange(-200, 201), q = *rc::gen::inRange(1, 200);
    const int digits = *rc::gen::inRange(1, 9);
    RC_PRE(p != 0);
    const Rational exact(p, q);
    const Rational text = parse(decimal_text(exact, digits));
    Rational unit = parse("1e+10");
    while (unit > abs(exact)) unit /= 10;  // 10^floor(log10 |exact|)
    unit /= pow(Integer(10), static_cast<unsigned>(digits - 1));
    const Rational off = abs(text - exact) * 2;
    RC_ASSERT(off <= unit);
    const Rational last = text / unit;
    RC_ASSERT(denominator(last) == 1);
    RC_ASSERT(off != unit || numerator(last) % 2 == 0);
  }));
}

TEST(DecimalText, Shapes) {
  EXPECT_EQ(decimal_text(Rational(1, 100000), 5), "0.00001");
  EXPECT_EQ(decimal_text(Rational(1, 1000000), 5), "1e-6");
  EXPECT_EQ(decimal_text(Rational(-12345678, 1), 3), "-1.23e+7");
  EXPECT_EQ(decimal_text(Rational(100, 1), 3), "100");
  EXPECT_EQ(decimal_text(Rational(99996, 1), 4), "1e+5");
  EXPECT_EQ(decimal_text(power(-1074), 3), "4.94e-324");
}

/// A caller who computes with MPFR finds its range and flags as they were.
TEST(Rounding, LeavesMpfrAsItWas) {
  const mpfr_exp_t least = mpfr_get_emin(), most = mpfr_get_emax();
  for (const mpfr_flags_t flags : {mpfr_flags_t{0}, mpfr_flags_t{MPFR_FLAGS_DIVBY0}}) {
    mpfr_flags_restore(flags, MPFR_FLAGS_ALL);
    static_cast<void>(nearest_double(power(-1075)));    // underflow
    static_cast<void>(nearest_double(power(1025)));     // overflow
    static_cast<void>(nearest_double(Rational(1, 3)));  // inexact
    static_cast<void>(decimal_text(Rational(1, 3), 5));
    EXPECT_EQ(mpfr_flags_save(), flags);
    EXPECT_EQ(mpfr_get_emin(), least);
    EXPECT_EQ(mpfr_get_emax(), most);
  }
  mpfr_flags_clear(MPFR_FLAGS_ALL);
}

/// Work is bounded by the operands' length: a million bits either way take milliseconds.
TEST(Rounding, LongNumbers) {
  const Rational huge = power(1000000) / 3;
  EXPECT_EQ(round_to_double(huge, Rounding::Down).value, std::numeric_limits<double>::max());
  EXPECT_EQ(round_to_double(1 / huge, Rounding::Up).value, 0x1p-1074);
  EXPECT_EQ(round_to_double(-1 / huge).value, 0.0);
  EXPECT_EQ(round_to_double(-1 / huge).error, Sign::Positive);
  EXPECT_EQ(decimal_text(huge, 5), "3.3002e+301029");
  EXPECT_EQ(nearest_double((huge + 1) / (huge * 3)), 1.0 / 3);
}

}  // namespace
}  // namespace plumb::rounding_test
