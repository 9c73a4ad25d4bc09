// All cells of an arrangement of planes, by brute force: for solids that are Boolean combinations
// of convex polytopes with small integer coordinates. A full-dimensional cell is a vector of signs,
// one for each plane. Every cell of an arrangement whose normals span space has a corner, so the
// cells around all corners are all cells. All signs are signs of integers of 128 bits, which share
// nothing with predicates/.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/testing/exact.h"

namespace plumb::testing {

/// A point with integer coordinates, at most 2^16 large.
using IntegerPoint = std::array<std::int64_t, 3>;

/// The plane a x + b y + c z + d = 0. The integers have no common factor, and the first of a, b, c
/// that is not 0 is positive.
struct IntegerPlane {
  std::array<std::int64_t, 3> normal{};
  std::int64_t offset = 0;
  friend auto operator<=>(const IntegerPlane&, const IntegerPlane&) = default;
};

inline constexpr std::size_t kMostModelPlanes = 64;
/// For each plane, whether a cell is above it.
using CellSigns = std::bitset<kMostModelPlanes>;

/// A bounded convex polytope: the points that are on the right side of all these planes.
struct IntegerPolytope {
  CellSigns planes;  ///< The planes of its facets.
  CellSigns above;   ///< Those of them that it lies above.
};

/// Collects the planes of polytopes.
class ModelPlanes {
 public:
  /// Returns the hull of points that do not lie in one plane, by testing all planes through three
  /// of them.
  IntegerPolytope hull_of(std::span<const IntegerPoint> points);
  std::span<const IntegerPlane> planes() const { return planes_; }

 private:
  std::size_t index_of(const IntegerPlane& plane);
  std::vector<IntegerPlane> planes_;
};

/// The cells of an arrangement.
struct ModelCells {
  /// A full-dimensional cell, and a point of it.
  struct Cell {
    CellSigns signs;
    ExactPoint3 inside;
  };
  /// A point where at least three planes meet, and the cells around it.
  struct Corner {
    ExactPoint3 at;
    std::vector<std::uint32_t> cells;
  };
  std::vector<Cell> cells;
  std::vector<Corner> corners;
};

/// Finds all cells. Requires at most kMostModelPlanes planes whose normals span space. O(n^4) for n
/// planes.
ModelCells cells_of(std::span<const IntegerPlane> planes);

}  // namespace plumb::testing
