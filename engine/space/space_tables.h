// The planes and points that complexes in space refer to.
//
// Planes 0, 1, 2 are x = 0, y = 0, z = 0 in every table, so that the directions of the axes are
// pairs of planes like any other direction.
#pragma once

#include <cstdint>
#include <memory>

#include "plumb/predicates/point3_table.h"

namespace plumb {

struct SpaceTables {
  SpaceTables();
  SpaceTables(const SpaceTables&) = delete;
  SpaceTables& operator=(const SpaceTables&) = delete;

  PlaneTable planes;
  Point3Table points;  ///< of `planes`
};

inline constexpr PlaneId kPlaneX{0};
inline constexpr PlaneId kPlaneY{1};
inline constexpr PlaneId kPlaneZ{2};

}  // namespace plumb
