// Morton order: codes of places on a grid of 2^10 cells an axis, and sorting by them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace plumb {

/// An item with its code.
struct MortonCoded {
  std::uint32_t code;
  std::uint32_t item;
};

/// The bits of three numbers of 10 bits, interleaved; those of the first are the highest.
inline std::uint32_t morton_code(const std::array<std::uint32_t, 3>& cell) {
  const auto spread = [](std::uint32_t x) {  // bit i becomes bit 3i
    x = (x | x << 16) & 0x030000ffU;
    x = (x | x << 8) & 0x0300f00fU;
    x = (x | x << 4) & 0x030c30c3U;
    return (x | x << 2) & 0x09249249U;
  };
  return spread(cell[0]) << 2 | spread(cell[1]) << 1 | spread(cell[2]);
}

/// Items of equal codes keep their order. Three passes by a digit.
inline void sort_by_code(std::vector<MortonCoded>& items) {
  std::vector<MortonCoded> to(items.size());
  constexpr std::uint32_t kDigitBits = 10;
  for (std::uint32_t shift = 0; shift < 30; shift += kDigitBits) {
    std::array<std::uint32_t, std::size_t{1} << kDigitBits> place{};
    const auto digit = [shift](const MortonCoded& c) {
      return c.code >> shift & ((1U << kDigitBits) - 1);
    };
    for (const MortonCoded& c : items) ++place[digit(c)];
    std::uint32_t sum = 0;
    for (std::uint32_t& p : place) sum += std::exchange(p, sum);
    for (const MortonCoded& c : items) to[place[digit(c)]++] = c;
    items.swap(to);
  }
}

}  // namespace plumb
