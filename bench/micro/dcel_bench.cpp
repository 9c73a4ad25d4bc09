// Building and walking the half-edge structure of an n x n grid; ns per half-edge in
// "per_halfedge".
#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "plumb/dcel/dcel.h"

namespace plumb {
namespace {

struct Grid {
  std::size_t vertices = 0;
  std::vector<std::uint32_t> corners, cycle_begin = {0}, twin, face_of_cycle;
};

/// Squares row by row, or in random order (how badly does the order of the listing matter?). The
/// outside is closed the way a torus is, so that twins have a formula.
Grid make_grid(std::uint32_t n, bool shuffled) {
  Grid g;
  g.vertices = std::size_t{n} * n;
  std::vector<std::uint32_t> place(g.vertices), cell(g.vertices);
  std::iota(place.begin(), place.end(), 0U);
  if (shuffled) std::shuffle(place.begin(), place.end(), std::mt19937(1));
  for (std::uint32_t i = 0; i < place.size(); ++i) cell[place[i]] = i;
  const auto at = [n](std::uint32_t x, std::uint32_t y) { return (y % n) * n + x % n; };
  for (const std::uint32_t c : cell) {
    const std::uint32_t x = c % n, y = c / n;
    g.corners.insert(g.corners.end(), {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    g.twin.insert(g.twin.end(), {4 * place[at(x, y + n - 1)] + 2, 4 * place[at(x + 1, y)] + 3,
                                 4 * place[at(x, y + 1)], 4 * place[at(x + n - 1, y)] + 1});
    g.cycle_begin.push_back(static_cast<std::uint32_t>(g.corners.size()));
    g.face_of_cycle.push_back(static_cast<std::uint32_t>(g.face_of_cycle.size()));
  }
  return g;
}

DcelFromCycles build(const Grid& g) {
  return Dcel::from_cycles(g.vertices, g.corners, g.cycle_begin, g.twin, g.face_of_cycle);
}

void per_halfedge(benchmark::State& state, std::size_t halfedges) {
  state.counters["per_halfedge"] = benchmark::Counter(
      static_cast<double>(halfedges),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

Grid input(const benchmark::State& state) {
  return make_grid(static_cast<std::uint32_t>(state.range(0)), state.range(1) != 0);
}

void BM_Build(benchmark::State& state) {
  const Grid g = input(state);
  for (auto _ : state) benchmark::DoNotOptimize(build(g));
  per_halfedge(state, g.corners.size());
}

void BM_WalkLoops(benchmark::State& state) {
  const Grid g = input(state);
  const Dcel d = build(g).dcel;
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (std::size_t l = 0; l < d.loop_slots(); ++l) {
      for (const HalfedgeId h : d.along(LoopId(l))) sum += d.origin(h).value();
    }
    benchmark::DoNotOptimize(sum);
  }
  per_halfedge(state, g.corners.size());
}

void BM_WalkAroundVertices(benchmark::State& state) {
  const Grid g = input(state);
  const Dcel d = build(g).dcel;
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (std::size_t v = 0; v < d.vertex_slots(); ++v) {
      for (const HalfedgeId h : d.around(VertexId(v))) sum += d.face(h).value();
    }
    benchmark::DoNotOptimize(sum);
  }
  per_halfedge(state, g.corners.size());
}

void BM_Audit(benchmark::State& state) {
  const Grid g = input(state);
  const Dcel d = build(g).dcel;
  for (auto _ : state) benchmark::DoNotOptimize(d.audit());
  per_halfedge(state, g.corners.size());
}

void BM_SplitAndJoinEdge(benchmark::State& state) {
  Dcel d;
  const FaceId f = d.add_face();
  const HalfedgeId h = d.add_edge(d.add_vertex(f), d.add_vertex(f));
  for (auto _ : state) {
    d.join_edge(d.split_edge(h));
    if (d.halfedge_slots() > (1U << 20U)) d.compact();
  }
}

/// A loop split by a chord, and away with it.
void BM_SplitAndJoinFace(benchmark::State& state) {
  Dcel d;
  const FaceId f = d.add_face();
  const HalfedgeId first = d.add_edge(d.add_vertex(f), d.add_vertex(f));
  const HalfedgeId second = d.add_edge(first, d.add_vertex(f));
  for (auto _ : state) {
    const HalfedgeId chord = d.add_edge(twin(first), twin(second));
    benchmark::DoNotOptimize(chord);
    d.remove_edge(chord);
    if (d.halfedge_slots() > (1U << 20U)) d.compact();
  }
}

/// Half of the edges of a strip of n split edges go, then the rest moves together.
void BM_Compact(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    Dcel d;
    const FaceId f = d.add_face();
    HalfedgeId h = d.add_edge(d.add_vertex(f), d.add_vertex(f));
    std::vector<HalfedgeId> made;
    for (std::size_t i = 0; i < n; ++i) made.push_back(h = d.split_edge(h));
    for (std::size_t i = n; i >= 2; i -= 2) d.join_edge(made[i - 1]);
    state.ResumeTiming();
    benchmark::DoNotOptimize(d.compact());
  }
  per_halfedge(state, 2 * n);
}

// {side of the grid, shuffled}: 4 * 10^6 half-edges at side 1000.
void sizes(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{100, 1000}, {0, 1}})->Unit(benchmark::kMillisecond);
}
BENCHMARK(BM_Build)->Apply(sizes);
BENCHMARK(BM_WalkLoops)->Apply(sizes);
BENCHMARK(BM_WalkAroundVertices)->Apply(sizes);
BENCHMARK(BM_Audit)->Apply(sizes);
BENCHMARK(BM_SplitAndJoinEdge);
BENCHMARK(BM_SplitAndJoinFace);
BENCHMARK(BM_Compact)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb
