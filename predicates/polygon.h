// Signed area of closed polygons, simple or not.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Sign of the signed area enclosed by the closed polygon through the given points: Positive when
/// it winds counter-clockwise on balance, Zero for instance for a symmetric bow-tie. Reversal flips
/// the sign, rotation of the list keeps it. O(n) doubles when the filter decides, else O(n) exact
/// terms.
Sign polygon_area_sign(const PointTable2& points, std::span<const std::uint32_t> polygon);

/// Twice the signed area, exactly.
Rational twice_polygon_area(const PointTable2& points, std::span<const std::uint32_t> polygon);

}  // namespace plumb
#pragma GCC visibility pop
