// Contacts of two spheres of triangles: cost per facet of one of them, at several sizes and positions.
#include <benchmark/benchmark.h>

#include <cmath>

#include "generate/meshes.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/meet.h"

namespace plumb {
namespace {

struct Operands {
  SpaceComplex a;
  SpaceComplex b;
  std::shared_ptr<SpaceTables> tables;
};

void refer_to(SpaceComplex& complex, const TableMap& map) {
  for (SpacePoint& p : complex.vertex_point) p = map(p);
  for (PlaneId& p : complex.facet_plane) p = map(p);
  for (auto& planes : complex.edge_planes) planes = {map(planes[0]), map(planes[1])};
}

Operands operands(const PolygonMesh& a, const PolygonMesh& b) {
  Context context;
  Operands result{
      complex_of_mesh(a, {}, context).complex, complex_of_mesh(b, {}, context).complex, {}};
  result.tables = copy(*result.a.tables);
  refer_to(result.b, merge(*result.tables, *result.b.tables));
  result.a.tables = result.b.tables = result.tables;
  return result;
}

PolygonMesh turned(PolygonMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point3& p : mesh.points) p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
  return mesh;
}

/// A third of the radius apart.
PolygonMesh shifted(const PolygonMesh& mesh) { return testing::moved(mesh, {0.21, 0.16, 0.19}); }
PolygonMesh same(const PolygonMesh& mesh) { return mesh; }
PolygonMesh nearly_same(const PolygonMesh& mesh) { return turned(mesh, 1e-12); }
PolygonMesh turned_far(const PolygonMesh& mesh) { return turned(mesh, 0.5); }

void BM_Meet(benchmark::State& state, PolygonMesh (*second)(const PolygonMesh&)) {
  const PolygonMesh mesh = testing::icosphere_mesh(static_cast<int>(state.range(0)), 1, {0, 0, 0});
  const Operands o = operands(mesh, second(mesh));
  Context context;
  std::size_t contacts = 0;
  for (auto _ : state) {
    contacts = meet(o.a, o.b, *o.tables, context).size();
    benchmark::DoNotOptimize(contacts);
  }
  state.counters["facets"] = static_cast<double>(mesh.face_count());
  state.counters["contacts"] = static_cast<double>(contacts);
  state.counters["per_facet"] = benchmark::Counter(
      static_cast<double>(mesh.face_count()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->Arg(3)->Arg(4)->Arg(5)->Arg(6)->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(BM_Meet, shifted, shifted)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Meet, same, same)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Meet, nearly_same, nearly_same)->Apply(sizes);
BENCHMARK_CAPTURE(BM_Meet, turned, turned_far)->Apply(sizes);

}  // namespace
}  // namespace plumb
