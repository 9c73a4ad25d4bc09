// Cells of a coarse grid that boxes occupy. Two boxes can meet only where both occupy a cell, so
// boxes of one list that are far from all boxes of another one are found without a tree.
//
// Cost: Building takes O(boxes), and a question takes O(1), whatever the sizes of the boxes are.
// Memory: 32 KB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/space/bounds/packed_boxes.h"

namespace plumb {

/// The cells that boxes occupy. Immutable after construction.
class OccupiedCells {
 public:
  /// Notes the cells of the boxes. Requires that all boxes meet `around`, the box that is divided
  /// into cells; only their parts in `around` count.
  OccupiedCells(const Box3& around, std::span<const Box3> boxes);

  /// Whether the part of `box` in `around` may meet one of the boxes. It is true for all boxes if
  /// `around` is not finite or if the boxes are too large for the grid. Requires that `box` meets
  /// `around`.
  bool may_meet(const Box3& box) const;

 private:
  static constexpr std::uint32_t kCells = 64;  // Along each axis; those along x share a word.

  /// The words that a box occupies, and its bits in each of them.
  struct Range {
    std::uint32_t low_y, high_y, low_z, high_z;
    std::uint64_t bits;
    std::uint32_t words() const { return (high_y - low_y + 1) * (high_z - low_z + 1); }
  };
  Range range_of(const Box3& box) const;

  Box3 around_;
  CellGrid grid_;
  std::vector<std::uint64_t> cells_;  // The cells along x of each y and z; empty if all count.
};

}  // namespace plumb
