// check_map on test maps, and its comparison with the brute-force twin.
#pragma once

#include <limits>
#include <string>

#include "plumb/plane/map_check.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/map_oracle.h"
#include "plumb/testing/test_map.h"

namespace plumb::testing {

inline constexpr std::uint64_t kAllDefects = std::numeric_limits<std::uint64_t>::max();
inline constexpr OuterRule kOuterRules[] = {OuterRule::Listed, OuterRule::Infer, OuterRule::Ignore};

inline MapReport checked(const TestMap& map, OracleOptions options = {},
                         std::uint64_t max_defects = kAllDefects) {
  Context context;
  return check_map(to_map(map), {options.outer, options.merge_vertices, max_defects}, context);
}

/// True when check_map refuses the map with one of the two errors it promises.
inline bool is_refused(const TestMap& map, OracleOptions options = {}) {
  try {
    checked(map, options);
  } catch (const Error& error) {
    return error.code() == ErrorCode::BadIndex || error.code() == ErrorCode::DegenerateFace;
  }
  return false;
}

/// Empty when check_map and the twin say the same about `map`, else the difference and the map.
inline std::string disagreement(const TestMap& map, OracleOptions options = {}) {
  const std::string refused = refusal(map, options);
  std::string text;
  if (!refused.empty()) {
    text = is_refused(map, options) ? "" : "not refused: " + refused;
  } else {
    text = difference(checked(map, options), judge(map, options));
  }
  if (text.empty()) return text;
  return text + "\nouter rule " + std::to_string(static_cast<int>(options.outer)) + ", merge " +
         std::to_string(options.merge_vertices) + ", map\n" + to_text(map);
}

}  // namespace plumb::testing
