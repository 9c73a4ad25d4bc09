// Signed integers with a fixed number of 64-bit words, called limbs. The fixed-width stages of
// predicates compute with these integers.
//
// Fixed<L> represents the integers of [-2^(64L-1), 2^(64L-1)) in two's complement. No operation
// checks for overflow. Every caller has a proof that its results fit (docs/design/numbers.md).
// There are two implementations of this interface:
//
//   fixed_native.h     uses carry chains and products of two 64-bit words with 128 bits. All
//                      functions are inlined and all loops are unrolled
//   fixed_portable.h   uses Boost.Multiprecision cpp_int of fixed size (PLUMB_PORTABLE)
//
// Members (both implementations; L, M, A, B, To are limb counts):
//
//   Fixed<L>()                       makes the number zero
//   explicit Fixed<L>(std::int64_t)  makes the given number
//   Fixed<L>::from_limbs(p)          reads L limbs in two's complement, p[0] is least significant
//   x.limb(i)                        returns limb i in two's complement
//   x.sign(), x.is_zero()            return the sign, and whether x is zero
//   x + y, x - y, -x, x += y, x -= y    require that the result fits L limbs
//   x << n                           requires 0 <= n < 64 L, and that the result fits
//   x == y, x <=> y                  compare the values of x and y
//   x.fits<M>()                      returns whether x lies in the range of Fixed<M>
//   x.resized<M>()                   returns the same value in M limbs; requires fits<M>()
//   multiply(Fixed<A>, Fixed<B>)     returns a Fixed<A + B>, and never overflows
//   multiply_to<To>(Fixed<A>, Fixed<B>)    returns a Fixed<To>; the product must fit To limbs
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
