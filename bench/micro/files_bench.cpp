// Readers and writers, in memory, in bytes a second: a sphere of 20,480 triangles, a map of 10,000
// hexagons, a star of 10,000 corners.
#include <benchmark/benchmark.h>

#include <string>
#include <string_view>
#include <utility>

#include "../text_of.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/plane_families.h"
#include "plumb/io/map_io.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/predicates/error.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/map_families.h"

namespace plumb {
namespace {

using bench::text_of;

/// What `read` makes of the text that `write` writes.
template <class Read>
void run_reader(benchmark::State& state, const std::string& text, Read read) {
  for (auto _ : state) {
    Context context;
    benchmark::DoNotOptimize(read(text, context));
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}

template <class Write>
void run_writer(benchmark::State& state, Write write) {
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::string text = text_of(write);
    bytes += text.size();
    benchmark::DoNotOptimize(text.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}

void add_meshes() {
  static const PolygonMesh mesh = testing::icosphere_mesh(5, 1, {0, 0, 0});
  constexpr std::pair<const char*, MeshFormat> kFormats[] = {
      {"off", MeshFormat::Off}, {"obj", MeshFormat::Obj},
      {"stl", MeshFormat::Stl}, {"stl-binary", MeshFormat::StlBinary},
      {"ply", MeshFormat::Ply}, {"ply-text", MeshFormat::PlyText}};
  for (const auto& [name, format] : kFormats) {
    const auto write = [format = format](std::ostream& out) { write_mesh(out, mesh, format); };
    benchmark::RegisterBenchmark(
        (std::string("read/") + name).c_str(), [=, format = format](benchmark::State& state) {
          run_reader(state, text_of(write), [format](const std::string& text, Context& context) {
            return read_mesh(text, format, {}, context);
          });
        });
    benchmark::RegisterBenchmark((std::string("write/") + name).c_str(),
                                 [=](benchmark::State& state) { run_writer(state, write); });
  }
}

void add_sets_of_space() {
  static const Nef3 set = testing::solid(testing::icosphere_mesh(5, 1, {0, 0, 0}));
  const auto write = [](std::ostream& out) { write_nef3(out, set.complex()); };
  benchmark::RegisterBenchmark("read/nef", [=](benchmark::State& state) {
    run_reader(state, text_of(write), [](const std::string& text, Context& context) {
      return read_nef3(text, {}, context);
    });
  });
  benchmark::RegisterBenchmark("read/nef, with its audit", [=](benchmark::State& state) {
    run_reader(state, text_of(write), [](const std::string& text, Context& context) {
      SpaceComplex complex = read_nef3(text, {}, context);
      PLUMB_CHECK(!audit(complex, AuditForm::Minimal, context));
      return complex;
    });
  });
  benchmark::RegisterBenchmark("write/nef",
                               [=](benchmark::State& state) { run_writer(state, write); });
}

void add_maps() {
  static const Map map = to_map(testing::hexagons(100, 1));
  const auto write = [](std::ostream& out) { write_map(out, map); };
  benchmark::RegisterBenchmark("read/map", [=](benchmark::State& state) {
    run_reader(state, text_of(write), [](const std::string& text, Context& context) {
      return read_map(text, {}, context);
    });
  });
  benchmark::RegisterBenchmark("write/map",
                               [=](benchmark::State& state) { run_writer(state, write); });
}

void add_sets_of_the_plane() {
  static const Nef2 star = Nef2::polygon(testing::star_polygon(10000, 1));
  constexpr std::pair<const char*, PlaneFormat> kFormats[] = {
      {"wkt", PlaneFormat::Wkt}, {"geojson", PlaneFormat::GeoJson}, {"nef2", PlaneFormat::Nef2}};
  for (const auto& [name, format] : kFormats) {
    const auto write = [format = format](std::ostream& out) {
      Context context;
      PlaneText(star, format, context).write(out, context);
    };
    benchmark::RegisterBenchmark(
        (std::string("read/") + name).c_str(), [=, format = format](benchmark::State& state) {
          run_reader(state, text_of(write), [format](const std::string& text, Context& context) {
            return read_plane_set(text, format, {}, context);
          });
        });
    benchmark::RegisterBenchmark((std::string("write/") + name).c_str(),
                                 [=](benchmark::State& state) { run_writer(state, write); });
  }
}

const bool registered = [] {
  add_meshes();
  add_sets_of_space();
  add_maps();
  add_sets_of_the_plane();
  return true;
}();

}  // namespace
}  // namespace plumb
