// A grid with one bit for each cell, which states whether a box reaches the cell. Other boxes are
// compared with these cells.
//
// Cells follow coordinates monotonically, so a common point of two boxes lies in a cell that both
// boxes reach. If boxes would set many words, the grid would be useless and slow. In this case no
// cells are kept.
//
// Tested by tests/space/occupied_cells_test.cpp.

#include "plumb/space/bounds/occupied_cells.h"

#include <algorithm>

namespace plumb {
namespace {

constexpr std::size_t kWordsPerBox = 16;  // Boxes that set more words on average are too large.
// If a box covers more words, it counts as meeting some box.
constexpr std::uint32_t kMostWords = 64;

}  // namespace

OccupiedCells::OccupiedCells(const Box3& around, std::span<const Box3> boxes)
    : around_(around), grid_(around, kCells - 1) {
  if (!grid_.is_finite()) return;
  cells_.assign(std::size_t{kCells} * kCells, 0);
  std::size_t left = kWordsPerBox * (boxes.size() + kCells);
  for (const Box3& box : boxes) {
    const Range range = range_of(box);
    if (range.words() > left) {
      cells_.clear();
      return;
    }
    left -= range.words();
    for (std::uint32_t z = range.low_z; z <= range.high_z; ++z) {
      for (std::uint32_t y = range.low_y; y <= range.high_y; ++y) {
        cells_[kCells * z + y] |= range.bits;
      }
    }
  }
}

bool OccupiedCells::may_meet(const Box3& box) const {
  if (cells_.empty()) return true;
  const Range range = range_of(box);
  if (range.words() > kMostWords) return true;
  for (std::uint32_t z = range.low_z; z <= range.high_z; ++z) {
    for (std::uint32_t y = range.low_y; y <= range.high_y; ++y) {
      if ((cells_[kCells * z + y] & range.bits) != 0) return true;
    }
  }
  return false;
}

/// Returns the cells of the part of a box that is in the grid.
OccupiedCells::Range OccupiedCells::range_of(const Box3& box) const {
  std::array<double, 3> low, high;
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = box.low[i] > around_.low[i] ? box.low[i] : around_.low[i];
    high[i] = box.high[i] < around_.high[i] ? box.high[i] : around_.high[i];
  }
  const auto first = grid_.cell(low), last = grid_.cell(high);
  const std::uint64_t from_first = ~std::uint64_t{0} << first[0],
                      to_last = ~std::uint64_t{0} >> (kCells - 1 - last[0]);
  return {first[1], last[1], first[2], last[2], from_first & to_last};
}

}  // namespace plumb
