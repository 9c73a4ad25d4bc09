// Minkowski sums of sets of the plane: minkowski_sum() of two Nef2. The Minkowski sum of A and B is
// the set of all points a + b with a in A and b in B. The sums are exact, and the marks of all
// cells are exact, too.
//
// Main flow of minkowski_sum() for closed operands:
//  1. decompose  splits one operand into convex pieces (plane_partition.h). It selects the operand
//                that has fewer pieces
//  2. convolve   makes, for each piece, the convolution of the border of this piece with the border
//                of the other operand. A convolution is a set of closed polygons. The step takes
//                all points around which these polygons have a positive winding number. These
//                points are the sum of the piece and the other operand
//  3. union_of   unites the results of all pieces
// If an operand is not closed, both operands are split into relatively open convex cells: open
// polygons, open segments, and points. The sum of two such cells is the relative interior of the
// sum of their closures. An open polygon P is added only to those cells of the other operand that
// do not lie in the border of another cell. The reason is that, if a cell C lies in the border of a
// cell D, the sum of P and C lies within the sum of P and D.
//
// Why the winding number is right: let A be a closed region and let B be a convex polygon. A point
// p belongs to A + B exactly if A meets the polygon p - B. The winding number of the convolution of
// A and B at p is the Euler characteristic of the intersection of A and p - B. The Euler
// characteristic is the number of components of the intersection minus the number of its holes. So
// the holes could make the winding number 0 or negative at a point of A + B. To prevent this, one
// copy of B is added to the convolution at one vertex v of each loop of A: the polygon v + B. If a
// loop of A surrounds a hole of the intersection, the whole loop lies in the convex polygon p - B.
// Then p lies in v + B, and the copy adds 1 to the winding number at p. With these copies, the
// winding number is positive exactly at the points p for which A meets p - B.
//
// Cost: let the closed operands have n and m vertices, and let one of them be split into k convex
// pieces. The convolution of one piece with the other operand has at most n (1 + m) segments. If
// the border of the other operand has few reflex corners, the convolution has about n + m segments.
// The sweep over a convolution with s segments and c crossings takes O((s + c) log s). For operands
// that are not closed, the number of sums is the product of the numbers of cells of the two
// operands. Numbers: each vertex of the result is a sum of two vertices, or a crossing of two lines
// through such sums. Sources: L. Guibas, L. Ramshaw, J. Stolfi, A kinetic framework for
// computational geometry, FOCS 1983, 100-111; R. Wein, Exact and efficient construction of planar
// Minkowski sums using the convolution method, ESA 2006, LNCS 4168, 829-840.
#pragma once

#include <span>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns { a + b : a in A, b in B }. Each operand may consist of polygons, lines and points. The
/// sum is empty if an operand is empty. Identities: A + B = B + A; (A union B) + C = (A + C) union
/// (B + C); A + {p} is the translate of A by p. Throws Error{BadArgument} if one operand is
/// unbounded and the other operand is not empty. Throws the errors of the Context.
[[nodiscard]] Nef2 minkowski_sum(const Nef2& a, const Nef2& b,
                                 Context& context = unlimited_context());

/// Returns the sum of all sets. It consists of the sums x1 + ... + xn, where xi is any point of set
/// i. The sum is empty if a set is empty, and the set {0} if there are no sets. Throws as
/// minkowski_sum() of two sets does.
[[nodiscard]] Nef2 minkowski_sum(std::span<const Nef2> sets,
                                 Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
