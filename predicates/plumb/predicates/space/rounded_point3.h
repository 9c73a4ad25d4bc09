// Computes the doubles nearest to the coordinates of points of space. The functions are faster than
// computing the exact coordinates in lowest terms and rounding them. docs/design/numbers.md
// (Rounding to nearest) proves the bounds.
#pragma once

#include <optional>

#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point rounded to the nearest doubles.
struct RoundedPoint3 {
  Point3 at;      ///< The correctly rounded coordinates; infinite if beyond all doubles.
  bool is_exact;  ///< Whether the rounded coordinates equal the exact coordinates.
};

/// The stages of rounded(). Tests and benchmarks can call each stage on its own.
namespace rung {

/// Rounds the common point of three planes, or of a line and a plane, if the planes and the line
/// are defined by input points. The function computes with a precision of about 100 bits. Cost:
/// about 0.5 us. Returns no value in the following cases:
///   - the point has another definition;
///   - the arithmetic does not round to nearest;
///   - a coordinate is equal or very near to a double, or to the middle of two adjacent doubles.
///     There is an exception: the function returns a value if a plane or line of the definition is
///     orthogonal to the axis of that coordinate.
std::optional<RoundedPoint3> rounded_filter(const Point3Table& points, SpacePoint x);
/// Computes exact coordinates in integers of fixed width, and rounds them by using their leading
/// bits. Unlike rounded_filter(), this function also rounds points whose planes are nearly
/// parallel. Returns no value in the last two cases of rounded_filter(), and if the point has too
/// many bits for fixed widths. Requires a constructed point that does not depend on the frame.
/// Cost: about 0.5 us.
std::optional<RoundedPoint3> rounded_fixed(const Point3Table& points, SpacePoint x);
/// Rounds by three divisions of exact integers. Requires a constructed point that does not depend
/// on the frame. Cost: about 1.5 us. This is a third of the cost of exact(), because no gcd is
/// computed.
RoundedPoint3 rounded_exact(const Point3Table& points, SpacePoint x);

}  // namespace rung

/// Returns round_to_double() of each coordinate of exact(points, x). Requires
/// !points.depends_on_frame(x).
RoundedPoint3 rounded(const Point3Table& points, SpacePoint x);

}  // namespace plumb
#pragma GCC visibility pop
