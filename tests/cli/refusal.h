// What the program does with bad input.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "run_program.h"

namespace plumb::testing {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Nothing on standard output, one message that starts with the place and says `part`.
inline void expect_refusal(const RunResult& result, const std::string& start,
                           const std::string& part) {
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(result.out.empty()) << result.out.substr(0, 200);
  EXPECT_TRUE(result.err.starts_with(start)) << result.err;
  EXPECT_TRUE(contains(result.err, part)) << result.err;
}

}  // namespace plumb::testing
