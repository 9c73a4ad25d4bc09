// Numbers of fixed size as little-endian bytes, at the end of a text.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <utility>

#include "plumb/io/text_output.h"

namespace plumb {

template <class Number>
void put_little_endian(TextOutput& out, Number value) {
  char raw[sizeof(Number)];
  std::memcpy(raw, &value, sizeof(Number));
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = 0; i < sizeof(Number) / 2; ++i) {
      std::swap(raw[i], raw[sizeof(Number) - 1 - i]);
    }
  }
  out << std::string_view(raw, sizeof(Number));
}

}  // namespace plumb
