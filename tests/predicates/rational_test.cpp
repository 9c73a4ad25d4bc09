// Integer and Rational against cpp_int and cpp_rational, which share no code with GMP.
#include "plumb/predicates/rational.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

#include "plumb/predicates/boost_rational.h"
#include "plumb/predicates/error.h"

namespace plumb::rational_test {
namespace {

using BigInt = boost::multiprecision::cpp_int;
using BigRational = boost::multiprecision::cpp_rational;

BigInt big(const Integer& x) { return to_boost<BigInt>(x); }
BigRational big(const Rational& x) { return to_boost<BigRational>(x); }

/// Of 0 to 300 bits, small ones and powers of two more often.
Integer draw_integer() {
  const auto limbs = *rc::gen::inRange(0, 6);
  Integer result = *rc::gen::inRange(-3, 4);
  for (int i = 1; i < limbs; ++i) {
    result = (result << 64) + *rc::gen::arbitrary<std::uint64_t>();
  }
  const auto kind = *rc::gen::inRange(0, 8);
  if (kind == 0) result = Integer(1) << *rc::gen::inRange(0, 200);
  if (kind == 1) result = *rc::gen::arbitrary<std::int64_t>();
  return *rc::gen::arbitrary<bool>() ? -result : result;
}

Rational draw_rational() {
  const Integer denominator = draw_integer();
  const bool is_whole = *rc::gen::inRange(0, 4) == 0;
  return is_whole || denominator.is_zero() ? Rational(draw_integer())
                                           : Rational(draw_integer(), denominator);
}

/// With any bits, so of all magnitudes, but finite.
double draw_double() {
  const double value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::isfinite(value) ? value : std::ldexp(1.0, *rc::gen::inRange(-1074, 1024));
}

/// In lowest terms, the denominator positive, and what it should be.
void require(const Rational& x, const BigRational& expected) {
  RC_ASSERT(denominator(x) > 0);
  RC_ASSERT(gcd(numerator(x), denominator(x)) == 1);
  RC_ASSERT(big(numerator(x)) == numerator(expected));
  RC_ASSERT(big(denominator(x)) == denominator(expected));
}

void require(const Integer& x, const BigInt& expected) { RC_ASSERT(big(x) == expected); }

template <class Call>
ErrorCode code_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::Usage;
}

/// `apply` takes two operands of any kind, `apply_to` changes its first.
template <class A, class B, class X, class Apply, class ApplyTo>
void require_operator(const A& a, const B& b, const X& expected, Apply apply, ApplyTo apply_to) {
  require(apply(a, b), expected);
  require(apply(A(a), b), expected);
  require(apply(a, B(b)), expected);
  require(apply(A(a), B(b)), expected);
  if constexpr (std::is_same_v<A, Integer> == std::is_same_v<X, BigInt> && std::is_class_v<A>) {
    A in_place = a;
    apply_to(in_place, b);
    require(in_place, expected);
    A grown = a * 5 + 1;  // memory of its own
    grown = a;
    apply_to(grown, b);
    require(grown, expected);
  }
}

template <class A, class B, class X, class Y>
void require_ring(const A& a, const B& b, const X& x, const Y& y) {
  using Big = std::conditional_t<std::is_same_v<A, Rational> || std::is_same_v<B, Rational>,
                                 BigRational, BigInt>;
  const Big p(x), q(y);
  const auto sum = [](auto&& s, auto&& t) {
    return std::forward<decltype(s)>(s) + std::forward<decltype(t)>(t);
  };
  const auto difference = [](auto&& s, auto&& t) {
    return std::forward<decltype(s)>(s) - std::forward<decltype(t)>(t);
  };
  const auto product = [](auto&& s, auto&& t) {
    return std::forward<decltype(s)>(s) * std::forward<decltype(t)>(t);
  };
  const auto quotient = [](auto&& s, auto&& t) {
    return std::forward<decltype(s)>(s) / std::forward<decltype(t)>(t);
  };
  require_operator(a, b, Big(p + q), sum, [](auto& s, const auto& t) { s += t; });
  require_operator(a, b, Big(p - q), difference, [](auto& s, const auto& t) { s -= t; });
  require_operator(a, b, Big(p * q), product, [](auto& s, const auto& t) { s *= t; });
  if (q != 0) {
    require_operator(a, b, Big(p / q), quotient, [](auto& s, const auto& t) { s /= t; });
  } else {
    RC_ASSERT(code_of([&] { (void)(a / b); }) == ErrorCode::BadArgument);
  }
  RC_ASSERT((a == b) == (p == q));
  RC_ASSERT((a != b) == (p != q));
  RC_ASSERT((a < b) == (p < q));
  RC_ASSERT((a <= b) == (p <= q));
  RC_ASSERT((a > b) == (p > q));
  RC_ASSERT((a >= b) == (p >= q));
  RC_ASSERT(((a <=> b) < 0) == (p < q));
}

RC_GTEST_PROP(Integer, CalculatesAsCppInt, ()) {
  const Integer a = draw_integer(), b = draw_integer();
  require_ring(a, b, big(a), big(b));
  if (b.is_zero()) {
    RC_ASSERT(code_of([&] { (void)(a % b); }) == ErrorCode::BadArgument);
    return;
  }
  require_operator(
      a, b, BigInt(big(a) % big(b)),
      [](auto&& s, auto&& t) {
        return std::forward<decltype(s)>(s) % std::forward<decltype(t)>(t);
      },
      [](auto& s, const auto& t) { s %= t; });
  Integer quotient, remainder;
  divide_qr(a, b, quotient, remainder);
  RC_ASSERT(quotient == a / b && remainder == a % b);
}

RC_GTEST_PROP(Integer, CalculatesWithBuiltInIntegers, ()) {
  const Integer a = draw_integer();
  const auto i = *rc::gen::arbitrary<std::int64_t>();
  const auto u = *rc::gen::arbitrary<std::uint64_t>();
  const auto n = *rc::gen::arbitrary<int>();
  require_ring(a, i, big(a), BigInt(i));
  require_ring(i, a, BigInt(i), big(a));
  require_ring(a, u, big(a), BigInt(u));
  require_ring(u, a, BigInt(u), big(a));
  require_ring(a, n, big(a), BigInt(n));
  require_ring(n, a, BigInt(n), big(a));
  require(Integer(i), BigInt(i));
  require(Integer(u), BigInt(u));
}

RC_GTEST_PROP(Integer, HasTheFunctionsOfCppInt, ()) {
  const Integer a = draw_integer(), b = draw_integer();
  const BigInt x = big(a), y = big(b);
  require(gcd(a, b), gcd(x, y));
  require(lcm(a, b), lcm(x, y));
  require(abs(a), abs(x));
  require(-a, -x);
  require(+a, x);
  const auto n = *rc::gen::inRange(0, 150);
  require(a << n, x << n);
  require(Integer(a) << n, x << n);
  const BigInt unit = BigInt(1) << n;
  const BigInt down = (x - ((x % unit + unit) % unit)) / unit;
  require(a >> n, down);
  require(Integer(a) >> n, down);
  require(pow(a, static_cast<unsigned>(n % 7)), pow(x, static_cast<unsigned>(n % 7)));
  Integer c = a;
  require(c++, x);
  require(c--, x + 1);
  require(++c, x + 1);
  require(--c, x);
  if (a > 0) {
    RC_ASSERT(msb(a) == msb(x));
    RC_ASSERT(lsb(a) == lsb(x));
    RC_ASSERT(bit_test(a, static_cast<unsigned>(n)) == bit_test(x, static_cast<unsigned>(n)));
  }
  Integer sum = a;
  require(sum.add_product(a, b).subtract_product(b, b), x + x * y - y * y);
}

RC_GTEST_PROP(Integer, ReadsWhatItWrites, ()) {
  const Integer a = draw_integer();
  RC_ASSERT(a.str() == big(a).str());
  RC_ASSERT(Integer(a.str()) == a);
  RC_ASSERT(Integer(std::string_view("+" + abs(a).str())) == abs(a));
  std::ostringstream out;
  out << a;
  RC_ASSERT(out.str() == a.str());
  RC_ASSERT(from_boost(big(a)) == a);
  RC_ASSERT(from_boost(to_boost<boost::multiprecision::mpz_int>(a)) == a);
  RC_ASSERT(Integer(a.mpz()) == a);
}

RC_GTEST_PROP(Rational, CalculatesAsCppRational, ()) {
  const Rational a = draw_rational(), b = draw_rational();
  require_ring(a, b, big(a), big(b));
  const Rational c = draw_rational(), d = draw_rational();
  require(a * b + c * d, big(a) * big(b) + big(c) * big(d));
  require(a * b - c * d, big(a) * big(b) - big(c) * big(d));
}

RC_GTEST_PROP(Rational, CalculatesWithOtherNumbers, ()) {
  const Rational a = draw_rational();
  const Integer i = draw_integer();
  const auto n = *rc::gen::arbitrary<std::int64_t>();
  const auto u = *rc::gen::arbitrary<std::uint64_t>();
  const double d = draw_double();
  require_ring(a, i, big(a), big(i));
  require_ring(i, a, big(i), big(a));
  require_ring(a, n, big(a), BigInt(n));
  require_ring(n, a, BigInt(n), big(a));
  require_ring(a, u, big(a), BigInt(u));
  require_ring(u, a, BigInt(u), big(a));
  require_ring(a, d, big(a), BigRational(d));
  require_ring(d, a, BigRational(d), big(a));
}

RC_GTEST_PROP(Rational, MayBeBothOperands, ()) {
  const Rational a = draw_rational();
  const BigRational x = big(a);
  Rational b = a;
  const Rational& itself = b;
  b += itself;
  require(b, x + x);
  b = a;
  b -= itself;
  require(b, 0);
  b = a;
  b *= itself;
  require(b, x * x);
  if (!a.is_zero()) {
    b = a;
    b /= itself;
    require(b, 1);
  }
  b = a;
  b = b - b * b;
  require(b, x - x * x);
  b = a;
  b = std::as_const(b);
  require(b, x);
  Rational& same = b;
  b = std::move(same);
  require(b, x);
  swap(b, same);
  require(b, x);
  Integer i = numerator(a);
  i = i * i - i;
  i += i;
  require(i, 2 * (numerator(x) * numerator(x) - numerator(x)));
}

RC_GTEST_PROP(Rational, TakesSignAndMagnitude, ()) {
  const Rational a = draw_rational();
  require(abs(a), abs(big(a)));
  require(-a, -big(a));
  require(+a, big(a));
  RC_ASSERT(a.sign() == big(a).sign());
  RC_ASSERT(a.is_zero() == (a == 0));
  RC_ASSERT(a.is_whole() == (denominator(a) == 1));
  Rational c = a;
  require(c++, big(a));
  require(c--, big(a) + 1);
  require(++c, big(a) + 1);
  require(--c, big(a));
}

RC_GTEST_PROP(Rational, ReadsWhatItWrites, ()) {
  const Rational a = draw_rational();
  RC_ASSERT(a.str() == big(a).str());
  RC_ASSERT(Rational(a.str()) == a);
  std::ostringstream out;
  out << a;
  RC_ASSERT(out.str() == a.str());
  RC_ASSERT(from_boost(big(a)) == a);
  RC_ASSERT(from_boost(to_boost<boost::multiprecision::mpq_rational>(a)) == a);
  RC_ASSERT(Rational(a.mpq()) == a);
}

RC_GTEST_PROP(Rational, IsExactlyTheDouble, ()) {
  const double d = draw_double();
  require(Rational(d), BigRational(d));
  RC_ASSERT(static_cast<double>(Rational(d)) == d);
  RC_ASSERT(Rational(d) == d);
  RC_ASSERT(Integer(d) == from_boost(BigInt(d)));
  const auto f = static_cast<float>(d == 0 ? d : std::ldexp(d, -std::ilogb(d)));
  require(Rational(f), BigRational(f));
}

RC_GTEST_PROP(Rational, HashesEqualNumbersEqually, ()) {
  const Rational a = draw_rational();
  const Rational b = (a * 6 + 4) / 2 - 2 - 2 * a;  // a, of other memory
  RC_ASSERT(a == b);
  RC_ASSERT(std::hash<Rational>()(a) == std::hash<Rational>()(b));
  RC_ASSERT(std::hash<Integer>()(numerator(a)) == std::hash<Integer>()(numerator(b)));
}

TEST(Rational, HashesDifferFromEachOther) {
  std::unordered_set<Rational> fractions;
  std::unordered_set<std::size_t> hashes;
  for (int p = -50; p <= 50; ++p) {
    for (int q = 1; q <= 50; ++q) {
      fractions.insert(Rational(p, q));
      hashes.insert(std::hash<Rational>()(Rational(p, q)));
    }
  }
  EXPECT_EQ(hashes.size(), fractions.size());
}

TEST(Rational, TakesExtremeDoubles) {
  using Limits = std::numeric_limits<double>;
  for (const double d : {0.0, -0.0, 5e-324, -5e-324, 0x1.fffffffffffffp-1023, Limits::min(),
                         Limits::max(), Limits::lowest(), 0x1p52, 0x1p53 + 2, 0.1}) {
    EXPECT_EQ(big(Rational(d)), BigRational(d));
    EXPECT_EQ(Rational(d).convert_to<double>(), d);
  }
  EXPECT_EQ(Rational(5e-324), Rational(1, Integer(1) << 1074));
  EXPECT_EQ(pow(Integer(10), 400).convert_to<double>(), Limits::infinity());
  EXPECT_EQ((Integer(1) << 53) + 1, 9007199254740993);
  EXPECT_EQ(Integer(9007199254740993).convert_to<double>(), 9007199254740992.0);
  EXPECT_EQ(Integer(9007199254740995).convert_to<double>(), 9007199254740996.0);
}

TEST(Rational, RefusesWhatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double d : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::signaling_NaN()}) {
    EXPECT_EQ(code_of([&] { Rational x(d); }), ErrorCode::NotFinite);
    EXPECT_EQ(code_of([&] { Rational x(static_cast<float>(d)); }), ErrorCode::NotFinite);
    EXPECT_EQ(code_of([&] { Integer x(d); }), ErrorCode::NotFinite);
    Rational x(1, 3);
    EXPECT_EQ(code_of([&] { x += d; }), ErrorCode::NotFinite);
    EXPECT_EQ(code_of([&] { (void)(x < d); }), ErrorCode::NotFinite);
    EXPECT_EQ(x, Rational(1, 3));
  }
}

TEST(Rational, RefusesToDivideByZero) {
  Rational x(1, 3);
  Integer i = 7;
  EXPECT_EQ(code_of([&] { x /= 0; }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { x /= Rational(); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { x /= 0.0; }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { x = 1 / Rational(); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { x = Rational(1, 0); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { x = Rational("1/0"); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { x = Rational("0/0"); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { i /= 0; }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { i %= Integer(); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { divide_qr(i, Integer(), i, i); }), ErrorCode::BadArgument);
  EXPECT_EQ(x, Rational(1, 3));
  EXPECT_EQ(i, 7);
}

TEST(Rational, RefusesOtherText) {
  for (const char* text : {"", "-", "+", " 1", "1 ", "1.5", "0x10", "1/", "/2", "1/-2", "1/+2",
                           "--1", "1/2/3", "1e3", "one"}) {
    EXPECT_EQ(code_of([&] { Rational x(text); }), ErrorCode::Syntax) << text;
  }
  for (const char* text : {"", "-", "1/2", "+-1", "1,000"}) {
    EXPECT_EQ(code_of([&] { Integer x(text); }), ErrorCode::Syntax) << text;
  }
  EXPECT_EQ(Rational("-010/025"), Rational(-2, 5));
  EXPECT_EQ(Rational(std::string("+4/6")), Rational(2, 3));
}

TEST(Integer, RefusesNegativeShiftsAndBitsOfNothing) {
  Integer i = 7;
  EXPECT_EQ(code_of([&] { i <<= -1; }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { i = i >> -1; }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { (void)msb(Integer()); }), ErrorCode::BadArgument);
  EXPECT_EQ(code_of([&] { (void)lsb(-i); }), ErrorCode::BadArgument);
}

template <class T>
void expect_limits() {
  using Limits = std::numeric_limits<T>;
  for (const T x : {Limits::min(), Limits::max(), T(0), T(1), T(Limits::min() + 1)}) {
    EXPECT_EQ(big(Integer(x)), BigInt(x));
    EXPECT_EQ(big(Rational(x)), BigRational(BigInt(x)));
    EXPECT_EQ(Integer(x), x);
    EXPECT_EQ(Rational(x), x);
    EXPECT_EQ(Integer(x).convert_to<T>(), x);
    EXPECT_EQ(static_cast<T>(Integer(x)), x);
    Integer assigned = 5;
    assigned = x;
    EXPECT_EQ(assigned, x);
    EXPECT_EQ(assigned - x, 0);
  }
  EXPECT_FALSE((Integer(Limits::max()) + 1).fits<T>());
  EXPECT_FALSE((Integer(Limits::min()) - 1).fits<T>());
  EXPECT_EQ(code_of([] { (Integer(Limits::max()) + 1).convert_to<T>(); }),
            ErrorCode::NumberOutOfRange);
}

TEST(Integer, TakesTheLimitsOfBuiltInIntegers) {
  expect_limits<std::int8_t>();
  expect_limits<std::uint8_t>();
  expect_limits<int>();
  expect_limits<unsigned>();
  expect_limits<long>();
  expect_limits<unsigned long>();
  expect_limits<std::int64_t>();
  expect_limits<std::uint64_t>();
  expect_limits<long long>();
  EXPECT_FALSE((Integer(1) << 64).fits<std::uint64_t>());
  EXPECT_FALSE((-(Integer(1) << 200)).fits<std::int64_t>());
}

TEST(Rational, IsZeroAfterAMove) {
  static_assert(std::is_nothrow_move_constructible_v<Rational>);
  static_assert(std::is_nothrow_move_assignable_v<Integer>);
  static_assert(!std::is_convertible_v<double, Integer> &&
                !std::is_convertible_v<Rational, double>);
  Rational from(22, 7);
  Rational to = std::move(from);
  EXPECT_EQ(to, Rational(22, 7));
  EXPECT_EQ(from, 0);  // NOLINT(bugprone-use-after-move)
  from = to;
  EXPECT_EQ(from, to);
  to = std::move(from);
  from = Rational(1, 5);
  from += to;
  EXPECT_EQ(from, Rational(117, 35));
  from = std::move(to);
  to += from;
  EXPECT_EQ(to, Rational(22, 7));
  Integer i = Integer(1) << 100, j = std::move(i);
  i += 3;  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(i, 3);
  j = std::move(i);
  EXPECT_EQ(j, 3);
  std::vector<Rational> many(100, Rational(1, 3));
  many.erase(many.begin(), many.begin() + 50);
  many.insert(many.begin(), 7);
  EXPECT_EQ(many.front(), 7);
  EXPECT_EQ(many.back(), Rational(1, 3));
}

TEST(Rational, LetsGmpChangeIt) {
  Rational x, y = 3;
  mpq_set_si(x.mpq(), 6, 4);
  mpq_canonicalize(x.mpq());
  EXPECT_EQ(x, Rational(3, 2));
  mpq_inv(y.mpq(), y.mpq());
  EXPECT_EQ(y, Rational(1, 3));
  Integer i;
  mpz_ui_pow_ui(i.mpz(), 3, 100);
  EXPECT_EQ(i, pow(Integer(3), 100));
}

}  // namespace
}  // namespace plumb::rational_test
