// Divided surfaces against engine/plane: on a flat mesh cells are faces of an arrangement of the
// plane.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "plumb/surface/surface.h"

namespace plumb::testing {

/// Polygons in [0, columns] x [0, rows].
struct FlatScene {
  std::uint32_t columns = 1;
  std::uint32_t rows = 1;
  std::vector<std::vector<RationalPoint2>> polygons;
};

/// Divides grid_mesh(columns, rows, shuffle) and compares: cells with their labels and areas,
/// regions and their loops as sets of the plane, and the same for borders as input. "" or what
/// differs.
std::string disagreement_on_plane(const FlatScene& scene, std::uint64_t shuffle);

}  // namespace plumb::testing
