// Vertical walls: the second method of decompose(). A wall is a plane polygon through a reflex
// edge. Sets are cut by walls until the parts are convex. All walls are parallel to one direction,
// called "vertical".
//
// Main flow of wall_subdivision():
//  1. choose_vertical   (walls.cpp) chooses the direction for which the fewest parts are expected
//  2. sight_walls       (wall_sight.h) takes each reflex edge that is not vertical. It extends a
//                       wall from this edge straight up and straight down, until the wall meets the
//                       boundary of the set. After this step, only vertical edges are reflex
//  3. spread_walls      (wall_spread.h) takes each vertical reflex edge, and extends a wall from it
//                       sideways into the reflex angle, up to the first facet or wall
//  4. with_walls        (wall_complex.h) overlays all walls with the set, once after step 2 and
//                        once after step 3
//  Steps 2 to 4 form a round. Rounds are repeated until no edge is reflex. One round is usually
//                       enough.
//
// A wall is bounded. A wall of step 2 ends where it meets the boundary of the set. The sides of the
// wall are vertical lines through the ends of its edge. Step 3 extends further walls from these
// lines. Step 2 cuts a set with r reflex edges into O(r^2) cells, because every wall meets O(r)
// other walls. Step 3 adds at most one part for each vertical edge. O(r^2) parts are optimal in the
// worst case (Chazelle 1984).
//
// Numbers. In the first round, the plane of each wall is the plane of a facet, or passes through
// the common line of the planes of two facets. The test walls_test.cpp measures the lengths of
// numbers in walls, for unions of tetrahedra with 53-bit coordinates and for blocks minus such
// tetrahedra. If the vertical direction is the direction of an axis, the longest number has 262
// bits. The test requires at most 800 bits. Each coordinate of a chosen vertical direction has at
// most 64 bits. If a coordinate of the direction has k bits, the numbers become up to k bits
// longer. Later rounds are needed only if some vertical line meets one cell in several segments.
// The plane of each wall of a later round passes through the common line of the planes of two
// walls. So the lengths of numbers grow with the number of rounds, but not with the number of
// walls. If a point was removed from a volume, a wall through that point is needed, and the length
// of its numbers depends on the point.
//
// In an unbounded set only the bounded volumes are cut by walls, because in an unbounded volume a
// wall could reach to infinity. Unbounded volumes are cut by planes instead, as in the first method
// of decompose().
//
// Cost: O((n + c) log(n + c)), where n is the number of cells of the set, and c is the number of
// intersections of walls with each other and with the set. In addition, each reflex edge is tested
// against every facet whose vertical projection is near the projection of the edge. Proofs:
// docs/design/walls.md. Sources: P. Hachenberger, Exact Minkowski sums of polyhedra and exact and
// efficient decomposition of polyhedra into convex pieces, Algorithmica 55 (2009) 329-345; B.
// Chazelle, Convex partitions of polyhedra, SIAM Journal on Computing 13 (1984).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/decompose.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the convex parts that decompose() with method Walls makes. The function uses the
/// vertical direction for which it expects the fewest parts. Throws Error{ResourceLimit} if reflex
/// edges are left after 64 rounds. Also throws the errors of the Context.
ConvexPieces decompose_by_walls(const Nef3& set, const DecomposeOptions& options = {},
                                Context& context = unlimited_context());

/// Cuts one bounded volume by walls, and merges neighbouring parts whose union is convex. Returns
/// the convex parts if there are fewer than `most` parts. Otherwise returns an empty list. If more
/// than 32 edges are reflex, choose_vertical() first estimates the number of parts. If the estimate
/// is too large, the function returns an empty list without cutting. The estimate takes O(r^2)
/// steps for r reflex edges. Throws the errors of the Context.
std::vector<Nef3> fewer_pieces_by_walls(const Nef3& volume, std::size_t most,
                                        Context& context = unlimited_context());

/// A direction (x, y, z) that is not zero.
using VerticalDirection = std::array<Integer, 3>;

/// Returns the set subdivided by walls. The result is a complex that is not minimal. Every marked
/// volume is convex. If a facet of the result lies in a facet of the set, both facets have the same
/// facet_origin. Any other facet of the result has kWallOrigin. Walls are marked: their points
/// belong to the set. `up` is the vertical direction. If `up` is empty, choose_vertical() chooses
/// the direction. Throws Error{BadArgument} if the set is unbounded. Throws Error{ResourceLimit} if
/// reflex edges are left after 64 rounds. Also throws the errors of the Context.
SpaceComplex wall_subdivision(const Nef3& set, const std::optional<VerticalDirection>& up,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
