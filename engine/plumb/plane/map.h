// A planar map as a user lists it: points, and cycles of indices of points. A Map only stores the
// listing; check_map() (map_check.h) decides whether the cycles subdivide the plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Regions as a user lists them (format: docs/formats.md, "map"). Boundaries of interior faces are
/// to run counter-clockwise, outer boundaries and boundaries of holes clockwise; check_map()
/// decides whether they do. Ids are 0-based here and 1-based in every text.
struct Map {
  PointTable2 points;                  ///< Coordinates of the vertices; equal ones are allowed.
  std::vector<std::uint32_t> corners;  ///< Vertex indices of all cycles, end to end.
  /// Offsets into corners, one more than cycles. Cycle c consists of corners[cycle_begin[c]], ...,
  /// corners[cycle_begin[c + 1] - 1].
  std::vector<std::uint32_t> cycle_begin = {0};

  /// Returns the number of listed points.
  std::size_t vertex_count() const { return points.size(); }
  /// Returns the number of listed cycles.
  std::size_t cycle_count() const { return cycle_begin.size() - 1; }
  /// Returns the vertices of cycle c in order; the first one is not repeated at the end. Requires
  /// that c is less than cycle_count(). The span is valid until the next add_cycle().
  std::span<const std::uint32_t> cycle(std::size_t c) const {
    return {corners.data() + cycle_begin[c], corners.data() + cycle_begin[c + 1]};
  }
  /// Appends a cycle of vertex indices without checking them. Requires that `vertices` is not a
  /// part of `corners`. O(length of the cycle), amortized.
  void add_cycle(std::span<const std::uint32_t> vertices) {
    corners.insert(corners.end(), vertices.begin(), vertices.end());
    cycle_begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

}  // namespace plumb
#pragma GCC visibility pop
