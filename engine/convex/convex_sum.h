// The Minkowski sum of two closed bounded convex sets of any dimension, by their merged normal fans.
//
// For a direction u let A(u) be the face of A where u is greatest: a vertex, an edge or a facet. A facet of A + B
// with outer normal u is A(u) + B(u), and no vertex of the sum is a + b for two pairs of vertices. So facets can be
// made one by one, each from its pair of faces, and fit together by the names (a, b) of their corners; nothing is
// degenerate. Directions:
//   normals of facets of A and of B
//   where an edge of A and an edge of B, not parallel, are both extreme: arcs of the two Gaussian maps cross
//
// Main flow of convex_sum():
//  1. facet_directions   of each facet of one operand the face of the other: climb from vertex to vertex, from
//                        where the facet beside it ended
//  2. edge_directions    for each edge of one operand turn u about it, from one of its facets' normals to the other,
//                        and follow the extreme vertex of the other operand (gift wrapping around its silhouette)
//  3. merge              the cycles of A(u) and B(u) by the angles of their edges; parallel ones add up
//  4. link               (link_facets.h) vertices, facets, marks: a minimal complex
//
// Cost: steps 1 and 2 O(degree) for each vertex passed; a vertex is passed for every facet of the sum at it, so it is
// output-sensitive where degrees are bounded. Signs: degree 3 in differences, balls of doubles, then
// rationals. Source: Fukuda, J. Symb. Comput. 38 (2004); Fogel, Halperin, CAD 39 (2007) 929-940.
#pragma once

#include "plumb/base/context.h"
#include "plumb/convex/convex_body.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// What belongs to the result.
enum class SumMarks : std::uint8_t {
  Closed,  ///< all of it
  Open,    ///< its relative interior
};

Nef3 convex_sum(const ConvexBody& a, const ConvexBody& b, SumMarks marks, Context& context);

}  // namespace plumb
