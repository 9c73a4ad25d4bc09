// Implements Fixed<L> with 64-bit words and 128-bit products. fixed.h describes the interface.
//
// The carry chains use the compiler's built-in functions that implement _addcarry_u64 and
// _subborrow_u64, because the header that declares these two functions has 45,000 lines.
//
// Notes on speed (g++ 12, clang 14): in an unrolled loop, calls of _addcarry_u64 become a chain of
// add and adc instructions. Under g++ 12, the same chain written with __int128 takes four to five
// times as many instructions.
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "plumb/predicates/sign.h"

#if defined(__clang__)
#define PLUMB_UNROLL _Pragma("unroll")
#else
#define PLUMB_UNROLL _Pragma("GCC unroll 32")
#endif

#pragma GCC visibility push(default)
namespace plumb {

namespace detail {

__extension__ typedef unsigned __int128 Uint128;
__extension__ typedef __int128 Int128;
using Carry = unsigned char;

/// Returns x + y + carry, and sets `carry` to the carry of the sum.
inline std::uint64_t add_with_carry(std::uint64_t x, std::uint64_t y, Carry& carry) {
#if defined(__x86_64__)
  unsigned long long sum = 0;
  carry = __builtin_ia32_addcarryx_u64(carry, x, y, &sum);
  return sum;
#else
  const Uint128 sum = static_cast<Uint128>(x) + y + carry;
  carry = static_cast<Carry>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
#endif
}

/// Returns x - y - borrow, and sets `borrow` to the borrow of the difference.
inline std::uint64_t subtract_with_borrow(std::uint64_t x, std::uint64_t y, Carry& borrow) {
#if defined(__x86_64__)
  unsigned long long difference = 0;
#if defined(__clang__)
  borrow = __builtin_ia32_subborrow_u64(borrow, x, y, &difference);
#else
  borrow = __builtin_ia32_sbb_u64(borrow, x, y, &difference);
#endif
  return difference;
#else
  const Uint128 difference = static_cast<Uint128>(x) - y - borrow;
  borrow = static_cast<Carry>((difference >> 64) & 1);
  return static_cast<std::uint64_t>(difference);
#endif
}

}  // namespace detail

template <int L>
class Fixed {
  static_assert(L >= 1);

 public:
  static constexpr int kLimbs = L;

  constexpr Fixed() = default;
  constexpr explicit Fixed(std::int64_t value) {
    limbs_.fill(value < 0 ? ~std::uint64_t{0} : 0);
    limbs_[0] = static_cast<std::uint64_t>(value);
  }

  static Fixed from_limbs(const std::uint64_t* limbs) {
    Fixed r;
    PLUMB_UNROLL
    for (std::size_t i = 0; i < kSize; ++i) r.limbs_[i] = limbs[i];
    return r;
  }

  std::uint64_t limb(int i) const { return limbs_[static_cast<std::size_t>(i)]; }

  bool is_negative() const { return static_cast<std::int64_t>(limbs_[kSize - 1]) < 0; }

  bool is_zero() const {
    std::uint64_t any = 0;
    PLUMB_UNROLL
    for (std::size_t i = 0; i < kSize; ++i) any |= limbs_[i];
    return any == 0;
  }

  Sign sign() const {
    if (is_negative()) return Sign::Negative;
    return is_zero() ? Sign::Zero : Sign::Positive;
  }

  friend Fixed operator+(const Fixed& x, const Fixed& y) {
    Fixed r;
    detail::Carry carry = 0;
    PLUMB_UNROLL
    for (std::size_t i = 0; i < kSize; ++i) {
      r.limbs_[i] = detail::add_with_carry(x.limbs_[i], y.limbs_[i], carry);
    }
    return r;
  }

  friend Fixed operator-(const Fixed& x, const Fixed& y) {
    Fixed r;
    detail::Carry borrow = 0;
    PLUMB_UNROLL
    for (std::size_t i = 0; i < kSize; ++i) {
      r.limbs_[i] = detail::subtract_with_borrow(x.limbs_[i], y.limbs_[i], borrow);
    }
    return r;
  }

  friend Fixed operator-(const Fixed& x) { return Fixed{} - x; }
  Fixed& operator+=(const Fixed& x) { return *this = *this + x; }
  Fixed& operator-=(const Fixed& x) { return *this = *this - x; }

  friend Fixed operator<<(const Fixed& x, int n) {
    const std::size_t words = static_cast<std::size_t>(n) / 64;
    const int bits = n % 64;
    Fixed r;
    for (std::size_t i = words; i < kSize; ++i) {
      const std::uint64_t low = i > words && bits != 0 ? x.limbs_[i - words - 1] >> (64 - bits) : 0;
      r.limbs_[i] = (x.limbs_[i - words] << bits) | low;
    }
    return r;
  }

  friend bool operator==(const Fixed& x, const Fixed& y) = default;
  friend std::strong_ordering operator<=>(const Fixed& x, const Fixed& y) {
    const auto top = [](const Fixed& v) { return static_cast<std::int64_t>(v.limbs_[kSize - 1]); };
    if (top(x) != top(y)) return top(x) <=> top(y);
    for (std::size_t i = kSize - 1; i-- > 0;) {
      if (x.limbs_[i] != y.limbs_[i]) return x.limbs_[i] <=> y.limbs_[i];
    }
    return std::strong_ordering::equal;
  }

  template <int M>
  bool fits() const {
    if constexpr (M >= L) {
      return true;
    } else {
      const std::uint64_t fill = is_negative() ? ~std::uint64_t{0} : 0;
      for (int i = M; i < L; ++i) {
        if (limb(i) != fill) return false;
      }
      return (static_cast<std::int64_t>(limb(M - 1)) < 0) == is_negative();
    }
  }

  template <int M>
  Fixed<M> resized() const {
    Fixed<M> r;
    const std::uint64_t fill = is_negative() ? ~std::uint64_t{0} : 0;
    PLUMB_UNROLL
    for (std::size_t i = 0; i < Fixed<M>::kSize; ++i) r.limbs_[i] = i < kSize ? limbs_[i] : fill;
    return r;
  }

  template <int To, int A, int B>
  friend Fixed<To> multiply_to(const Fixed<A>& x, const Fixed<B>& y);
  template <int M>
  friend class Fixed;

 private:
  static constexpr std::size_t kSize = static_cast<std::size_t>(L);

  /// If `condition` is true, subtracts y * 2^(64 offset) modulo 2^(64 L).
  template <int M>
  void subtract_shifted_if(bool condition, const Fixed<M>& y, std::size_t offset) {
    const std::uint64_t mask = condition ? ~std::uint64_t{0} : 0;
    detail::Carry borrow = 0;
    PLUMB_UNROLL
    for (std::size_t i = 0; i < Fixed<M>::kSize; ++i) {
      if (offset + i >= kSize) return;
      limbs_[offset + i] =
          detail::subtract_with_borrow(limbs_[offset + i], y.limbs_[i] & mask, borrow);
    }
  }

  std::array<std::uint64_t, kSize> limbs_{};
};

namespace detail {

/// Adds x * y * 2^(64 offset) to r, modulo 2^(64 To). This is one row of schoolbook multiplication.
/// Requires that limb offset + B of r and all higher limbs of r are zero.
template <std::size_t To, std::size_t B>
void add_row(std::array<std::uint64_t, To>& r, std::uint64_t x,
             const std::array<std::uint64_t, B>& y, std::size_t offset) {
  std::uint64_t carry = 0;
  PLUMB_UNROLL
  for (std::size_t j = 0; j < B; ++j) {
    if (offset + j >= To) return;
    const Uint128 sum = static_cast<Uint128>(x) * y[j] + r[offset + j] + carry;
    r[offset + j] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
  if (offset + B < To) r[offset + B] = carry;
}

}  // namespace detail

/// Returns the product in two's complement. Let X and Y be the values of the limbs of x and y, read
/// as unsigned integers. Let [c] be 1 if the condition c holds, and 0 otherwise. Then x y = X
/// Y - [x < 0] 2^(64 A) Y - [y < 0] 2^(64 B) X, modulo 2^(64 (A + B)).
template <int To, int A, int B>
Fixed<To> multiply_to(const Fixed<A>& x, const Fixed<B>& y) {
  if constexpr (To > A + B) {
    return multiply_to<A + B>(x, y).template resized<To>();
  } else if constexpr (To == 1) {
    return Fixed<1>(static_cast<std::int64_t>(x.limbs_[0] * y.limbs_[0]));
  } else if constexpr (A == 1 && B == 1) {
    const auto product = static_cast<detail::Int128>(static_cast<std::int64_t>(x.limbs_[0])) *
                         static_cast<std::int64_t>(y.limbs_[0]);
    Fixed<2> r;
    r.limbs_ = {static_cast<std::uint64_t>(product), static_cast<std::uint64_t>(product >> 64)};
    return r;
  } else {
    Fixed<To> r;
    PLUMB_UNROLL
    for (std::size_t i = 0; i < A; ++i) detail::add_row(r.limbs_, x.limbs_[i], y.limbs_, i);
    r.subtract_shifted_if(x.is_negative(), y, A);
    r.subtract_shifted_if(y.is_negative(), x, B);
    return r;
  }
}

}  // namespace plumb
#pragma GCC visibility pop

#undef PLUMB_UNROLL
