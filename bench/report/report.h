// What the programs of bench share: their JSON, the spread of repeated measurements, a process for
// one of them.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumb::bench {

/// {"least", "median", "greatest"} of several rounds. Requires one at least.
nlohmann::ordered_json spread(std::vector<double> values);

/// "median (least .. greatest)" of what spread() made.
std::string spread_text(const nlohmann::ordered_json& spread);

/// Writes `json` to `file`, unless the name is empty. `status`, or 2 when the file cannot be
/// written, which is said on stderr.
int write_json(const std::string& file, const nlohmann::ordered_json& json, int status);

/// How a process has ended.
struct Finished {
  bool is_well = false;  ///< exit status 0
  std::string output;    ///< what it has written to its standard output
  double megabytes = 0;  ///< its largest resident set, and that of its parent when it began
};

/// Runs `work` in a process of its own, whose standard output is read. An exception of `work` goes
/// to stderr and ends it with status 1. Throws std::runtime_error when there is no process to be
/// had.
Finished run_apart(const std::function<void()>& work);

}  // namespace plumb::bench
