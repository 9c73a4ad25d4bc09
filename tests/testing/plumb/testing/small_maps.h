// The truth table: small maps whose judgement a person can check in their head.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumb/plane/map_check.h"
#include "plumb/testing/test_map.h"

namespace plumb::testing {

struct SmallMap {
  std::string name;
  std::string text;  ///< the map format; cycles 1-based
  OuterRule outer;
  bool merge;
  MapVerdict verdict;
  std::uint64_t duplicate, open, crossing, twin;
  int mixed;  ///< -1: not computed
  std::uint64_t nested;
  std::size_t components;
};

/// Prints the name (GoogleTest looks for it).
void PrintTo(const SmallMap& map, std::ostream* out);

const std::vector<SmallMap>& small_maps();

/// Reads well-formed text of the map format; comments and blank lines are not understood.
TestMap parse_map(const std::string& text);

}  // namespace plumb::testing
