// Fixed<L> against cpp_int of unlimited size.
#include "plumb/predicates/arithmetic/fixed.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <random>
#include <vector>

namespace plumb::fixed_test {
namespace {

using Big = boost::multiprecision::cpp_int;

template <int L>
Big to_big(const Fixed<L>& x) {
  Big r = 0;
  for (int i = L; i-- > 0;) r = (r << 64) + x.limb(i);
  if (static_cast<std::int64_t>(x.limb(L - 1)) < 0) r -= Big(1) << (64 * L);
  return r;
}

/// Limbs of runs of ones and zeros: carries go far.
template <int L>
Fixed<L> random_fixed(std::mt19937_64& rng) {
  std::array<std::uint64_t, L> limbs;
  const auto fill = rng() % 3;
  const int used = 1 + static_cast<int>(rng() % L);
  for (int i = 0; i < L; ++i) {
    const std::uint64_t word = rng() % 4 == 0 ? 0 : (rng() % 3 == 0 ? ~std::uint64_t{0} : rng());
    limbs[static_cast<std::size_t>(i)] = i < used ? word : (fill == 0 ? ~std::uint64_t{0} : 0);
  }
  return Fixed<L>::from_limbs(limbs.data());
}

/// Is n in the range of Fixed<L>?
template <int L>
bool in_range(const Big& n) {
  const Big bound = Big(1) << (64 * L - 1);
  return n >= -bound && n < bound;
}

template <int L>
void check_ring(std::mt19937_64& rng) {
  const Fixed<L> x = random_fixed<L>(rng);
  const Fixed<L> y = random_fixed<L>(rng);
  const Big p = to_big(x);
  const Big q = to_big(y);
  if (in_range<L>(p + q)) {
    EXPECT_EQ(to_big(x + y), p + q);
  }
  if (in_range<L>(p - q)) {
    EXPECT_EQ(to_big(x - y), p - q);
  }
  if (in_range<L>(-p)) {
    EXPECT_EQ(to_big(-x), -p);
  }
  EXPECT_EQ(static_cast<int>(x.sign()), p.sign());
  EXPECT_EQ(x.is_zero(), p == 0);
  EXPECT_EQ((x <=> y) < 0, p < q);
  EXPECT_EQ((x <=> y) == 0, p == q);
  EXPECT_EQ(x == y, p == q);
  const int n = static_cast<int>(rng() % (64 * L));
  if (in_range<L>(p * (Big(1) << n))) {
    EXPECT_EQ(to_big(x << n), p * (Big(1) << n));
  }
  const Big magnitude = abs(p);
  if (in_range<L>(magnitude)) {
    EXPECT_EQ(bit_length(x), p == 0 ? 0 : msb(magnitude) + 1);
  }
}

template <int A, int B>
void check_product(std::mt19937_64& rng) {
  const Fixed<A> x = random_fixed<A>(rng);
  const Fixed<B> y = random_fixed<B>(rng);
  const Big product = to_big(x) * to_big(y);
  EXPECT_EQ(to_big(multiply(x, y)), product);
  EXPECT_EQ(to_big(multiply_to<A + B + 1>(x, y)), product);
  constexpr int kShort = A + B > 2 ? A + B - 1 : 1;
  if (in_range<kShort>(product)) {
    EXPECT_EQ(to_big(multiply_to<kShort>(x, y)), product);
  }
}

template <int L, int M>
void check_resize(std::mt19937_64& rng) {
  const Fixed<L> x = random_fixed<L>(rng);
  ASSERT_EQ(x.template fits<M>(), in_range<M>(to_big(x)));
  if (x.template fits<M>()) {
    EXPECT_EQ(to_big(x.template resized<M>()), to_big(x));
  }
}

TEST(Fixed, IsTheRingOfIntegers) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 2000; ++i) {
    check_ring<1>(rng);
    check_ring<2>(rng);
    check_ring<3>(rng);
    check_ring<5>(rng);
    check_ring<16>(rng);
    check_ring<24>(rng);
  }
}

TEST(Fixed, MultipliesExactly) {
  std::mt19937_64 rng(2);
  for (int i = 0; i < 2000; ++i) {
    check_product<1, 1>(rng);
    check_product<1, 2>(rng);
    check_product<3, 1>(rng);
    check_product<2, 2>(rng);
    check_product<4, 3>(rng);
    check_product<8, 8>(rng);
    check_product<3, 12>(rng);
  }
}

TEST(Fixed, ResizesWithoutLoss) {
  std::mt19937_64 rng(3);
  for (int i = 0; i < 2000; ++i) {
    check_resize<1, 3>(rng);
    check_resize<3, 1>(rng);
    check_resize<4, 3>(rng);
    check_resize<2, 2>(rng);
    check_resize<16, 7>(rng);
  }
}

TEST(Fixed, HoldsTheExtremes) {
  const Fixed<1> least(std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(to_big(multiply(least, least)), Big(1) << 126);
  EXPECT_EQ(to_big(least.resized<2>()), -(Big(1) << 63));
  EXPECT_TRUE((-least.resized<2>()).fits<2>());
  EXPECT_FALSE((-least.resized<2>()).fits<1>());
  EXPECT_EQ(to_big(Fixed<4>(-1)), -1);
  const auto low = multiply_to<2>(least.resized<2>(), Fixed<2>(1));
  EXPECT_EQ(to_big(low), -(Big(1) << 63));
  EXPECT_EQ(low.limb(1), ~std::uint64_t{0});
}

}  // namespace
}  // namespace plumb::fixed_test
