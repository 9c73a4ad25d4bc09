// A drawing that has been read: closed polygons in the plane.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Closed polygons, flat: shapes are lists of rings, rings are lists of points.
struct SvgDrawing {
  std::vector<Point2> points;       ///< x to the right, y upwards, the origin in the middle
  std::vector<std::size_t> places;  ///< of each point: the byte of the text that says so
  std::vector<std::uint32_t> ring_begin = {0};   ///< points; ring_count() + 1 entries
  std::vector<std::uint32_t> shape_begin = {0};  ///< rings; shape_count() + 1 entries
  std::vector<std::string> notes;                ///< what has been left out

  std::size_t ring_count() const { return ring_begin.size() - 1; }    ///< Of all shapes.
  std::size_t shape_count() const { return shape_begin.size() - 1; }  ///< Elements that were drawn.
  /// Closed: its last point is joined to its first.
  std::span<const Point2> ring(std::size_t r) const {
    return std::span(points).subspan(ring_begin[r], ring_begin[r + 1] - ring_begin[r]);
  }
};

}  // namespace plumb
#pragma GCC visibility pop
