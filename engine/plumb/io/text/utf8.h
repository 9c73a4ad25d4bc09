// Characters of UTF-8.
#pragma once

#include <cstddef>

namespace plumb {

/// Returns how many bytes the character of UTF-8 at `p` has; 0 if there is none.
inline std::size_t utf8_bytes(const char* p, const char* end) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(p[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t count = first < 0xC2   ? 0
                            : first < 0xE0 ? 2
                            : first < 0xF0 ? 3
                            : first < 0xF5 ? 4
                                           : 0;
  if (count == 0 || static_cast<std::size_t>(end - p) < count) return 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  }
  // Overlong forms, halves of surrogate pairs, and what lies behind U+10FFFF.
  const bool is_bad = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
                      (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F);
  return is_bad ? 0 : count;
}

}  // namespace plumb
