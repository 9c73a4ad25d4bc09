// Vertical walls: the second method of decompose(). Sets are cut through their reflex edges by
// walls until the parts are convex. All walls contain one direction, called "vertical".
//
// Main flow of wall_subdivision():
//  1. choose_vertical   (walls.cpp) chooses the direction for which the fewest parts are expected
//  2. sight_walls       (wall_sight.h) extends a wall from each reflex edge that is not vertical
//                       straight up and down, as far as the set goes; afterwards only vertical
//                       edges are reflex
//  3. spread_walls      (wall_spread.h) extends a wall from each of these edges ahead, up to the
//                       first facet or wall
//  4. with_walls        (wall_complex.h) overlays all walls with the set, once after step 2 and
//                       once after step 3
//
// A wall is bounded. It ends where it meets the boundary of the set, or above an end of its edge;
// there step 3 goes on. Step 2 cuts a set with r reflex edges into O(r^2) cells, because every wall
// meets O(r) others. Step 3 makes at most one more part for each vertical edge. A number of O(r^2)
// parts is optimal in the worst case (Chazelle 1984).
//
// Numbers. In one round the plane of a wall is that of a facet or belongs to the pencil of two
// facets. For 53-bit tetrahedra, united or subtracted from a block, the longest number of a wall
// had 262 bits with a vertical along an axis (walls_test.cpp; the aim is at most 800). The
// coordinates of the chosen vertical have at most 64 bits, and lengthen the numbers by as many
// bits. Later rounds are needed only if some cell of the set lies above itself. Their walls belong
// to pencils of walls, so the numbers grow with the count of rounds, but not with the count of
// walls. A point removed from a volume needs a wall through that point, however long the numbers of
// the point are.
//
// In an unbounded set only the bounded volumes are cut by walls: a wall without an end would have
// the frame at infinity as a side. Unbounded volumes are cut by planes, the first method.
//
// Cost: O((n + c) log(n + c)) for c intersections of walls with each other and with the set. In
// addition, each reflex edge costs a test of every facet near its shadow. Proofs:
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

/// Returns the convex parts that decompose() with method Walls makes. "Vertical" is the direction
/// for which the fewest parts are expected. Throws Error{ResourceLimit} if reflex edges are left
/// after 64 rounds, and what the context throws.
ConvexPieces decompose_by_walls(const Nef3& set, const DecomposeOptions& options = {},
                                Context& context = unlimited_context());

/// Returns the convex parts of one bounded volume, merged with neighbours, if walls make fewer than
/// `most` parts. Otherwise returns an empty list. Also returns an empty list if more than 32 edges
/// are reflex and choose_vertical() expects too many parts. That estimate takes O(r^2) steps for r
/// reflex edges. Throws what the context throws.
std::vector<Nef3> fewer_pieces_by_walls(const Nef3& volume, std::size_t most,
                                        Context& context = unlimited_context());

/// A direction (x, y, z) that is not zero.
using VerticalDirection = std::array<Integer, 3>;

/// Returns the set subdivided by walls, as a complex that is not minimal. Every marked volume is
/// convex. A facet that lies in a facet of the set has the facet_origin of that facet; any other
/// facet has kWallOrigin. Walls belong to the set. `up` is the vertical direction; if it is empty,
/// choose_vertical() chooses one. Throws Error{BadArgument} if the set is unbounded,
/// Error{ResourceLimit} if reflex edges are left after 64 rounds, and what the context throws.
SpaceComplex wall_subdivision(const Nef3& set, const std::optional<VerticalDirection>& up,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
