// Barycentric weights of points on lines, from doubles with error bounds. Internal.
#pragma once

#include <array>
#include <optional>

#include "plumb/predicates/point.h"

namespace plumb {

/// Two points of a line, or three points of a plane.
using LineEnds = std::array<Point3, 2>;
using TrianglePoints = std::array<Point3, 3>;

/// Returns the weights of the two points of a line at the point where the line meets a plane, each
/// rounded to the nearest double. Returns nothing if the doubles are not certain, or if a weight is
/// not positive. Requires rounds_to_nearest().
[[nodiscard]] std::optional<std::array<double, 2>> weights_on_line(const LineEnds& line,
                                                                   const TrianglePoints& plane);

/// Returns the weights of the corners of a triangle at the point where a line meets it, as
/// weights_on_line() does.
[[nodiscard]] std::optional<std::array<double, 3>> weights_of_corners(
    const TrianglePoints& triangle, const LineEnds& line);

}  // namespace plumb
