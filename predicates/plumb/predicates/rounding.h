// Correctly rounded conversions of exact numbers to doubles and to text. All conversions of plumb
// from rational numbers to doubles are made here.
//
// MPFR computes the doubles. The exponent range of MPFR is set to the range of double, and each
// result is passed to mpfr_subnormalize. The doubles are assembled from their bits, so that the
// caller's rounding mode and flush-to-zero setting have no influence. (Simpler ways are wrong:
// mpq_get_d() truncates, so half of its results are not the nearest double. Casting a 53-bit MPFR
// number to double rounds subnormals twice.) Decimal text is computed from the exact number by one
// integer division. The text cannot be computed from a double. For example, the texts 0.1 and 0.2
// are the candidates for 3/20 with one digit. The number 3/20 lies exactly between them, but the
// double nearest to 3/20 does not.
#pragma once

#include <string>

#include "plumb/predicates/rational.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The double to which a number is rounded.
enum class Rounding {
  Nearest,  ///< The nearest double, ties to even; infinite if |value| >= 2^1024 - 2^970.
  Down,     ///< The greatest double <= the value; -infinity below -DBL_MAX.
  Up,       ///< The least double >= the value; +infinity above DBL_MAX.
};

/// A rounded number and the sign of its rounding error.
struct RoundedDouble {
  double value;  ///< The double; never -0.0.
  Sign error;    ///< The sign of value - exact; Zero if the conversion was exact.
};

/// Returns `value` rounded to a double. Let r(q, mode) be q rounded in the given mode. Then
///   - r(-q, Nearest) = -r(q, Nearest);
///   - r(-q, Down) = -r(q, Up);
///   - r(q, Down) <= q <= r(q, Up);
///   - r(q, Down) and r(q, Up) are equal or adjacent doubles.
/// Cost: one division of the numerator by the denominator to 53 bits.
RoundedDouble round_to_double(const Rational& value, Rounding rounding = Rounding::Nearest);

/// Returns round_to_double(value).value, for pictures, reports and approximate copies.
double nearest_double(const Rational& value);

/// Returns `value` if it is finite, and otherwise the largest finite double of the same sign.
/// Tables of points store this value for coordinates beyond the range of double. So two different
/// coordinates have approximations that are either equal or in the same order as the coordinates.
double clamped_to_finite(double value);

/// Returns the exact value of a double. The result is exact even if flush-to-zero or
/// denormals-are-zero is on. Requires a finite value. nearest_double(exact_rational(d)) equals d.
Rational exact_rational(double value);

/// Returns `value` rounded to `digits` significant decimal digits, to nearest with ties to even.
/// The text has no trailing zeros; examples are "0", "-12.5", "0.00025" and "1.5e+30". The text has
/// an exponent in two cases. In the first case, the rounded magnitude is at least 10^digits. In the
/// second case, the first nonzero digit is more than five places right of the decimal point.
/// Requires digits >= 1. Cost: about one product and one division of numbers that are `digits`
/// digits longer than the operands.
std::string decimal_text(const Rational& value, int digits);

/// Returns "p/q" in lowest terms, or "p" for an integer.
std::string exact_text(const Rational& value);
/// Returns the decimal digits of an integer. If the integer is negative, "-" comes before the
/// digits.
std::string exact_text(const Integer& value);

}  // namespace plumb
#pragma GCC visibility pop
