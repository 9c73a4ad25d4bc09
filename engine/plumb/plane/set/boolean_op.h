// One or two complexes as curves of one scene, for sweeping them together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/complex/plane_rules.h"
#include "plumb/plane/plane_complex.h"

namespace plumb {

/// Several complexes over one table of points: all input points first, then all crossings.
struct JoinedPoints {
  PlanePoints points;                          ///< The points of all complexes.
  std::vector<std::vector<std::uint32_t>> to;  ///< The index there of each point of each complex.
};

/// Returns the points of the complexes in one table, in their order. Equal points stay different.
JoinedPoints join_points(std::span<const PlaneComplex* const> complexes);

/// One or two complexes as a scene for BooleanRule.
struct JoinedInput {
  SweepInput scene;                      ///< The edges as curves.
  std::vector<OverlayCurve> sides;       ///< The origin of each curve.
  std::vector<std::uint32_t> vertex_at;  ///< The vertex at each point, as BooleanRule takes it.
};

/// Returns the scene of one or two complexes. Isolated vertices become stops.
JoinedInput join_inputs(std::span<const PlaneComplex* const> complexes);

}  // namespace plumb
