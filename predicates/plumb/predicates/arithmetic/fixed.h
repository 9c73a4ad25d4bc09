// Signed integers with a fixed number of 64-bit limbs. The stages of fixed width compute with these
// integers.
//
// Fixed<L> represents the integers of [-2^(64L-1), 2^(64L-1)) in two's complement. No operation
// checks for overflow. Every caller has a proof that its results fit (docs/design/numbers.md).
// There are two implementations of this interface:
//
//   fixed_native.h     carry chains and 64x64->128 products; everything inlines and unrolls
//   fixed_portable.h   Boost.Multiprecision cpp_int of fixed size (PLUMB_PORTABLE)
//
// Members (both implementations; L, M, A, B, To are limb counts):
//
//   Fixed<L>()                       zero
//   explicit Fixed<L>(std::int64_t)
//   Fixed<L>::from_limbs(p)          two's complement, p[0] least significant, L limbs
//   x.limb(i)                        two's complement limb i
//   x.sign(), x.is_zero()
//   x + y, x - y, -x, x += y, x -= y    the result must fit L limbs
//   x << n                           0 <= n < 64 L, the result must fit
//   x == y, x <=> y
//   x.fits<M>()                      whether x lies in the range of Fixed<M>
//   x.resized<M>()                   the same value in M limbs; requires fits<M>()
//   multiply(Fixed<A>, Fixed<B>)     -> Fixed<A + B>, never overflows
//   multiply_to<To>(Fixed<A>, Fixed<B>) -> Fixed<To>; the product must fit To limbs
#pragma once

#ifdef PLUMB_PORTABLE
#include "plumb/predicates/arithmetic/fixed_portable.h"
#else
#include "plumb/predicates/arithmetic/fixed_native.h"
#endif

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the exact product. Cost: A * B products of words.
template <int A, int B>
Fixed<A + B> multiply(const Fixed<A>& x, const Fixed<B>& y) {
  return multiply_to<A + B>(x, y);
}

/// Returns the number of bits of |x|: the least n with |x| < 2^n (0 for x = 0).
template <int L>
int bit_length(const Fixed<L>& x) {
  const Fixed<L> magnitude = x.sign() == Sign::Negative ? -x : x;
  for (int i = L - 1; i >= 0; --i) {
    if (magnitude.limb(i) != 0) return 64 * i + 64 - std::countl_zero(magnitude.limb(i));
  }
  return 0;
}

}  // namespace plumb
#pragma GCC visibility pop
