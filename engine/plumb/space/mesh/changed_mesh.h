// A mesh whose faces were made from the faces of another mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// The result of a step that changes a mesh.
struct ChangedMesh {
  /// The points are the points of the input. Some points have no face.
  PolygonMesh mesh;
  std::vector<std::uint32_t> origin;  ///< The face of the input from which each face was made.
  /// For each face of the input, 1 if it was removed or has other corners now. Empty if the step
  /// changed nothing; all other members are then empty or 0.
  std::vector<std::uint8_t> changed;
  double largest_move = 0;  ///< A bound of the distances by which points of faces moved.
};

}  // namespace plumb
