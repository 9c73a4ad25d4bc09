// Correctly rounded conversions of exact numbers to doubles and to text. No other code turns a
// rational number into a double.
//
// Doubles are computed by MPFR with the exponent range of double and mpfr_subnormalize, and are
// assembled from their bits, so that the caller's rounding mode and flush-to-zero setting have no
// influence. (mpq_get_d truncates, so it is wrong half the time; casting a 53-bit MPFR number
// rounds subnormals twice.) Decimal text is computed by one exact integer division, because a
// decimal tie such as 3/20 at one digit is not a binary tie.
#pragma once

#include <string>

#include "plumb/predicates/rational.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Selects one of the doubles next to a number.
enum class Rounding {
  Nearest,  ///< The nearest double, ties to even; an infinity from 2^1024 - 2^970 on.
  Down,     ///< The greatest double <= the value; -infinity below -DBL_MAX.
  Up,       ///< The least double >= the value; +infinity above DBL_MAX.
};

/// A rounded number and the sign of its rounding error.
struct RoundedDouble {
  double value;  ///< The double; never -0.0.
  Sign error;    ///< The sign of value - exact; Zero if the conversion was exact.
};

/// Returns `value` rounded to a double. Identities, with r for the rounded value: r(-q, Nearest) =
/// -r(q, Nearest); r(-q, Down) = -r(q, Up); r(q, Down) <= q <= r(q, Up), and these two are equal or
/// neighbouring doubles. Cost: one division of the numerator by the denominator to 53 bits.
RoundedDouble round_to_double(const Rational& value, Rounding rounding = Rounding::Nearest);

/// Returns round_to_double(value).value, for pictures, reports and approximate copies.
double nearest_double(const Rational& value);

/// Returns the largest finite double of the same sign for an infinity, and otherwise `value`.
/// Tables of points store this for coordinates beyond all doubles, so that the comparison of
/// approximations stays monotone.
double clamped_to_finite(double value);

/// Returns the exact value of a double, also with flush-to-zero or denormals-are-zero. Requires a
/// finite value. nearest_double(exact_rational(d)) equals d.
Rational exact_rational(double value);

/// Returns `value` rounded to `digits` significant decimal digits, to nearest with ties to even,
/// without trailing zeros: "0", "-12.5", "0.00025", "1.5e+30". It uses exponent form if the rounded
/// magnitude is at least 10^digits, or if the first digit is more than five places right of the
/// point. Requires digits >= 1. Cost: about one product and one division of numbers as long as the
/// operands plus `digits` digits.
std::string decimal_text(const Rational& value, int digits);

/// Returns "p/q" in lowest terms, or "p" for an integer.
std::string exact_text(const Rational& value);
/// Returns the decimal digits of an integer, after "-" if it is negative.
std::string exact_text(const Integer& value);

}  // namespace plumb
#pragma GCC visibility pop
