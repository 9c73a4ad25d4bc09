// Converts an angle in degrees to a unit vector.
#pragma once

#include <cmath>
#include <numbers>

#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the vector (cos a, sin a), where a is the given angle. The result is exact for multiples
/// of 90 degrees. Requires a finite angle.
inline Point2 unit_vector(double degrees) {
  constexpr double kQuarter = 90;
  const double rest = std::remainder(degrees, 4 * kQuarter);  // This is exact.
  const double quarters = std::nearbyint(rest / kQuarter);
  const double angle = (rest - quarters * kQuarter) * (std::numbers::pi / (2 * kQuarter));
  const auto [c, s] = direction_at(angle);
  switch (static_cast<int>(quarters)) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case -1:
      return {s, -c};
    default:
      return {-c, -s};
  }
}

}  // namespace plumb
#pragma GCC visibility pop
