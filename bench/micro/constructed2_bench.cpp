// Points of the plane by index, their crossings, and rounding: ns per call, and which rung decided
// (counters filter, exact, big: shares of the calls). "naive" is the bare double expression.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kPoints = 4096;  // about what a sweep has in its caches
constexpr std::uint32_t kMask = kPoints - 1;

using Random = std::mt19937_64;

double real(Random& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }
int integer(Random& random, int reach) {
  return std::uniform_int_distribution<int>(-reach, reach)(random);
}

/// Points 2 i, 2 i + 1 span a line in every table.
PointTable2 random_table() {
  Random random(1);
  PointTable2 t;
  for (std::uint32_t i = 0; i < kPoints; ++i) t.push_back({real(random), real(random)});
  return t;
}

/// All lines pass through (1/8, 1/8), the ends are 20-bit dyadics.
template <class Push>
void push_pencil(Push push) {
  Random random(2);
  for (std::uint32_t i = 0; i < kPoints; i += 2) {
    const double u = integer(random, 1 << 20) * 0x1p-20, v = integer(random, 1 << 20) * 0x1p-20;
    push(0.125 - u, 0.125 - v);
    push(0.125 + 2 * u, 0.125 + 2 * v);
  }
}

PointTable2 pencil_table() {
  PointTable2 t;
  push_pencil([&](double x, double y) { t.push_back({x, y}); });
  return t;
}

/// The same in thirds: no point is a double.
PointTable2 rational_pencil_table() {
  PointTable2 t;
  push_pencil(
      [&](double x, double y) { t.push_back(exact_rational(x) / 3, exact_rational(y) / 3); });
  return t;
}

PointTable2 rational_table() {
  Random random(3);
  PointTable2 t;
  const auto coordinate = [&] { return Rational(integer(random, 1000000), 3000017); };
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const Rational x = coordinate();
    t.push_back(x, coordinate());
  }
  return t;
}

/// Points on a line of slope 1, a few units in the last place off it.
PointTable2 near_line_table() {
  Random random(4);
  PointTable2 t;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const double d = std::fabs(real(random)) + 1;
    t.push_back({d, d + integer(random, 2) * 0x1p-52});
  }
  return t;
}

/// The next three (or four) indices, apart from each other.
struct Picker {
  std::uint32_t n = 0;
  std::array<std::uint32_t, 4> next() {
    n += 2;
    return {n & kMask, (n + 1) & kMask, (n * 5 + 2) & kMask & ~1u, (n * 3 + 7) & kMask};
  }
};

// ---------------------------------------------------------------- by index

void naive_orient2d(benchmark::State& state) {
  const PointTable2 t = random_table();
  Picker pick;
  for (auto _ : state) {
    const auto [i, j, k, l] = pick.next();
    const Point2 a = t.approx(i), b = t.approx(j), c = t.approx(k);
    benchmark::DoNotOptimize((a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x) > 0);
  }
}
BENCHMARK(naive_orient2d);

void points_orient2d(benchmark::State& state) {
  const PointTable2 t = random_table();
  Picker pick;
  for (auto _ : state) {
    const auto [i, j, k, l] = pick.next();
    benchmark::DoNotOptimize(orient2d(t.approx(i), t.approx(j), t.approx(k)));
  }
}
BENCHMARK(points_orient2d);

void index_orient2d(benchmark::State& state, PointTable2 (*make)()) {
  const PointTable2 t = make();
  Picker pick;
  for (auto _ : state) {
    const auto [i, j, k, l] = pick.next();
    benchmark::DoNotOptimize(orient2d(t, i, j, k));
  }
}
BENCHMARK_CAPTURE(index_orient2d, random, random_table);
BENCHMARK_CAPTURE(index_orient2d, near_line, near_line_table);
BENCHMARK_CAPTURE(index_orient2d, rational, rational_table);

void index_orient2d_big(benchmark::State& state) {
  const PointTable2 t = rational_table();
  Picker pick;
  for (auto _ : state) {
    const auto [i, j, k, l] = pick.next();
    benchmark::DoNotOptimize(rung::orient2d_big(t, i, j, k));
  }
}
BENCHMARK(index_orient2d_big);

void index_cross_sign(benchmark::State& state, PointTable2 (*make)()) {
  const PointTable2 t = make();
  Picker pick;
  for (auto _ : state) {
    const auto [i, j, k, l] = pick.next();
    benchmark::DoNotOptimize(cross_sign(t, i, j, k, l));
  }
}
BENCHMARK_CAPTURE(index_cross_sign, random, random_table);
BENCHMARK_CAPTURE(index_cross_sign, rational, rational_table);

void index_compare_xy(benchmark::State& state, PointTable2 (*make)()) {
  const PointTable2 t = make();
  Picker pick;
  for (auto _ : state) {
    const auto [i, j, k, l] = pick.next();
    benchmark::DoNotOptimize(compare_xy(t, i, k));
  }
}
BENCHMARK_CAPTURE(index_compare_xy, random, random_table);
BENCHMARK_CAPTURE(index_compare_xy, rational, rational_table);

// ---------------------------------------------------------------- crossings

std::vector<Crossing2> crossings(const PointTable2& t) {
  std::vector<Crossing2> r;
  Picker pick;
  while (r.size() < kPoints) {
    const auto [a, b, c, l] = pick.next();
    const std::uint32_t d = c + 1;
    if (cross_sign(t, a, b, c, d) != Sign::Zero) r.push_back(make_crossing(t, a, b, c, d));
  }
  return r;
}

void crossing_make(benchmark::State& state, PointTable2 (*make)()) {
  const PointTable2 t = make();
  Picker pick;
  for (auto _ : state) {
    const auto [a, b, c, l] = pick.next();
    benchmark::DoNotOptimize(make_crossing(t, a, b, c, c + 1));
  }
}
BENCHMARK_CAPTURE(crossing_make, random, random_table);
BENCHMARK_CAPTURE(crossing_make, rational, rational_table);

/// Shares of the rungs over one round of all crossings.
struct Shares {
  double filter = 0, exact = 0, big = 0;
  template <class Filter, class Exact>
  void count(Filter filter_rung, Exact exact_rung) {
    if (is_decided(filter_rung())) {
      filter += 1.0 / kPoints;
    } else {
      (is_decided(exact_rung()) ? exact : big) += 1.0 / kPoints;
    }
  }
  void print(benchmark::State& state) const {
    state.counters["filter"] = filter;
    state.counters["exact"] = exact;
    state.counters["big"] = big;
  }
};

void crossing_compare(benchmark::State& state, PointTable2 (*make)()) {
  const PointTable2 t = make();
  const std::vector<Crossing2> c = crossings(t);
  std::uint32_t n = 0;
  for (auto _ : state) {
    const std::uint32_t m = n++;
    benchmark::DoNotOptimize(compare_xy(t, c[m & kMask], c[(m * 7 + 1) & kMask]));
  }
  Shares shares;
  for (std::uint32_t m = 0; m < kPoints; ++m) {
    const Crossing2 &p = c[m], &q = c[(m * 7 + 1) & kMask];
    shares.count([&] { return rung::compare_xy_filter(p, q); },
                 [&] { return rung::compare_xy_exact(t, p, q); });
  }
  shares.print(state);
}
BENCHMARK_CAPTURE(crossing_compare, random, random_table);
BENCHMARK_CAPTURE(crossing_compare, one_point, pencil_table);
BENCHMARK_CAPTURE(crossing_compare, rational, rational_table);
BENCHMARK_CAPTURE(crossing_compare, rational_one_point, rational_pencil_table);

void crossing_compare_point(benchmark::State& state, PointTable2 (*make)()) {
  const PointTable2 t = make();
  const std::vector<Crossing2> c = crossings(t);
  std::uint32_t n = 0;
  for (auto _ : state) {
    const std::uint32_t m = n++;
    benchmark::DoNotOptimize(compare_xy(t, c[m & kMask], (m * 7 + 1) & kMask));
  }
}
BENCHMARK_CAPTURE(crossing_compare_point, random, random_table);
BENCHMARK_CAPTURE(crossing_compare_point, rational, rational_table);

void crossing_side(benchmark::State& state, PointTable2 (*make)()) {
  const PointTable2 t = make();
  const std::vector<Crossing2> c = crossings(t);
  std::uint32_t n = 0;
  for (auto _ : state) {
    const std::uint32_t m = n++;
    const std::uint32_t i = (m * 6 + 10) & kMask;
    benchmark::DoNotOptimize(orient2d(t, i, i + 1, c[m & kMask]));
  }
  Shares shares;
  for (std::uint32_t m = 0; m < kPoints; ++m) {
    const std::uint32_t i = (m * 6 + 10) & kMask;
    shares.count([&] { return rung::orient2d_filter(t, i, i + 1, c[m]); },
                 [&] { return rung::orient2d_exact(t, i, i + 1, c[m]); });
  }
  shares.print(state);
}
BENCHMARK_CAPTURE(crossing_side, random, random_table);
BENCHMARK_CAPTURE(crossing_side, on_the_line, pencil_table);
BENCHMARK_CAPTURE(crossing_side, rational, rational_table);
BENCHMARK_CAPTURE(crossing_side, rational_on_the_line, rational_pencil_table);

// ---------------------------------------------------------------- output

void round_crossing(benchmark::State& state) {
  const PointTable2 t = random_table();
  const Rational x = exact(t, crossings(t).front()).x;
  for (auto _ : state) benchmark::DoNotOptimize(nearest_double(x));
}
BENCHMARK(round_crossing);

void text_of_crossing(benchmark::State& state) {
  const PointTable2 t = random_table();
  const Rational x = exact(t, crossings(t).front()).x;
  for (auto _ : state) benchmark::DoNotOptimize(decimal_text(x, 17));
}
BENCHMARK(text_of_crossing);

void exact_crossing(benchmark::State& state) {
  const PointTable2 t = random_table();
  const Crossing2 p = crossings(t).front();
  for (auto _ : state) benchmark::DoNotOptimize(exact(t, p));
}
BENCHMARK(exact_crossing);

}  // namespace
}  // namespace plumb
