// Integers and rationals over GMP: the operations that are too long to be inline.
//
// A whole number has a denominator of 1 that is not allocated: its limb is shared by all numbers
// and never written, which _mp_alloc = 0 marks. So every operation that lets GMP write a
// denominator first gives the fraction one of its own (new_denominator(), target()). Sums and
// products of whole numbers go to the functions of GMP for integers and need no gcd.
//
// Fractions are in lowest terms with a positive denominator, at all times.
//
// Tested by tests/predicates/rational_test.cpp.

#include "plumb/predicates/rational.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <ostream>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/work_meter.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

bool is_one(mpz_srcptr x) { return mpz_cmp_ui(x, 1) == 0; }
bool is_shared(mpz_srcptr denominator) { return denominator->_mp_alloc == 0; }

void set_denominator_to_one(mpq_ptr x) {
  if (is_shared(mpq_denref(x))) {
    *mpq_denref(x) = {0, 1, detail::shared_limb()};
  } else {
    mpz_set_ui(mpq_denref(x), 1);
  }
}

void set_to_zero(mpq_ptr x) {
  mpq_numref(x)->_mp_size = 0;
  set_denominator_to_one(x);
}

/// Returns the denominator, so that GMP can write to it. If the denominator was shared, its value
/// is lost.
mpz_ptr new_denominator(mpq_ptr x) {
  if (is_shared(mpq_denref(x))) mpq_denref(x)->_mp_size = 0;
  return mpq_denref(x);
}

/// Returns the fraction, so that GMP can write to it. If the fraction is an operand, its
/// denominator keeps the value 1.
mpq_ptr target(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) {
  if (!is_shared(mpq_denref(result))) return result;
  if (result == a || result == b) {
    mpz_init_set_ui(mpq_denref(result), 1);
  } else {
    mpq_denref(result)->_mp_size = 0;
  }
  return result;
}

/// Sets the result to x + n, or to x - n, which is in lowest terms because x is. `x` or `n` may be
/// parts of the result.
template <bool kAdds>
void add_whole(mpq_ptr result, mpq_srcptr x, mpz_srcptr n) {
  if (result == x) {
    (kAdds ? mpz_addmul : mpz_submul)(mpq_numref(result), n, mpq_denref(x));
    return;
  }
  mpz_mul(mpq_numref(result), n, mpq_denref(x));
  (kAdds ? mpz_add : mpz_sub)(mpq_numref(result), mpq_numref(x), mpq_numref(result));
  mpz_set(new_denominator(result), mpq_denref(x));
}

std::size_t limbs_of(mpq_srcptr x) { return mpz_size(mpq_numref(x)) + mpz_size(mpq_denref(x)); }

/// Counts an operation on two fractions before it begins. Its cost is that of greatest common
/// divisors.
void count_work_on(mpq_srcptr a, mpq_srcptr b) { detail::count_work(limbs_of(a) + limbs_of(b)); }

/// Adds or subtracts. Integer operands need no gcd.
template <bool kAdds>
void combine(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) {
  const bool a_is_whole = is_one(mpq_denref(a)), b_is_whole = is_one(mpq_denref(b));
  if (a_is_whole && b_is_whole) {
    (kAdds ? mpz_add : mpz_sub)(mpq_numref(result), mpq_numref(a), mpq_numref(b));
    set_denominator_to_one(result);
  } else if (b_is_whole) {
    add_whole<kAdds>(result, a, mpq_numref(b));
  } else if (a_is_whole) {
    add_whole<kAdds>(result, b, mpq_numref(a));  // The result is b - a.
    if (!kAdds) mpz_neg(mpq_numref(result), mpq_numref(result));
  } else {
    count_work_on(a, b);
    (kAdds ? mpq_add : mpq_sub)(target(result, a, b), a, b);
  }
}

[[noreturn]] void throw_not_finite() {
  throw Error(ErrorCode::NotFinite, "an exact number must not be NaN or infinite");
}

bool are_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

void append_digits(mpz_srcptr x, std::string& text) {
  const std::size_t before = text.size();
  // Two more characters are for a sign and the final zero.
  text.resize(before + mpz_sizeinbase(x, 10) + 2);
  mpz_get_str(text.data() + before, 10, x);
  text.resize(before + std::strlen(text.c_str() + before));
}

/// Mixes the sign, the length and the limbs of x into a hash.
std::size_t mixed(mpz_srcptr x, std::size_t hash) {
  const auto mix = [&hash](std::uint64_t word) {
    std::uint64_t h = (hash ^ word) * 0x9e3779b97f4a7c15U;
    hash = static_cast<std::size_t>(h ^ (h >> 32U));
  };
  mix(static_cast<std::uint64_t>(x->_mp_size));
  const mp_limb_t* const limbs = mpz_limbs_read(x);
  for (std::size_t i = 0; i < mpz_size(x); ++i) mix(limbs[i]);
  return hash;
}

}  // namespace

namespace detail {

void add(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) { combine<true>(result, a, b); }
void subtract(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) { combine<false>(result, a, b); }

void multiply(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) {
  if (is_one(mpq_denref(a)) && is_one(mpq_denref(b))) {
    mpz_mul(mpq_numref(result), mpq_numref(a), mpq_numref(b));
    set_denominator_to_one(result);
  } else if (mpq_sgn(a) == 0 || mpq_sgn(b) == 0) {
    set_to_zero(result);
  } else {
    count_work_on(a, b);
    mpq_mul(target(result, a, b), a, b);
  }
}

void divide(mpq_ptr result, mpq_srcptr a, mpq_srcptr b) {
  if (mpq_sgn(b) == 0) throw_division_by_zero();
  if (mpq_sgn(a) == 0) {
    set_to_zero(result);
  } else {
    count_work_on(a, b);
    mpq_div(target(result, a, b), a, b);
  }
}

void set(mpq_ptr result, mpq_srcptr value) {
  if (result == value) return;
  if (mpq_sgn(value) == 0) {
    set_to_zero(result);
    return;
  }
  mpz_set(mpq_numref(result), mpq_numref(value));
  if (is_one(mpq_denref(value))) {
    set_denominator_to_one(result);
  } else {
    mpz_set(new_denominator(result), mpq_denref(value));
  }
}

bool magnitude_fits(mpz_srcptr value, std::uint64_t& magnitude) {
  if (mpz_sizeinbase(value, 2) > 64) return false;
  magnitude = 0;
  for (std::size_t i = mpz_size(value); i-- > 0;) {
    magnitude = (GMP_NUMB_BITS < 64 ? magnitude << (GMP_NUMB_BITS % 64) : 0) |
                mpz_getlimbn(value, static_cast<mp_size_t>(i));
  }
  return true;
}

std::size_t hash_of(mpz_srcptr value) { return mixed(value, 0); }
std::size_t hash_of(mpq_srcptr value) {
  return mixed(mpq_denref(value), mixed(mpq_numref(value), 0));
}

void throw_division_by_zero() { throw Error(ErrorCode::BadArgument, "division by zero"); }
void throw_negative_shift() { throw Error(ErrorCode::BadArgument, "a shift by less than 0 bits"); }
void throw_out_of_range() {
  throw Error(ErrorCode::NumberOutOfRange, "an integer is too large for the type asked for");
}

}  // namespace detail

Integer::Integer(double value) {
  if (!std::isfinite(value)) throw_not_finite();
  mpz_init_set_d(value_, value);
}

Integer::Integer(std::string_view text) {
  std::string_view digits = text;
  if (!digits.empty() && (digits.front() == '-' || digits.front() == '+')) digits.remove_prefix(1);
  if (!are_digits(digits)) {
    throw Error(ErrorCode::Syntax, "not an integer: '" + std::string(text) + "'");
  }
  reset();
  Integer read;  // The object owns the memory, so an exception leaks no memory.
  mpz_set_str(read.value_, std::string(digits).c_str(), 10);
  if (text.front() == '-') read.negate();
  std::swap(value_[0], read.value_[0]);
}

std::string Integer::str() const {
  std::string text;
  append_digits(value_, text);
  return text;
}

void Integer::require_positive() const {
  if (sign() <= 0) throw Error(ErrorCode::BadArgument, "bits of a number that is not positive");
}

[[gnu::visibility("default")]] std::ostream& operator<<(std::ostream& out, const Integer& x) {
  return out << x.str();
}

Rational::Rational(double value) : Rational() {
  // The bits decide, so that the rounding mode and the mode denormals-are-zero of the caller do not
  // matter.
  if ((std::bit_cast<std::uint64_t>(value) & ~detail::kSignBit) >> 52U == 0x7ffU)
    throw_not_finite();
  const Decomposed d = decompose(value);
  if (d.mantissa == 0) return;
  mpz_set(mpq_numref(value_), detail::BuiltInOperand(d.mantissa).mpz());
  if (d.exponent >= 0) {
    mpz_mul_2exp(mpq_numref(value_), mpq_numref(value_), static_cast<mp_bitcnt_t>(d.exponent));
  } else {
    mpz_setbit(new_denominator(value_), static_cast<mp_bitcnt_t>(-d.exponent));
  }
}

Rational::Rational(Integer numerator, Integer denominator) : Rational(std::move(numerator)) {
  if (denominator.is_zero()) detail::throw_division_by_zero();
  if (is_one(denominator.mpz())) return;
  detail::count_work(mpz_size(mpq_numref(value_)) + mpz_size(denominator.mpz()));
  std::swap(*mpq_denref(value_), *denominator.mpz());
  denominator.mpz()->_mp_size = 0;
  mpq_canonicalize(value_);
}

Rational::Rational(std::string_view text) : Rational() {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    *this = Rational(Integer(text));
    return;
  }
  if (!are_digits(text.substr(slash + 1))) {
    throw Error(ErrorCode::Syntax, "not a fraction: '" + std::string(text) + "'");
  }
  *this = Rational(Integer(text.substr(0, slash)), Integer(text.substr(slash + 1)));
}

std::string Rational::str() const {
  std::string text;
  append_digits(mpq_numref(value_), text);
  if (is_whole()) return text;
  text += '/';
  append_digits(mpq_denref(value_), text);
  return text;
}

[[gnu::visibility("default")]] std::ostream& operator<<(std::ostream& out, const Rational& x) {
  return out << x.str();
}

}  // namespace plumb
