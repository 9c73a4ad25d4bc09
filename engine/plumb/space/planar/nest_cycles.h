// Boundary cycles of facets in their plane: which run around a facet, which around a hole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The sign of the sine of the corner of the use: Positive below half a turn, Negative above, Zero
/// at half a turn and at a full one (at the end of a slit).
Sign corner_sign(const SpaceComplex& complex, UseId u);

/// Does the cycle bound its facet from outside (rather than a hole)? Decided at its least vertex:
/// there a corner of more than half a turn belongs to a hole. O(length).
bool is_outer(const SpaceComplex& complex, UseId cycle);

/// The sign l in n_r x n_s = l (n_p x n_q), of pairs of planes that share the direction of their
/// lines. Not Zero.
Sign same_direction(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

// Which facet of a plane holds a hole or a point: the region that all facets of the plane make up
// is swept once.
//
// Notation: a cycle is given by one of its uses; hole, outer: is_outer() (nest_cycles.h)
//
// Main flow of nest_cycles():
//  1. vertices of all cycles and the points, seen along an axis, with a directed edge for each use
//  2. a sweep (triangulate.h) finds the edge just below each point where none ends
//  3. the least point of a hole has none: where the edge below it belongs to a hole, both lie in
//     one facet, and the least point of that one comes before; else its cycle is the outer one
//     looked for. A point inside a facet likewise.
//
// Cost: O(n log n) for n uses and points. Memory: 200 bytes a use or point, charged.

struct CycleNesting {
  /// Per cycle: the outer cycle of its facet, as an index of cycles; of an outer one itself.
  std::vector<std::uint32_t> of_cycle;
  /// Per point: the outer cycle of the facet that it lies in.
  std::vector<std::uint32_t> of_point;
};

/// All boundary cycles of all facets of a plane, and points that lie inside facets there. Requires
/// facets that do not overlap; of the complex no more than uses, the edges' origins and the
/// vertices' points. Stops the program where a hole or point has no facet around it. Throws what
/// the context throws.
CycleNesting nest_cycles(const SpaceComplex& complex, PlaneId plane, std::span<const UseId> cycles,
                         std::span<const VertexId> points, Context& context);

}  // namespace plumb
