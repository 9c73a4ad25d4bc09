// Calls of predicates as JSON: {"orient2d": {"filter": 12, "exact": 1}, ...}.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

#include "plumb/predicates/input/rung_counters.h"

namespace plumb::bench {

/// Calls in one of so many runs, by predicate and by the rung that decided; what was never called
/// is left out.
inline nlohmann::ordered_json calls_of(const RungCounts& counts, double runs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t p = 0; p < kPredicates; ++p) {
    for (std::size_t r = 0; r < kRungs; ++r) {
      if (counts[p][r] == 0) continue;
      json[kPredicateNames[p]][kRungNames[r]] = static_cast<double>(counts[p][r]) / runs;
    }
  }
  return json;
}

}  // namespace plumb::bench
