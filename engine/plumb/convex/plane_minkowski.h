// Minkowski sums of sets of the plane: minkowski_sum() of two Nef2. The Minkowski sum of A and B is
// the set of all points a + b with a in A and b in B. The sums are exact, and the marks of all
// cells are exact, too.
//
// Main flow of minkowski_sum() for closed operands:
//  1. decompose  splits the operand with fewer convex pieces into its pieces (plane_partition.h)
//  2. convolve   makes, for each piece, the convolution of the border of the other operand with the
//                border of the piece, and takes the points with a positive winding number
//  3. union_of   unites the results of all pieces
// If an operand is not closed, both operands are split into relatively open convex cells: open
// polygons, open segments, and points. The sum of two such cells is the relative interior of the
// sum of their closures. An open polygon is added only to those cells of the other operand that do
// not lie in the border of another cell, because the other sums lie within these.
//
// Why the winding number is right: the convolution of a closed region A and a convex polygon B
// winds around a point p as often as the Euler characteristic of the intersection of A with p - B.
// This is the number of components of the intersection minus the number of its holes. As p - B is
// convex, a loop of A that surrounds such a hole lies in p - B entirely. So one copy of B is added
// at one vertex of each loop: its winding number is 1 for such a point p. The sum is positive
// exactly for the points p for which the intersection is not empty.
//
// Cost: let the closed operands have n and m vertices, and let one of them consist of k convex
// pieces. A convolution with a piece has at most n (1 + m) segments, and for a border that does not
// turn to and fro about n + m. Its sweep takes O((s + c) log s) for s segments and c crossings. For
// operands that are not closed, the number of sums is the product of the numbers of cells. Numbers:
// each vertex of the result is a sum of two vertices, or a crossing of two lines through such sums.
// Sources: L. Guibas, L. Ramshaw, J. Stolfi, A kinetic framework for computational geometry, FOCS
// 1983, 100-111; R. Wein, Exact and efficient construction of planar Minkowski sums using the
// convolution method, ESA 2006, LNCS 4168, 829-840.
#pragma once

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns { a + b : a in A, b in B }. Each operand may consist of polygons, lines and points. The
/// sum is empty if an operand is empty. Identities: A + B = B + A; (A union B) + C = (A + C) union
/// (B + C); A + {p} is the translate of A by p. Throws Error{BadArgument} if one operand is
/// unbounded and the other operand is not empty. Throws what the context throws.
[[nodiscard]] Nef2 minkowski_sum(const Nef2& a, const Nef2& b,
                                 Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
