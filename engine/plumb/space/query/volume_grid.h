// Places of which the volume is known: a grid over a complex whose cells, but for those near an
// item, lie in one volume.
//
// Main flow:
//  1. Places       cells of about one size, a few for each item; a layer of cells around them all
//                  stands for what is outside
//  2. mark         every cell that the box of an item reaches
//  3. join_cells   the others, by a flood: between two neighbours without an item there is none
//  4. ask          one exact question for each connected part
//
// Cells are told apart by a function of each coordinate that never falls, rounding included. So a
// point that lies in an item, or on the way between points of two neighbouring cells, has its cell,
// or one of theirs, marked, and nothing here depends on how exact the function is.
//
// Cost: O(n) for n boxes. Memory: 4 bytes a cell, kCellsPerItem n cells and a few more.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/point.h"

namespace plumb {

class VolumeGrid {
 public:
  VolumeGrid() = default;  ///< knows nothing
  /// `volume_of` says where a point off all items lies. Boxes that are not bounded, or reach into
  /// too many cells, make a grid that knows nothing.
  VolumeGrid(std::span<const Box3> boxes, const std::function<VolumeId(const Point3&)>& volume_of);

  /// The volume around the point, which no item holds; invalid: an item may be near.
  VolumeId volume_at(const Point3& p) const;

  /// A place to the left of a point (towards -x), its other coordinates being the same.
  struct Left {
    double x = 0;
    VolumeId volume;  ///< invalid: none is known nearby
  };
  Left left_of(const Point3& p) const;

 private:
  static constexpr std::size_t kCellsPerItem = 4;
  static constexpr std::size_t kLeastCells = 512;
  static constexpr std::uint32_t kMostCellsAlong = 2048;  // an axis
  static constexpr std::uint32_t kMostSteps = 8;          // to the left

  using Cell = std::array<std::uint32_t, 3>;

  bool lay_out(std::span<const Box3> boxes);
  bool mark(std::span<const Box3> boxes);
  std::uint32_t join_cells();
  void ask(std::uint32_t parts, std::size_t questions,
           const std::function<VolumeId(const Point3&)>& volume_of);

  std::uint32_t place(double x, std::size_t axis, double stretch = 1) const;
  Cell cell_of(const std::array<double, 3>& p) const;
  std::size_t index(const Cell& cell) const;
  double middle(std::uint32_t place, std::size_t axis) const;

  Box3 all_;
  std::array<double, 3> scale_{};
  std::array<std::uint32_t, 3> count_{};  // with the two outer layers
  std::vector<std::uint32_t> part_;       // per cell, until ask(): the connected part
  std::vector<VolumeId> volume_;          // per cell; none: the grid knows nothing
};

}  // namespace plumb
