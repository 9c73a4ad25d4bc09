// Exact integers and fractions, the public exact coordinate: GMP's mpz_t and mpq_t as values.
//
// 0 takes no memory, nor does the denominator of a whole number; moving never allocates. Operators
// reuse the memory of temporaries. Built-in integers of any width are operands as they are, doubles
// are operands of fractions, exactly.
#pragma once

#include <gmp.h>

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#if __GNU_MP_VERSION < 6 || (__GNU_MP_VERSION == 6 && __GNU_MP_VERSION_MINOR < 2)
#error "plumb needs GMP 6.2 or later"
#endif

#pragma GCC visibility push(default)
namespace plumb {

class Integer;
class Rational;

namespace detail {

/// What a number without memory of its own points to: a denominator of 1, or any limb of 0.
inline constexpr mp_limb_t kSharedLimb = 1;

inline mp_ptr shared_limb() { return const_cast<mp_ptr>(&kSharedLimb); }

template <class T>
concept BuiltInInteger =
    std::integral<T> && !std::same_as<T, bool> && sizeof(T) <= sizeof(std::uint64_t);

template <class T>
concept BuiltInFloat = std::same_as<T, double> || std::same_as<T, float>;

template <class T>
concept IntegerTerm = std::same_as<T, Integer> || BuiltInInteger<T>;

template <class T>
concept RationalTerm = std::same_as<T, Rational> || IntegerTerm<T> || BuiltInFloat<T>;

/// Operands, with or without references, one of them an Integer.
template <class A, class B>
concept IntegerTerms = IntegerTerm<std::remove_cvref_t<A>> && IntegerTerm<std::remove_cvref_t<B>> &&
    (std::same_as<std::remove_cvref_t<A>, Integer> ||
     std::same_as<std::remove_cvref_t<B>, Integer>);

/// Operands, with or without references, one of them a Rational.
template <class A, class B>
concept RationalTerms = RationalTerm<std::remove_cvref_t<A>> &&
    RationalTerm<std::remove_cvref_t<B>> &&(std::same_as<std::remove_cvref_t<A>, Rational> ||
                                            std::same_as<std::remove_cvref_t<B>, Rational>);

/// A built-in integer as GMP reads it, without an allocation.
class BuiltInOperand {
 public:
  template <BuiltInInteger T>
  explicit BuiltInOperand(T value) {
    auto magnitude = static_cast<std::uint64_t>(value);
    if (value < 0) magnitude = 0 - magnitude;
    int size = 0;
    while (magnitude != 0) {
      limbs_[size++] = static_cast<mp_limb_t>(magnitude & GMP_NUMB_MASK);
      magnitude = GMP_NUMB_BITS < 64 ? magnitude >> (GMP_NUMB_BITS % 64) : 0;
    }
    mpz_ptr z = mpq_numref(value_);
    z->_mp_alloc = 0;
    z->_mp_size = value < 0 ? -size : size;
    z->_mp_d = limbs_;
    *mpq_denref(value_) = {0, 1, shared_limb()};
  }
  BuiltInOperand(const BuiltInOperand&) = delete;
  BuiltInOperand& operator=(const BuiltInOperand&) = delete;
  mpz_srcptr mpz() const { return mpq_numref(value_); }
  mpq_srcptr mpq() const { return value_; }

 private:
  mp_limb_t limbs_[(64 + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS];
  mpq_t value_;
};

/// An integer of somebody else's as a fraction.
class WholeOperand {
 public:
  explicit WholeOperand(mpz_srcptr value) {
    *mpq_numref(value_) = *value;
    *mpq_denref(value_) = {0, 1, shared_limb()};
  }
  mpq_srcptr mpq() const { return value_; }

 private:
  mpq_t value_;
};

// `result` may be an operand, and its denominator the shared one.
void add(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void subtract(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void multiply(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void divide(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void set(mpq_ptr result, mpq_srcptr value);

/// The magnitude and true, or false where it has more than 64 bits.
bool magnitude_fits(mpz_srcptr value, std::uint64_t& magnitude);
/// The nearest double, ties to even; infinity beyond the range.
double nearest(mpq_srcptr value);

std::size_t hash_of(mpz_srcptr value);
std::size_t hash_of(mpq_srcptr value);

[[noreturn]] void throw_division_by_zero();
[[noreturn]] void throw_negative_shift();
[[noreturn]] void throw_out_of_range();

/// Throws Error if `count` is negative or no GMP bit count.
template <BuiltInInteger T>
mp_bitcnt_t bit_count(T count) {
  if (count < 0) throw_negative_shift();
  if constexpr (sizeof(T) > sizeof(mp_bitcnt_t)) {
    if (static_cast<std::uint64_t>(count) > std::numeric_limits<mp_bitcnt_t>::max()) {
      throw_out_of_range();
    }
  }
  return static_cast<mp_bitcnt_t>(count);
}

}  // namespace detail

/// An integer of any size. Division truncates, as that of built-in integers does.
class Integer {
 public:
  /// Makes 0, without an allocation.
  Integer() noexcept { reset(); }
  /// Makes the integer that `value` is.
  template <detail::BuiltInInteger T>
  Integer(T value) {
    value == 0 ? reset() : mpz_init_set(value_, detail::BuiltInOperand(value).mpz());
  }
  /// Makes `value` without its fraction. Throws Error (NotFinite) if it is NaN or infinite.
  explicit Integer(double value);
  /// Reads decimal digits, after a sign or none. Throws Error (Syntax) if `text` is anything else.
  explicit Integer(std::string_view text);
  /// Copies a GMP integer.
  explicit Integer(mpz_srcptr value) {
    value->_mp_size == 0 ? reset() : mpz_init_set(value_, value);
  }
  /// Copies.
  Integer(const Integer& other) : Integer(other.mpz()) {}
  /// Takes the value over, without an allocation; leaves 0.
  Integer(Integer&& other) noexcept : value_{{other.value_[0]}} { other.reset(); }
  /// Copies; the memory there is reused.
  Integer& operator=(const Integer& other) {
    mpz_set(value_, other.value_);
    return *this;
  }
  /// Takes the value over, without an allocation; leaves 0.
  Integer& operator=(Integer&& other) noexcept {
    Integer taken(std::move(other));
    std::swap(value_[0], taken.value_[0]);
    return *this;
  }
  /// Sets the value; the memory there is reused.
  template <detail::BuiltInInteger T>
  Integer& operator=(T value) {
    mpz_set(value_, detail::BuiltInOperand(value).mpz());
    return *this;
  }
  /// Gives the memory back.
  ~Integer() {
    if (value_[0]._mp_alloc != 0) mpz_clear(value_);
  }

  /// Returns the number as GMP reads it.
  mpz_srcptr mpz() const noexcept { return value_; }
  /// Returns the number for GMP to change.
  mpz_ptr mpz() noexcept { return value_; }

  /// Returns -1, 0 or 1.
  int sign() const noexcept { return mpz_sgn(value_); }
  /// Tells whether this is 0.
  bool is_zero() const noexcept { return value_[0]._mp_size == 0; }
  /// Returns a negative number if this is less than `other`, a positive one if greater, else 0.
  template <detail::IntegerTerm T>
  int compare(const T& other) const noexcept {
    if constexpr (std::same_as<T, Integer>) {
      return mpz_cmp(value_, other.mpz());
    } else {
      return other == 0 ? sign() : mpz_cmp(value_, detail::BuiltInOperand(other).mpz());
    }
  }
  /// Changes the sign.
  void negate() noexcept { value_[0]._mp_size = -value_[0]._mp_size; }
  /// Returns the decimal digits, after a minus if negative.
  std::string str() const;

  /// Tells whether a T can hold the value.
  template <detail::BuiltInInteger T>
  bool fits() const noexcept {
    std::uint64_t magnitude = 0;
    if (!detail::magnitude_fits(value_, magnitude)) return false;
    const auto most = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
    return sign() >= 0 ? magnitude <= most : std::signed_integral<T> && magnitude <= most + 1;
  }
  /// Returns the value as a built-in integer. Throws Error (NumberOutOfRange) if that cannot hold
  /// it.
  template <detail::BuiltInInteger T>
  T convert_to() const {
    if (!fits<T>()) detail::throw_out_of_range();
    std::uint64_t magnitude = 0;
    detail::magnitude_fits(value_, magnitude);
    return static_cast<T>(sign() < 0 ? 0 - magnitude : magnitude);
  }
  /// Returns the nearest double, ties to even; infinity beyond the range.
  template <std::same_as<double> T>
  T convert_to() const {
    return detail::nearest(detail::WholeOperand(value_).mpq());
  }
  /// Converts like convert_to().
  template <class T>
  requires detail::BuiltInInteger<T> || std::same_as<T, double>
  explicit operator T() const { return convert_to<T>(); }

  /// Adds.
  template <detail::IntegerTerm T>
  Integer& operator+=(const T& other) {
    mpz_add(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Subtracts.
  template <detail::IntegerTerm T>
  Integer& operator-=(const T& other) {
    mpz_sub(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Multiplies.
  template <detail::IntegerTerm T>
  Integer& operator*=(const T& other) {
    mpz_mul(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Divides and truncates. Throws Error (BadArgument) if `other` is 0.
  template <detail::IntegerTerm T>
  Integer& operator/=(const T& other) {
    if (other == 0) detail::throw_division_by_zero();
    mpz_tdiv_q(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Leaves the remainder of /=, of this number's sign. Throws Error (BadArgument) if `other` is 0.
  template <detail::IntegerTerm T>
  Integer& operator%=(const T& other) {
    if (other == 0) detail::throw_division_by_zero();
    mpz_tdiv_r(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Multiplies by 2^count. Throws Error (BadArgument) if `count` is negative.
  template <detail::BuiltInInteger T>
  Integer& operator<<=(T count) {
    mpz_mul_2exp(value_, value_, detail::bit_count(count));
    return *this;
  }
  /// Divides by 2^count and rounds down. Throws Error (BadArgument) if `count` is negative.
  template <detail::BuiltInInteger T>
  Integer& operator>>=(T count) {
    mpz_fdiv_q_2exp(value_, value_, detail::bit_count(count));
    return *this;
  }
  /// Adds x * y, without a temporary.
  Integer& add_product(const Integer& x, const Integer& y) {
    mpz_addmul(value_, x.value_, y.value_);
    return *this;
  }
  /// Subtracts x * y, without a temporary.
  Integer& subtract_product(const Integer& x, const Integer& y) {
    mpz_submul(value_, x.value_, y.value_);
    return *this;
  }
  /// Adds 1.
  Integer& operator++() { return *this += 1; }
  /// Subtracts 1.
  Integer& operator--() { return *this -= 1; }
  /// Adds 1 and returns what was there before.
  Integer operator++(int) {
    Integer before = *this;
    ++*this;
    return before;
  }
  /// Subtracts 1 and returns what was there before.
  Integer operator--(int) {
    Integer before = *this;
    --*this;
    return before;
  }

  /// Returns the sum.
  template <class A, class B>
  requires detail::IntegerTerms<A, B>
  friend Integer operator+(A&& a, B&& b) {
    return into<A, B>(a, b, [](auto... x) { mpz_add(x...); });
  }
  /// Returns the difference.
  template <class A, class B>
  requires detail::IntegerTerms<A, B>
  friend Integer operator-(A&& a, B&& b) {
    return into<A, B>(a, b, [](auto... x) { mpz_sub(x...); });
  }
  /// Returns the product.
  template <class A, class B>
  requires detail::IntegerTerms<A, B>
  friend Integer operator*(A&& a, B&& b) {
    return into<A, B>(a, b, [](auto... x) { mpz_mul(x...); });
  }
  /// Returns the quotient, truncated. Throws Error (BadArgument) if `b` is 0.
  template <class A, class B>
  requires detail::IntegerTerms<A, B>
  friend Integer operator/(A&& a, B&& b) {
    if (b == 0) detail::throw_division_by_zero();
    return into<A, B>(a, b, [](auto... x) { mpz_tdiv_q(x...); });
  }
  /// Returns the remainder, of the sign of `a`. Throws Error (BadArgument) if `b` is 0.
  template <class A, class B>
  requires detail::IntegerTerms<A, B>
  friend Integer operator%(A&& a, B&& b) {
    if (b == 0) detail::throw_division_by_zero();
    return into<A, B>(a, b, [](auto... x) { mpz_tdiv_r(x...); });
  }
  /// Returns x * 2^count. Throws Error (BadArgument) if `count` is negative.
  template <detail::BuiltInInteger T>
  friend Integer operator<<(const Integer& x, T count) {
    Integer result;
    mpz_mul_2exp(result.value_, x.value_, detail::bit_count(count));
    return result;
  }
  /// Returns x * 2^count. Throws Error (BadArgument) if `count` is negative.
  template <detail::BuiltInInteger T>
  friend Integer operator<<(Integer&& x, T count) {
    x <<= count;
    return Integer(std::move(x));
  }
  /// Returns x / 2^count, rounded down. Throws Error (BadArgument) if `count` is negative.
  template <detail::BuiltInInteger T>
  friend Integer operator>>(const Integer& x, T count) {
    Integer result;
    mpz_fdiv_q_2exp(result.value_, x.value_, detail::bit_count(count));
    return result;
  }
  /// Returns x / 2^count, rounded down. Throws Error (BadArgument) if `count` is negative.
  template <detail::BuiltInInteger T>
  friend Integer operator>>(Integer&& x, T count) {
    x >>= count;
    return Integer(std::move(x));
  }
  /// Returns the same number.
  friend Integer operator+(Integer x) noexcept { return x; }
  /// Returns the negative.
  friend Integer operator-(Integer x) noexcept {
    x.negate();
    return x;
  }
  /// Tells whether the numbers are equal.
  template <detail::IntegerTerm T>
  friend bool operator==(const Integer& a, const T& b) noexcept {
    return a.compare(b) == 0;
  }
  /// Returns the order of the numbers.
  template <detail::IntegerTerm T>
  friend std::strong_ordering operator<=>(const Integer& a, const T& b) noexcept {
    return a.compare(b) <=> 0;
  }

  /// Returns the magnitude.
  friend Integer abs(Integer x) noexcept {
    if (x.sign() < 0) x.negate();
    return x;
  }
  /// Returns the greatest common divisor, not negative; 0 for two zeros.
  friend Integer gcd(const Integer& a, const Integer& b) {
    Integer result;
    mpz_gcd(result.value_, a.value_, b.value_);
    return result;
  }
  /// Returns the least common multiple, not negative; 0 if one of the numbers is 0.
  friend Integer lcm(const Integer& a, const Integer& b) {
    Integer result;
    mpz_lcm(result.value_, a.value_, b.value_);
    return result;
  }
  /// Returns base^exponent; 1 for 0^0.
  friend Integer pow(const Integer& base, unsigned exponent) {
    Integer result;
    mpz_pow_ui(result.value_, base.value_, exponent);
    return result;
  }
  /// Sets `quotient` and `remainder` as / and % do. Requires two different objects. Throws Error
  /// (BadArgument) if `b` is 0.
  friend void divide_qr(const Integer& a, const Integer& b, Integer& quotient, Integer& remainder) {
    if (b.is_zero()) detail::throw_division_by_zero();
    mpz_tdiv_qr(quotient.value_, remainder.value_, a.value_, b.value_);
  }
  /// Returns the place of the highest bit that is 1. Throws Error (BadArgument) if x <= 0.
  friend std::size_t msb(const Integer& x) {
    x.require_positive();
    return mpz_sizeinbase(x.value_, 2) - 1;
  }
  /// Returns the place of the lowest bit that is 1. Throws Error (BadArgument) if x <= 0.
  friend std::size_t lsb(const Integer& x) {
    x.require_positive();
    return mpz_scan1(x.value_, 0);
  }
  /// Tells whether bit number `place` is 1, in two's complement.
  friend bool bit_test(const Integer& x, std::size_t place) {
    return mpz_tstbit(x.value_, detail::bit_count(place)) != 0;
  }
  /// Exchanges the values, without an allocation.
  friend void swap(Integer& a, Integer& b) noexcept { std::swap(a.value_[0], b.value_[0]); }
  /// Writes the decimal digits.
  friend std::ostream& operator<<(std::ostream& out, const Integer& x);

 private:
  void reset() noexcept { value_[0] = {0, 0, detail::shared_limb()}; }
  void require_positive() const;

  static const Integer& operand(const Integer& x) { return x; }
  template <detail::BuiltInInteger T>
  static detail::BuiltInOperand operand(T x) {
    return detail::BuiltInOperand(x);
  }

  /// The result of what `set` does of three GMP integers; the first is an operand if that is a
  /// temporary.
  template <class A, class B, class Set>
  static Integer into(A& a, B& b, Set set) {
    if constexpr (std::same_as<A, Integer>) {
      set(a.mpz(), mpz_srcptr(a.mpz()), operand(b).mpz());
      return Integer(std::move(a));
    } else if constexpr (std::same_as<B, Integer>) {
      set(b.mpz(), operand(a).mpz(), mpz_srcptr(b.mpz()));
      return Integer(std::move(b));
    } else {
      Integer result;
      set(result.mpz(), operand(a).mpz(), operand(b).mpz());
      return result;
    }
  }

  mpz_t value_;  // 0 by shared_limb() and no memory, unless there was a value before
};

/// A fraction of integers of any size, always in lowest terms with a positive denominator.
class Rational {
 public:
  /// Makes 0, without an allocation.
  Rational() noexcept { reset(); }
  /// Makes the whole number that `value` is.
  template <detail::BuiltInInteger T>
  Rational(T value) : Rational(Integer(value)) {}
  /// Makes exactly the value. Throws Error (NotFinite) if it is NaN or infinite.
  Rational(double value);
  /// Makes exactly the value. Throws Error (NotFinite) if it is NaN or infinite.
  Rational(float value) : Rational(static_cast<double>(value)) {}
  /// Makes the whole number that `value` is.
  Rational(const Integer& value) : Rational(Integer(value)) {}
  /// Makes the whole number that `value` is, of its memory.
  Rational(Integer&& value) noexcept {
    reset();
    std::swap(*mpq_numref(value_), *value.mpz());
  }
  /// Makes numerator / denominator. Throws Error (BadArgument) if the denominator is 0.
  Rational(Integer numerator, Integer denominator);
  /// Reads an integer, or two and a '/' between them, the latter unsigned, in decimal digits.
  /// Throws Error: Syntax if `text` is anything else, BadArgument if the denominator is 0.
  explicit Rational(std::string_view text);
  /// Copies a GMP fraction. Requires it to be in lowest terms with a positive denominator.
  explicit Rational(mpq_srcptr value) : Rational() { detail::set(value_, value); }
  /// Copies.
  Rational(const Rational& other) : Rational(other.mpq()) {}
  /// Takes the value over, without an allocation; leaves 0.
  Rational(Rational&& other) noexcept : value_{{other.value_[0]}} { other.reset(); }
  /// Copies; the memory there is reused.
  Rational& operator=(const Rational& other) {
    detail::set(value_, other.value_);
    return *this;
  }
  /// Takes the value over, without an allocation; leaves 0.
  Rational& operator=(Rational&& other) noexcept {
    Rational taken(std::move(other));
    std::swap(value_[0], taken.value_[0]);
    return *this;
  }
  /// Gives the memory back.
  ~Rational() {
    if (mpq_numref(value_)->_mp_alloc != 0) mpz_clear(mpq_numref(value_));
    if (mpq_denref(value_)->_mp_alloc != 0) mpz_clear(mpq_denref(value_));
  }

  /// Returns the number as GMP reads it.
  mpq_srcptr mpq() const noexcept { return value_; }
  /// Returns the number for GMP to change. It must be in lowest terms with a positive denominator
  /// again before anything else is done with it.
  mpq_ptr mpq() {
    if (mpq_denref(value_)->_mp_alloc == 0) mpz_init_set_ui(mpq_denref(value_), 1);
    return value_;
  }

  /// Returns -1, 0 or 1.
  int sign() const noexcept { return mpq_sgn(value_); }
  /// Tells whether this is 0.
  bool is_zero() const noexcept { return mpq_numref(value_)->_mp_size == 0; }
  /// Tells whether the denominator is 1.
  bool is_whole() const noexcept { return mpz_cmp_ui(mpq_denref(value_), 1) == 0; }
  /// Returns a negative number if this is less than `other`, a positive one if greater, else 0.
  /// Throws Error (NotFinite) if `other` is NaN or infinite.
  template <detail::RationalTerm T>
  int compare(const T& other) const {
    if constexpr (detail::BuiltInInteger<T>) {
      if (other == 0) return sign();
    }
    return mpq_cmp(value_, operand(other).mpq());
  }
  /// Changes the sign.
  void negate() noexcept { mpq_numref(value_)->_mp_size = -mpq_numref(value_)->_mp_size; }
  /// Returns numerator/denominator in decimal digits, without "/1".
  std::string str() const;
  /// Returns the nearest double, ties to even; infinity beyond the range.
  template <std::same_as<double> T>
  T convert_to() const {
    return detail::nearest(value_);
  }
  /// Converts like convert_to().
  template <std::same_as<double> T>
  explicit operator T() const {
    return convert_to<T>();
  }

  /// Adds. Throws Error (NotFinite) if `other` is NaN or infinite, as all operators do.
  template <detail::RationalTerm T>
  Rational& operator+=(const T& other) {
    detail::add(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Subtracts.
  template <detail::RationalTerm T>
  Rational& operator-=(const T& other) {
    detail::subtract(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Multiplies.
  template <detail::RationalTerm T>
  Rational& operator*=(const T& other) {
    detail::multiply(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Divides. Throws Error (BadArgument) if `other` is 0.
  template <detail::RationalTerm T>
  Rational& operator/=(const T& other) {
    detail::divide(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Adds 1.
  Rational& operator++() { return *this += 1; }
  /// Subtracts 1.
  Rational& operator--() { return *this -= 1; }
  /// Adds 1 and returns what was there before.
  Rational operator++(int) {
    Rational before = *this;
    ++*this;
    return before;
  }
  /// Subtracts 1 and returns what was there before.
  Rational operator--(int) {
    Rational before = *this;
    --*this;
    return before;
  }

  /// Returns the sum.
  template <class A, class B>
  requires detail::RationalTerms<A, B>
  friend Rational operator+(A&& a, B&& b) { return into<A, B>(a, b, detail::add); }
  /// Returns the difference.
  template <class A, class B>
  requires detail::RationalTerms<A, B>
  friend Rational operator-(A&& a, B&& b) { return into<A, B>(a, b, detail::subtract); }
  /// Returns the product.
  template <class A, class B>
  requires detail::RationalTerms<A, B>
  friend Rational operator*(A&& a, B&& b) { return into<A, B>(a, b, detail::multiply); }
  /// Returns the quotient. Throws Error (BadArgument) if `b` is 0.
  template <class A, class B>
  requires detail::RationalTerms<A, B>
  friend Rational operator/(A&& a, B&& b) { return into<A, B>(a, b, detail::divide); }
  /// Returns the same number.
  friend Rational operator+(Rational x) noexcept { return x; }
  /// Returns the negative.
  friend Rational operator-(Rational x) noexcept {
    x.negate();
    return x;
  }
  /// Tells whether the numbers are equal. Throws Error (NotFinite) if `b` is NaN or infinite.
  template <detail::RationalTerm T>
  friend bool operator==(const Rational& a, const T& b) {
    if constexpr (detail::BuiltInInteger<T>) {
      if (b == 0) return a.is_zero();
    }
    return mpq_equal(a.value_, operand(b).mpq()) != 0;
  }
  /// Returns the order of the numbers. Throws Error (NotFinite) if `b` is NaN or infinite.
  template <detail::RationalTerm T>
  friend std::strong_ordering operator<=>(const Rational& a, const T& b) {
    return a.compare(b) <=> 0;
  }

  /// Returns the magnitude.
  friend Rational abs(Rational x) noexcept {
    if (x.sign() < 0) x.negate();
    return x;
  }
  /// Returns the numerator, of the sign of the number.
  friend Integer numerator(const Rational& x) { return Integer(mpq_numref(x.value_)); }
  /// Returns the denominator, which is positive.
  friend Integer denominator(const Rational& x) { return Integer(mpq_denref(x.value_)); }
  /// Exchanges the values, without an allocation.
  friend void swap(Rational& a, Rational& b) noexcept { std::swap(a.value_[0], b.value_[0]); }
  /// Writes what str() returns.
  friend std::ostream& operator<<(std::ostream& out, const Rational& x);

 private:
  void reset() noexcept {
    *mpq_numref(value_) = {0, 0, detail::shared_limb()};
    *mpq_denref(value_) = {0, 1, detail::shared_limb()};
  }

  static const Rational& operand(const Rational& x) { return x; }
  static detail::WholeOperand operand(const Integer& x) { return detail::WholeOperand(x.mpz()); }
  template <detail::BuiltInInteger T>
  static detail::BuiltInOperand operand(T x) {
    return detail::BuiltInOperand(x);
  }
  template <detail::BuiltInFloat T>
  static Rational operand(T x) {
    return Rational(x);
  }

  /// The result of what `set` does of three GMP fractions; the first is an operand if that is a
  /// temporary.
  template <class A, class B>
  static Rational into(A& a, B& b, void (*set)(mpq_ptr, mpq_srcptr, mpq_srcptr)) {
    if constexpr (std::same_as<A, Rational>) {
      set(a.value_, a.value_, operand(b).mpq());
      return Rational(std::move(a));
    } else if constexpr (std::same_as<B, Rational>) {
      set(b.value_, operand(a).mpq(), b.value_);
      return Rational(std::move(b));
    } else {
      Rational result;
      set(result.value_, operand(a).mpq(), operand(b).mpq());
      return result;
    }
  }

  mpq_t value_;  // a denominator without memory of its own is 1, by shared_limb()
};

}  // namespace plumb
#pragma GCC visibility pop

/// Hashes of integers: those of equal ones are equal.
template <>
struct std::hash<plumb::Integer> {
  /// Returns the hash.
  std::size_t operator()(const plumb::Integer& x) const noexcept {
    return plumb::detail::hash_of(x.mpz());
  }
};

/// Hashes of fractions: those of equal ones are equal.
template <>
struct std::hash<plumb::Rational> {
  /// Returns the hash.
  std::size_t operator()(const plumb::Rational& x) const noexcept {
    return plumb::detail::hash_of(x.mpq());
  }
};
