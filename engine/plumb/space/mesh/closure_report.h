// What a mesh does not say of a set. Internal.
#pragma once

#include "plumb/space/to_mesh.h"

namespace plumb {

/// Returns the report of mesh_of_complex() without making the mesh. The counts of edges and
/// vertices that are not manifold are 0. Requires that the complex has volumes and marks, and that
/// no marked volume is unbounded. O(n).
ToMeshReport closure_report(const SpaceComplex& complex);

}  // namespace plumb
