// Places of which the volume is known: a grid over a complex whose cells lie in one volume each,
// except those near a vertex, edge or facet.
//
// Main flow:
//  1. lay_out     makes cells of about one size, a few for each item; a layer of cells around them
//                 all represents what is outside
//  2. mark        marks every cell that the box of an item reaches
//  3. flood_cells floods the others: between two neighbours without an item there is none
//  4. ask         asks one exact question for each connected part
//
// Cells are distinguished by a function of each coordinate that never falls, rounding included. So
// a point that lies on an item, or on the way between points of two neighbouring cells, has its
// cell, or one of theirs, marked, and correctness does not depend on how exact the function is.
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

/// The grid. Immutable after construction.
class VolumeGrid {
 public:
  VolumeGrid() = default;  ///< Makes a grid that knows nothing.
  /// Makes a grid over the boxes of all items. `volume_of` returns the volume of a point off all
  /// items. Boxes that are not bounded, or reach into too many cells, make a grid that knows
  /// nothing.
  VolumeGrid(std::span<const Box3> boxes, const std::function<VolumeId(const Point3&)>& volume_of);

  /// Returns the volume around a point, which then no item holds; invalid if an item may be near.
  VolumeId volume_at(const Point3& p) const;

  /// A place to the left of a point (towards -x) with the same other coordinates.
  struct Left {
    double x = 0;     ///< Its x coordinate.
    VolumeId volume;  ///< The volume there; invalid if none is known nearby.
  };
  /// Returns the nearest place to the left whose volume is known, at most kMostSteps cells away.
  Left left_of(const Point3& p) const;

 private:
  static constexpr std::size_t kCellsPerItem = 4;
  static constexpr std::size_t kLeastCells = 512;
  static constexpr std::uint32_t kMostCellsAlong = 2048;  // The most cells along one axis.
  static constexpr std::uint32_t kMostSteps = 8;  // The most cells to the left that are asked.

  using Cell = std::array<std::uint32_t, 3>;

  bool lay_out(std::span<const Box3> boxes);
  bool mark(std::span<const Box3> boxes);
  std::uint32_t flood_cells();
  void ask(std::uint32_t parts, std::size_t questions,
           const std::function<VolumeId(const Point3&)>& volume_of);

  std::uint32_t place(double x, std::size_t axis, double stretch = 1) const;
  Cell cell_of(const std::array<double, 3>& p) const;
  std::size_t index(const Cell& cell) const;
  double middle(std::uint32_t place, std::size_t axis) const;

  Box3 all_;
  std::array<double, 3> scale_{};
  std::array<std::uint32_t, 3> count_{};  // Cells along each axis, with both outer layers.
  std::vector<std::uint32_t> part_;       // The connected part of each cell, until ask().
  std::vector<VolumeId> volume_;  // The volume of each cell; empty if the grid knows nothing.
};

}  // namespace plumb
