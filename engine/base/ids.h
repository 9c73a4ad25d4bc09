// Ids of the elements of planar maps and of complexes in space.
#pragma once

#include <cstdint>

#include "plumb/predicates/strong_id.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point where edges end, or alone in a face or volume.
using VertexId = StrongId<struct VertexTag>;
using HalfedgeId = StrongId<struct HalfedgeTag>;  ///< an edge in one of its two directions
using EdgeId = StrongId<struct EdgeTag>;          ///< undirected: half-edges 2e and 2e+1
using LoopId = StrongId<struct LoopTag>;          ///< one boundary cycle of a face
using FaceId = StrongId<struct FaceTag>;          ///< a region of a map, a plane or a surface
using CycleId = StrongId<struct CycleTag>;        ///< a cycle as listed in the input
using SegmentId = StrongId<struct SegmentTag>;    ///< a curve given to an arrangement

// In space (space_complex.h) vertices, edges and half-edges have the ids above.
using UseId = StrongId<struct UseTag>;        ///< an edge on the boundary of a facet
using FacetId = StrongId<struct FacetTag>;    ///< a connected part of a plane, in space
using VolumeId = StrongId<struct VolumeTag>;  ///< a connected part of space off all facets

}  // namespace plumb
#pragma GCC visibility pop
