// The nearest doubles to the point of a source.
#pragma once

#include <array>
#include <optional>

#include "plumb/predicates/nearest_quotient.h"
#include "plumb/predicates/plane_exact.h"
#include "plumb/predicates/rounded_point3.h"

namespace plumb::exact3 {

/// `clear`: nearest doubles to coordinates that are none, 0 for others. For those a plane through input points or a line has to have
/// one coordinate, or nothing is returned.
std::optional<RoundedPoint3> with_coordinates_across(std::array<double, 3> clear,
                                                     const PlaneTable& planes,
                                                     const PointSource& source);

/// What some 100 bits tell of a line and a plane through input points, or of three planes that are so too (as_line()); nothing
/// for other sources. Cost: ~120 ns. Conditions: rung::rounded_filter().
std::optional<RoundedPoint3> rounded_on_line(const PlaneTable& planes, const PointSource& source);

/// Of the point of a source that does not depend on the frame: what rung::rounded_fixed() finds.
template <int X, int W>
std::optional<RoundedPoint3> rounded_fixed(const Homogeneous<Fixed<X>, Fixed<W>>& point,
                                           const PlaneTable& planes, const PointSource& source) {
  if (!rounds_to_nearest()) return {};
  const TwofoldScaled w = top_bits(point.w);
  std::array<double, 3> clear;
  for (std::size_t i = 0; i < 3; ++i) clear[i] = nearest_quotient(point.x[i], w, point.scale);
  return with_coordinates_across(clear, planes, source);
}

}  // namespace plumb::exact3
