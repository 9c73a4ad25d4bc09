#include "macro_report.h"

#include <fmt/core.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

#include "../complexity/cpu_time.h"

namespace plumb::bench {
namespace {

constexpr double kEnoughSeconds = 0.3;
constexpr int kMostRuns = 7;

/// From here on the largest resident set is that of what follows: the kernel forgets the peak. Where it does not, of all.
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
  Timing least = once();
  double sum = least.seconds;
  for (int run = 1; run < kMostRuns && sum < kEnoughSeconds; ++run) {
    const Timing next = once();
    sum += next.seconds;
    least.seconds = std::min(least.seconds, next.seconds);
  }
  return {least.seconds, least.size, peak_megabytes()};
}

}  // namespace

std::size_t MacroOptions::size(std::size_t full, std::size_t least) const {
  return std::max(least, static_cast<std::size_t>(static_cast<double>(full) * most / 100));
}

Measured in_own_process(const std::function<std::function<Timing()>()>& prepare) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) {
    int status = 1;
    try {
      const Measured found = least_of_runs(prepare);
      if (write(ends[1], &found, sizeof found) == sizeof found) status = 0;
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}\n", error.what());
    }
    _exit(status);
  }
  close(ends[1]);
  Measured found;
  const bool is_read = read(ends[0], &found, sizeof found) == sizeof found;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!is_read || status != 0) throw std::runtime_error("a measurement failed");
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
  if (options.json.empty()) return status;
  std::ofstream out(options.json);
  if ((out << json.dump(1) << '\n').flush()) return status;
  fmt::print(stderr, "{}: cannot be written\n", options.json);
  return 2;
}

}  // namespace plumb::bench
