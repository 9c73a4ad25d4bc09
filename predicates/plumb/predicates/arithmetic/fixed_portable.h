// Fixed<L> on Boost.Multiprecision, without intrinsics and __int128. fixed.h describes the
// interface.
#pragma once

#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "plumb/predicates/sign.h"

// If a cpp_int is copied to a cpp_int of another size, g++ 12 warns of reads past the end. The
// warning is wrong, because only as many limbs are copied as the smaller of the two numbers has.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#pragma GCC diagnostic ignored "-Wstringop-overread"
#endif

#pragma GCC visibility push(default)
namespace plumb {

template <int L>
class Fixed {
  static_assert(L >= 1);

 public:
  static constexpr int kLimbs = L;
  /// The number of bits of a magnitude, without the sign. The interface needs only 64 L - 1 bits.
  /// The number is at least 128, because cpp_ints with fewer bits are stored in machine words,
  /// which behave differently on overflow.
  static constexpr unsigned kBits = L == 1 ? 128 : 64 * L;
  using Number = boost::multiprecision::number<
      boost::multiprecision::cpp_int_backend<kBits, kBits, boost::multiprecision::signed_magnitude,
                                             boost::multiprecision::unchecked, void>,
      boost::multiprecision::et_off>;

  Fixed() = default;
  explicit Fixed(std::int64_t value) : value_(value) {}
  explicit Fixed(const Number& value) : value_(value) {}

  static Fixed from_limbs(const std::uint64_t* limbs) {
    const bool negative = static_cast<std::int64_t>(limbs[L - 1]) < 0;
    Number magnitude = 0;  // The magnitude of x, or of -1 - x (the complement of x) if x < 0.
    for (int i = L; i-- > 0;) magnitude = (magnitude << 64) | (negative ? ~limbs[i] : limbs[i]);
    return Fixed(negative ? Number(-1 - magnitude) : magnitude);
  }

  std::uint64_t limb(int i) const {
    if (!is_negative()) return word(value_, i);
    return ~word(Number(-1 - value_), i);
  }

  bool is_negative() const { return value_.sign() < 0; }
  bool is_zero() const { return value_.is_zero(); }
  Sign sign() const { return static_cast<Sign>(value_.sign()); }

  friend Fixed operator+(const Fixed& x, const Fixed& y) {
    return Fixed(Number(x.value_ + y.value_));
  }
  friend Fixed operator-(const Fixed& x, const Fixed& y) {
    return Fixed(Number(x.value_ - y.value_));
  }
  friend Fixed operator-(const Fixed& x) { return Fixed(Number(-x.value_)); }
  Fixed& operator+=(const Fixed& x) { return *this = *this + x; }
  Fixed& operator-=(const Fixed& x) { return *this = *this - x; }

  friend Fixed operator<<(const Fixed& x, int n) {
    const Number magnitude = Number(abs(x.value_)) << n;
    return Fixed(x.is_negative() ? Number(-magnitude) : magnitude);
  }

  friend bool operator==(const Fixed& x, const Fixed& y) { return x.value_ == y.value_; }
  friend std::strong_ordering operator<=>(const Fixed& x, const Fixed& y) {
    return x.value_.compare(y.value_) <=> 0;
  }

  template <int M>
  bool fits() const {
    if constexpr (M >= L) return true;
    const Number magnitude = is_negative() ? Number(-1 - value_) : value_;
    return magnitude.is_zero() || msb(magnitude) < 64 * M - 1;
  }

  template <int M>
  Fixed<M> resized() const {
    return Fixed<M>(typename Fixed<M>::Number(value_));
  }

  const Number& number() const { return value_; }

 private:
  static std::uint64_t word(const Number& magnitude, int i) {
    return static_cast<std::uint64_t>(Number((magnitude >> (64 * i)) & ~std::uint64_t{0}));
  }

  Number value_ = 0;
};

template <int To, int A, int B>
Fixed<To> multiply_to(const Fixed<A>& x, const Fixed<B>& y) {
  using Product = typename Fixed<A + B>::Number;
  return Fixed<To>(typename Fixed<To>::Number(Product(Product(x.number()) * Product(y.number()))));
}

}  // namespace plumb
#pragma GCC visibility pop

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
