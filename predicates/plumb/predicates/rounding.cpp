// Rounding of rationals to doubles and decimals, and exact texts.
//
// Rounding to doubles is a division by MPFR with 53 bits and the exponent range of doubles, after
// which mpfr_subnormalize() uses the direction of the first rounding to round to subnormal numbers
// as if there had been only one. The bits of the double are assembled from integers, as arithmetic
// on subnormal numbers would depend on FTZ and DAZ. MPFR's range and flags are restored afterwards.
//
// Decimal rounding divides integers, and is exact to the nearest, ties to even.
//
// Reference: L. Fousse, G. Hanrot, V. Lefèvre, P. Pélissier, P. Zimmermann, MPFR, ACM Trans.
// on Mathematical Software 33 (2007).
//
// Tested by tests/predicates/rounding_test.cpp.

#include "plumb/predicates/rounding.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "plumb/predicates/arithmetic/mpfr53.h"

namespace plumb {

namespace {

mpfr_rnd_t mpfr_rounding(Rounding rounding) {
  switch (rounding) {
    case Rounding::Down:
      return MPFR_RNDD;
    case Rounding::Up:
      return MPFR_RNDU;
    case Rounding::Nearest:
      break;
  }
  return MPFR_RNDN;
}

Integer power_of_ten(std::int64_t n) {
  Integer r;
  mpz_ui_pow_ui(r.mpz(), 10, static_cast<unsigned long>(n));
  return r;
}

/// Returns the number of bits of a positive integer.
std::int64_t bit_count(const Integer& n) {
  return static_cast<std::int64_t>(mpz_sizeinbase(n.mpz(), 2));
}

struct Quotient {
  Integer floor;
  Integer remainder;
  Integer divisor;
};

/// Returns p * 10^shift / q with its remainder.
Quotient scaled_quotient(const Integer& p, const Integer& q, std::int64_t shift) {
  Quotient r;
  r.divisor = shift < 0 ? Integer(q * power_of_ten(-shift)) : q;
  const Integer dividend = shift > 0 ? Integer(p * power_of_ten(shift)) : p;
  divide_qr(dividend, r.divisor, r.floor, r.remainder);
  return r;
}

/// Returns the integer nearest to the quotient, ties to even.
Integer nearest(const Quotient& r) {
  const int half = Integer(2 * r.remainder).compare(r.divisor);
  const bool up = half > 0 || (half == 0 && bit_test(r.floor, 0));
  return up ? Integer(r.floor + 1) : r.floor;
}

/// The positive value digits[0].digits[1..] * 10^exponent.
struct Decimal {
  std::string digits;
  std::int64_t exponent;
};

/// Returns p / q rounded to `digits` digits. The function starts with an estimate of log10(p / q)
/// by the numbers of bits, which is wrong by at most two places. It changes the estimate until the
/// quotient has exactly `digits` digits before rounding.
Decimal round_decimal(const Integer& p, const Integer& q, int digits) {
  const Integer limit = power_of_ten(digits);
  const Integer least = power_of_ten(digits - 1);
  std::int64_t exponent = (bit_count(p) - bit_count(q)) * 30103 / 100000;
  Quotient r = scaled_quotient(p, q, digits - 1 - exponent);
  while (r.floor >= limit || r.floor < least) {
    exponent += r.floor >= limit ? 1 : -1;
    r = scaled_quotient(p, q, digits - 1 - exponent);
  }
  Integer rounded = nearest(r);
  if (rounded == limit) {
    rounded = least;
    ++exponent;
  }
  return {exact_text(rounded), exponent};
}

void strip_zeros(std::string& digits) { digits.erase(digits.find_last_not_of('0') + 1); }

/// Returns the digits with the decimal point after place `exponent`. Missing places are filled with
/// zeros.
std::string plain_text(const std::string& digits, std::int64_t exponent) {
  std::string text;
  if (exponent < 0)
    return text.append("0.").append(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return text.append(digits).append(whole - digits.size(), '0');
  return text.append(digits, 0, whole).append(".").append(digits, whole);
}

std::string exponent_text(const std::string& digits, std::int64_t exponent) {
  std::string text(1, digits.front());
  if (digits.size() > 1) text.append(".").append(digits, 1);
  return text.append(exponent < 0 ? "e" : "e+").append(std::to_string(exponent));
}

RoundedDouble rounded(mpq_srcptr value, Rounding rounding) {
  const DoubleRange range;
  const mpfr_rnd_t mode = mpfr_rounding(rounding);
  Mpfr53 v;
  const int inexact = mpfr_set_q(v.get(), value, mode);
  const int error = mpfr_subnormalize(v.get(), inexact, mode);
  return {to_double(v.get()), sign_of(error)};
}

}  // namespace

double detail::nearest(mpq_srcptr value) { return rounded(value, Rounding::Nearest).value; }

RoundedDouble round_to_double(const Rational& value, Rounding rounding) {
  return rounded(value.mpq(), rounding);
}

double nearest_double(const Rational& value) { return round_to_double(value).value; }

double clamped_to_finite(double value) {
  if (!std::isinf(value)) return value;
  return std::copysign(std::numeric_limits<double>::max(), value);
}

Rational exact_rational(double value) { return Rational(value); }

std::string decimal_text(const Rational& value, int digits) {
  if (value.is_zero()) return "0";
  Decimal d = round_decimal(abs(numerator(value)), denominator(value), digits);
  strip_zeros(d.digits);
  const bool plain = d.exponent >= -5 && d.exponent < digits;
  std::string text = value < 0 ? "-" : "";
  return text += plain ? plain_text(d.digits, d.exponent) : exponent_text(d.digits, d.exponent);
}

std::string exact_text(const Integer& value) { return value.str(); }

std::string exact_text(const Rational& value) { return value.str(); }

}  // namespace plumb
