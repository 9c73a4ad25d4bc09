// How many of its random cases a test runs. Cases of tables are always run, all of them.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace plumb::testing {

/// All `cases`, or as many percent of them as the environment's PLUMB_TEST_SHARE says (set by ctest
/// from the option of that name: under sanitizers a case takes about ten times as long), rounded
/// up.
inline std::uint64_t share_of(std::uint64_t cases) {
  const char* percent = std::getenv("PLUMB_TEST_SHARE");
  if (percent == nullptr) return cases;
  return (cases * std::strtoull(percent, nullptr, 10) + 99) / 100;
}

/// For tests that can run on for longer: environment variable PLUMB_CASES, else share_of(standard).
inline std::uint64_t case_count(std::uint64_t standard) {
  const char* text = std::getenv("PLUMB_CASES");
  return text == nullptr ? share_of(standard) : std::strtoull(text, nullptr, 10);
}

}  // namespace plumb::testing
