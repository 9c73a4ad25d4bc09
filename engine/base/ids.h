// Ids of the elements of planar maps.
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

}  // namespace plumb
