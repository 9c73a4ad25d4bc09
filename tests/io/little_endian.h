// Little-endian numbers in files that tests make.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>

namespace plumb::testing {

/// Replaces the bytes at `at` by those of a number.
template <class Number>
void place(std::string& bytes, std::size_t at, Number value) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  std::copy(raw.begin(), raw.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

}  // namespace plumb::testing
