// Ids of the cells of planar maps and of complexes in space.
#pragma once

#include <cstdint>

#include "plumb/predicates/strong_id.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point where edges end, or an isolated vertex in a facet, face or volume.
using VertexId = StrongId<struct VertexTag>;
using HalfedgeId = StrongId<struct HalfedgeTag>;  ///< One of the two directions of an edge.
using EdgeId = StrongId<struct EdgeTag>;          ///< Edge e: the half-edges 2 e and 2 e + 1.
using LoopId = StrongId<struct LoopTag>;          ///< A boundary cycle of a face.
using FaceId = StrongId<struct FaceTag>;          ///< A region of a planar, sphere or surface map.
using CycleId = StrongId<struct CycleTag>;        ///< A cycle that the input lists.
using SegmentId = StrongId<struct SegmentTag>;    ///< An input curve of an arrangement.

// Complexes in space (space_complex.h) use the ids above for vertices, edges and half-edges. An
// edge use is one occurrence of an edge on the boundary of a facet (K. Weiler, The radial edge
// structure, in: Geometric Modeling for CAD Applications, North-Holland, 1988).
using UseId = StrongId<struct UseTag>;        ///< An edge use: an edge on the boundary of a facet.
using FacetId = StrongId<struct FacetTag>;    ///< A connected part of a plane.
using VolumeId = StrongId<struct VolumeTag>;  ///< A connected component of space minus all facets.

}  // namespace plumb
#pragma GCC visibility pop
