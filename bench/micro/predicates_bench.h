// Registers one benchmark: a predicate over all tuples of a data set.
#pragma once

#include <benchmark/benchmark.h>

#include <string>
#include <tuple>
#include <utility>

#include "plumb/predicates/sign.h"
#include "predicate_data.h"

namespace plumb::bench {

inline const char* name_of(Family f) {
  return f == Family::Random ? "random" : (f == Family::Near ? "near" : "degenerate");
}

/// CPU time a call as the counter "per_call" (the time column is per pass over all tuples).
template <class Data, class Predicate>
void run_all(benchmark::State& state, const Data& data, Predicate predicate) {
  for (auto _ : state) {
    int sum = 0;
    for (const auto& tuple : data) sum += static_cast<int>(std::apply(predicate, tuple));
    benchmark::DoNotOptimize(sum);
  }
  state.counters["per_call"] = benchmark::Counter(
      static_cast<double>(data.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// The share of tuples on which `rung` gives a sign.
template <class Data, class RungFunction>
double share(const Data& data, RungFunction rung) {
  std::size_t count = 0;
  for (const auto& tuple : data) count += is_decided(std::apply(rung, tuple));
  return static_cast<double>(count) / static_cast<double>(data.size());
}

template <class Data, class Predicate>
void measure(const std::string& name, Family family, Data data, Predicate predicate) {
  const std::string full = name + "/" + name_of(family);
  benchmark::RegisterBenchmark(full.c_str(), [=, data = std::move(data)](benchmark::State& state) {
    run_all(state, data, predicate);
  });
}

/// With the share of tuples that each rung decides.
template <class Data, class Predicate, class Filter, class Small, class Exact>
void measure(const std::string& name, Family family, Data data, Predicate predicate, Filter filter,
             Small small, Exact exact) {
  const std::string full = name + "/" + name_of(family);
  const auto up_to_small = [=](const auto&... p) {
    const FilteredSign s = filter(p...);
    return is_decided(s) ? s : small(p...);
  };
  const auto up_to_exact = [=](const auto&... p) {
    const FilteredSign s = up_to_small(p...);
    return is_decided(s) ? s : exact(p...);
  };
  const double one = share(data, filter), two = share(data, up_to_small);
  const double three = share(data, up_to_exact);
  benchmark::RegisterBenchmark(full.c_str(), [=, data = std::move(data)](benchmark::State& state) {
    run_all(state, data, predicate);
    state.counters["filter"] = one;
    state.counters["small"] = two - one;
    state.counters["exact"] = three - two;
    state.counters["big"] = 1 - three;
  });
}

}  // namespace plumb::bench
