// Minkowski sums of sets of space. The Minkowski sum of A and B is the set of all points a + b with
// a in A and b in B. The sums are exact, and the marks of all cells are exact, too.
//
// Main flow of minkowski_sum():
//  1. parts          decomposes both operands into convex parts. If both operands are closed, the
//                    parts are closed. Otherwise there are two kinds of parts. A body is a part of
//                    dimension 3, with the marks of its boundary. All other parts are relatively
//                    open: open triangles, open segments and points
//  2. convex_sum     (convex_sum.h, half_open_body.h) computes the sum of each pair of parts,
//                    except for pairs that cannot change the result
//  3. union_of       unites the sums
//
// Marks. Let S and T be convex sets. R(S) denotes the relative interior of S, and K(S) denotes the
// closure of S. Then R(S) + R(T) = R(K(S) + K(T)), and K(S) + K(T) is closed if S or T is bounded.
//   both closed         Each operand is the union of its closed convex parts. So the sum is a
//                       finite union of closed sets, and is closed, too.
//   two bodies          A face of the sum is the sum of a face of each body. The sum is marked if
//                       these two faces are marked. If the two faces are parallel, or if a face has
//                       marked and unmarked parts, the sums of their marked parts are added.
//   otherwise           Each operand is the union of its relatively open parts. These parts are the
//                       cells of its convex parts. The sum of any set and an open body is open.
//                       The sum of an open body and a set X does not change if X is replaced by a
//                       dense subset of X. So an open body is added only to those parts of the
//                       other operand that do not lie in the boundary of another part. If neither
//                       part of a pair is a body, the sum of this pair is always needed.
// So the sum is open if at least one operand is open, and the sum is closed if both operands are
// closed. For example, let the operands be two half-open boxes. The boundary of their sum has one
// cell (a facet, edge or vertex) in each direction, and so has the boundary of each box. The sum
// contains its cell in a direction if each of the two boxes contains its own cell in this
// direction. Suppose that, in one direction, the facets of both operands are unmarked. The sum's
// facet in this direction can still have marked parts, because marked edges and vertices of the two
// facets are added, too. For example, the sum of two marked edges that are not parallel is a marked
// parallelogram in the sum's facet.
//
// Cost: let the operands have sizes n and m, and let the sum have k facets. The sum of two convex
// sets takes O((n + m + k) log(n + m + k)) time under two conditions (convex_sum.h). The degrees of
// vertices must be bounded. Both sets must be solids. For other operands, the number of sums is the
// product of the numbers of parts of the two operands. If a solid is not closed and the other
// operand has parts of lower dimension, each cell of the boundary of the solid is a part. The
// union of all these sums is computed, too. Numbers: the normal of each plane of the sum is a
// normal of the input or a cross product of two edges of the input. So numbers become longer if a
// sum is an operand of another sum, but not if a sum is an operand of a Boolean operation.
//
// Proofs: docs/design/walls.md. Sources: M. de Berg et al., Computational Geometry, chapter 13; P.
// Hachenberger, Exact Minkowski sums of polyhedra and exact and efficient decomposition of
// polyhedra into convex pieces, Algorithmica 55 (2009) 329-345.
#pragma once

#include <span>

#include "plumb/base/context.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns { a + b : a in A, b in B }. Each operand may consist of solids, facets, polylines and
/// points. The sum is empty if an operand is empty. Identities: A + B = B + A; (A union B) + C = (A
/// + C) union (B + C); A + {p} is the translate of A by p. Throws Error{BadArgument} if one operand
/// is unbounded and the other operand is not empty. Throws the errors of the Context.
Nef3 minkowski_sum(const Nef3& a, const Nef3& b, Context& context = unlimited_context());

/// Returns the sum of all sets. It consists of the sums x1 + ... + xn, where xi is any point of set
/// i. The result does not depend on the order of the sets. The function first adds all convex sets
/// to each other. So every other set is added to one convex set only. The sum is empty if a set is
/// empty, and the set {0} if there are no sets. Throws as minkowski_sum() of two sets does.
Nef3 minkowski_sum(std::span<const Nef3> sets, Context& context = unlimited_context());

/// Returns { x : x + b in A for all b in B }. These are the vectors x for which the set B, moved by
/// x, lies in A. Returns the whole space if B is empty. Throws Error{BadArgument} if B is
/// unbounded, or if both A and the complement of A are unbounded. Throws the errors of the Context.
Nef3 minkowski_erosion(const Nef3& a, const Nef3& b, Context& context = unlimited_context());

/// Returns a closed polyhedron that approximates a ball, for use in offsets. The polyhedron is made
/// from the octahedron |x| + |y| + |z| <= radius, whose faces are subdivided `rounds` times. New
/// vertices are moved to the sphere with this radius around the origin, and rounded to doubles. The
/// ball has 8 * 4^rounds triangles. Throws:
/// - Error{BadArgument} if the radius is not positive or not finite, or if rounds > 0 and the
///   radius is below 2^-900,
/// - Error{ResourceLimit} if rounds > 7.
Nef3 polyhedral_ball(double radius, unsigned rounds, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
