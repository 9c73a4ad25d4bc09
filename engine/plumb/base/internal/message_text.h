// Formats numbers and lists for messages and files.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#pragma GCC visibility push(default)
namespace plumb {

/// An upper bound for the length of the text of a number. The longest text of a double is
/// "-2.2250738585072014e-308", which has 24 characters. The longest text of a 64-bit integer has 20
/// characters.
inline constexpr std::size_t kNumberBytes = 32;

/// Writes the text that format_double() returns to the memory at `to`, and returns the end of the
/// text. Requires that kNumberBytes bytes can be written.
inline char* put_double(char* to, double value) {
  constexpr double kTwo63 = 9223372036854775808.0;
  char* const end = to + kNumberBytes;
  if (std::fabs(value) < kTwo63) {
    const auto whole = static_cast<std::int64_t>(value);
    if (static_cast<double>(whole) == value) return std::to_chars(to, end, whole).ptr;
  }
  return std::to_chars(to, end, value).ptr;
}

/// Returns a text for `value` from which the readers of plumb (record_reader.h) read exactly the
/// same value. An integer with an absolute value less than 2^63 is written as an integer. Any other
/// value is written as the shortest decimal that is read as `value`. Requires that `value` is
/// finite.
inline std::string format_double(double value) {
  char text[kNumberBytes];
  return {text, put_double(text, value)};
}

/// Returns the first five entries of a list of numbers or texts: "3, 8, 11, 12, 15 and 5 more".
template <class List>
std::string listed(const List& list) {
  constexpr std::size_t kMost = 5;
  std::string text;
  std::size_t i = 0;
  for (const auto& entry : list) {
    if (i == kMost) return text + " and " + std::to_string(list.size() - kMost) + " more";
    if (i++ > 0) text += ", ";
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(entry)>>) {
      text += std::to_string(entry);
    } else {
      text += entry;
    }
  }
  return text;
}

}  // namespace plumb
#pragma GCC visibility pop
