// Exact numbers to doubles and to text, correctly rounded. The only place where a rational becomes
// a double.
//
// Doubles go through MPFR with the exponent range of double and mpfr_subnormalize, and are put
// together from their bits: the caller's rounding mode and FTZ/DAZ have no say. (mpq_get_d
// truncates and is wrong half the time; casting a 53-bit mpfr rounds subnormals twice.) Decimal
// text is cut from one exact integer division, because a tie such as 3/20 at one digit is no binary
// tie.
#pragma once

#include <string>

#include "plumb/predicates/rational.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Which of the doubles next to a number.
enum class Rounding {
  Nearest,  ///< ties to even; from 2^1024 - 2^970 on it is an infinity
  Down,     ///< greatest double <= the value; -infinity below -DBL_MAX
  Up,       ///< least double >= the value; +infinity above DBL_MAX
};

/// A double and how it lies to what was rounded.
struct RoundedDouble {
  double value;  ///< never -0.0
  Sign error;    ///< sign of value - exact: Zero when nothing was lost
};

/// Identities: round(-q, Nearest) = -round(q, Nearest); round(-q, Down) = -round(q, Up);
/// round(q, Down) <= q <= round(q, Up), one double apart unless equal.
/// Cost: one division of the numerator by the denominator cut to 53 bits.
RoundedDouble round_to_double(const Rational& value, Rounding rounding = Rounding::Nearest);

/// round_to_double(value).value: for pictures, reports and approximate copies.
double nearest_double(const Rational& value);

/// An infinity becomes the largest finite double of its sign: what tables of points hold for
/// coordinates beyond all doubles, so that comparing approximations stays monotone.
double clamped_to_finite(double value);

/// The number a double is, whatever FTZ/DAZ say. Requires finite.
/// Identity: nearest_double(exact_rational(d)) == d.
Rational exact_rational(double value);

/// `value` rounded to `digits` >= 1 significant decimal digits, nearest, ties to even, without
/// trailing zeros: "0", "-12.5", "0.00025", "1.5e+30" (exponent form when the first digit stands
/// left of 10^digits or more than five places right of the point).
/// Cost: one product and one division of numbers of the operands' length plus `digits`.
std::string decimal_text(const Rational& value, int digits);

/// "p/q" in lowest terms, "p" for integers.
std::string exact_text(const Rational& value);
std::string exact_text(const Integer& value);

}  // namespace plumb
#pragma GCC visibility pop
