// Minkowski sums of sets of space: all a + b with a in A and b in B. Sums are exact, including
// every mark.
//
// Main flow of minkowski_sum():
//  1. parts          decomposes both operands into convex parts; each is closed or relatively open
//                    (a body without its boundary, an open triangle, an open segment, a point)
//  2. convex_sum     (convex_sum.h) adds each pair of parts that can matter
//  3. union_of       unites the sums
//
// Marks. Let S and T be convex, R(.) the relative interior and K(.) the closure. Then
// R(S) + R(T) = R(K(S) + K(T)), and K(S) + K(T) is closed if one of them is bounded.
//   both closed         Each operand is the union of its closed convex parts, so the sum is a union
//                       of closed sums and closed itself.
//   otherwise           Each operand is the union of its relatively open parts, the cells of its
//                       convex parts. A sum with an open body is open, and does not change when the
//                       other operand is replaced by a dense part of it. So a body is added only to
//                       parts that are in the boundary of no other part of their set; if an
//                       operand is open, so is the sum. Of the rest every pair is needed.
// So open + anything is open, and closed + closed is closed. The sum of two half-open boxes keeps a
// facet, edge or vertex where both operands have one in that direction. Where the operands' facets
// of one direction are unmarked, marked cells around them still add up: two marked edges that are
// not parallel mark a parallelogram of the sum's facet.
//
// Cost: O((n + m + k) log(n + m + k)) besides the degrees of vertices for two convex sets that are
// both closed, or one of which is open, where the sum has k facets (convex_sum.h). Other operands
// cost the product of their numbers of parts, and a union of as many sets. Numbers: the normals of
// the sum's planes are normals of the input or cross products of two edges, so a sum of sums has
// longer numbers than a Boolean of sums.
//
// Proofs: docs/design/walls.md. Sources: M. de Berg et al., Computational Geometry, chapter 13;
// P. Hachenberger, Exact Minkowski sums of polyhedra and exact and efficient decomposition of
// polyhedra into convex pieces, Algorithmica 55 (2009) 329-345.
#pragma once

#include "plumb/base/context.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns { a + b : a in A, b in B }. Operands may be solids, facets, polylines, points, or mixed.
/// The sum is empty if an operand is empty. Identities: A + B = B + A;
/// (A union B) + C = (A + C) union (B + C); A + {p} is the translate of A by p. Throws
/// Error{BadArgument} if neither operand is empty and one is unbounded, and what the context
/// throws.
Nef3 minkowski_sum(const Nef3& a, const Nef3& b, Context& context = unlimited_context());

/// Returns { x : x + b in A for all b in B }: what remains of A when the mirror image of B moves
/// through the complement of A. Returns the whole space if B is empty. Throws Error{BadArgument} if
/// B is unbounded, or if both A and its complement are, and what the context throws.
Nef3 minkowski_erosion(const Nef3& a, const Nef3& b, Context& context = unlimited_context());

/// Returns a closed polyhedral ball to offset with: the octahedron |x| + |y| + |z| <= radius, its
/// faces subdivided `rounds` times, with new vertices moved to the sphere of that radius and
/// rounded to doubles. It has 8 4^rounds triangles. Throws Error{BadArgument} unless the radius is
/// positive and finite, or if it is below 2^-900 and rounds > 0; Error{ResourceLimit} if
/// rounds > 7.
Nef3 polyhedral_ball(double radius, unsigned rounds, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
