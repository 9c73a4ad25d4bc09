// Polygons, lines and points as WKT and GeoJSON list them: what their readers return, what their
// writers are given.
//
// What the shapes mean as a set: a polygon is the closed region of the points inside by the even-odd
// rule of its rings, boundaries included; a line is all its points; everything is united.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A ring or line is a chain of indices of `points`; the last corner of a ring is followed by its
/// first, which is not repeated.
struct PlaneShapes {
  PointTable2 points;                              ///< all corners, exact
  std::vector<std::uint32_t> ring_corners;         ///< end to end
  std::vector<std::uint32_t> ring_begin = {0};     ///< into ring_corners; one more than rings
  std::vector<std::uint32_t> polygon_begin = {0};  ///< into rings; one more than polygons
  std::vector<std::uint32_t> line_corners;         ///< of polylines, end to end
  std::vector<std::uint32_t> line_begin = {0};     ///< into line_corners; one more than lines
  std::vector<std::uint32_t> single_points;        ///< indices of isolated points

  /// Each of some rings: an outer one and holes.
  std::size_t polygon_count() const { return polygon_begin.size() - 1; }
  std::size_t ring_count() const { return ring_begin.size() - 1; }  ///< Of all polygons.
  std::size_t line_count() const { return line_begin.size() - 1; }  ///< Polylines.
  /// Its corners.
  std::span<const std::uint32_t> ring(std::size_t r) const {
    return {ring_corners.data() + ring_begin[r], ring_corners.data() + ring_begin[r + 1]};
  }
  /// Its points.
  std::span<const std::uint32_t> line(std::size_t l) const {
    return {line_corners.data() + line_begin[l], line_corners.data() + line_begin[l + 1]};
  }
  /// Is there nothing at all?
  bool empty() const { return polygon_count() == 0 && line_count() == 0 && single_points.empty(); }

  /// The corners since the last ring are one.
  void end_ring() { ring_begin.push_back(static_cast<std::uint32_t>(ring_corners.size())); }
  /// The rings since the last polygon are one.
  void end_polygon() { polygon_begin.push_back(static_cast<std::uint32_t>(ring_count())); }
  /// The points since the last line are one.
  void end_line() { line_begin.push_back(static_cast<std::uint32_t>(line_corners.size())); }
};

/// The set of the shapes. One sweep for all polygons whose rings meet at common corners only
/// (touching polygons, holes that touch); a polygon that crosses itself is brought into order by a
/// sweep of its own first. O((n + k) log n) for n corners and k crossings.
Nef2 to_set(const PlaneShapes& shapes, Context& context);

/// The parts of a set as shapes, exactly.
PlaneShapes to_shapes(const PlaneParts& parts, Context& context);

/// Every coordinate rounded to the nearest double. Throws Error{NumberOutOfRange} when one lies
/// beyond the largest.
PlaneShapes rounded(PlaneShapes shapes, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
