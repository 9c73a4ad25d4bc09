// Sums of two doubles with a bound of their error, some 100 bits, and the doubles nearest to
// quotients that are computed with them. docs/design/numbers.md (Rounding to nearest) proves the
// bounds.
//
// Notation. u = 2^-53. A Twofold {high, low, terms} stands for high + low with |low| <= u |high|;
// `terms` bounds the sum of the absolute values from which it was computed. Its error is a multiple
// of u^2 terms, which the code that computes it counts:
//
//   difference(a, b)   has no error for doubles a and b.
//   product of x, y    has (e + f + 9) u^2 terms for errors of e and f u^2 terms: u^2 for the
//                      product of both lows, which is left out, at most 7 u^2 for the roundings of
//                      the parts below `high`, and 1 to spare.
//   sum of x, y        has 6 u^2 terms more than the larger error.
//
// This requires rounding to nearest (rounds_to_nearest()), and that nothing overflows or becomes
// subnormal. The roundings of `terms` are covered by what callers take more than needed. Sources:
// T. J. Dekker, A floating-point technique for extending the available precision, Numerische
// Mathematik 18 (1971); D. E. Knuth, The Art of Computer Programming 2, 4.2.2.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "plumb/predicates/arithmetic/fixed.h"
#include "plumb/predicates/arithmetic/scaled.h"

namespace plumb {

/// The number high + low.
struct Twofold {
  double high = 0;   ///< The leading part.
  double low = 0;    ///< The rest, |low| <= u |high|.
  double terms = 0;  ///< Bounds the sum of the absolute values of all terms.
};

/// Whether arithmetic rounds to nearest, as it is now. FTZ and DAZ do not matter where nothing is
/// subnormal.
inline bool rounds_to_nearest() {
  const volatile double one = 1, less = 0x1p-53, more = 0x1.8p-53;
  return one + less == 1 && -one - less == -1 && one + more > 1;
}

namespace twofold {

/// Returns a + b = high + low exactly (Knuth's two-sum).
inline Twofold exact_sum(double a, double b, double terms) {
  const double high = a + b, of_b = high - a;
  return {high, (a - (high - of_b)) + (b - of_b), terms};
}

struct Halves {
  double upper;
  double lower;
};
inline Halves halves(double a) {
  const double c = 0x1.0000002p27 * a, upper = c - (c - a);
  return {upper, a - upper};
}

/// Returns a b = high + low exactly (Dekker's product).
inline Twofold exact_product(double a, double b) {
  const double high = a * b;
  const auto [a1, a2] = halves(a);
  const auto [b1, b2] = halves(b);
  return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2, std::fabs(high)};
}

inline Twofold difference(double a, double b) {
  Twofold d = exact_sum(a, -b, 0);
  d.terms = std::fabs(d.high);
  return d;
}

inline Twofold product(const Twofold& x, const Twofold& y) {
  const Twofold p = exact_product(x.high, y.high);
  return exact_sum(p.high, p.low + (x.high * y.low + x.low * y.high), x.terms * y.terms);
}
inline Twofold product(const Twofold& x, double y) {
  return product(x, Twofold{y, 0, std::fabs(y)});
}

inline Twofold negative(const Twofold& x) { return {-x.high, -x.low, x.terms}; }
inline Twofold sum(const Twofold& x, const Twofold& y) {
  const Twofold s = exact_sum(x.high, y.high, 0);
  return exact_sum(s.high, s.low + (x.low + y.low), x.terms + y.terms);
}

}  // namespace twofold

// The doubles nearest to quotients, from some 100 bits of numerator and denominator.
//
// Let E and F be the errors of x and w; 2^7 u^2 terms are taken for either. The quotient q = q1 +
// q2 with q1 = x.high / w.high and q2 = (x - q1 w).high / w.high is off by at most 2 (E + |q| F) /
// |w.high|: E + |q| F for the operands, and at most 64 u^2 terms for x - q1 w and q2, where
// |w.high| >= 2^20 F. If a double a is added, the sum is off by that and by one rounding of the
// parts below the leading doubles of a + q and q, 2 u^2 of either. Errors are given twice as large.
//
// A number high + low is taken for rounded if both ends of the interval around it round to `high`,
// and `high` is not in the interval, so that the number is no double.
//
// Fixed widths. The top 106 bits of exact integers x and w are mantissas of at least 1/2, off by at
// most 2 u^2. They are divided in the same way, with themselves for terms. Their quotient lies
// between 1/2 and 2; a quotient in [2^-900, 2^900] is such a one times a power of two.

namespace twofold {

/// A number with |number - (high + low)| <= error and |low| <= u |high|.
struct Number {
  double high;
  double low;
  double error;
};

/// Returns 2^7 u^2 terms.
inline double error_of(const Twofold& x) { return 0x1p-99 * x.terms; }

/// Whether w is surely not 0, and known well enough to divide by it.
inline bool is_divisor(const Twofold& w) {
  return std::fabs(w.high) >= std::max(0x1p-400, 0x1p20 * error_of(w));
}

/// Returns x / w, with an infinite error if that is less than 2^-200 or w may be 0. Requires
/// rounds_to_nearest(), and that x - q1 w does not become subnormal for |w| >= 2^-400 and
/// |q1| >= 2^-200.
inline Number quotient(const Twofold& x, const Twofold& w) {
  const double q1 = x.high / w.high;
  if (!is_divisor(w) || !(std::fabs(q1) >= 0x1p-200)) {
    return {0, 0, std::numeric_limits<double>::infinity()};
  }
  const Twofold rest = sum(x, negative(product(w, q1)));
  const Twofold q = exact_sum(q1, rest.high / w.high, 0);
  return {q.high, q.low, 4 * (error_of(x) + std::fabs(q.high) * error_of(w)) / std::fabs(w.high)};
}

/// Returns a + q.
inline Number sum(double a, const Number& q) {
  const Twofold leading = exact_sum(a, q.high, 0);
  const Twofold s = exact_sum(leading.high, leading.low + q.low, 0);
  return {s.high, s.low, q.error + 0x1p-104 * (std::fabs(leading.high) + std::fabs(q.high))};
}

/// Returns the number rounded to nearest, if that is certain and not the number itself; otherwise
/// 0.
inline double nearest_to(const Number& q) {
  const bool is_clear = q.high + (q.low + q.error) == q.high &&
                        q.high + (q.low - q.error) == q.high && std::fabs(q.low) > q.error;
  return is_clear ? q.high : 0;
}

}  // namespace twofold

/// The number mantissa * 2^exponent.
struct TwofoldScaled {
  Twofold mantissa;  ///< The mantissa; its size is from 1/2 to 1.
  int exponent;      ///< The power of two.
};

/// Returns the leading 106 bits of x, truncated. Requires x != 0.
template <int L>
TwofoldScaled top_bits(const Fixed<L>& x) {
  const bool is_negative = x.is_negative();
  const Fixed<L> magnitude = is_negative ? -x : x;
  int top = L - 1;
  while (magnitude.limb(top) == 0) --top;
  const int zeros = std::countl_zero(magnitude.limb(top));
  const auto bits = [&](int limb) {  // 64 bits, counted from the highest 1 of the number on.
    const std::uint64_t high = limb >= 0 ? magnitude.limb(limb) << zeros : 0;
    return limb > 0 && zeros > 0 ? high | (magnitude.limb(limb - 1) >> (64 - zeros)) : high;
  };
  const auto as_double = [](std::uint64_t b) {
    return static_cast<double>(static_cast<std::int64_t>(b));
  };
  const std::uint64_t first = bits(top), second = bits(top - 1);
  const double high = as_double(first >> 11U) * 0x1p-53;
  const double low = as_double(((first & 0x7ffU) << 42U) | (second >> 22U)) * 0x1p-106;
  const Twofold mantissa = twofold::exact_sum(high, low, high);
  return {is_negative ? twofold::negative(mantissa) : mantissa, 64 * top + 64 - zeros};
}

/// Returns twofold::nearest_to() of x 2^scale / w. Requires rounds_to_nearest(). Cost: about 20 ns.
template <int L>
double nearest_quotient(const Fixed<L>& x, const TwofoldScaled& w, int scale) {
  if (x.is_zero()) return 0;
  const TwofoldScaled numerator = top_bits(x);
  const long exponent = static_cast<long>(numerator.exponent) - w.exponent + scale;
  if (exponent < -900 || exponent > 900) return 0;
  return twofold::nearest_to(twofold::quotient(numerator.mantissa, w.mantissa)) *
         power_of_two(static_cast<int>(exponent));
}

}  // namespace plumb
