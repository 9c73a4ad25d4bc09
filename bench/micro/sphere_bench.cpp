// Overlays of the sphere maps that Booleans of solids meet: time of one combine().
#include <benchmark/benchmark.h>

#include <vector>

#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/sphere_overlay.h"

namespace plumb {
namespace {

/// A corner of n facets around a direction.
NefSphere corner(int n, const SphereVector& lean) {
  const std::vector<SphereVector> all{{3, 0, 1},  {2, 2, 1},   {0, 3, 1},  {-2, 2, 1},
                                      {-3, 0, 1}, {-2, -2, 1}, {0, -3, 1}, {2, -2, 1}};
  std::vector<SphereVector> corners;
  for (int i = 0; i < n; ++i) {
    const SphereVector& v = all[static_cast<std::size_t>(i * 8 / n)];
    corners.emplace_back(Rational(v.x + lean.x), Rational(v.y + lean.y), Rational(v.z + lean.z));
  }
  return NefSphere::polygon(corners, Boundary::Closed);
}

/// The map of a convex edge.
NefSphere edge(const SphereVector& n1, const SphereVector& n2) {
  return NefSphere::convex(std::vector<SphereVector>{n1, n2}, Boundary::Closed);
}

NefSphere facet(const SphereVector& n) { return NefSphere::half_sphere(n, Boundary::Closed); }

void run(benchmark::State& state, const NefSphere& first, const NefSphere& second) {
  PlaneTable planes(first.planes());
  SphereMap b = second.map();
  if (first.shared_planes() != second.shared_planes()) {
    const std::vector<PlaneId> to = planes.merge(second.planes());
    for (PlaneId& c : b.circle) c = to[c.value()];
    for (SphereDirection& u : b.direction) u = {to[u.p.value()], to[u.q.value()]};
  }
  SphereOverlay overlay(planes);
  SphereMap out;
  SphereOrigins origins;
  for (auto _ : state) {
    overlay.combine(first.map(), b, MarkTable(kUnion), out, origins);
    benchmark::DoNotOptimize(out.direction.data());
  }
  state.counters["points"] = static_cast<double>(out.point_count());
}

const SphereVector kNone{0, 0, 0};

void BM_FacetAndFacet(benchmark::State& s) { run(s, facet({1, 2, 3}), facet({3, -1, 1})); }
void BM_EdgeAndFacet(benchmark::State& s) {
  run(s, edge({1, 2, 3}, {-1, 1, 2}), facet({3, -1, 1}));
}
void BM_CornerAndFacet(benchmark::State& s) { run(s, corner(4, kNone), facet({1, 5, 1})); }
void BM_CornerAndCorner(benchmark::State& s) {
  const int n = static_cast<int>(s.range(0));
  run(s, corner(n, kNone), corner(n, {1, 1, 0}));
}
void BM_CornerAndItself(benchmark::State& s) {
  const NefSphere set = corner(static_cast<int>(s.range(0)), kNone);
  run(s, set, set);
}
BENCHMARK(BM_FacetAndFacet);
BENCHMARK(BM_EdgeAndFacet);
BENCHMARK(BM_CornerAndFacet);
BENCHMARK(BM_CornerAndCorner)->Arg(3)->Arg(4)->Arg(8);
BENCHMARK(BM_CornerAndItself)->Arg(3)->Arg(4)->Arg(8);

}  // namespace
}  // namespace plumb
