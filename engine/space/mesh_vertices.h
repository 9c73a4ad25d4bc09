// The vertices of a mesh: points of equal coordinates are one.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/mesh_arrays.h"
#include "plumb/space/space_tables.h"

namespace plumb {

struct MeshVertices {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::vector<std::uint32_t> of_point;  ///< per point of the mesh; kNone: no face uses it
  std::vector<std::uint32_t> input;  ///< per vertex: the least point of the mesh there; ascending
  std::vector<SpacePoint> point;     ///< per vertex
  std::uint64_t merged = 0;          ///< used points that are not the least at their place
};

/// Adds the points to the tables. -0 equals 0. Throws Error{BadIndex, NotFinite}. O(n) expected.
MeshVertices merge_equal_points(const MeshView& mesh, SpaceTables& tables);

}  // namespace plumb
