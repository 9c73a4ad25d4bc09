// Queries to a SpaceLocator on spheres of 20 * 4^depth triangles: time for each, and how it grows.
#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "generate/dice.h"
#include "generate/meshes.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/space_locator.h"
#include "plumb/space/volumes.h"

namespace plumb::testing {
namespace {

SpaceComplex sphere(int depth) {
  Context context;
  SpaceComplex complex = complex_of_mesh(icosphere_mesh(depth, 1, {}), {}, context).complex;
  label_volumes(complex, context);
  return complex;
}

/// Coordinates k / parts in [-1.25, 1.25].
std::vector<Point3> points(std::int64_t parts) {
  Dice dice(1);
  const auto coordinate = [&] {
    return static_cast<double>(dice.between(-parts - parts / 4, parts + parts / 4)) /
           static_cast<double>(parts);
  };
  std::vector<Point3> result;
  for (int i = 0; i < 4096; ++i) {
    const double x = coordinate(), y = coordinate();
    result.push_back({x, y, coordinate()});
  }
  return result;
}

void ask(benchmark::State& state, const SpaceLocator& locator, const std::vector<Point3>& from) {
  std::vector<SpaceItem> items(from.size());
  for (auto _ : state) {
    locator.locate(from, items);
    benchmark::DoNotOptimize(items.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(from.size()));
}

void locate_anywhere(benchmark::State& state) {
  const SpaceComplex complex = sphere(static_cast<int>(state.range(0)));
  ask(state, SpaceLocator(complex), points(std::int64_t{1} << 40));
}
BENCHMARK(locate_anywhere)->DenseRange(2, 6)->Unit(benchmark::kMillisecond);

/// Rays meet vertices and edges, many points lie in planes of symmetry.
void locate_on_a_grid(benchmark::State& state) {
  const SpaceComplex complex = sphere(static_cast<int>(state.range(0)));
  ask(state, SpaceLocator(complex), points(4));
}
BENCHMARK(locate_on_a_grid)->Arg(5)->Unit(benchmark::kMillisecond);

void locate_vertices(benchmark::State& state) {
  const SpaceComplex complex = sphere(static_cast<int>(state.range(0)));
  std::vector<Point3> from;
  for (std::size_t i = 0; i < 4096; ++i) {
    const SpacePoint p = complex.vertex_point[i % complex.vertex_count()];
    from.push_back(complex.planes().point(p.input()));
  }
  ask(state, SpaceLocator(complex), from);
}
BENCHMARK(locate_vertices)->Arg(5)->Unit(benchmark::kMillisecond);

void shoot_from_the_centre(benchmark::State& state) {
  const SpaceComplex complex = sphere(static_cast<int>(state.range(0)));
  const SpaceLocator locator(complex);
  const std::vector<Point3> towards = points(std::int64_t{1} << 40);
  for (auto _ : state) {
    for (const Point3& d : towards) benchmark::DoNotOptimize(locator.shoot(Point3{}, d));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(towards.size()));
}
BENCHMARK(shoot_from_the_centre)->Arg(5)->Unit(benchmark::kMillisecond);

void build(benchmark::State& state) {
  const SpaceComplex complex = sphere(static_cast<int>(state.range(0)));
  for (auto _ : state) SpaceLocator locator(complex);
}
BENCHMARK(build)->Arg(5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb::testing
