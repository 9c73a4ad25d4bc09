// check_map beside CGAL's Arrangement_2 (exact predicates, exact constructions) on the same clean maps.
//
//   arrangement_peer [FACES]      (default 30000)
//
// CGAL inserts all edges of the map at once (CGAL::insert of a range: its sweep); CPU time of the insertion
// alone against that of check_map alone, in one run. Both must count the same faces. (CGAL needs time
// quadratic in the edges at one vertex: minutes for a fan of 100000.)
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "../complexity/cpu_time.h"
#include "generate/map_families.h"
#include "plumb/plane/map_check.h"

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

struct Outcome {
  double seconds;
  std::size_t faces;
};

Outcome with_cgal(const testing::TestMap& map) {
  const std::vector<Traits::Curve_2> segments = segments_of(map);
  Arrangement arrangement;
  const double start = cpu_seconds();
  CGAL::insert(arrangement, segments.begin(), segments.end());
  return {cpu_seconds() - start, arrangement.number_of_faces()};
}

Outcome with_plumb(const testing::TestMap& map) {
  Map copy = to_map(map);
  Context context;
  const double start = cpu_seconds();
  const MapReport report = check_map(std::move(copy), {}, context);
  return {cpu_seconds() - start, report.regions.size()};
}

int run(std::uint32_t faces) {
  bool agree = true;
  for (const testing::MapFamily& family : testing::map_families()) {
    const testing::TestMap map = family.make(faces);
    const Outcome ours = with_plumb(map);
    const Outcome theirs = with_cgal(map);
    fmt::print("{:20} {:8} faces  plumb {:8.3f} s  Arrangement_2 {:8.3f} s  ratio {:.3f}{}\n",
               family.name, ours.faces, ours.seconds, theirs.seconds, ours.seconds / theirs.seconds,
               ours.faces == theirs.faces ? "" : "  FACES DIFFER");
    std::fflush(stdout);
    agree = agree && ours.faces == theirs.faces;
  }
  return agree ? 0 : 1;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  const long faces = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 30000;
  if (faces < 10 || faces > 10000000) {
    fmt::print(stderr, "usage: arrangement_peer [FACES], 10 to 10^7\n");
    return 2;
  }
  return plumb::bench::run(static_cast<std::uint32_t>(faces));
}
