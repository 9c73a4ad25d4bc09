// Convexity of a set of space, of any kind: open or closed cell by cell, unbounded, flat, a
// segment, a point.
//
// Main flow, for the set S of a minimal complex:
//  1. body   If there are two marked volumes, the segment between them crosses a cell whose
//            surroundings are not all alike, so S is not convex. If there is one, V, then S must
//            lie between V and its closure K, and K must be convex.
//  2. plane  In every plane with facets S must be convex.
//  3. side   In the line of every side of a marked facet S must be convex.
// Without a marked volume S must lie in one plane or line (flat), and 2 and 3 remain.
//
// Why the body is enough for K. As a closed connected set K is convex if it is so near each of its
// points (H. Tietze 1928, S. Nakajima 1928). Near a facet V is on one side. Near an edge there are
// two facets, and the angle between them inside V is at most half a turn (half a turn if both are
// in one plane, with different marks). Near a vertex K is a cone over regions of the sphere with
// such angles along their boundary. By Gauss-Bonnet a region between two or more of these closed
// curves would have no area, so each has one curve and is convex, and K is convex there if there is
// one region: the edges and corners form one cycle. A facet, edge or vertex with V all around is a
// slit, one without V sticks out: neither passes. See docs/design/walls.md, "Convexity".
//
// Why planes and lines are enough for S. V is the interior of K, so a segment between two points of
// S runs through V, or in the boundary of K, and then in one of its planes. Within such a plane H:
//   a marked facet f   There is no other: between two is something unmarked, or they would be one.
//                      S is f and marked edges and vertices; f must be a convex polygon without
//                      holes or slits, and what is marked must lie on its boundary. Then what is
//                      left are segments within one side of f: what is marked of it must be
//                      consecutive.
//   none               S is marked edges and vertices: two edges span an unmarked triangle, or lie
//                      on a line, where S convex would make them one. So it is one edge with any of
//                      its ends, or one vertex.
// So a closed cube without a vertex is convex; without an edge it is only if at most one of the
// edge's ends is left; without a facet, if at most one edge or vertex in that plane is left, with
// ends.
//
// The frame: S is convex if its intersection with the cube is convex for all large R. What lies on
// the cube looks as S does on one of its cells, cut by half-spaces, so cells of the frame are
// skipped.
#pragma once

#include "plumb/space/space_complex.h"

namespace plumb {

/// Whether the set holds the segment between any two of its points; the empty set does. Exact: one
/// sign for each edge and for each corner of a marked facet. Requires the minimal form. O(n log n)
/// for sorting facets by planes; no arithmetic beyond what the first violation needs.
bool is_convex(const SpaceComplex& complex);

}  // namespace plumb
