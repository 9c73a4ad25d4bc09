// Minkowski sums of sets of space: all a + b with a in A and b in B. Exact, with every mark.
//
// Main flow of minkowski_sum():
//  1. parts          both operands as convex parts; each is closed or relatively open (a body without its
//                    boundary, an open triangle, an open segment, a point)
//  2. convex_sum     (convex_sum.h) of each pair that can matter, closed or relatively open
//  3. union_of       of all
//
// Marks. Let S and T be convex, R(.) the relative interior, K(.) the closure: R(S) + R(T) = R(K(S) + K(T)), and
// K(S) + K(T) is closed where one of them is bounded.
//   both closed         Each is the union of its closed pieces, so the sum is that of closed sums: closed.
//   otherwise           Each is the union of its relatively open parts, the items of its pieces. A sum with an
//                       open body is open, and does not change when the other operand is replaced by a dense part of it.
//                       So a body is added to all parts that are in the boundary of no other part of their set (all of
//                       them open: the sum is open), and of the rest every pair is needed.
// So open + anything is open; closed + closed is closed; a half-open box + a half-open box keeps a facet, edge or
// vertex where both operands have one in that direction. Where their facets of one direction are unmarked, what is
// marked around these still adds up: two marked edges that are not parallel mark a parallelogram of the sum's facet.
//
// Unbounded operands: Error{BadArgument}; of an erosion, the first may be. The empty set gives the empty set.
//
// Cost: two convex sets (both closed, or one of them open) O((n + m + k) log(n + m + k)) besides the degrees of
// vertices, k facets of the sum (convex_sum.h). Others: the product of the numbers of parts, and a
// union of as many sets. Numbers: the sum's planes have input normals or cross products of two edges, so that a
// sum of sums has longer numbers than a Boolean of sums has.
//
// Sources: de Berg et al., Computational Geometry, chapter 13; Hachenberger, Algorithmica 55 (2009) 329-345.
#pragma once

#include "plumb/base/context.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// { a + b : a in A, b in B }. Operands of any kind: solids, facets, polylines, points, mixed ones. Identities:
/// A + B = B + A; (A union B) + C = (A + C) union (B + C); A + {p} is the translate. Throws Error{BadArgument} for an
/// unbounded operand.
Nef3 minkowski_sum(const Nef3& a, const Nef3& b, Context& context);

/// { x : x + b in A for all b in B }: what stays of A when B's mirror image is rolled around its complement. A or its
/// complement is bounded, B is bounded: else Error{BadArgument}. B empty: the whole space.
Nef3 minkowski_erosion(const Nef3& a, const Nef3& b, Context& context);

/// A closed ball of polyhedral shape to offset with: the octahedron |x| + |y| + |z| <= r, its faces
/// subdivided `rounds` times with new vertices pushed out to the sphere of radius r (rounded to doubles: close to it).
/// 8 4^rounds triangles. Throws Error{BadArgument} unless r > 0 is finite, or where it is below
/// 2^-900 and rounds > 0; Error{ResourceLimit} above 7 rounds.
Nef3 polyhedral_ball(double radius, unsigned rounds, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
