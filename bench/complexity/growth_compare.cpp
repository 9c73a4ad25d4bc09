// Compares two files of bench/run, growth, memory of structures and capabilities: growth_compare OLD NEW
//
// Prints, for every family and size in both, what changed: instructions, allocations, their bytes, loads and stores and calls
// of predicates by more than 2%, calls that the filter did not decide by more than 2% of all, and time by more than 15% where
// its batches say so, too: a sign test of all batches of the family, every old one against the new one of its place, at the 5%
// level. Then bytes that structures hold and calls of predicates of capabilities, by more than 2%, and what of OLD has no
// counterpart in NEW. Exit status 1 when something has become worse or a family, structure or capability is gone, 2 when a file
// cannot be read or nothing is in both.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <exception>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace plumb::bench {
namespace {

using Json = nlohmann::json;

constexpr double kWorkTolerance = 0.02;
constexpr double kTimeTolerance = 0.15;
constexpr double kLevel = 0.05;

Json read(const std::string& path) {
  std::ifstream in(path);
  return Json::parse(in);
}

/// Samples of every family, by size.
using Samples = std::map<std::string, std::map<double, Json>>;

Samples samples_of(const Json& all) {
  Samples result;
  for (const Json& program : all.at("programs")) {
    for (const Json& family : program.at("families")) {
      if (!family.contains("samples")) continue;  // it failed
      for (const Json& sample : family.at("samples")) {
        const std::string name =
            program.at("title").get<std::string>() + ": " + family.at("name").get<std::string>();
        result[name][sample.at("size").get<double>()] = sample;
      }
    }
  }
  return result;
}

/// A figure of every row of a part of bench/macro that has one; empty for files without that part.
using Figures = std::map<std::string, double>;

template <class Figure>
Figures figures_of(const Json& all, const char* part, const char* name, Figure figure) {
  Figures result;
  for (const Json& found : all.value("macro", Json::array())) {
    if (found.at("part") != part) continue;
    for (const Json& row : found.at("rows")) {
      const double value = figure(row);
      if (value > 0) {
        result[row.at(name).get<std::string>() + ", " + row.at("input").get<std::string>()] = value;
      }
    }
  }
  return result;
}

/// Bytes that an element of every structure holds.
Figures memory_of(const Json& all) {
  return figures_of(all, "memory", "structure",
                    [](const Json& row) { return row.at("measured").get<double>(); });
}

/// Calls of predicates of every capability that makes any.
Figures calls_of(const Json& all) {
  return figures_of(all, "capabilities", "capability", [](const Json& row) {
    double sum = 0;
    for (const Json& rungs : row.value("calls", Json::object())) {
      for (const Json& calls : rungs) sum += calls.get<double>();
    }
    return sum;
  });
}

bool compare_work(const std::string& family, double size, const Json& before, const Json& after) {
  bool is_well = true;
  for (const char* const count :
       {"instructions", "allocations", "bytes", "accesses", "predicates"}) {
    const double old_count = before.value(count, 0.0), new_count = after.value(count, 0.0);
    if (old_count <= 0 || new_count <= 0) continue;
    const double ratio = new_count / old_count;
    if (std::fabs(ratio - 1) <= kWorkTolerance) continue;
    fmt::print("{} {:.0f}: {} x {:.3f}\n", family, size, count, ratio);
    if (ratio > 1) is_well = false;
  }
  return is_well;
}

/// The share of calls of predicates that neither ids nor the filter decided.
double unfiltered_share(const Json& sample) {
  const double calls = sample.value("predicates", 0.0);
  return calls > 0 ? sample.at("unfiltered").get<double>() / calls : 0;
}

/// True unless more calls pass the filter. Both have to count calls.
bool compare_rungs(const std::string& family, double size, const Json& before, const Json& after) {
  if (before.value("predicates", 0.0) <= 0 || after.value("predicates", 0.0) <= 0) return true;
  const double old_share = unfiltered_share(before), new_share = unfiltered_share(after);
  if (std::fabs(new_share - old_share) <= kWorkTolerance) return true;
  fmt::print("{} {:.0f}: beyond the filter {:.1f}% of the calls, were {:.1f}%\n", family, size,
             100 * new_share, 100 * old_share);
  return new_share < old_share;
}

/// Batches that became slower, and all of them that changed.
struct Signs {
  unsigned slower = 0;
  unsigned all = 0;

  void add(const Json& before, const Json& after) {
    const std::size_t count = std::min(before.size(), after.size());
    for (std::size_t i = 0; i < count; ++i) {
      const double old_seconds = before[i], new_seconds = after[i];
      if (old_seconds == new_seconds) continue;
      ++all;
      if (new_seconds > old_seconds) ++slower;
    }
  }
  /// That as many or more would be slower by chance.
  double chance() const {
    if (slower == 0) return 1;
    return boost::math::cdf(
        boost::math::complement(boost::math::binomial(all, 0.5), static_cast<double>(slower) - 1));
  }
};

/// True unless it has become worse. Requires a size in both.
bool compare(const std::string& family, const std::map<double, Json>& before,
             const std::map<double, Json>& after) {
  bool is_well = true;
  Signs signs;
  double logarithms = 0;
  int sizes = 0;
  for (const auto& [size, old_sample] : before) {
    const auto found = after.find(size);
    if (found == after.end()) continue;
    if (!compare_work(family, size, old_sample, found->second)) is_well = false;
    if (!compare_rungs(family, size, old_sample, found->second)) is_well = false;
    signs.add(old_sample.at("batches"), found->second.at("batches"));
    logarithms += std::log(found->second.at("seconds").get<double>() /
                           old_sample.at("seconds").get<double>());
    ++sizes;
  }
  const double ratio = std::exp(logarithms / sizes);
  const bool is_slower = ratio > 1 + kTimeTolerance && signs.chance() < kLevel;
  if (is_slower || ratio < 1 / (1 + kTimeTolerance)) {
    fmt::print("{}: time x {:.3f}, {} of {} batches slower\n", family, ratio, signs.slower,
               signs.all);
  }
  return is_well && !is_slower;
}

bool have_common_size(const std::map<double, Json>& before, const std::map<double, Json>& after) {
  return std::ranges::any_of(before, [&](const auto& s) { return after.contains(s.first); });
}

/// True unless a row has more of `what`, or is gone.
bool compare_rows(const char* what, const Figures& before, const Figures& after) {
  bool is_well = true;
  std::size_t compared = 0;
  for (const auto& [row, old_figure] : before) {
    const auto found = after.find(row);
    if (found == after.end()) {
      fmt::print("{}: GONE\n", row);
      is_well = false;
      continue;
    }
    ++compared;
    const double ratio = found->second / old_figure;
    if (std::fabs(ratio - 1) <= kWorkTolerance) continue;
    fmt::print("{}: {} x {:.3f}\n", row, what, ratio);
    if (ratio > 1) is_well = false;
  }
  if (compared > 0) fmt::print("{} compared: {}\n", compared, what);
  return is_well;
}

/// Where both count calls.
bool compare_calls(const Figures& before, const Figures& after) {
  return after.empty() || compare_rows("calls of predicates", before, after);
}

int run(const std::string& before, const std::string& after) {
  const Json old_results = read(before), new_results = read(after);
  const Samples old_samples = samples_of(old_results), new_samples = samples_of(new_results);
  bool is_well = true;
  std::size_t compared = 0;
  for (const auto& [family, samples] : old_samples) {
    const auto found = new_samples.find(family);
    if (found == new_samples.end() || !have_common_size(samples, found->second)) {
      fmt::print("{}: {}\n", family, found == new_samples.end() ? "GONE" : "GONE, no size in both");
      is_well = false;
      continue;
    }
    ++compared;
    if (!compare(family, samples, found->second)) is_well = false;
  }
  if (compared == 0) {
    fmt::print(stderr, "growth_compare: no family and size is in both files\n");
    return 2;
  }
  if (!compare_rows("bytes held", memory_of(old_results), memory_of(new_results))) is_well = false;
  if (!compare_calls(calls_of(old_results), calls_of(new_results))) is_well = false;
  fmt::print("{} of {} families compared: {}\n", compared, old_samples.size(),
             is_well ? "none is worse" : "WORSE, or GONE");
  return is_well ? 0 : 1;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  CLI::App app{"What changed between two results of bench/run"};
  std::string before, after;
  app.add_option("old", before)->required();
  app.add_option("new", after)->required();
  CLI11_PARSE(app, argc, argv);
  try {
    return plumb::bench::run(before, after);
  } catch (const std::exception& error) {
    fmt::print(stderr, "growth_compare: {}\n", error.what());
    return 2;
  }
}
