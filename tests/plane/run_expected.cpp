// Judges every map that a table names and compares verdict and counts with the table.
//
//   run_expected DIRECTORY      (or PLUMB_MAPS_DIR in the environment)
//
// DIRECTORY/expected.tsv has a header line naming its columns, tab-separated; those used: file,
// verdict (valid, open, superposed, not-a-planar-subdivision, malformed), duplicate, open,
// crossing, mixed, twin, components. Empty fields are not compared; of a defective map the counts
// behind its headline are. Exit 0: all agree; 1: some do not (they are printed); 2: the table
// cannot be read.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "plane/checked.h"
#include "plumb/testing/small_maps.h"

namespace plumb::testing {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
  return fields;
}

std::vector<Row> read_table(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> columns = split(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = split(line);
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      row[columns[i]] = i < fields.size() ? fields[i] : "";
    }
  }
  return rows;
}

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// A face without two directions is malformed in a file, whatever check_map makes of it.
bool has_flat_cycle(const TestMap& map) {
  for (const Cycle& cycle : map.cycles) {
    const ExactPoint& p = map.points[cycle[0]];
    const ExactPoint& q = map.points[cycle[1]];
    bool flat = true;
    for (const std::uint32_t v : cycle) {
      const ExactPoint& r = map.points[v];
      flat = flat && (q.x - p.x) * (r.y - p.y) == (q.y - p.y) * (r.x - p.x);
    }
    if (flat) return true;
  }
  return false;
}

std::string name_of(MapVerdict verdict) {
  static constexpr const char* kNames[] = {"valid", "not-a-planar-subdivision", "open",
                                           "superposed"};
  return kNames[static_cast<int>(verdict)];
}

// The counts that the headline rests on; the table does not bind the others.
std::map<std::string, std::uint64_t> headline_counts(const MapReport& report) {
  const MapDefectCounts& n = report.counts;
  switch (report.verdict) {
    case MapVerdict::NotAPlanarSubdivision:
      return {{"duplicate", n.duplicate}, {"open", n.open}, {"crossing", n.crossing}};
    case MapVerdict::Open:
      return {{"duplicate", n.duplicate}, {"open", n.open}, {"crossing", n.crossing}};
    default:
      return {{"duplicate", n.duplicate},     {"open", n.open}, {"crossing", n.crossing},
              {"mixed", n.mixed.value_or(0)}, {"twin", n.twin}, {"components", report.components}};
  }
}

std::string mismatch(const Row& row, const TestMap& map) {
  const bool malformed = !refusal(map, {}).empty() || has_flat_cycle(map);
  if (malformed || row.at("verdict") == "malformed") {
    return malformed && row.at("verdict") == "malformed" ? "" : "malformed: " + row.at("verdict");
  }
  const MapReport report = checked(map, {}, 10);
  if (name_of(report.verdict) != row.at("verdict")) return "verdict " + name_of(report.verdict);
  for (const auto& [name, got] : headline_counts(report)) {
    const std::string& wanted = row.at(name);
    if (!wanted.empty() && wanted != std::to_string(got)) {
      return name + " " + std::to_string(got) + ", not " + wanted;
    }
  }
  return "";
}

int run(const std::string& directory) {
  const std::vector<Row> rows = read_table(directory + "/expected.tsv");
  if (rows.empty()) {
    std::cerr << directory << "/expected.tsv: no rows\n";
    return 2;
  }
  std::size_t failures = 0;
  for (const Row& row : rows) {
    const std::string wrong = mismatch(row, parse_map(text_of(directory + "/" + row.at("file"))));
    if (wrong.empty()) continue;
    ++failures;
    std::cout << row.at("file") << ": " << wrong << '\n';
  }
  std::cout << rows.size() << " maps, " << failures << " judged otherwise than expected\n";
  return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace plumb::testing

int main(int argc, char** argv) {
  const char* directory = argc > 1 ? argv[1] : std::getenv("PLUMB_MAPS_DIR");
  if (directory == nullptr) {
    std::cerr << "usage: run_expected DIRECTORY\n";
    return 2;
  }
  return plumb::testing::run(directory);
}
