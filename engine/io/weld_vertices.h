// Vertices that are at one place become one: for formats that list the corners of every triangle.
#pragma once

#include <cstddef>

#include "plumb/base/context.h"
#include "plumb/space/polygon_mesh.h"

namespace plumb {

/// Makes equal vertices one, exactly, and leaves out the faces that then have a vertex twice in a row and
/// the vertices that no face has. Vertices are in order of their first use by a face. Returns how many
/// faces were left out. O(n) expected; charges its working memory for as long as it runs.
std::size_t weld_vertices(PolygonMesh& mesh, Context& context);

}  // namespace plumb
