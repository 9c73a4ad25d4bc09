// A double from text, by std::from_chars() where the standard library has it for doubles: libc++
// does from version 20 on.
#pragma once

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace plumb {

/// Returns the end of the longest decimal number that the text begins with: an optional minus sign,
/// digits with at most one point, and an exponent. Returns `begin` if there is none.
inline const char* end_of_decimal(const char* begin, const char* end) {
  const auto skip_digits = [end](const char* p) {
    while (p != end && *p >= '0' && *p <= '9') ++p;
    return p;
  };
  const char* const whole = begin + (begin != end && *begin == '-' ? 1 : 0);
  const char* last = skip_digits(whole);
  std::ptrdiff_t digits = last - whole;
  if (last != end && *last == '.') {
    const char* const part = skip_digits(last + 1);
    digits += part - (last + 1);
    last = part;
  }
  if (digits == 0) return begin;
  if (last != end && (*last == 'e' || *last == 'E')) {
    const char* power = last + 1;
    if (power != end && (*power == '-' || *power == '+')) ++power;
    const char* const after = skip_digits(power);
    if (after != power) last = after;
  }
  return last;
}

/// Reads a double as std::from_chars() does, by std::strtod(). A number of 128 characters or more,
/// "inf" and "nan" are errc::not_supported, as is any number with a point where the C locale has
/// another one: the caller has a slower way.
inline std::from_chars_result double_by_strtod(const char* begin, const char* end, double& value) {
  constexpr std::size_t kMost = 127;
  const char* const last = end_of_decimal(begin, end);
  const auto size = static_cast<std::size_t>(last - begin);
  if (size == 0 || size > kMost) return {begin, std::errc::not_supported};
  std::array<char, kMost + 1> text;
  std::memcpy(text.data(), begin, size);
  text[size] = '\0';
  char* stop = nullptr;
  errno = 0;
  const double read = std::strtod(text.data(), &stop);
  if (stop != text.data() + size) return {begin, std::errc::not_supported};
  if (std::isinf(read) || (errno == ERANGE && read == 0)) {
    return {last, std::errc::result_out_of_range};
  }
  value = read;
  return {last, std::errc()};
}

/// Calls std::from_chars(), or does the same by std::strtod().
template <class Number>
std::from_chars_result double_from_chars(const char* begin, const char* end, Number& value) {
  if constexpr (requires { std::from_chars(begin, end, value); }) {
    return std::from_chars(begin, end, value);
  } else {
    return double_by_strtod(begin, end, value);
  }
}

}  // namespace plumb
