// How the time of check_map grows with the number of faces, family by family.
//
//   map_families [--most FACES] [--limit SLOPE] [FAMILY...]
//
// Sizes from 1000 to FACES (default 10^6; a short run: 30000), two a decade; CPU time of check_map
// alone, the least of some repetitions. Prints the times and the fitted exponent with its 95%
// confidence interval. Exit status 1 when an exponent is above SLOPE (default 1.15).
#include "generate/map_families.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "cpu_time.h"
#include "plumb/base/error.h"
#include "plumb/plane/map_check.h"
#include "power_fit.h"

namespace plumb::bench {
namespace {

using testing::MapFamily;

double seconds_once(const Map& map) {
  Map copy = map;
  Context context;
  const double start = cpu_seconds();
  const MapReport report = check_map(std::move(copy), {}, context);
  const double seconds = cpu_seconds() - start;
  PLUMB_CHECK(report.verdict == MapVerdict::Valid);
  return seconds;
}

double least_seconds_of(const Map& map) {
  return least_seconds([&map] { return seconds_once(map); });
}

std::vector<std::uint32_t> sizes_up_to(std::uint32_t most) {
  std::vector<std::uint32_t> sizes;
  for (std::uint32_t decade = 1000; decade <= most; decade *= 10) {
    sizes.push_back(decade);
    if (decade <= most / 3) sizes.push_back(3 * decade);
  }
  return sizes;
}

PowerFit measure(const MapFamily& family, std::uint32_t most) {
  std::vector<Sample> samples;
  for (const std::uint32_t size : sizes_up_to(most)) {
    const testing::TestMap source = family.make(size);
    const auto faces = static_cast<double>(testing::face_count(source));
    const Sample& s = samples.emplace_back(Sample{faces, least_seconds_of(to_map(source))});
    fmt::print("{:20} {:9.0f} faces {:10.6f} s {:8.1f} ns a face\n", family.name, s.size, s.seconds,
               1e9 * s.seconds / s.size);
  }
  return fit_power(samples);
}

bool is_wanted(const MapFamily& family, const std::vector<std::string>& names) {
  return names.empty() || std::find(names.begin(), names.end(), family.name) != names.end();
}

int run(std::uint32_t most, double limit, const std::vector<std::string>& names) {
  bool within = true;
  for (const MapFamily& family : testing::map_families()) {
    if (!is_wanted(family, names)) continue;
    const PowerFit fit = measure(family, most);
    fmt::print("{:20} time ~ faces^{:.3f}, 95% confidence {:.3f} .. {:.3f}{}\n\n", family.name,
               fit.slope, fit.slope - fit.half_width, fit.slope + fit.half_width,
               fit.slope > limit ? "  ABOVE THE LIMIT" : "");
    within = within && fit.slope <= limit;
  }
  return within ? 0 : 1;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"Growth of check_map"};
  std::uint32_t most = 1000000;
  double limit = 1.15;
  std::vector<std::string> names;
  app.add_option("--most", most, "largest number of faces")->check(CLI::Range(10000U, 10000000U));
  app.add_option("--limit", limit, "largest exponent allowed");
  app.add_option("families", names, "only these families");
  CLI11_PARSE(app, argc, argv);
  return plumb::bench::run(most, limit, names);
}
