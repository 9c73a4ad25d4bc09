// The nearest doubles to points of space, without their exact coordinates in lowest terms.
#pragma once

#include <optional>

#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb {

struct RoundedPoint3 {
  Point3 at;      ///< each coordinate correctly rounded; beyond all doubles: infinite
  bool is_exact;  ///< nothing was lost
};

namespace rung {

/// What some 100 bits tell, of points of three planes through input points: nothing if a coordinate
/// is, or is very near to, a double or the middle of two, but for one that a plane across its axis
/// says. Nothing, too, where arithmetic does not round to nearest. Cost: ~0.5 us.
std::optional<RoundedPoint3> rounded_filter(const Point3Table& points, SpacePoint x);
/// The same of the exact coordinates in fixed widths, however close to parallel the planes are, and
/// of lines, too. Requires a constructed point that does not depend on the frame. Cost: ~0.5 us.
std::optional<RoundedPoint3> rounded_fixed(const Point3Table& points, SpacePoint x);
/// Requires a constructed point. Cost: ~1.5 us, a third of exact(): three divisions, no gcd.
RoundedPoint3 rounded_exact(const Point3Table& points, SpacePoint x);

}  // namespace rung

/// Identity: round_to_double() of exact(points, x), by its coordinates. Requires
/// !points.depends_on_frame(x).
RoundedPoint3 rounded(const Point3Table& points, SpacePoint x);

}  // namespace plumb
#pragma GCC visibility pop
