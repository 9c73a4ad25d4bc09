// A planar map in the form in which a user lists it: points, and cycles of indices of points. The
// struct Map only stores these lists. check_map() decides whether the cycles subdivide the plane
// (map_check.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A list of points, and a list of cycles that bound regions (format: docs/formats.md, "map"). In a
/// valid map, the outer boundary of each bounded face runs counter-clockwise. The boundaries of
/// holes run clockwise. The outer boundary of each connected component runs clockwise, too, because
/// it bounds a hole in the face around the component. check_map() decides whether a map is valid.
/// Ids are 0-based in this struct and 1-based in every text format.
struct Map {
  PointTable2 points;                  ///< Points of the vertices; equal points are allowed.
  std::vector<std::uint32_t> corners;  ///< Vertex indices of all cycles, end to end.
  /// For each cycle, the offset of its first corner in `corners`. The last entry is the size of
  /// `corners`. Cycle c consists of corners[cycle_begin[c]], ..., corners[cycle_begin[c + 1] - 1].
  std::vector<std::uint32_t> cycle_begin = {0};

  /// Returns the number of listed points.
  std::size_t vertex_count() const { return points.size(); }
  /// Returns the number of listed cycles.
  std::size_t cycle_count() const { return cycle_begin.size() - 1; }
  /// Returns the vertex indices of cycle c in order. The first index is not repeated at the end.
  /// Requires that c is less than cycle_count(). The span is valid until the next call of
  /// add_cycle().
  std::span<const std::uint32_t> cycle(std::size_t c) const {
    return {corners.data() + cycle_begin[c], corners.data() + cycle_begin[c + 1]};
  }
  /// Appends a cycle of vertex indices. The indices are not checked. Requires that `vertices` does
  /// not point into `corners`. Cost: O(length of the cycle), amortized.
  void add_cycle(std::span<const std::uint32_t> vertices) {
    corners.insert(corners.end(), vertices.begin(), vertices.end());
    cycle_begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

}  // namespace plumb
#pragma GCC visibility pop
