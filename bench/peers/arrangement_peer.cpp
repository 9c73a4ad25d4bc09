// check_map beside CGAL's Arrangement_2 (exact predicates, exact constructions) on the same clean
// maps.
//
//   arrangement_peer [FACES] [--rounds N] [--json FILE]      (default 10000 faces)
//
// CGAL inserts all edges of the map at once (CGAL::insert of a range: its sweep); CPU time of the
// insertion alone against that of check_map alone. Both must count the same faces. (CGAL needs time
// quadratic in the edges at one vertex: minutes for a fan of 100000.)
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "../complexity/cpu_time.h"
#include "peer_report.h"
#include "plumb/plane/map_check.h"
#include "plumb/testing/map_families.h"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;

// Numerators and denominators of the generated maps are below 2^53.
Kernel::FT coordinate(const testing::BigRational& value) {
  const Kernel::FT num(static_cast<double>(numerator(value)));
  if (denominator(value) == 1) return num;
  return num / Kernel::FT(static_cast<double>(denominator(value)));
}

std::vector<Traits::Curve_2> segments_of(const testing::TestMap& map) {
  std::vector<Kernel::Point_2> points;
  for (const testing::ExactPoint& p : map.points) {
    points.emplace_back(coordinate(p.x), coordinate(p.y));
    CGAL::exact(points.back());
  }
  std::vector<Traits::Curve_2> segments;
  for (const testing::Cycle& cycle : map.cycles) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::uint32_t u = cycle[i];
      const std::uint32_t v = cycle[(i + 1) % cycle.size()];
      if (u < v) segments.emplace_back(points[u], points[v]);
    }
  }
  return segments;
}

PeerRun with_cgal(const std::vector<Traits::Curve_2>& segments) {
  Arrangement arrangement;
  const double start = cpu_seconds();
  CGAL::insert(arrangement, segments.begin(), segments.end());
  return {cpu_seconds() - start, static_cast<double>(arrangement.number_of_faces()), 0};
}

PeerRun with_plumb(const Map& map) {
  Map copy = map;
  Context context;
  const double start = cpu_seconds();
  const MapReport report = check_map(std::move(copy), {}, context);
  return {cpu_seconds() - start, static_cast<double>(report.regions.size()), 0};
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  using namespace plumb::bench;
  CLI::App app{"Maps beside CGAL's arrangements"};
  std::uint32_t faces = 10000;
  PeerOptions options;
  options.add_to(app);
  app.add_option("faces", faces, "10 to 10^7")->check(CLI::Range(10, 10000000));
  CLI11_PARSE(app, argc, argv);
  PeerReport report("Maps beside CGAL's arrangements");
  report.use("CGAL", CGAL_VERSION_STR);
  for (const plumb::testing::MapFamily& family : plumb::testing::map_families()) {
    const plumb::testing::TestMap made = family.make(faces);
    const plumb::Map map = to_map(made);
    const auto segments = segments_of(made);
    report.compare(
        {"map check", fmt::format("{}, {} faces", family.name, plumb::testing::face_count(made)),
         "CGAL Arrangement_2", "faces", 0, options.rounds},
        [&] { return with_plumb(map); }, [&] { return with_cgal(segments); });
  }
  return report.finish(options.json);
}
