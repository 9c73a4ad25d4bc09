// How the time of overlays of the sphere grows, family by family.
//
//   sphere_families [--most N] [--slack S]
//
// CPU time of SphereOverlay::combine alone against n + k (arcs of both operands and points of the
// result), from about 100 to N arcs (default 30000; a short run: 3000). Prints times and the fitted
// exponent with its 95% confidence interval. Exit status 1 when an exponent is above its family's limit.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "cpu_time.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/sphere_overlay.h"
#include "power_fit.h"

namespace plumb::bench {
namespace {

constexpr double kLimit = 1.25;

/// A polygon around the z axis whose corners change between two heights.
NefSphere crown(std::size_t n, double turn, double low, double high) {
  std::vector<SphereVector> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        (static_cast<double>(i) + turn) * 2 * std::numbers::pi / static_cast<double>(n);
    corners.emplace_back(std::cos(angle), std::sin(angle), i % 2 == 0 ? low : high);
  }
  return NefSphere::polygon(corners, Boundary::Closed);
}

/// The maps of two sets over one table.
struct Operands {
  PlaneTable planes;
  SphereMap a;
  SphereMap b;

  Operands(const NefSphere& first, const NefSphere& second)
      : planes(first.planes()), a(first.map()), b(second.map()) {
    const std::vector<PlaneId> to = planes.merge(second.planes());
    for (PlaneId& c : b.circle) c = to[c.value()];
    for (SphereDirection& u : b.direction) u = {to[u.p.value()], to[u.q.value()]};
  }
};

Sample measure_once(const Operands& o) {
  SphereOverlay overlay(o.planes);
  SphereMap out;
  SphereOrigins origins;
  const double seconds = least_seconds([&] {
    const double start = cpu_seconds();
    overlay.combine(o.a, o.b, MarkTable(kUnion), out, origins);
    return cpu_seconds() - start;
  });
  return {static_cast<double>(o.a.arc_count() + o.b.arc_count() + out.point_count()), seconds};
}

/// Zigzags that cross each other in every arc.
Sample crossing_crowns(std::size_t n) {
  return measure_once(Operands(crown(n, 0, 0.5, 1.5), crown(n, 0.37, 0.6, 1.4)));
}
/// One inside the other, without any contact.
Sample nested_crowns(std::size_t n) {
  return measure_once(Operands(crown(n, 0, 0.5, 0.6), crown(n, 0.37, 1.5, 1.6)));
}
/// A set with itself: every point and arc is shared.
Sample equal_crowns(std::size_t n) {
  const NefSphere set = crown(n, 0, 0.5, 1.5);
  return measure_once(Operands(set, set));
}

struct Job {
  const char* name;
  Sample (*run)(std::size_t n);
};
constexpr Job kJobs[] = {{"crossing-crowns", crossing_crowns},
                         {"nested-crowns", nested_crowns},
                         {"equal-crowns", equal_crowns}};

bool measure(const Job& job, std::size_t most, double slack) {
  std::vector<Sample> samples;
  for (double n = 100; n <= static_cast<double>(most) * 1.01; n *= std::sqrt(10.0)) {
    const Sample& s = samples.emplace_back(job.run(2 * static_cast<std::size_t>(n / 2)));
    fmt::print("{:16} {:8.0f} n + k {:10.6f} s {:8.1f} ns each\n", job.name, s.size, s.seconds,
               1e9 * s.seconds / s.size);
  }
  const PowerFit fit = fit_power(samples);
  const bool within = fit.slope <= kLimit + slack;
  fmt::print("{:16} time ~ (n + k)^{:.3f}, 95% confidence {:.3f} .. {:.3f}, limit {:.2f}{}\n\n",
             job.name, fit.slope, fit.slope - fit.half_width, fit.slope + fit.half_width, kLimit,
             within ? "" : "  ABOVE THE LIMIT");
  return within;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Growth of overlays of the sphere"};
  std::size_t most = 30000;
  double slack = 0;
  app.add_option("--most", most, "largest number of arcs")->check(CLI::Range(1000U, 1000000U));
  app.add_option("--slack", slack, "added to the limit");
  CLI11_PARSE(app, argc, argv);
  bool within = true;
  for (const auto& job : plumb::bench::kJobs) {
    if (!plumb::bench::measure(job, most, slack)) within = false;
  }
  return within ? 0 : 1;
}
