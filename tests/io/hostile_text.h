// Malformed files as data: shared by the tests of readers and of the program.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plumb::testing {

struct HostileText {
  const char* name;
  std::string bytes;
  std::size_t line;
  std::size_t column;
  const char* message;  ///< a part of the message
};

inline std::string bytes_with_nul(const char* text, std::size_t size) { return {text, size}; }

inline std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

}  // namespace plumb::testing
