// Comparing a report of the engine with the oracle's.
#include <algorithm>
#include <sstream>

#include "plumb/testing/map_oracle.h"

namespace plumb::testing {
namespace {

bool is_directed(DefectKind kind) {
  return kind == DefectKind::Duplicate || kind == DefectKind::Open;
}

OracleDefect reduced(const MapDefect& defect) {
  OracleDefect result{defect.kind, {}, {}, std::nullopt};
  if (defect.kind != DefectKind::Mixed && defect.kind != DefectKind::Nested) {
    for (const MapEdge& e : defect.edges) {
      const bool keep = is_directed(defect.kind) || e.from < e.to;
      result.edges.emplace_back(keep ? e.from : e.to, keep ? e.to : e.from);
    }
    std::sort(result.edges.begin(), result.edges.end());
  }
  if (defect.kind != DefectKind::Nested) result.cycles = defect.cycles;
  if (defect.kind == DefectKind::Crossing && defect.point) result.point = exact_of(*defect.point);
  return result;
}

std::string text_of(const OracleDefect& defect) {
  static constexpr const char* kNames[] = {"duplicate", "open",  "crossing",
                                           "twin",      "mixed", "nested"};
  std::ostringstream out;
  out << kNames[static_cast<int>(defect.kind)];
  for (const auto& [u, v] : defect.edges) out << ' ' << u << '-' << v;
  out << " cycles";
  for (const std::uint32_t c : defect.cycles) out << ' ' << c;
  if (defect.point) out << " at " << defect.point->x << ' ' << defect.point->y;
  return out.str();
}

class Comparison {
 public:
  template <class Value>
  void expect(const char* what, const Value& got, const Value& wanted) {
    if (got == wanted || !text_.empty()) return;
    std::ostringstream out;
    out << what << ": got " << got << ", expected " << wanted;
    text_ = out.str();
  }
  void fail(const std::string& text) {
    if (text_.empty()) text_ = text;
  }
  std::string text() const { return text_; }

 private:
  std::string text_;
};

long long number(const std::optional<std::uint64_t>& count) {
  return count ? static_cast<long long>(*count) : -1;
}

void compare_counts(const MapReport& report, const OracleReport& expected, Comparison& result) {
  const MapDefectCounts& got = report.counts;
  const MapDefectCounts& wanted = expected.counts;
  result.expect("duplicate", got.duplicate, wanted.duplicate);
  result.expect("open", got.open, wanted.open);
  result.expect("crossing", got.crossing, wanted.crossing);
  result.expect("twin", got.twin, wanted.twin);
  if (!expected.has_zero_length_edge) {
    result.expect("mixed", number(got.mixed), number(wanted.mixed));
    result.expect("nested", got.nested, wanted.nested);
  }
  result.expect("verdict", static_cast<int>(report.verdict), static_cast<int>(expected.verdict));
  result.expect("edges", report.edges, expected.edges);
  result.expect("cycles", report.cycles, expected.cycles);
  result.expect("components", report.components, expected.components);
}

std::vector<OracleDefect> defined(std::vector<OracleDefect> defects, const OracleReport& expected) {
  std::erase_if(defects, [&](const OracleDefect& d) {
    return expected.has_zero_length_edge &&
           (d.kind == DefectKind::Mixed || d.kind == DefectKind::Nested);
  });
  return defects;
}

void compare_defects(const MapReport& report, const OracleReport& expected, Comparison& result) {
  const std::vector<OracleDefect> got = defined(defects_of(report), expected);
  const std::vector<OracleDefect> wanted = defined(expected.defects, expected);
  for (std::size_t i = 0; i < std::min(got.size(), wanted.size()); ++i) {
    if (got[i] == wanted[i]) continue;
    return result.fail("defect: got " + text_of(got[i]) + ", expected " + text_of(wanted[i]));
  }
  result.expect("number of defects", got.size(), wanted.size());
}

std::string text_of(const MapRegion& region) {
  std::string text = region.outer ? std::to_string(*region.outer) : "unbounded";
  for (const std::uint32_t hole : region.holes) text += " -" + std::to_string(hole);
  return text;
}

void compare_regions(const MapReport& report, const OracleReport& expected, Comparison& result) {
  std::vector<MapRegion> got = report.regions;
  if (!got.empty()) {
    std::sort(got.begin() + 1, got.end(),
              [](const MapRegion& a, const MapRegion& b) { return a.outer < b.outer; });
  }
  result.expect("number of regions", got.size(), expected.regions.size());
  for (std::size_t i = 0; i < std::min(got.size(), expected.regions.size()); ++i) {
    result.expect("region", text_of(got[i]), text_of(expected.regions[i]));
  }
}

}  // namespace

std::vector<OracleDefect> defects_of(const MapReport& report) {
  std::vector<OracleDefect> result;
  for (const MapDefect& defect : report.defects) result.push_back(reduced(defect));
  std::sort(result.begin(), result.end());
  return result;
}

std::string difference(const MapReport& report, const OracleReport& expected) {
  Comparison result;
  compare_counts(report, expected, result);
  compare_defects(report, expected, result);
  compare_regions(report, expected, result);
  return result.text();
}

}  // namespace plumb::testing
