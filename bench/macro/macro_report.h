// What the programs of bench/macro share: --most, --json, a process for each measurement.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace plumb::bench {

struct MacroOptions {
  double most = 100;  ///< percent of the full sizes
  std::string json;

  /// `full`, or as much of it as is wanted; at least `least`.
  std::size_t size(std::size_t full, std::size_t least = 2) const;
};

/// What a process of its own found out.
struct Measured {
  double seconds = 0;    ///< CPU time, the least of the runs
  double size = 0;       ///< of what was worked on
  double megabytes = 0;  ///< its largest resident set once the input was there, which counts
  nlohmann::json calls;  ///< of predicates, in the first run (report/calls.h)
};

/// Runs `once` several times in a process of its own; each returns CPU seconds and size. Throws
/// std::runtime_error when that process fails.
struct Timing {
  double seconds;
  double size;
};
Measured in_own_process(const std::function<std::function<Timing()>()>& prepare);

/// Parses, calls `fill` with the rows to add to, writes {"part", "title", "rows"}. Exit status:
/// that of `fill`, 2 when the file cannot be written.
int macro_main(std::string_view part, std::string_view title, int argc, char** argv,
               const std::function<int(const MacroOptions&, nlohmann::ordered_json& rows)>& fill);

}  // namespace plumb::bench
