// What a mesh file holds: polygons, and what was passed over on the way to them.
#pragma once

#include <string>
#include <vector>

#include "plumb/space/polygon_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What a reader of meshes gives.
struct MeshFile {
  PolygonMesh mesh;  ///< as it stands in the file
  /// What the file says besides, and what was left out: one sentence each, for people.
  std::vector<std::string> notes;
};

}  // namespace plumb
#pragma GCC visibility pop
