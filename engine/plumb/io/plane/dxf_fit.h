// The cubic spline through given points, for the reader of DXF. Programs draw this curve for a
// SPLINE that has fit points and no control points.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/point.h"

namespace plumb {

/// The conditions at the ends of a curve through points.
struct FitEnds {
  bool is_closed = false;  ///< Whether the curve returns to its first point, smoothly.
  /// The directions at the ends of an open curve. Without one, the curvature is 0 there.
  std::optional<Point2> begin = {}, end = {};
};

/// The control points of cubic Bezier curves, one for each pair of consecutive points: 3 k + 1
/// points for k curves, because a curve begins where the last one ends. The parameter that each
/// curve begins at is the sum of the distances before it, and first and second derivatives by this
/// parameter are continuous.
struct FitCurve {
  std::vector<Point2> control;
  std::vector<double> begin;  ///< The parameters, k + 1.
};

/// Returns the curve through `points`. Points that equal the previous point are left out. The curve
/// is empty if fewer than two different points are left. Cost: O(n).
FitCurve fit_curve(std::span<const Point2> points, const FitEnds& ends, Context& context);

}  // namespace plumb
