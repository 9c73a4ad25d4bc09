// Faces for the holes of a mesh. The source also defines triangulated() (repair_mesh.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/complex/space_tables.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// Adds faces whose common boundary is a closed chain of points: one polygon if they lie in one
/// plane, or if there are more than 100; else the triangles of least area. `place` has the point of
/// each index in the tables. Returns how many faces were added. O(k^3) for k <= 100 points, else
/// O(k).
std::uint32_t fill_hole(PolygonMesh& mesh, std::span<const std::uint32_t> chain,
                        std::span<const SpacePoint> place, SpaceTables& tables);

}  // namespace plumb
