// Converts exact integers. An integer can be approximated by a double times a power of two. It can
// also be converted to an array of limbs (64-bit words) and back.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/fixed.h"
#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The approximation mantissa * 2^exponent of an integer, with 1/2 <= |mantissa| < 1. The mantissa
/// is truncated, so that the relative error is less than 2^-51 in any rounding mode. The
/// approximation of zero is {0, 0}.
struct Scaled {
  double mantissa = 0;
  int exponent = 0;
};

/// Returns 2^exponent. Requires -1022 <= exponent <= 1023.
constexpr double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Returns the approximation of x, which has the leading bits of x. The result does not depend on
/// the rounding mode.
template <int L>
Scaled scaled(const Fixed<L>& x) {
  const bool negative = x.is_negative();
  const Fixed<L> magnitude = negative ? -x : x;
  int top = L - 1;
  while (top > 0 && magnitude.limb(top) == 0) --top;
  const std::uint64_t high = magnitude.limb(top);
  if (high == 0) return {};
  const int zeros = std::countl_zero(high);
  const std::uint64_t low = top > 0 && zeros > 0 ? magnitude.limb(top - 1) >> (64 - zeros) : 0;
  const std::uint64_t bits53 = ((high << zeros) | low) >> 11;
  const auto mantissa = static_cast<double>(static_cast<std::int64_t>(bits53)) * power_of_two(-53);
  return {negative ? -mantissa : mantissa, 64 * top + 64 - zeros};
}

Scaled scaled(const Integer& x);

/// Returns the number of bits of |x|: the least n with |x| < 2^n (0 for x = 0).
inline int bit_length(const Integer& x) {
  return x.is_zero() ? 0 : static_cast<int>(mpz_sizeinbase(x.mpz(), 2));
}

/// Returns the number of trailing zero bits. Requires x != 0.
inline int trailing_zeros(const Integer& x) { return static_cast<int>(mpz_scan1(x.mpz(), 0)); }
template <int L>
int trailing_zeros(const Fixed<L>& x) {
  int limb = 0;
  while (x.limb(limb) == 0) ++limb;
  return 64 * limb + std::countr_zero(x.limb(limb));
}

/// Appends x to `limbs`, as `count` limbs in two's complement. Requires bit_length(x) < 64 count.
void append_limbs(const Integer& x, std::size_t count, std::vector<std::uint64_t>& limbs);

/// Returns the integer that append_limbs() wrote.
Integer integer_from_limbs(const std::uint64_t* limbs, std::size_t count);

/// Converts an integer with `count` limbs to an integer with L limbs. Requires that L limbs can
/// represent the value.
template <int L>
Fixed<L> fixed_from_limbs(const std::uint64_t* limbs, std::size_t count) {
  const bool negative = static_cast<std::int64_t>(limbs[count - 1]) < 0;
  std::uint64_t extended[L];
  for (std::size_t i = 0; i < L; ++i) {
    extended[i] = i < count ? limbs[i] : (negative ? ~std::uint64_t{0} : 0);
  }
  return Fixed<L>::from_limbs(extended);
}

/// Returns the integer mantissa * 2^shift. Requires shift >= 0.
inline Integer shifted(const Integer& mantissa, int shift) {
  Integer result = mantissa;
  result <<= static_cast<unsigned>(shift);
  return result;
}

/// Returns value / 2^low. Requires that the value is a multiple of 2^low.
inline Integer to_integer(double value, int low) {
  const Decomposed d = decompose(value);
  return d.mantissa == 0 ? Integer(0) : shifted(Integer(d.mantissa), d.exponent - low);
}

}  // namespace plumb
#pragma GCC visibility pop
