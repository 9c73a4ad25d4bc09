// How the time of arrangements and Booleans of the plane grows, family by family.
//
//   plane_families [--most N] [FAMILY...]
//
// CPU time of the operation alone against n + k (input edges and vertices of the result), from
// about 1000 to N (default 10^5; a short run: 10000). Prints times, the fitted exponent with its
// 95% confidence interval and, for arrangements, the bytes of the result and of the peak per
// crossing. Exit status 1 when an exponent is above its family's limit, or memory above 400 bytes.
#include <fmt/core.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cpu_time.h"
#include "plane_jobs.h"
#include "power_fit.h"

namespace plumb::bench {
namespace {

/// One job at one size: seconds, and the measure its time should be linear in (up to a logarithm).
struct Job {
  const char* name;
  double limit;
  std::size_t smallest;  ///< input size at which it starts
  std::size_t per_size;  ///< sizes go up to most / per_size
  Sample (*run)(std::size_t size);
};

template <class Work>
double seconds_of(Work work) {
  return least_seconds([&work] {
    const double start = cpu_seconds();
    work();
    return cpu_seconds() - start;
  });
}

double size_of(const PlaneComplex& complex, std::size_t n) {
  return static_cast<double>(complex.vertex_count() + n);
}

Sample arrange_short(std::size_t n) {
  const SegmentScene scene = scene_of(testing::short_segments(n));
  return {size_of(arranged(scene).complex, n), seconds_of([&] { arranged(scene); })};
}

Sample arrange_long(std::size_t n) {
  const SegmentScene scene = scene_of(testing::long_segments(n));
  return {size_of(arranged(scene).complex, n), seconds_of([&] { arranged(scene); })};
}

Sample stars(std::size_t n, MarkFunction f) {
  const Nef2 a = Nef2::polygon(testing::star_polygon(n, 1));
  const Nef2 b = Nef2::polygon(testing::star_polygon(n, 2));
  const auto work = [&] {
    Context context;
    return combine(a, b, f, context);
  };
  return {static_cast<double>(2 * n), seconds_of(work)};
}

Sample star_intersection(std::size_t n) { return stars(n, kIntersection); }
Sample star_union(std::size_t n) { return stars(n, kUnion); }
Sample star_difference(std::size_t n) { return stars(n, kSymmetricDifference); }

Sample octagon_union(std::size_t n) {
  const auto polygons = testing::octagons(n);
  return {static_cast<double>(8 * n), seconds_of([&] { union_of_polygons(polygons); })};
}

/// Interior, then closure: no sweep.
Sample regularize(std::size_t n) {
  const Nef2 set = union_of_polygons(testing::octagons(n));
  return {static_cast<double>(set.complex().edge_count()),
          seconds_of([&] { return set.regularization(); })};
}

/// Building the locator and asking it n times.
Sample locate(std::size_t n) {
  const Nef2 star = Nef2::polygon(testing::star_polygon(n, 1));
  const testing::PlanePolygon queries = testing::star_polygon(n, 3);
  return {static_cast<double>(n), seconds_of([&] {
            const Nef2 fresh = !star;  // shares nothing with star
            return std::count_if(queries.begin(), queries.end(),
                                 [&](Point2 p) { return fresh.contains(p); });
          })};
}

constexpr Job kJobs[] = {
    {"arrange-short", 1.1, 1000, 1, arrange_short},
    {"arrange-long", 1.1, 30, 30, arrange_long},
    {"stars-intersection", 1.25, 1000, 1, star_intersection},
    {"stars-union", 1.25, 1000, 1, star_union},
    {"stars-symmetric-difference", 1.25, 1000, 1, star_difference},
    {"octagons-union", 1.25, 300, 3, octagon_union},
    {"octagons-regularize", 1.15, 300, 3, regularize},
    {"star-locate", 1.35, 1000, 1, locate},  // n log^2 n
};

/// Sizes a half decade apart.
std::vector<std::size_t> sizes(std::size_t smallest, std::size_t most) {
  std::vector<std::size_t> result;
  for (double s = static_cast<double>(smallest); s <= static_cast<double>(most) * 1.01;
       s *= std::sqrt(10.0)) {
    result.push_back(static_cast<std::size_t>(std::lround(s)));
  }
  return result;
}

bool measure(const Job& job, std::size_t most, double slack) {
  std::vector<Sample> samples;
  for (const std::size_t n : sizes(job.smallest, most / job.per_size)) {
    const Sample& s = samples.emplace_back(job.run(n));
    fmt::print("{:28} {:8} {:10.0f} n + k {:10.6f} s {:8.1f} ns each\n", job.name, n, s.size,
               s.seconds, 1e9 * s.seconds / s.size);
  }
  const PowerFit fit = fit_power(samples);
  const bool within = fit.slope <= job.limit + slack;
  fmt::print("{:28} time ~ (n + k)^{:.3f}, 95% confidence {:.3f} .. {:.3f}, limit {:.2f}{}\n\n",
             job.name, fit.slope, fit.slope - fit.half_width, fit.slope + fit.half_width, job.limit,
             within ? "" : "  ABOVE THE LIMIT");
  return within;
}

double peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Before anything else has raised the peak.
bool measure_memory() {
  const std::size_t n = 2000;
  const SegmentScene scene = scene_of(testing::long_segments(n));
  const double before = peak_bytes();
  const Arrangement arrangement = arranged(scene);
  const double crossings =
      static_cast<double>(arrangement.complex.vertex_count()) - 2.0 * static_cast<double>(n);
  const double bytes = (peak_bytes() - before) / crossings;
  fmt::print(
      "arrangement of {} long segments, {:.0f} crossings: peak of {:.0f} bytes a crossing\n\n", n,
      crossings, bytes);
  return bytes <= 400;
}

int run(std::size_t most, double slack, const std::vector<std::string>& names) {
  bool within = measure_memory();
  for (const Job& job : kJobs) {
    const bool is_wanted =
        names.empty() || std::find(names.begin(), names.end(), job.name) != names.end();
    if (is_wanted && !measure(job, most, slack)) within = false;
  }
  return within ? 0 : 1;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Growth of arrangements and Booleans of the plane"};
  std::size_t most = 100000;
  double slack = 0;
  std::vector<std::string> names;
  app.add_option("--most", most, "largest input size")->check(CLI::Range(5000U, 10000000U));
  app.add_option("--slack", slack, "added to every limit");
  app.add_option("families", names, "only these families");
  CLI11_PARSE(app, argc, argv);
  plumb::bench::keep_freed_memory();
  return plumb::bench::run(most, slack, names);
}
