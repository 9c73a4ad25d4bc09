// The nearest doubles to points of space, computed without exact coordinates in lowest terms.
// docs/design/numbers.md (Rounding to nearest) proves the bounds.
#pragma once

#include <optional>

#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point rounded to the nearest doubles.
struct RoundedPoint3 {
  Point3 at;      ///< Each coordinate correctly rounded; infinite beyond all doubles.
  bool is_exact;  ///< Whether the point is that of doubles.
};

/// The stages of rounded(), callable on their own for tests and benchmarks.
namespace rung {

/// Rounds a point of three planes through input points by some 100 bits. Returns nothing for other
/// points, if arithmetic does not round to nearest, or if a coordinate is, or is very near to, a
/// double or the middle of two, unless a plane across its axis or the line states that coordinate.
/// Cost: about 0.5 us.
std::optional<RoundedPoint3> rounded_filter(const Point3Table& points, SpacePoint x);
/// Rounds by the leading bits of exact coordinates in fixed widths, however close to parallel the
/// planes are. Returns nothing in the same cases, and if the point has more bits. Requires a
/// constructed point that does not depend on the frame. Cost: about 0.5 us.
std::optional<RoundedPoint3> rounded_fixed(const Point3Table& points, SpacePoint x);
/// Rounds by three divisions of exact integers. Requires a constructed point that does not depend
/// on the frame. Cost: about 1.5 us, a third of exact(), as no gcd is computed.
RoundedPoint3 rounded_exact(const Point3Table& points, SpacePoint x);

}  // namespace rung

/// Returns round_to_double() of each coordinate of exact(points, x). Requires
/// !points.depends_on_frame(x).
RoundedPoint3 rounded(const Point3Table& points, SpacePoint x);

}  // namespace plumb
#pragma GCC visibility pop
