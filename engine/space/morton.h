// Morton order: cells of a grid, codes of 10 bits an axis, and sorting by them. BoxTree (box_tree.h) has an order of its own, of
// 21 bits an axis and finer where places are crowded, which takes twice as long.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/box_tree.h"

namespace plumb {

/// Cells 0 to `last` along each axis, all around a box. Where the box has no extent to speak of all is in cell 0.
class CellGrid {
 public:
  CellGrid(const Box3& around, std::uint32_t last) : low_(around.low), last_(last) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double extent = around.high[i] - around.low[i];
      is_finite_ = is_finite_ && std::isfinite(extent);
      scale_[i] = extent > 0x1p-900 ? last / extent : 0;
    }
  }
  bool is_finite() const { return is_finite_; }

  /// Of a point of the box. Monotone in every coordinate: each step of the arithmetic is. Requires is_finite().
  std::array<std::uint32_t, 3> cell(const std::array<double, 3>& at) const {
    std::array<std::uint32_t, 3> cell;
    for (std::size_t i = 0; i < 3; ++i) {
      cell[i] = std::min(static_cast<std::uint32_t>((at[i] - low_[i]) * scale_[i]), last_);
    }
    return cell;
  }

 private:
  std::array<double, 3> low_;
  std::array<double, 3> scale_;
  std::uint32_t last_;
  bool is_finite_ = true;
};

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
