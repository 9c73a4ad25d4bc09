// Sums of two doubles with a bound of their error: some 100 bits, for what doubles nearly decide.
//
// Notation. u = 2^-53. A Twofold {high, low, terms} stands for high + low, |low| <= u |high|; `terms` bounds the sum of the
// absolute values of what it was computed from. Its error is a multiple of u^2 terms that whoever computes counts:
//
//   difference(a, b)   of doubles: none
//   product of x, y    errors e u^2 terms and f u^2 terms give (e + f + 9) u^2 terms: u^2 of both lows, which are left out, and
//                      at most 7 u^2 for the roundings of what is below `high`
//   sum of x, y        6 u^2 terms more than the larger error
//
// Requires rounding to nearest (rounds_to_nearest()) and that nothing overflows or becomes subnormal; the terms' own
// roundings are for the caller's slack.
// Source: Dekker, Numer. Math. 18 (1971); Knuth, TAOCP 2, 4.2.2.
#pragma once

#include <cmath>

namespace plumb {

struct Twofold {
  double high = 0;
  double low = 0;
  double terms = 0;
};

/// Does arithmetic round to nearest, as it is now? FTZ and DAZ do not matter where nothing is subnormal.
inline bool rounds_to_nearest() {
  const volatile double one = 1, less = 0x1p-53, more = 0x1.8p-53;
  return one + less == 1 && -one - less == -1 && one + more > 1;
}

namespace twofold {

/// a + b = high + low exactly.
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

/// a b = high + low exactly.
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
}  // namespace plumb
