// Writes meshes as STL, text or binary (docs/formats.md, "STL").
#pragma once

#include <ostream>

#include "plumb/space/polygon_mesh.h"

namespace plumb {

/// read_stl() of what is written gives the same triangles, but for what is rounded, with vertices numbered by
/// first use. Both throw Error{BadArgument} when a face is no triangle, Error{NumberOutOfRange} when a
/// coordinate lies beyond the largest double (text) or float (binary), and what `out` throws.
void write_stl_text(std::ostream& out, const PolygonMesh& mesh);
/// Coordinates become floats.
void write_stl_binary(std::ostream& out, const PolygonMesh& mesh);

/// The coordinates of the vertices as binary STL holds them. `exact` becomes empty.
/// Throws Error{NumberOutOfRange} as above.
PolygonMesh rounded_to_floats(PolygonMesh mesh);

}  // namespace plumb
