// The price of attributes: the union of two spheres of 20,480 triangles as a valid mesh, without
// and with texture coordinates and normals. `job` also makes the sets from their meshes, and
// `job_texture` has texture coordinates only.
#include <benchmark/benchmark.h>

#include <memory>
#include <utility>

#include "generate/meshes.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/valid_mesh.h"

namespace plumb {
namespace {

std::shared_ptr<const MeshSource> textured_sphere(const Point3& centre) {
  MeshSource source{"sphere", testing::icosphere_mesh(5, 1, centre), {}};
  MeshChannel texture{"texcoord_0", 2, {}}, normal{"normal", 3, {}};
  for (const std::uint32_t v : source.mesh.corners) {
    const Point3& p = source.mesh.points[v];
    texture.values.insert(texture.values.end(), {p.x * p.y, p.z * p.z});
    normal.values.insert(normal.values.end(), {p.x - centre.x, p.y - centre.y, p.z - centre.z});
  }
  source.attributes.channels = {texture, normal};
  return std::make_shared<const MeshSource>(std::move(source));
}

const std::shared_ptr<const MeshSource>& sphere(int i) {
  static const std::shared_ptr<const MeshSource> kSpheres[] = {textured_sphere({0, 0, 0}),
                                                               textured_sphere({0.53, 0.31, 0.17})};
  return kSpheres[i];
}

/// Returns a sphere with texture coordinates only.
const std::shared_ptr<const MeshSource>& textured(int i) {
  const auto without_normals = [](int k) {
    MeshSource source = *sphere(k);
    source.attributes.channels.pop_back();
    return std::make_shared<const MeshSource>(std::move(source));
  };
  static const std::shared_ptr<const MeshSource> kSpheres[] = {without_normals(0),
                                                               without_normals(1)};
  return kSpheres[i];
}

ValidMesh mesh_of(const Nef3& set) { return valid_mesh(set, {.faces = MeshFaces::Triangles}); }

void union_plain(benchmark::State& state) {
  const Nef3 a = Nef3::from_mesh(sphere(0)->mesh), b = Nef3::from_mesh(sphere(1)->mesh);
  for (auto _ : state) benchmark::DoNotOptimize(mesh_of(a + b));
}
BENCHMARK(union_plain)->Unit(benchmark::kMillisecond);

void union_attributes(benchmark::State& state) {
  const Nef3 a = from_source(sphere(0)), b = from_source(sphere(1));
  for (auto _ : state) benchmark::DoNotOptimize(mesh_with_attributes(a + b));
}
BENCHMARK(union_attributes)->Unit(benchmark::kMillisecond);

void job_plain(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        mesh_of(Nef3::from_mesh(sphere(0)->mesh) + Nef3::from_mesh(sphere(1)->mesh)));
  }
}
BENCHMARK(job_plain)->Unit(benchmark::kMillisecond);

void job_texture(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        mesh_with_attributes(from_source(textured(0)) + from_source(textured(1))));
  }
}
BENCHMARK(job_texture)->Unit(benchmark::kMillisecond);

void job_attributes(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(mesh_with_attributes(from_source(sphere(0)) + from_source(sphere(1))));
  }
}
BENCHMARK(job_attributes)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plumb
