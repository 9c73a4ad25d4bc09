// Minkowski sums of sets of space: all a + b with a in A and b in B. Sums are exact, including
// every mark.
//
// Main flow of minkowski_sum():
//  1. parts          decomposes both operands into convex parts; each is closed or relatively open
//                    (a body without its boundary, an open triangle, an open segment, a point)
//  2. convex_sum     (convex_sum.h) adds each pair of parts that can matter
//  3. union_of       unites the sums
//
// Marks. Let S and T be convex, R(.) the relative interior and K(.) the closure. Then R(S) + R(T) =
// R(K(S) + K(T)), and K(S) + K(T) is closed if S or T is bounded.
//   both closed         Each operand is the union of its closed convex parts. So the sum is a union
//                       of closed sums, and it is closed.
//   otherwise           Each operand is the union of its relatively open parts, the cells of its
//                       convex parts. The sum with an open body is open. It stays the same when the
//                       other operand is replaced by a dense part of itself. So a body is added
//                       only to those parts of the other operand that lie in the boundary of no
//                       other part. All other pairs of parts are needed.
// So open + anything is open, and closed + closed is closed. The sum of two half-open boxes
// contains a facet, edge or vertex of its boundary if both operands contain their own facet, edge
// or vertex in that direction. If the operands' facets in a direction are unmarked, the marked
// edges and vertices around them still add up: two marked edges that are not parallel mark a
// parallelogram of the sum's facet.
//
// Cost: let the operands have sizes n and m, and let the sum have k facets. Two convex sets take
// O((n + m + k) log(n + m + k)) besides the degrees of vertices, if both are closed or one is open
// (convex_sum.h). Other operands cost the product of their counts of parts, and a union of as many
// sets. Numbers: the normals of the sum's planes are normals of the input or cross products of two
// edges. So the numbers of a sum of sums are longer than those of a Boolean of sums.
//
// Proofs: docs/design/walls.md. Sources: M. de Berg et al., Computational Geometry, chapter 13; P.
// Hachenberger, Exact Minkowski sums of polyhedra and exact and efficient decomposition of
// polyhedra into convex pieces, Algorithmica 55 (2009) 329-345.
#pragma once

#include "plumb/base/context.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns { a + b : a in A, b in B }. Operands may be solids, facets, polylines, points, or mixed.
/// The sum is empty if an operand is empty. Identities: A + B = B + A; (A union B) + C = (A + C)
/// union (B + C); A + {p} is the translate of A by p. Throws Error{BadArgument} if one operand is
/// unbounded and the other one is not empty, and what the context throws.
Nef3 minkowski_sum(const Nef3& a, const Nef3& b, Context& context = unlimited_context());

/// Returns { x : x + b in A for all b in B }. It is A without the points that the mirror image of B
/// covers when it moves through the complement of A. Returns the whole space if B is empty. Throws
/// Error{BadArgument} if B is unbounded, or if both A and its complement are unbounded, and what
/// the context throws.
Nef3 minkowski_erosion(const Nef3& a, const Nef3& b, Context& context = unlimited_context());

/// Returns a closed polyhedral ball, for offsets. It is the octahedron |x| + |y| + |z| <= radius
/// with its faces subdivided `rounds` times. New vertices are moved to the sphere of that radius
/// and rounded to doubles. The ball has 8 * 4^rounds triangles. Throws:
/// - Error{BadArgument} if the radius is not positive, not finite, or below 2^-900 with rounds > 0,
/// - Error{ResourceLimit} if rounds > 7.
Nef3 polyhedral_ball(double radius, unsigned rounds, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
