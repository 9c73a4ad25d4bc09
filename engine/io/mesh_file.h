// What a mesh file holds: polygons, and what was passed over on the way to them.
#pragma once

#include <string>
#include <vector>

#include "plumb/space/polygon_mesh.h"

namespace plumb {

struct MeshFile {
  PolygonMesh mesh;
  /// What the file says besides, and what was left out: one sentence each, for people.
  std::vector<std::string> notes;
};

}  // namespace plumb
