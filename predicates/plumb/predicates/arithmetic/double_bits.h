// Functions that split a double into an integer and a power of two, and functions that compare
// doubles. All functions use integer operations only. Therefore their results are right in every
// rounding mode, and also if the processor replaces subnormal results by zero (flush-to-zero, FTZ)
// or subnormal operands by zero (denormals-are-zero, DAZ). In contrast, the expression `a < b` for
// two doubles can be wrong under DAZ.
#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "plumb/predicates/arithmetic/fixed.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

/// A double as mantissa * 2^exponent with |mantissa| < 2^53. The double 0 has mantissa 0 and
/// exponent 0. All other doubles have an odd mantissa.
struct Decomposed {
  std::int64_t mantissa = 0;
  int exponent = 0;
  friend bool operator==(const Decomposed&, const Decomposed&) = default;
};

namespace detail {

inline constexpr int kExponentBias = 1075;  // The bias if the mantissa is an integer.
inline constexpr std::uint64_t kFractionMask = (std::uint64_t{1} << 52) - 1;
inline constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;

/// |value| = magnitude * 2^(biased - kExponentBias), 1 <= biased <= 2046, magnitude < 2^53.
struct RawDouble {
  std::uint64_t magnitude;
  int biased;
  bool negative;
};

constexpr RawDouble raw(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto field = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t hidden = static_cast<std::uint64_t>(field != 0) << 52;
  return {(bits & kFractionMask) | hidden, field + static_cast<int>(field == 0), (bits >> 63) != 0};
}

constexpr std::int64_t with_sign(std::uint64_t magnitude, bool negative) {
  const std::uint64_t mask = negative ? ~std::uint64_t{0} : 0;
  return static_cast<std::int64_t>((magnitude ^ mask) - mask);
}

}  // namespace detail

/// Returns mantissa and exponent. Requires a finite value.
constexpr Decomposed decompose(double value) {
  const detail::RawDouble r = detail::raw(value);
  if (r.magnitude == 0) return {};
  const int zeros = std::countr_zero(r.magnitude);
  return {detail::with_sign(r.magnitude >> zeros, r.negative),
          r.biased - detail::kExponentBias + zeros};
}

/// Returns a key by which doubles can be compared. The keys are ordered like the doubles:
/// ordered_key(a) < ordered_key(b) if and only if a < b. Two keys are equal if and only if the two
/// doubles are equal. Both zeros have the same key. Negative infinity has the least key, and
/// positive infinity has the greatest key. Requires that the value is not a NaN.
constexpr std::uint64_t ordered_key(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & detail::kSignBit) != 0 ? detail::kSignBit - (bits & ~detail::kSignBit)
                                        : detail::kSignBit + bits;
}

/// Returns the order of a and b: Negative if a < b. The result is right even under DAZ, where the
/// result of `a < b` can be wrong.
constexpr Sign compare(double a, double b) {
  const std::uint64_t p = ordered_key(a);
  const std::uint64_t q = ordered_key(b);
  return p < q ? Sign::Negative : (p > q ? Sign::Positive : Sign::Zero);
}

constexpr bool is_less(double a, double b) { return ordered_key(a) < ordered_key(b); }
constexpr bool is_equal(double a, double b) { return ordered_key(a) == ordered_key(b); }

/// Returns the sign of a double. The result is right under DAZ, too.
constexpr Sign sign_of_double(double value) { return compare(value, 0.0); }

/// Whether the value is neither infinite nor a NaN. The result is right with -ffinite-math-only,
/// too.
constexpr bool is_finite(double value) {
  return ((std::bit_cast<std::uint64_t>(value) >> 52) & 0x7ff) != 0x7ff;
}

/// The common grid of a set of doubles: all multiples of a power of two, 2^low(), the unit of the
/// grid. The unit is the largest power of two of which all doubles of the set are multiples. Each
/// double of the set is n * 2^low() for an integer n with |n| < 2^bits(). If the set contains no
/// nonzero doubles, its grid is empty and bits() is 0.
class Grid {
 public:
  constexpr Grid() = default;
  constexpr Grid(std::initializer_list<double> values) {
    for (const double v : values) add(v);
  }

  /// Extends this grid so that it also contains `value`. The code has no branches, because a stage
  /// of fixed width spends most of its time in this function.
  constexpr void add(double value) {
    const detail::RawDouble r = detail::raw(value);
    const int unit = r.biased + std::countr_zero(r.magnitude);
    low_ = std::min(low_, r.magnitude == 0 ? kNone : unit);
    // For a zero, the second argument is 1. For a nonzero value it is at least 1, too, so a zero
    // never changes the result of a grid with other values.
    high_ = std::max(high_, r.biased + static_cast<int>(std::bit_width(r.magnitude)));
  }

  /// Extends this grid so that it also covers all values of `other`.
  constexpr void add(const Grid& other) {
    low_ = std::min(low_, other.low_);
    high_ = std::max(high_, other.high_);
  }

  /// Returns the exponent of the unit of the grid; 0 for an empty grid.
  constexpr int low() const { return is_empty() ? 0 : low_ - detail::kExponentBias; }
  /// Returns the number of bits of the largest integer |n|; at most 2098.
  constexpr int bits() const { return is_empty() ? 0 : high_ - low_; }
  constexpr bool is_empty() const { return low_ == kNone; }

  /// Returns the integer value / 2^low(). Requires that the value is on the grid and that bits() <=
  /// 63.
  constexpr std::int64_t to_int64(double value) const {
    const detail::RawDouble r = detail::raw(value);
    // The magnitude is less than 2^53, so it can first be shifted to the left by 10 bits. Then it
    // is shifted to the right by `down` bits. The number `down` is not negative, because biased -
    // low_ > 10 would make bits() > 63. It is at most 62, because the magnitude has at most 52
    // trailing zeros. If the value is 0, the result is 0 for every shift. (The shift is computed in
    // unsigned integers, because low_ is kNone on an empty grid.)
    const unsigned up = static_cast<unsigned>(r.biased) - static_cast<unsigned>(low_);
    const unsigned down = (10U - up) & 63U;
    return detail::with_sign((r.magnitude << 10) >> down, r.negative);
  }

  /// Returns the integer value / 2^low() with L limbs (64-bit words). Requires that the value is on
  /// the grid and that bits() < 64 L.
  template <int L>
  Fixed<L> to_fixed(double value) const {
    const Decomposed d = decompose(value);
    if (d.mantissa == 0) return Fixed<L>{};
    return Fixed<L>(d.mantissa) << (d.exponent - low());
  }

 private:
  static constexpr int kNone = std::numeric_limits<int>::max();
  int low_ = kNone;
  int high_ = 0;
};

}  // namespace plumb
#pragma GCC visibility pop
