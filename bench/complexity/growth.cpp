#include "growth.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "../report/calls.h"
#include "../report/report.h"
#include "cpu_time.h"
#include "power_fit.h"

namespace plumb::bench {
namespace {

constexpr double kTolerance = 0.15;
constexpr int kBatches = 5;
constexpr double kBatchSeconds = 0.02;
constexpr std::size_t kLeastSizes = 6;
constexpr double kLeastSpan = 100;
constexpr double kLongSeconds = 4;  ///< no further batches after that
constexpr double kBusySlack =
    0.3;  ///< for time, where it must stand in for instructions on a busy machine

struct Measure {
  const char* name;
  double Cost::*value;
};
constexpr std::array kMeasures{
    Measure{"seconds", &Cost::seconds}, Measure{"instructions", &Cost::instructions},
    Measure{"allocations", &Cost::allocations}, Measure{"bytes", &Cost::bytes},
    Measure{"predicates", &Cost::predicates}};

struct SizeCost {
  double size = 0;
  Cost least;
  RungCounts rungs{};    ///< of the last batch
  std::size_t runs = 0;  ///< in it
};

/// Other programs disturb caches: short runs are batched, all inputs of a size alike, and the least
/// counts.
SizeCost cost_of(const Work& work, Meter& meter) {
  SizeCost result{work.size, {}};
  double all = 0;
  for (int batch = 0; batch < kBatches && all < kLongSeconds; ++batch) {
    Cost sum;
    std::size_t runs = 0;
    for (; runs == 0 || sum.seconds < kBatchSeconds || runs % work.inputs != 0; ++runs) {
      work.run(meter);
      const Cost cost = meter.take();
      for (const Measure& m : kMeasures) sum.*m.value += cost.*m.value;
      for (std::size_t p = 0; p < kPredicates; ++p) {
        for (std::size_t r = 0; r < kRungs; ++r) sum.rungs[p][r] += cost.rungs[p][r];
      }
    }
    all += sum.seconds;
    for (const Measure& m : kMeasures) {
      const double mean = sum.*m.value / static_cast<double>(runs);
      result.least.*m.value = batch == 0 ? mean : std::min(result.least.*m.value, mean);
    }
    result.rungs = sum.rungs;
    result.runs = runs;
  }
  return result;
}

/// Of cost / log(size)^logs.
PowerFit fit(const std::vector<SizeCost>& costs, double Cost::*value, int logs) {
  std::vector<Sample> samples;
  for (const SizeCost& c : costs) {
    samples.push_back({c.size, c.least.*value / std::pow(std::log2(c.size), logs)});
  }
  return fit_power(samples);
}

struct Options {
  double most = 100;
  double slack = 0;
  bool work_only = false;
};

std::vector<std::size_t> chosen_sizes(const Family& family, double percent) {
  std::vector<std::size_t> sizes = family.sizes;
  const double largest = static_cast<double>(sizes.back()) * percent / 100;
  while (sizes.size() > 3 && static_cast<double>(sizes.back()) > largest) sizes.pop_back();
  return sizes;
}

std::string bound_text(const Bound& bound) {
  return fmt::format("size^{:g}{}", bound.power,
                     bound.logs == 0 ? "" : fmt::format(" log^{}", bound.logs));
}

bool are_counted(const std::vector<SizeCost>& costs, double Cost::*value) {
  return std::ranges::all_of(costs, [&](const SizeCost& c) { return c.least.*value > 0; });
}

/// Prints the verdicts of a family and adds them to its JSON. True when all are within.
bool judge(const Family& family, const std::vector<SizeCost>& costs, const Options& options,
           nlohmann::ordered_json& json) {
  bool is_within = true;
  for (const Measure& m : kMeasures) {
    if (!are_counted(costs, m.value)) continue;
    const PowerFit f = fit(costs, m.value, family.bound.logs);
    const bool stands_in = m.value == &Cost::seconds && options.work_only;
    const bool is_judged = !(stands_in && are_counted(costs, &Cost::instructions));
    const double limit =
        family.bound.power + kTolerance + options.slack + (stands_in ? kBusySlack : 0);
    const bool is_over = f.slope > limit;
    fmt::print("    {:12} / log^{} ~ size^{:.3f} +- {:.3f}{}\n", m.name, family.bound.logs, f.slope,
               f.half_width, is_over ? (is_judged ? "   ABOVE" : "   above, not judged") : "");
    json["fits"][m.name] = {{"power", f.slope}, {"half_width", f.half_width}, {"within", !is_over}};
    if (is_judged && is_over) is_within = false;
  }
  if (family.goal > 0) {
    const PowerFit f = fit(costs, &Cost::seconds, 0);
    const bool is_over = f.slope > family.goal + options.slack;
    fmt::print("    seconds ~ size^{:.3f} +- {:.3f}, goal {:.2f}{}\n", f.slope, f.half_width,
               family.goal, is_over ? "   ABOVE" : "");
    json["goal"] = {{"power", f.slope},
                    {"half_width", f.half_width},
                    {"most", family.goal},
                    {"within", !is_over}};
    if (is_over && !options.work_only) is_within = false;
  }
  return is_within;
}

nlohmann::ordered_json to_json(const SizeCost& c) {
  nlohmann::ordered_json json{{"size", c.size}};
  for (const Measure& m : kMeasures) json[m.name] = c.least.*m.value;
  return json;
}

void print_calls(const nlohmann::ordered_json& calls) {
  for (const auto& [predicate, rungs] : calls.items()) {
    fmt::print("    {:18}", predicate);
    for (const auto& [rung, count] : rungs.items()) {
      fmt::print(" {:12.1f} {}", count.get<double>(), rung);
    }
    fmt::print("\n");
  }
}

void print_size(const SizeCost& c, std::string_view unit) {
  fmt::print(
      "  {:10.0f} {:14} {:10.6f} s {:9.1f} ns {:9.0f} instructions {:8.2f} allocations {:8.1f} "
      "bytes {:8.2f} predicates each\n",
      c.size, unit, c.least.seconds, 1e9 * c.least.seconds / c.size, c.least.instructions / c.size,
      c.least.allocations / c.size, c.least.bytes / c.size, c.least.predicates / c.size);
  std::fflush(stdout);
}

/// Are these sizes that a power may be read off?
bool are_enough(const std::vector<SizeCost>& costs) {
  if (costs.size() >= kLeastSizes && costs.back().size >= kLeastSpan * costs.front().size) {
    return true;
  }
  fmt::print("    TOO FEW SIZES: {} over a factor of {:.1f}\n", costs.size(),
             costs.back().size / costs.front().size);
  return false;
}

/// True when the family is within its bound. Throws what its making of inputs throws.
bool measure(const Family& family, const Options& options, Meter& meter,
             nlohmann::ordered_json& json) {
  fmt::print("{}: {}; bound {}\n", family.name, family.claim, bound_text(family.bound));
  json = {
      {"name", family.name},
      {"claim", family.claim},
      {"unit", family.unit},
      {"bound",
       {{"power", family.bound.power}, {"logs", family.bound.logs}, {"tolerance", kTolerance}}}};
  std::vector<SizeCost> costs;
  for (const std::size_t size : chosen_sizes(family, options.most)) {
    const Work work = family.prepare(size);
    const SizeCost& c = costs.emplace_back(cost_of(work, meter));
    print_size(c, family.unit);
    json["samples"].push_back(to_json(c));
  }
  const SizeCost& largest = costs.back();
  json["calls"] = calls_of(largest.rungs, static_cast<double>(largest.runs));
  print_calls(json["calls"]);
  const bool has_all_sizes = options.most < 100 || are_enough(costs);
  const bool is_within = judge(family, costs, options, json) && has_all_sizes;
  json["within"] = is_within;
  fmt::print("\n");
  return is_within;
}

/// The same; a family that throws is not within, its JSON says why, and the next ones are measured.
bool measure_or_note(const Family& family, const Options& options, Meter& meter,
                     nlohmann::ordered_json& json) {
  try {
    return measure(family, options, meter, json);
  } catch (const std::exception& error) {
    fmt::print("    FAILED: {}\n\n", error.what());
    json = {{"name", family.name},
            {"claim", family.claim},
            {"unit", family.unit},
            {"failure", error.what()},
            {"within", false}};
    return false;
  }
}

}  // namespace

std::vector<std::size_t> sizes_between(double least, double most, double factor) {
  std::vector<std::size_t> sizes;
  for (double s = least; s <= most * 1.01; s *= factor) {
    sizes.push_back(static_cast<std::size_t>(std::lround(s)));
  }
  return sizes;
}

int growth_main(std::string_view title, std::span<const Family> families, int argc, char** argv) {
  CLI::App app{std::string(title)};
  Options options;
  std::string json_file;
  std::vector<std::string> names;
  app.add_option("--most", options.most, "percent of the largest size to go to (default 100)");
  app.add_option("--slack", options.slack, "added to every bound and goal");
  app.add_flag("--work", options.work_only, "judge instructions and allocations, not time");
  app.add_option("--json", json_file, "write the measurements there");
  app.add_option("families", names, "only these (default: all)");
  CLI11_PARSE(app, argc, argv);
  keep_freed_memory();
  Meter meter;
  if (!meter.counts_instructions()) fmt::print("This system does not count instructions.\n\n");
  nlohmann::ordered_json json{{"title", title}, {"families", nlohmann::ordered_json::array()}};
  for (const std::string& name : names) {
    if (std::ranges::find(families, name, &Family::name) != families.end()) continue;
    fmt::print(stderr, "no family '{}'\n", name);
    return 2;
  }
  bool is_within = true;
  for (const Family& family : families) {
    if (!names.empty() && std::find(names.begin(), names.end(), family.name) == names.end())
      continue;
    if (!measure_or_note(family, options, meter, json["families"].emplace_back())) {
      is_within = false;
    }
  }
  return write_json(json_file, json, is_within ? 0 : 1);
}

}  // namespace plumb::bench
