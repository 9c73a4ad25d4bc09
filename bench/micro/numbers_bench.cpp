// The kernels under exact predicates: integers of fixed width beside GMP's, sums and roundings of
// fractions, decimals. "per_call" is CPU time of one operation.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "plumb/predicates/arithmetic/fixed.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kNumbers = 1024;

void per_call(benchmark::State& state) {
  state.counters["per_call"] = benchmark::Counter(
      static_cast<double>(kNumbers),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <int L>
std::vector<Fixed<L>> fixed_numbers(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Fixed<L>> result;
  for (std::size_t i = 0; i < kNumbers; ++i) {
    std::uint64_t limbs[L];
    for (std::uint64_t& limb : limbs) limb = random();
    result.push_back(Fixed<L>::from_limbs(limbs));
  }
  return result;
}

Integer integer_of(std::size_t bits, std::mt19937_64& random) {
  Integer result = random() | (std::uint64_t{1} << 63U);
  while (msb(result) + 1 < bits) result = (result << 64U) + random();
  return random() % 2 == 0 ? result : Integer(-result);
}

std::vector<Integer> integers(std::size_t bits, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Integer> result;
  for (std::size_t i = 0; i < kNumbers; ++i) result.push_back(integer_of(bits, random));
  return result;
}

std::vector<Rational> fractions(std::size_t bits) {
  std::mt19937_64 random(7);
  std::vector<Rational> result;
  for (std::size_t i = 0; i < kNumbers; ++i) {
    const Integer top = integer_of(bits, random);
    const Integer bottom = abs(integer_of(bits, random));
    result.emplace_back(top, bottom);
  }
  return result;
}

template <int L>
void BM_FixedMultiply(benchmark::State& state) {
  const auto x = fixed_numbers<L>(1), y = fixed_numbers<L>(2);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kNumbers; ++i) benchmark::DoNotOptimize(multiply(x[i], y[i]));
  }
  per_call(state);
}
BENCHMARK(BM_FixedMultiply<1>);
BENCHMARK(BM_FixedMultiply<2>);
BENCHMARK(BM_FixedMultiply<4>);
BENCHMARK(BM_FixedMultiply<8>);

template <int L>
void BM_FixedAdd(benchmark::State& state) {
  const auto x = fixed_numbers<L>(1), y = fixed_numbers<L>(2);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kNumbers; ++i) benchmark::DoNotOptimize(x[i] + y[i]);
  }
  per_call(state);
}
BENCHMARK(BM_FixedAdd<2>);
BENCHMARK(BM_FixedAdd<8>);

void BM_GmpMultiply(benchmark::State& state) {
  const auto bits = static_cast<std::size_t>(state.range(0));
  const std::vector<Integer> x = integers(bits, 1), y = integers(bits, 2);
  Integer product;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kNumbers; ++i) {
      product = x[i] * y[i];
      benchmark::DoNotOptimize(product);
    }
  }
  per_call(state);
}
BENCHMARK(BM_GmpMultiply)->ArgName("bits")->Arg(64)->Arg(256)->Arg(512)->Arg(4096);

void BM_NearestDouble(benchmark::State& state) {
  const std::vector<Rational> values = fractions(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    for (const Rational& value : values) benchmark::DoNotOptimize(nearest_double(value));
  }
  per_call(state);
}
BENCHMARK(BM_NearestDouble)->ArgName("bits")->Arg(64)->Arg(256)->Arg(1024);

void BM_ExactText(benchmark::State& state) {
  const std::vector<Rational> values = fractions(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    for (const Rational& value : values) benchmark::DoNotOptimize(exact_text(value));
  }
  per_call(state);
}
BENCHMARK(BM_ExactText)->ArgName("bits")->Arg(64)->Arg(256);

/// Balanced, as against one after the other: the numbers grow with what was added.
void BM_RationalSum(benchmark::State& state) {
  const std::vector<Rational> values = fractions(64);
  for (auto _ : state) {
    RationalSum sum;
    for (const Rational& value : values) sum.add(value);
    benchmark::DoNotOptimize(sum.total());
  }
  per_call(state);
}
void BM_RationalSumInARow(benchmark::State& state) {
  const std::vector<Rational> values = fractions(64);
  for (auto _ : state) {
    Rational sum = 0;
    for (const Rational& value : values) sum += value;
    benchmark::DoNotOptimize(sum);
  }
  per_call(state);
}
BENCHMARK(BM_RationalSum)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_RationalSumInARow)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb
