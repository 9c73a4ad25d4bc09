// Ids of the elements of planar maps and of complexes in space.
#pragma once

#include <cstdint>

#include "plumb/predicates/strong_id.h"

namespace plumb {

using VertexId = StrongId<struct VertexTag>;
using HalfedgeId = StrongId<struct HalfedgeTag>;
using EdgeId = StrongId<struct EdgeTag>;  ///< undirected: half-edges 2e and 2e+1
using LoopId = StrongId<struct LoopTag>;  ///< one boundary cycle of a face
using FaceId = StrongId<struct FaceTag>;
using CycleId = StrongId<struct CycleTag>;  ///< a cycle as listed in the input
using SegmentId = StrongId<struct SegmentTag>;

// In space (space_complex.h) vertices, edges and half-edges have the ids above.
using UseId = StrongId<struct UseTag>;  ///< an edge on the boundary of a facet
using FacetId = StrongId<struct FacetTag>;
using VolumeId = StrongId<struct VolumeTag>;

}  // namespace plumb
