// Complexes as curves of one scene, for sweeping them together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/complex/plane_rules.h"
#include "plumb/plane/plane_complex.h"

namespace plumb {

/// Several complexes over one table of points: all input points first, then all crossings.
struct JoinedPoints {
  PlanePoints points;
  std::vector<std::vector<std::uint32_t>> to;  ///< per complex: dense index by its own
};

JoinedPoints join_points(std::span<const PlaneComplex* const> complexes);

/// One or two complexes as a scene for BooleanRule.
struct JoinedInput {
  SweepInput scene;
  std::vector<OverlayCurve> sides;       ///< per curve
  std::vector<std::uint32_t> vertex_at;  ///< per point, as BooleanRule wants it
};

/// Requires one or two complexes. Isolated vertices become stops.
JoinedInput join_inputs(std::span<const PlaneComplex* const> complexes);

}  // namespace plumb
