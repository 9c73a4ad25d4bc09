// Writes meshes as PLY, binary or text (docs/formats.md, "PLY").
#pragma once

#include <cstdint>
#include <ostream>

#include "plumb/space/polygon_mesh.h"

namespace plumb {

/// read_ply() of what is written gives the same mesh, but for what `exact` holds: vertices are rounded to
/// doubles. Both throw Error{NumberOutOfRange} when one lies beyond the largest double; what `out` throws.
void write_ply_text(std::ostream& out, const PolygonMesh& mesh);
/// Little-endian.
void write_ply_binary(std::ostream& out, const PolygonMesh& mesh);

}  // namespace plumb
