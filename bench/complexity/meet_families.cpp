// How the time to find contacts grows with the size of two spheres of triangles in several positions.
//
//   meet_families [--depth D] [--limit X]
//
// prints for each position the time at every size up to 20 * 4^D triangles each and the fitted
// exponent; exits 1 if one is above the limit.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "cpu_time.h"
#include "generate/meshes.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/meet.h"
#include "power_fit.h"

namespace plumb::bench {
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

struct Position {
  const char* name;
  PolygonMesh (*second)(const PolygonMesh&);
};
constexpr Position kPositions[] = {
    {"a third apart",
     [](const PolygonMesh& m) {
       return testing::moved(m, {0.21, 0.16, 0.19});
     }},
    {"apart",
     [](const PolygonMesh& m) {
       return testing::moved(m, {1.2, 1.2, 1.2});
     }},
    {"the same", [](const PolygonMesh& m) { return m; }},
    {"turned by 1e-12", [](const PolygonMesh& m) { return turned(m, 1e-12); }},
    {"turned by 0.5", [](const PolygonMesh& m) { return turned(m, 0.5); }},
};

struct Result {
  double seconds;
  std::size_t contacts;
};

/// The points of earlier runs stay in the table: they are not read again.
Result measure(const Operands& o) {
  Result result{};
  result.seconds = least_seconds([&] {
    Context context;
    const double start = cpu_seconds();
    result.contacts = meet(o.a, o.b, *o.tables, context).size();
    return cpu_seconds() - start;
  });
  return result;
}

PowerFit measure(const Position& position, int depth) {
  std::vector<Sample> samples;
  for (int d = depth - 2; d <= depth; ++d) {
    const PolygonMesh mesh = testing::icosphere_mesh(d, 1, {0, 0, 0});
    const Result r = measure(operands(mesh, position.second(mesh)));
    const auto size = static_cast<double>(mesh.face_count());
    samples.push_back({size, r.seconds});
    fmt::print("{:16} 2 x {:7.0f} facets {:8} contacts {:9.2f} ms {:8.1f} ns a facet\n",
               position.name, size, r.contacts, 1e3 * r.seconds, 5e8 * r.seconds / size);
  }
  return fit_power(samples);
}

int run(int depth, double limit) {
  bool within = true;
  for (const Position& position : kPositions) {
    const PowerFit fit = measure(position, depth);
    fmt::print("{:16} time ~ facets^{:.3f}{}\n\n", position.name, fit.slope,
               fit.slope > limit ? "  ABOVE THE LIMIT" : "");
    within = within && fit.slope <= limit;
  }
  return within ? 0 : 1;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Growth of meet"};
  int depth = 6;
  double limit = 1.15;
  app.add_option("--depth", depth, "how often the largest sphere is subdivided")
      ->check(CLI::Range(3, 8));
  app.add_option("--limit", limit, "largest exponent allowed");
  CLI11_PARSE(app, argc, argv);
  return plumb::bench::run(depth, limit);
}
