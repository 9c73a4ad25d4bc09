// Converts numbers of fixed size to bytes of a file, and bytes to numbers. Numbers have the byte
// order of the file, which does not depend on the byte order of the processor.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the bytes of an integer or floating-point number in the order `order`.
template <class Number>
std::array<char, sizeof(Number)> to_bytes(Number value, std::endian order) {
  static_assert(std::endian::native == std::endian::little ||
                std::endian::native == std::endian::big);
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Returns the integer or floating-point number whose bytes begin at `first`, in the order `order`.
/// Requires that sizeof(Number) bytes can be read there. The bytes need not be aligned.
template <class Number>
Number from_bytes(const char* first, std::endian order) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), first, bytes.size());
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

}  // namespace plumb
#pragma GCC visibility pop
