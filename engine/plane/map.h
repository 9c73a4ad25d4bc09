// A planar map as listed: points, and cycles of point indices, nothing checked yet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Regions as a user lists them (format: docs/formats.md, "map"). Interior cycles run
/// counter-clockwise, outer boundaries and hole boundaries clockwise; whether that is so is what
/// check_map() finds out. Ids are 0-based here and 1-based in every text.
struct Map {
  PointTable2 points;                            ///< distinct or not
  std::vector<std::uint32_t> corners;            ///< vertex indices, the cycles end to end
  std::vector<std::uint32_t> cycle_begin = {0};  ///< cycle c is corners[cycle_begin[c], [c+1])

  std::size_t vertex_count() const { return points.size(); }          ///< Listed points.
  std::size_t cycle_count() const { return cycle_begin.size() - 1; }  ///< Listed cycles.
  /// Its vertices, in order; the first is not repeated.
  std::span<const std::uint32_t> cycle(std::size_t c) const {
    return {corners.data() + cycle_begin[c], corners.data() + cycle_begin[c + 1]};
  }
  /// Appends a cycle of vertex indices. Nothing is checked.
  void add_cycle(std::span<const std::uint32_t> vertices) {
    corners.insert(corners.end(), vertices.begin(), vertices.end());
    cycle_begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

}  // namespace plumb
#pragma GCC visibility pop
