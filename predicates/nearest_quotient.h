// The doubles nearest to quotients, told by some 100 bits of numerator and denominator.
//
// With E and F the errors of x and w (double_double.h; 2^7 u^2 terms are taken for either), the quotient q = q1 + q2,
// q1 = x.high / w.high, q2 = (x - q1 w).high / w.high, is off by at most 2 (E + |q| F) / |w.high|: E + |q| F for the operands, at
// most 64 u^2 terms for x - q1 w and q2, where |w.high| >= 2^20 F. A double a added to it is off by that and one rounding of
// what is below the leading doubles of a + q and q, 2 u^2 of either. Errors are given twice as large.
//
// A number high + low is taken for rounded if `high` is what both ends of the interval around it round to, and none of its points is
// `high` itself: so the number is no double.
//
// Fixed widths. The top 106 bits of exact integers x and w are mantissas of 1/2 at least, off by 2 u^2 at most: they go the same
// way, with themselves for terms. Their quotient lies between 1/2 and 2; one in [2^-900, 2^900] is such a one times a power of
// two.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "plumb/predicates/double_double.h"
#include "plumb/predicates/fixed.h"
#include "plumb/predicates/scaled.h"

namespace plumb {
namespace twofold {

/// |number - (high + low)| <= error, |low| <= u |high|.
struct Number {
  double high;
  double low;
  double error;
};

inline double error_of(const Twofold& x) { return 0x1p-99 * x.terms; }

/// Is it not 0, and known well enough to divide by it?
inline bool is_divisor(const Twofold& w) {
  return std::fabs(w.high) >= std::max(0x1p-400, 0x1p20 * error_of(w));
}

/// x / w, the error infinite where that is less than 2^-200 or w may be 0. Requires rounds_to_nearest(), and that x - q1 w does not
/// become subnormal where |w| >= 2^-400 and |q1| >= 2^-200.
inline Number quotient(const Twofold& x, const Twofold& w) {
  const double q1 = x.high / w.high;
  if (!is_divisor(w) || !(std::fabs(q1) >= 0x1p-200)) {
    return {0, 0, std::numeric_limits<double>::infinity()};
  }
  const Twofold rest = sum(x, negative(product(w, q1)));
  const Twofold q = exact_sum(q1, rest.high / w.high, 0);
  return {q.high, q.low, 4 * (error_of(x) + std::fabs(q.high) * error_of(w)) / std::fabs(w.high)};
}

/// a + q
inline Number sum(double a, const Number& q) {
  const Twofold leading = exact_sum(a, q.high, 0);
  const Twofold s = exact_sum(leading.high, leading.low + q.low, 0);
  return {s.high, s.low, q.error + 0x1p-104 * (std::fabs(leading.high) + std::fabs(q.high))};
}

/// The number rounded to nearest, if that is clear and not the number itself; else 0.
inline double nearest_to(const Number& q) {
  const bool is_clear = q.high + (q.low + q.error) == q.high &&
                        q.high + (q.low - q.error) == q.high && std::fabs(q.low) > q.error;
  return is_clear ? q.high : 0;
}

}  // namespace twofold

/// value ~ mantissa * 2^exponent
struct TwofoldScaled {
  Twofold mantissa;
  int exponent;
};

/// Requires x != 0.
template <int L>
TwofoldScaled top_bits(const Fixed<L>& x) {
  const bool is_negative = x.is_negative();
  const Fixed<L> magnitude = is_negative ? -x : x;
  int top = L - 1;
  while (magnitude.limb(top) == 0) --top;
  const int zeros = std::countl_zero(magnitude.limb(top));
  const auto bits = [&](int limb) {  // 64 of them, from the highest 1 of the number on
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

/// twofold::nearest_to() x 2^scale / w. Requires rounds_to_nearest(). Cost: ~20 ns.
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
