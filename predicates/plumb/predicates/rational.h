// Exact integers (Integer) and fractions (Rational). The interface of plumb uses fractions for
// exact coordinates. The two classes wrap GMP's mpz_t and mpq_t with value semantics.
//
// No memory is allocated for the number 0. No memory is allocated for the denominator of a fraction
// that is an integer. Moving never allocates. If an operand of an operator is a temporary, the
// result reuses its memory. Every operator also accepts built-in integers of any width. The
// operators of fractions also accept doubles and floats and use their exact values.
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

/// All numbers that have no allocated memory of their own point to this limb. (A limb is a machine
/// word of a GMP number.) Such a number is either 0 or the denominator 1. The denominator 1 has
/// this limb as its only limb, so the value of the limb is one. The number 0 has no limbs, so the
/// limb is never read for it.
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

/// Whether the operators of integers accept operands of the types A and B, which may be references.
/// At least one of the types must be Integer, and the other must be Integer or a built-in integer
/// type.
template <class A, class B>
concept IntegerTerms = IntegerTerm<std::remove_cvref_t<A>> && IntegerTerm<std::remove_cvref_t<B>> &&
    (std::same_as<std::remove_cvref_t<A>, Integer> ||
     std::same_as<std::remove_cvref_t<B>, Integer>);

/// Whether the operators of fractions accept operands of the types A and B, which may be
/// references. At least one of the types must be Rational, and the other must be a RationalTerm.
template <class A, class B>
concept RationalTerms = RationalTerm<std::remove_cvref_t<A>> &&
    RationalTerm<std::remove_cvref_t<B>> &&(std::same_as<std::remove_cvref_t<A>, Rational> ||
                                            std::same_as<std::remove_cvref_t<B>, Rational>);

/// A built-in integer in the representation of GMP, without an allocation.
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

/// A view of an existing GMP integer as a fraction. The view does not copy the integer.
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

// The following functions store the result of an operation on fractions in `result`. The object
// `result` may also be an operand. If the denominator of `result` is 1, it need not have allocated
// memory: it may point to shared_limb().
void add(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void subtract(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void multiply(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void divide(mpq_ptr result, mpq_srcptr a, mpq_srcptr b);
void set(mpq_ptr result, mpq_srcptr value);

/// Sets `magnitude` to |value| and returns true, or returns false if |value| has more than 64 bits.
bool magnitude_fits(mpz_srcptr value, std::uint64_t& magnitude);
/// Returns the nearest double, ties to even. Returns an infinity if the value is beyond the range
/// of double.
double nearest(mpq_srcptr value);

std::size_t hash_of(mpz_srcptr value);
std::size_t hash_of(mpq_srcptr value);

[[noreturn]] void throw_division_by_zero();
[[noreturn]] void throw_negative_shift();
[[noreturn]] void throw_out_of_range();

/// Converts `count` to the type that GMP uses for bit counts. Throws Error if `count` is negative
/// or too large.
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

/// An integer of any size. Division truncates towards 0, as for built-in integers.
class Integer {
 public:
  /// Constructs 0, without an allocation.
  Integer() noexcept { reset(); }
  /// Constructs the integer equal to `value`.
  template <detail::BuiltInInteger T>
  Integer(T value) {
    value == 0 ? reset() : mpz_init_set(value_, detail::BuiltInOperand(value).mpz());
  }
  /// Constructs the integer part of `value`, truncated towards 0. Throws Error (NotFinite) if
  /// `value` is NaN or infinite.
  explicit Integer(double value);
  /// Parses decimal digits with an optional sign before them. Throws Error (Syntax) if `text` has
  /// any other form.
  explicit Integer(std::string_view text);
  /// Copies a GMP integer.
  explicit Integer(mpz_srcptr value) {
    value->_mp_size == 0 ? reset() : mpz_init_set(value_, value);
  }
  /// Copies the value.
  Integer(const Integer& other) : Integer(other.mpz()) {}
  /// Moves the value without an allocation and leaves 0 in `other`.
  Integer(Integer&& other) noexcept : value_{{other.value_[0]}} { other.reset(); }
  /// Copies the value and reuses the memory of this number.
  Integer& operator=(const Integer& other) {
    mpz_set(value_, other.value_);
    return *this;
  }
  /// Moves the value without an allocation and leaves 0 in `other`.
  Integer& operator=(Integer&& other) noexcept {
    Integer taken(std::move(other));
    std::swap(value_[0], taken.value_[0]);
    return *this;
  }
  /// Sets the value and reuses the memory of this number.
  template <detail::BuiltInInteger T>
  Integer& operator=(T value) {
    mpz_set(value_, detail::BuiltInOperand(value).mpz());
    return *this;
  }
  /// Releases the memory.
  ~Integer() {
    if (value_[0]._mp_alloc != 0) mpz_clear(value_);
  }

  /// Returns a pointer to the GMP number, for reading.
  mpz_srcptr mpz() const noexcept { return value_; }
  /// Returns a pointer to the GMP number, for reading and writing.
  mpz_ptr mpz() noexcept { return value_; }

  /// Returns the sign: -1, 0 or 1.
  int sign() const noexcept { return mpz_sgn(value_); }
  /// Whether the number is 0.
  bool is_zero() const noexcept { return value_[0]._mp_size == 0; }
  /// Compares this number with `other`. The result is negative if this number is less, 0 if they
  /// are equal, and positive if this number is greater.
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
  /// Returns the decimal digits, with a minus sign before them if the number is negative.
  std::string str() const;

  /// Whether the type T can represent the value.
  template <detail::BuiltInInteger T>
  bool fits() const noexcept {
    std::uint64_t magnitude = 0;
    if (!detail::magnitude_fits(value_, magnitude)) return false;
    const auto most = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
    return sign() >= 0 ? magnitude <= most : std::signed_integral<T> && magnitude <= most + 1;
  }
  /// Returns the value as a built-in integer. Throws Error (NumberOutOfRange) if the type T cannot
  /// represent the value.
  template <detail::BuiltInInteger T>
  T convert_to() const {
    if (!fits<T>()) detail::throw_out_of_range();
    std::uint64_t magnitude = 0;
    detail::magnitude_fits(value_, magnitude);
    return static_cast<T>(sign() < 0 ? 0 - magnitude : magnitude);
  }
  /// Returns the nearest double, ties to even. Returns an infinity if the value is beyond the range
  /// of double.
  template <std::same_as<double> T>
  T convert_to() const {
    return detail::nearest(detail::WholeOperand(value_).mpq());
  }
  /// Returns convert_to<T>().
  template <class T>
  requires detail::BuiltInInteger<T> || std::same_as<T, double>
  explicit operator T() const { return convert_to<T>(); }

  /// Adds `other`.
  template <detail::IntegerTerm T>
  Integer& operator+=(const T& other) {
    mpz_add(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Subtracts `other`.
  template <detail::IntegerTerm T>
  Integer& operator-=(const T& other) {
    mpz_sub(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Multiplies by `other`.
  template <detail::IntegerTerm T>
  Integer& operator*=(const T& other) {
    mpz_mul(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Divides by `other` and truncates the quotient. Throws Error (BadArgument) if `other` is 0.
  template <detail::IntegerTerm T>
  Integer& operator/=(const T& other) {
    if (other == 0) detail::throw_division_by_zero();
    mpz_tdiv_q(value_, value_, operand(other).mpz());
    return *this;
  }
  /// Replaces this number by the remainder of its division by `other`. The remainder is 0 or has
  /// the sign of this number. Throws Error (BadArgument) if `other` is 0.
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
  /// Adds 1 and returns the previous value.
  Integer operator++(int) {
    Integer before = *this;
    ++*this;
    return before;
  }
  /// Subtracts 1 and returns the previous value.
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
  /// Returns the truncated quotient. Throws Error (BadArgument) if `b` is 0.
  template <class A, class B>
  requires detail::IntegerTerms<A, B>
  friend Integer operator/(A&& a, B&& b) {
    if (b == 0) detail::throw_division_by_zero();
    return into<A, B>(a, b, [](auto... x) { mpz_tdiv_q(x...); });
  }
  /// Returns the remainder of a / b. The remainder is 0 or has the sign of `a`. Throws Error
  /// (BadArgument) if `b` is 0.
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
  /// Returns the number with the opposite sign.
  friend Integer operator-(Integer x) noexcept {
    x.negate();
    return x;
  }
  /// Whether the numbers are equal.
  template <detail::IntegerTerm T>
  friend bool operator==(const Integer& a, const T& b) noexcept {
    return a.compare(b) == 0;
  }
  /// Returns the order of the numbers.
  template <detail::IntegerTerm T>
  friend std::strong_ordering operator<=>(const Integer& a, const T& b) noexcept {
    return a.compare(b) <=> 0;
  }

  /// Returns the absolute value.
  friend Integer abs(Integer x) noexcept {
    if (x.sign() < 0) x.negate();
    return x;
  }
  /// Returns the greatest common divisor, which is never negative. gcd(0, 0) is 0.
  friend Integer gcd(const Integer& a, const Integer& b) {
    Integer result;
    mpz_gcd(result.value_, a.value_, b.value_);
    return result;
  }
  /// Returns the least common multiple, which is never negative. The result is 0 if a or b is 0.
  friend Integer lcm(const Integer& a, const Integer& b) {
    Integer result;
    mpz_lcm(result.value_, a.value_, b.value_);
    return result;
  }
  /// Returns base^exponent. The result for 0^0 is 1.
  friend Integer pow(const Integer& base, unsigned exponent) {
    Integer result;
    mpz_pow_ui(result.value_, base.value_, exponent);
    return result;
  }
  /// Sets `quotient` to a / b and `remainder` to a % b. Requires that `quotient` and `remainder`
  /// are different objects. Throws Error (BadArgument) if `b` is 0.
  friend void divide_qr(const Integer& a, const Integer& b, Integer& quotient, Integer& remainder) {
    if (b.is_zero()) detail::throw_division_by_zero();
    mpz_tdiv_qr(quotient.value_, remainder.value_, a.value_, b.value_);
  }
  /// Returns the index of the highest bit that is 1. The lowest bit of a number has index 0. Throws
  /// Error (BadArgument) if x <= 0.
  friend std::size_t msb(const Integer& x) {
    x.require_positive();
    return mpz_sizeinbase(x.value_, 2) - 1;
  }
  /// Returns the index of the lowest bit that is 1. Throws Error (BadArgument) if x <= 0.
  friend std::size_t lsb(const Integer& x) {
    x.require_positive();
    return mpz_scan1(x.value_, 0);
  }
  /// Whether the bit with index `place` is 1 in the two's complement representation.
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

  /// Calls set(result, a, b) and returns the result. If an operand is a temporary, the result is
  /// computed in the memory of this operand.
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

  mpz_t value_;  // A new 0 points to shared_limb() and has no allocated memory.
};

/// A fraction of integers of any size, always in lowest terms with a positive denominator.
class Rational {
 public:
  /// Constructs 0, without an allocation.
  Rational() noexcept { reset(); }
  /// Constructs the rational equal to the integer `value`.
  template <detail::BuiltInInteger T>
  Rational(T value) : Rational(Integer(value)) {}
  /// Constructs the rational equal to `value`. Throws Error (NotFinite) if `value` is NaN or
  /// infinite.
  Rational(double value);
  /// Constructs the rational equal to `value`. Throws Error (NotFinite) if `value` is NaN or
  /// infinite.
  Rational(float value) : Rational(static_cast<double>(value)) {}
  /// Constructs the rational equal to the integer `value`.
  Rational(const Integer& value) : Rational(Integer(value)) {}
  /// Constructs the rational equal to the integer `value`. The numerator takes over the memory of
  /// `value`.
  Rational(Integer&& value) noexcept {
    reset();
    std::swap(*mpq_numref(value_), *value.mpz());
  }
  /// Constructs numerator / denominator. Throws Error (BadArgument) if the denominator is 0.
  Rational(Integer numerator, Integer denominator);
  /// Parses "p" or "p/q" in decimal digits. p may have a sign, but q must not. Throws Error
  /// (Syntax) if `text` has any other form, and Error (BadArgument) if q is 0.
  explicit Rational(std::string_view text);
  /// Copies a GMP fraction. Requires that the fraction is in lowest terms and has a positive
  /// denominator.
  explicit Rational(mpq_srcptr value) : Rational() { detail::set(value_, value); }
  /// Copies the value.
  Rational(const Rational& other) : Rational(other.mpq()) {}
  /// Moves the value without an allocation and leaves 0 in `other`.
  Rational(Rational&& other) noexcept : value_{{other.value_[0]}} { other.reset(); }
  /// Copies the value and reuses the memory of this number.
  Rational& operator=(const Rational& other) {
    detail::set(value_, other.value_);
    return *this;
  }
  /// Moves the value without an allocation and leaves 0 in `other`.
  Rational& operator=(Rational&& other) noexcept {
    Rational taken(std::move(other));
    std::swap(value_[0], taken.value_[0]);
    return *this;
  }
  /// Releases the memory.
  ~Rational() {
    if (mpq_numref(value_)->_mp_alloc != 0) mpz_clear(mpq_numref(value_));
    if (mpq_denref(value_)->_mp_alloc != 0) mpz_clear(mpq_denref(value_));
  }

  /// Returns a pointer to the GMP number, for reading.
  mpq_srcptr mpq() const noexcept { return value_; }
  /// Returns a pointer to the GMP number, for reading and writing. After a write and before the
  /// next use of this object, the number must be in lowest terms with a positive denominator.
  mpq_ptr mpq() {
    if (mpq_denref(value_)->_mp_alloc == 0) mpz_init_set_ui(mpq_denref(value_), 1);
    return value_;
  }

  /// Returns the sign: -1, 0 or 1.
  int sign() const noexcept { return mpq_sgn(value_); }
  /// Whether the number is 0.
  bool is_zero() const noexcept { return mpq_numref(value_)->_mp_size == 0; }
  /// Whether the number is an integer, that is, its denominator is 1.
  bool is_whole() const noexcept { return mpz_cmp_ui(mpq_denref(value_), 1) == 0; }
  /// Compares this number with `other`. The result is negative if this number is less, 0 if they
  /// are equal, and positive if this number is greater.
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
  /// Returns "numerator/denominator" in decimal digits, or only the numerator if the denominator is
  /// 1.
  std::string str() const;
  /// Returns the nearest double, ties to even. Returns an infinity if the value is beyond the range
  /// of double.
  template <std::same_as<double> T>
  T convert_to() const {
    return detail::nearest(value_);
  }
  /// Returns convert_to<T>().
  template <std::same_as<double> T>
  explicit operator T() const {
    return convert_to<T>();
  }

  /// Adds `other`. This operator throws Error (NotFinite) if `other` is NaN or infinite, and so do
  /// all other operators of fractions.
  template <detail::RationalTerm T>
  Rational& operator+=(const T& other) {
    detail::add(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Subtracts `other`.
  template <detail::RationalTerm T>
  Rational& operator-=(const T& other) {
    detail::subtract(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Multiplies by `other`.
  template <detail::RationalTerm T>
  Rational& operator*=(const T& other) {
    detail::multiply(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Divides by `other`. Throws Error (BadArgument) if `other` is 0.
  template <detail::RationalTerm T>
  Rational& operator/=(const T& other) {
    detail::divide(value_, value_, operand(other).mpq());
    return *this;
  }
  /// Adds 1.
  Rational& operator++() { return *this += 1; }
  /// Subtracts 1.
  Rational& operator--() { return *this -= 1; }
  /// Adds 1 and returns the previous value.
  Rational operator++(int) {
    Rational before = *this;
    ++*this;
    return before;
  }
  /// Subtracts 1 and returns the previous value.
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
  /// Returns the number with the opposite sign.
  friend Rational operator-(Rational x) noexcept {
    x.negate();
    return x;
  }
  /// Whether the numbers are equal. Throws Error (NotFinite) if `b` is NaN or infinite.
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

  /// Returns the absolute value.
  friend Rational abs(Rational x) noexcept {
    if (x.sign() < 0) x.negate();
    return x;
  }
  /// Returns the numerator, which has the sign of the number.
  friend Integer numerator(const Rational& x) { return Integer(mpq_numref(x.value_)); }
  /// Returns the denominator, which is positive.
  friend Integer denominator(const Rational& x) { return Integer(mpq_denref(x.value_)); }
  /// Exchanges the values, without an allocation.
  friend void swap(Rational& a, Rational& b) noexcept { std::swap(a.value_[0], b.value_[0]); }
  /// Writes x.str().
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

  /// Calls set(result, a, b) and returns the result. If an operand is a temporary, the result is
  /// computed in the memory of this operand.
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

  mpq_t value_;  // A denominator without allocated memory is 1 and points to shared_limb().
};

}  // namespace plumb
#pragma GCC visibility pop

/// Hash function of integers. Equal integers have equal hashes.
template <>
struct std::hash<plumb::Integer> {
  /// Returns the hash of x.
  std::size_t operator()(const plumb::Integer& x) const noexcept {
    return plumb::detail::hash_of(x.mpz());
  }
};

/// Hash function of fractions. Equal fractions have equal hashes.
template <>
struct std::hash<plumb::Rational> {
  /// Returns the hash of x.
  std::size_t operator()(const plumb::Rational& x) const noexcept {
    return plumb::detail::hash_of(x.mpq());
  }
};
