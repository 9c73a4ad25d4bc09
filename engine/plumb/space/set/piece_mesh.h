// The mesh of the pieces of a boundary before it is rounded. Internal.
#pragma once

#include "plumb/space/set/cut_boundary.h"
#include "plumb/space/set/round_mesh.h"
#include "plumb/space/set/source_triangles.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Returns the mesh of the faces of a cut boundary, in the same order. Its points are the nearest
/// doubles. MeshOfComplex::facet has the indices of their pieces. A point at which attributes
/// change is listed in MeshToRound::kept.
MeshToRound mesh_of_pieces(const CutBoundary& cut, const SourceTriangles& triangles,
                           const SpaceComplex& complex);

}  // namespace plumb
