// Finds the defects of faces that rounding may have damaged.
#pragma once

#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/space/mesh/doubtful_faces.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/rounded_mesh.h"

namespace plumb {

/// Returns the effects of rounding on the doubtful faces of a mesh. mesh.exact lists the vertices
/// of these faces that were rounded, with their coordinates before rounding; other vertices may be
/// listed, too. rounded_vertices and beyond_doubles of the report are left empty. Reads the faces
/// by complex_of_mesh(). Throws the errors of the Context.
RoundingReport check_faces(const PolygonMesh& mesh, const DoubtfulFaces& doubtful,
                           std::uint64_t max_listed, Context& context);

}  // namespace plumb
