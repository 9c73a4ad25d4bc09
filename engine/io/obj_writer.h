// Writes meshes as OBJ (docs/formats.md, "OBJ").
#pragma once

#include <ostream>

#include "plumb/space/polygon_mesh.h"

namespace plumb {

/// read_obj() of the text gives the same mesh, but for what `exact` holds: vertices are rounded. Throws
/// Error{NumberOutOfRange} when one lies beyond the largest double; what `out` throws.
void write_obj(std::ostream& out, const PolygonMesh& mesh);

}  // namespace plumb
