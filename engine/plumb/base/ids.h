// Ids of the cells of planar maps and of complexes in space.
#pragma once

#include <cstdint>

#include "plumb/predicates/strong_id.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A point where edges end, or an isolated vertex in a facet, face or volume.
using VertexId = StrongId<struct VertexTag>;
using HalfedgeId = StrongId<struct HalfedgeTag>;  ///< One of the two directions of an edge.
/// An edge. The half-edges of edge e have the ids 2 e and 2 e + 1.
using EdgeId = StrongId<struct EdgeTag>;
using LoopId = StrongId<struct LoopTag>;        ///< A boundary cycle of a face.
using FaceId = StrongId<struct FaceTag>;        ///< A region of a planar, sphere or surface map.
using CycleId = StrongId<struct CycleTag>;      ///< A cycle that the input lists.
using SegmentId = StrongId<struct SegmentTag>;  ///< An input curve of an arrangement.

// Complexes in space (space_complex.h) use the ids above for vertices, edges and half-edges. An
// edge use is one occurrence of an edge on the boundary of a facet (K. Weiler, The radial edge
// structure, in: Geometric Modeling for CAD Applications, North-Holland, 1988).
/// One occurrence of an edge on the boundary of a facet (an edge use).
using UseId = StrongId<struct UseTag>;
using FacetId = StrongId<struct FacetTag>;    ///< A connected part of a plane.
using VolumeId = StrongId<struct VolumeTag>;  ///< A connected part of space outside all facets.

}  // namespace plumb
#pragma GCC visibility pop
