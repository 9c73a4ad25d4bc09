#include "macro_report.h"

#include <fmt/core.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "../complexity/cpu_time.h"
#include "../report/calls.h"
#include "../report/report.h"

namespace plumb::bench {
namespace {

constexpr double kEnoughSeconds = 0.3;
constexpr int kMostRuns = 7;

/// From here on the largest resident set is that of what follows: the kernel forgets the peak.
/// Where it does not, of all.
void forget_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

/// The largest resident set of this process. (getrusage() keeps the peak, and that of the parent.)
double peak_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

/// In the process of the measurement.
Measured least_of_runs(const std::function<std::function<Timing()>()>& prepare) {
  const std::function<Timing()> once = prepare();
  forget_peak();
  reset_rung_counts();
  Timing least = once();
  nlohmann::json calls = calls_of(rung_counts(), 1);
  double sum = least.seconds;
  for (int run = 1; run < kMostRuns && sum < kEnoughSeconds; ++run) {
    const Timing next = once();
    sum += next.seconds;
    least.seconds = std::min(least.seconds, next.seconds);
  }
  return {least.seconds, least.size, peak_megabytes(), std::move(calls)};
}

}  // namespace

std::size_t MacroOptions::size(std::size_t full, std::size_t least) const {
  return std::max(least, static_cast<std::size_t>(static_cast<double>(full) * most / 100));
}

Measured in_own_process(const std::function<std::function<Timing()>()>& prepare) {
  const Finished process = run_apart([&] {
    const Measured found = least_of_runs(prepare);
    fmt::print("{:.17g} {:.17g} {:.17g} {}\n", found.seconds, found.size, found.megabytes,
               found.calls.dump());
  });
  Measured found;
  std::istringstream output(process.output);
  output >> found.seconds >> found.size >> found.megabytes;
  if (!process.is_well || !output) throw std::runtime_error("a measurement failed");
  found.calls = nlohmann::json::parse(output);
  return found;
}

int macro_main(std::string_view part, std::string_view title, int argc, char** argv,
               const std::function<int(const MacroOptions&, nlohmann::ordered_json& rows)>& fill) {
  CLI::App app{std::string(title)};
  MacroOptions options;
  app.add_option("--most", options.most, "percent of the full sizes (default 100)");
  app.add_option("--json", options.json, "write the rows there");
  CLI11_PARSE(app, argc, argv);
  nlohmann::ordered_json json{
      {"part", part}, {"title", title}, {"rows", nlohmann::ordered_json::array()}};
  int status = 2;
  try {
    status = fill(options, json["rows"]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return write_json(options.json, json, status);
}

}  // namespace plumb::bench
