// What the program does with bad input.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "run_program.h"

namespace plumb::testing {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The message of a refusal as text: that of the object under --json, with its place before it.
inline std::string told_by(const RunResult& result) {
  const auto json = nlohmann::json::parse(result.err, nullptr, false);
  if (json.is_discarded()) return result.err;
  const auto& error = json.at("error");
  std::string place = error.at("file").is_null() ? "plumb" : error.at("file").get<std::string>();
  for (const char* const name : {"line", "column"}) {
    if (!error.at(name).is_null()) place += ':' + std::to_string(error.at(name).get<int>());
  }
  return place + ": " + error.at("message").get<std::string>();
}

/// Nothing on standard output, one message that starts with the place and says `part`.
inline void expect_refusal(const RunResult& result, const std::string& start,
                           const std::string& part) {
  EXPECT_EQ(result.code, 2);
  EXPECT_TRUE(result.out.empty()) << result.out.substr(0, 200);
  const std::string told = told_by(result);
  EXPECT_TRUE(told.starts_with(start)) << result.err;
  EXPECT_TRUE(contains(told, part)) << result.err;
}

}  // namespace plumb::testing
